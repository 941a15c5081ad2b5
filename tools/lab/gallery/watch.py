# SPDX-License-Identifier: MIT
"""A wrist watch under a crystal: steel case, blue dial, applied marks, a leather strap closed around nothing."""
import math

from parts import BASE, SEGMENTS, base, circle, rounded_box, scene, smoothed
from mesh import Obj
from png import encode16
from shapes import lathe, prism, profile, superellipse, textured_disc
from transform import AXIS_TO_FRONT, AXIS_TO_RIGHT, lean_back, roll, translate

MATERIALS = BASE + """
newmtl steel
Kd 0.56 0.55 0.54
Pm 1
Pr 0.3

newmtl dial
Kd 0.8 0.8 0.8
map_Kd watch_dial.png

newmtl mark
Kd 0.9 0.87 0.8
Ks 0.4 0.4 0.4
Pr 0.3

newmtl second
Kd 0.85 0.2 0.04

newmtl leather
Kd 0.2 0.085 0.035
Ks 0.3 0.3 0.3
Pr 0.5

newmtl thread
Kd 0.7 0.52 0.3

newmtl crystal
Kd 0.02 0.02 0.02
Ks 0.5 0.5 0.5
Ni 1.5
d 0.08
illum 2
"""

SIZE_PX, LEVELS = 384, 7
CENTRE, EDGE, INK = (30, 74, 122), (10, 26, 54), (236, 232, 220)
DIAL_RADIUS, DIAL_Z = 0.43, 0.06
STRAP_TALL, STRAP_DEEP, STRAP_THICK = 0.62, 0.46, 0.035
LEAN_DEGREES = 22


def coverage(distance):
    return min(1.0, max(0.0, 0.5 - distance * SIZE_PX / 2))


def ticks(r, turn, count, first, last, half_width):
    """How much of a pixel one of `count` radial marks covers."""
    across = abs(r * math.sin(2 * math.pi * (turn - round(turn * count) / count))) - half_width
    return coverage(max(first - r, r - last, across))


def ink(x, y):
    r, turn = math.hypot(x, y), math.atan2(x, y) / (2 * math.pi)
    track = max(ticks(r, turn, 60, 0.90, 0.94, 0.006), ticks(r, turn, 12, 0.88, 0.94, 0.012))
    r, turn = math.hypot(x, y + 0.42), math.atan2(x, y + 0.42) / (2 * math.pi)
    small = max(ticks(r, turn, 12, 0.17, 0.205, 0.007), coverage(abs(r - 0.225) - 0.006))
    return max(track, small)


def dial():
    """The PNG file's bytes: colours 0 to 7 go from the centre to the edge, 8 to 15 from there to the ink."""
    palette = [tuple(round(a + (b - a) * k / LEVELS) for a, b in zip(CENTRE, EDGE)) for k in range(LEVELS + 1)]
    palette += [tuple(round(a + (b - a) * (k + 1) / 8) for a, b in zip(EDGE, INK)) for k in range(8)]
    rows = []
    for j in range(SIZE_PX):
        row = []
        for i in range(SIZE_PX):
            x, y = (2 * i + 1) / SIZE_PX - 1, 1 - (2 * j + 1) / SIZE_PX
            level = round(ink(x, y) * 8)
            # An ordered dither of 2×2 hides the steps of the gradient.
            shade = math.hypot(x, y) ** 1.5 * LEVELS + (0.25, 0.75, 0.99, 0.5)[i % 2 + 2 * (j % 2)] - 0.25
            row.append(7 + level if level else min(LEVELS, max(0, math.floor(shade))))
        rows.append(row)
    return encode16(palette, rows)


def case(obj, place):
    front = AXIS_TO_FRONT.then(place)
    obj.part("case", "steel")
    body = [(0, -0.09, 0), (0.44, -0.09, 0.03), (0.5, -0.03, 0.03), (0.5, 0.09, 0.02), (0.475, 0.115, 0.01),
            (0.465, 0.15, 0.012), (0.435, 0.15, 0.01), (0.43, DIAL_Z, 0)]
    obj.grids(lathe(profile(body), SEGMENTS), front)
    for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        obj.grid(rounded_box((0.045, 0.13, 0.06), 4), translate(x * 0.27, y * 0.44, -0.07).then(place))
    crown = profile([(0.03, 0, 0), (0.03, 0.03, 0), (0.07, 0.03, 0.008), (0.07, 0.1, 0.015), (0, 0.105, 0)])
    obj.grids(lathe(crown, 32), AXIS_TO_RIGHT.then(translate(0.48, 0, 0.02)).then(place))
    pusher = profile([(0.032, 0, 0), (0.032, 0.08, 0.01), (0, 0.082, 0)])
    for turn in (-32, 32):
        obj.grids(lathe(pusher, 24), AXIS_TO_RIGHT.then(translate(0.47, 0, 0.02)).then(roll(turn)).then(place))
    obj.part("dial", "dial")
    obj.grids(textured_disc(DIAL_RADIUS, SEGMENTS, 3), translate(0, 0, DIAL_Z).then(place))
    obj.part("crystal", "crystal")
    dome = [(0.436, 0.14), (0.33, 0.152), (0.22, 0.159), (0.11, 0.164), (0, 0.166)]
    points = [[(r * s, y, r * c) for c, s in circle(SEGMENTS)] for r, y in dome]
    obj.grid(smoothed(points, closed=True), front)


def hand(length, tail, wide, tip):
    return [(-wide, -tail), (-tip, length), (tip, length), (wide, -tail)]


def hands(obj, place):
    obj.part("marks", "mark")
    for hour in range(12):
        if hour == 6:
            continue
        wide = 0.017 if hour % 3 else 0.026
        bar = [(-wide, 0.28), (-wide, 0.365), (wide, 0.365), (wide, 0.28)]
        for face in prism(bar, DIAL_Z, DIAL_Z + 0.016):
            obj.face(face, roll(30 * hour).then(place))
    for name, outline, low, degrees in (("hour", hand(0.23, 0.06, 0.026, 0.016), 0.085, 304.5),
                                        ("minute", hand(0.35, 0.07, 0.02, 0.011), 0.1, 54)):
        obj.part(name, "mark")
        for face in prism(outline, low, low + 0.01):
            obj.face(face, roll(degrees).then(place))
    obj.part("second", "second")
    for face in prism(hand(0.075, 0.03, 0.008, 0.005), 0.07, 0.078):
        obj.face(face, roll(215).then(translate(0, -0.42 * DIAL_RADIUS, 0)).then(place))
    for face in prism(hand(0.375, 0.11, 0.008, 0.005), 0.112, 0.118):
        obj.face(face, roll(132).then(place))
    obj.part("cap", "steel")
    obj.grids(lathe(profile([(0.026, DIAL_Z, 0), (0.026, 0.125, 0.008), (0, 0.127, 0)]), 24), AXIS_TO_FRONT.then(place))


def along(degrees, out=0.0, across=0.0):
    """A point beside the strap's loop; 0 degrees is the watch, `out` lies away from the loop."""
    a = math.radians(degrees)
    c, s = math.cos(a), math.sin(a)
    r = superellipse(2.3, c, s)
    normal = (abs(c * r) ** 1.3 * math.copysign(1, c) / STRAP_DEEP, abs(s * r) ** 1.3 * math.copysign(1, s) / STRAP_TALL)
    length = math.hypot(*normal)
    return (across, STRAP_TALL * r * s + out * normal[1] / length, STRAP_DEEP * (r * c - 1) + out * normal[0] / length)


def half_width(degrees):
    """The strap is broad at the watch and narrow at the clasp."""
    return 0.155 + 0.055 * (1 + math.cos(math.radians(degrees))) / 2


def strap(obj, place):
    obj.part("strap", "leather")
    points = []
    for k in range(97):
        degrees = 20 + 320 * k / 96
        row = []
        for c, s in circle(24):
            f = superellipse(5, c, s)
            row.append(along(degrees, STRAP_THICK * f * c, half_width(degrees) * f * s))
        points.append(row)
    obj.grid(smoothed(points, closed=True), place)
    obj.part("stitches", "thread")
    for side in (-1, 1):
        for k in range(40):
            degrees = 62 + 6 * k
            if abs(degrees - 180) < 24:
                continue
            row = [[along(degrees + step, STRAP_THICK * 0.97 + lift, side * (half_width(degrees) - 0.028 + shift))
                    for shift in (-0.007, 0.007)] for step, lift in ((0, 0), (0.6, 0.008), (2.8, 0.008), (3.4, 0))]
            obj.grid(smoothed(row, closed=False), place)
    obj.part("clasp", "steel")
    points = [[along(180 + turn, out, x) for x in (-0.18, -0.172, 0.172, 0.18)]
              for turn, out in ((-14, 0.03), (-13, 0.055), (-5, 0.06), (5, 0.06), (13, 0.055), (14, 0.03))]
    obj.grid(smoothed(points, closed=False), place)


def files():
    obj = Obj("A wrist watch under a crystal", "watch.mtl")
    lean = lean_back(LEAN_DEGREES)
    lowest = min(lean.point(along(d, STRAP_THICK))[1] for d in range(180, 360))
    place = lean.then(translate(0, 0.002 - lowest, 0.22))
    base(obj, 0.72)
    case(obj, translate(0, 0, 0.05).then(place))
    hands(obj, translate(0, 0, 0.05).then(place))
    strap(obj, place)
    return {"watch.obj": obj, "watch.mtl": MATERIALS, "watch_dial.png": dial(),
            "watch.json": scene([{"obj": "watch.obj"}])}
