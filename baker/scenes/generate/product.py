# SPDX-License-Identifier: MIT
"""The demo scene: a desk clock of glossy plastic and brushed steel on a satin plinth, with a glow ring under it.

One unit is about 10 cm; the plinth stands on y = 0 and the dial looks towards +z, leaning back.
"""
import math

import dial
from mesh import Obj
from shapes import arch, cushion, lathe, prism, profile, textured_disc, torus
from transform import AXIS_TO_BACK, AXIS_TO_FRONT, AXIS_TO_RIGHT, lean_back, roll, translate

SEGMENTS = 72

PLINTH_RADIUS, PLINTH_HEIGHT = 0.74, 0.10
GLOW_RADIUS, GLOW_TUBE = 0.285, 0.028
BODY_HALF, BODY_HALF_DEPTH, BODY_EXPONENT = 0.60, 0.34, 4.5
TRIM_HALF_WIDTH, TRIM_HEIGHT = 0.03, 0.007
LEAN_DEGREES = 10
BODY_CENTRE = translate(0, 0.86, 0)
DIAL_RADIUS, DIAL_Z = 0.425, 0.315
RIM_RADIUS = 0.47  # where the body's shell ends under the bezel, in front and behind
RIB_RADII, RIB_HALF_WIDTH = (0.155, 0.255, 0.355), 0.027
TIME_HOURS, TIME_MINUTES, TIME_SECONDS = 10, 9, 36

MATERIALS = """# SPDX-License-Identifier: MIT
# Satin plinth.
newmtl plinth
Kd 0.4 0.39 0.375
Ks 0.5 0.5 0.5
Ns 20
Pr 0.3

# Glossy red plastic.
newmtl shell
Kd 0.45 0.022 0.012
Ks 0.6 0.6 0.6
Ns 90
Pr 0.15

# Brushed steel.
newmtl steel
Kd 0.72 0.72 0.74
Ks 0.72 0.72 0.74
Ns 20
Pr 0.28
Pm 1

# Printed paper under no glass.
newmtl dial
Kd 0.85 0.85 0.85
map_Kd product_dial.png

# Dark lacquer of the hands.
newmtl hands
Kd 0.012 0.016 0.028
Ks 0.6 0.6 0.6
Ns 30
Pr 0.25

newmtl second_hand
Kd 0.85 0.13 0.03

# Black rubber of the foot and the rear panel.
newmtl rubber
Kd 0.025 0.025 0.028

# Tan leather of the handle.
newmtl leather
Kd 0.32 0.15 0.06

# The light of the foot.
newmtl glow
Kd 0 0 0
Ke 0.3 4.2 4.8
"""


def _shell_stations(steps):
    """Outlines from the rear to the front rim: circles at the rims, a rounded square at the widest place."""
    stations = []
    for k in range(steps + 1):
        a = math.pi * (k / steps - 0.5)
        c = math.cos(a) if 0 < k < steps else 0.0
        bulge = c ** 0.8
        size = RIM_RADIUS + (BODY_HALF - RIM_RADIUS) * bulge
        z = BODY_HALF_DEPTH * math.copysign(abs(math.sin(a)) ** 0.8, math.sin(a))
        stations.append((size, z, 2 + (BODY_EXPONENT - 2) * bulge))
    return stations


def _hand(length, tail, half_width, tip_half_width):
    """Outline of a tapered hand that points to 12, clockwise."""
    return [(-half_width, -tail), (-tip_half_width, length), (tip_half_width, length), (half_width, -tail)]


def _plinth(obj):
    obj.part("plinth", "plinth")
    r, h = PLINTH_RADIUS, PLINTH_HEIGHT
    obj.grids(lathe(profile([(0, 0, 0), (r - 0.03, 0, 0.015), (r, h, 0.035), (0, h, 0)]), SEGMENTS))


def _foot(obj):
    obj.part("foot", "rubber")
    top = PLINTH_HEIGHT
    obj.grids(lathe(profile([(0.24, top, 0), (0.24, top + 0.03, 0.01), (0.17, top + 0.05, 0.02), (0.17, top + 0.2, 0)]),
                    SEGMENTS // 2))
    obj.part("glow_ring", "glow")
    obj.grids(torus(GLOW_RADIUS, GLOW_TUBE, SEGMENTS // 2, 10), translate(0, PLINTH_HEIGHT + GLOW_TUBE, 0))


def _shell(obj, place):
    obj.part("shell", "shell")
    obj.grids(cushion(_shell_stations(32), 96), place)
    obj.part("trim", "steel")
    proud, flat = BODY_HALF + TRIM_HEIGHT, TRIM_HALF_WIDTH - TRIM_HEIGHT
    band = [(BODY_HALF, -TRIM_HALF_WIDTH), (proud, -flat), (proud, flat), (BODY_HALF, TRIM_HALF_WIDTH)]
    obj.grids(cushion([(size, z, BODY_EXPONENT) for size, z in band], 96), place)


def _front(obj, place):
    front = AXIS_TO_FRONT.then(place)
    obj.part("bezel", "steel")
    ring = [(0.50, 0.31, 0), (0.50, 0.375, 0.02), (0.455, 0.395, 0.012), (0.43, 0.34, 0.004), (0.415, 0.31, 0)]
    obj.grids(lathe(profile(ring), SEGMENTS), front)
    obj.part("dial", "dial")
    obj.grids(textured_disc(DIAL_RADIUS, SEGMENTS // 2, 2), translate(0, 0, DIAL_Z).then(place))
    _hands(obj, place)


def _angles():
    """Of the hands, clockwise from 12."""
    minutes = TIME_MINUTES + TIME_SECONDS / 60
    hours = TIME_HOURS + minutes / 60
    return {"hour_hand": hours * 30, "minute_hand": minutes * 6, "second_hand": TIME_SECONDS * 6}


def _hands(obj, place):
    hands = (("hour_hand", "hands", _hand(0.235, 0.06, 0.034, 0.024), 0.330, 0.342),
             ("minute_hand", "hands", _hand(0.345, 0.07, 0.026, 0.016), 0.348, 0.358),
             ("second_hand", "second_hand", _hand(0.37, 0.11, 0.011, 0.007), 0.363, 0.369))
    for name, material, outline, z0, z1 in hands:
        obj.part(name, material)
        for face in prism(outline, z0, z1):
            obj.face(face, roll(_angles()[name]).then(place))
    obj.part("hand_cap", "steel")
    obj.grids(lathe(profile([(0.04, DIAL_Z, 0), (0.04, 0.378, 0.012), (0, 0.382, 0)]), 24), AXIS_TO_FRONT.then(place))


def _back(obj, place):
    """A rubber panel inside a steel ring, with concentric steel ribs over the loudspeaker."""
    back = AXIS_TO_BACK.then(place)
    obj.part("rear_ring", "steel")
    ring = [(0.50, 0.31, 0), (0.50, 0.36, 0.02), (0.44, 0.36, 0.02), (0.43, 0.30, 0)]
    obj.grids(lathe(profile(ring), SEGMENTS), back)
    obj.part("rear_panel", "rubber")
    obj.grids(lathe(profile([(0.44, 0.315, 0), (0, 0.315, 0)]), SEGMENTS // 2), back)
    obj.part("rear_ribs", "steel")
    for radius in RIB_RADII:
        outer, inner = radius + RIB_HALF_WIDTH, radius - RIB_HALF_WIDTH
        rib = [(outer, 0.31, 0), (outer, 0.345, 0.012), (inner, 0.345, 0.012), (inner, 0.31, 0)]
        obj.grids(lathe(profile(rib), SEGMENTS // 2), back)
    obj.grids(lathe(profile([(0.06, 0.31, 0), (0.06, 0.345, 0.015), (0, 0.352, 0)]), 24), back)


def _handle(obj, place):
    obj.part("handle", "leather")
    obj.grids(arch(0.33, 0.20, 2.6, (0.022, 0.085), 32, 24), translate(0, BODY_HALF - 0.05, 0).then(place))
    obj.part("crowns", "steel")
    crown = profile([(0.035, 0, 0), (0.035, 0.05, 0), (0.075, 0.05, 0.008), (0.075, 0.115, 0.02), (0, 0.12, 0)])
    obj.grids(lathe(crown, 32), AXIS_TO_RIGHT.then(translate(BODY_HALF - 0.02, 0, 0)).then(place))


def files():
    obj = Obj("Desk clock: the demo scene", "product.mtl")
    body = lean_back(LEAN_DEGREES).then(BODY_CENTRE)
    _plinth(obj)
    _foot(obj)
    _shell(obj, body)
    _front(obj, body)
    _back(obj, body)
    _handle(obj, body)
    return {"product.obj": obj, "product.mtl": MATERIALS, "product_dial.png": dial.texture(),
            "clock.json": _clock(body)}


def _clock(body):
    """The same scene with hands that turn, clockwise from 12."""
    axis = ", ".join("%.9g" % c for c in body.vector((0, 0, -1)))
    pivot = ", ".join("%.9g" % c for c in body.point((0, 0, DIAL_Z)))
    hands = ",\n".join('        {"name": "%s", "turn": [%s], "pivot": [%s], "at": %.9g}' % (name, axis, pivot, angle)
                       for name, angle in _angles().items())
    return '{\n    "objects": [{"obj": "product.obj"}],\n    "parts": [\n%s\n    ]\n}\n' % hands
