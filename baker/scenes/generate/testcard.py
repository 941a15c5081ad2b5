# SPDX-License-Identifier: MIT
"""A test card: the extremes that a layout or a reconstruction must survive, gathered on one disc.

Black, white, mirror and saturated spheres, a needle, rods from thick to hair-thin, and a thin plate.
"""
import math

from mesh import Obj
from shapes import lathe, prism, profile, sphere
from transform import translate

BALL_RADIUS, BALL_RING_RADIUS = 0.17, 0.62
NEEDLE_HEIGHT, NEEDLE_RADIUS = 1.30, 0.035
ROD_RADII = (0.032, 0.016, 0.008, 0.004, 0.002)
PLATE_THICKNESS = 0.004

MATERIALS = """# SPDX-License-Identifier: MIT
# 18 % grey.
newmtl grey
Kd 0.18 0.18 0.18

newmtl black
Kd 0 0 0

newmtl black_gloss
Kd 0 0 0
Ks 0.6 0.6 0.6
Ns 200
Pr 0.08

newmtl white
Kd 0.8 0.8 0.8

newmtl mirror
Kd 0.95 0.95 0.95
Ks 0.95 0.95 0.95
Ns 2000
Pr 0.03
Pm 1

newmtl gold
Kd 1.0 0.71 0.29
Ks 1.0 0.71 0.29
Ns 40
Pr 0.2
Pm 1

newmtl red
Kd 0.6 0 0

newmtl green
Kd 0 0.6 0

newmtl blue
Kd 0 0 0.6
"""

BALLS = ("black", "red", "mirror", "green", "white", "blue", "black_gloss", "gold")


def _balls(obj):
    for i, material in enumerate(BALLS):
        angle = 2 * math.pi * (i + 0.5) / len(BALLS)
        x, z = BALL_RING_RADIUS * math.sin(angle), BALL_RING_RADIUS * math.cos(angle)
        obj.part("ball_" + material, material)
        obj.grids(sphere(BALL_RADIUS, 32, 16), translate(x, 0.05 + BALL_RADIUS, z))


def _rods(obj):
    obj.part("rods", "white")
    for i, radius in enumerate(ROD_RADII):
        rod = profile([(0, 0, 0), (radius, 0, 0), (radius, 0.75, 0), (0, 0.75, 0)])
        obj.grids(lathe(rod, 12), translate(-0.24 + 0.12 * i, 0.05, 0.24))


def _plate(obj):
    obj.part("plate", "red")
    half = PLATE_THICKNESS / 2
    outline = [(-0.28, 0.05), (-0.28, 0.75), (0.28, 0.75), (0.28, 0.05)]
    for face in prism(outline, -half, half):
        obj.face(face, translate(0, 0, -0.26))


def files():
    obj = Obj("Test card: black, white, mirror, saturated, needle-thin and plate-thin things", "testcard.mtl")
    obj.part("base", "grey")
    obj.grids(lathe(profile([(0, 0, 0), (0.9, 0, 0), (0.9, 0.05, 0.02), (0, 0.05, 0)]), 64))
    _balls(obj)
    obj.part("needle", "gold")
    obj.grids(lathe(profile([(NEEDLE_RADIUS, 0.05, 0), (0, 0.05 + NEEDLE_HEIGHT, 0)]), 24))
    _rods(obj)
    _plate(obj)
    return {"testcard.obj": obj, "testcard.mtl": MATERIALS}
