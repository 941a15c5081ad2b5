# SPDX-License-Identifier: MIT
"""An item of a game: a potion in a round flask, with a cork, a gold collar and a cord."""
import math
import random

from parts import BASE, SEGMENTS, base, circle, scene, smoothed
from mesh import Obj
from shapes import lathe, profile, sphere, torus
from transform import translate

MATERIALS = BASE + """
newmtl flask
Kd 0.45 0.55 0.55
Ks 0.5 0.5 0.5
Ni 1.5
d 0.16
illum 2

newmtl potion
Kd 0.01 0.17 0.16
Ke 0.0 0.05 0.045
Ks 0.4 0.4 0.4
Pr 0.25

newmtl foam
Kd 0.45 0.85 0.7
Ke 0.02 0.12 0.1

newmtl cork
Kd 0.42 0.25 0.12

newmtl gold
Kd 0.95 0.66 0.26
Pm 1
Pr 0.28

newmtl cord
Kd 0.5 0.38 0.2
"""

CENTRE, RADIUS, WALL = 0.6, 0.56, 0.035
LEVEL = 0.70  # where the liquid ends


def flask(obj):
    obj.part("flask", "flask")
    points = []
    angles = [math.radians(-78 + 146 * k / 32) for k in range(33)]
    outline = [(RADIUS * math.cos(a), CENTRE + RADIUS * math.sin(a)) for a in angles]
    outline += [(0.185, 1.16), (0.175, 1.22), (0.172, 1.34), (0.19, 1.40), (0.225, 1.42), (0.235, 1.45), (0.215, 1.475)]
    for r, y in outline:
        points.append([(r * s, y, r * c) for c, s in circle(SEGMENTS)])
    obj.grid(smoothed(points, closed=True))


def liquid(obj):
    obj.part("potion", "potion")
    inner = RADIUS - WALL
    top = math.asin((LEVEL - CENTRE) / inner)
    angles = [-math.pi / 2 + (top + math.pi / 2) * k / 28 for k in range(29)]
    points = [[(inner * math.cos(a) * s * (k > 0), CENTRE + inner * math.sin(a), inner * math.cos(a) * c * (k > 0))
               for c, s in circle(SEGMENTS)] for k, a in enumerate(angles)]
    obj.grid(smoothed(points, closed=True))
    edge = inner * math.cos(top)
    obj.grids(lathe(profile([(edge, LEVEL, 0), (0, LEVEL, 0)]), SEGMENTS))
    obj.part("foam", "foam")
    rng = random.Random(7)
    for _ in range(26):
        turn, way, size = rng.uniform(0, 2 * math.pi), edge * math.sqrt(rng.uniform(0, 0.8)), rng.uniform(0.025, 0.075)
        at = translate(way * math.cos(turn), LEVEL + size * 0.3, way * math.sin(turn))
        obj.grids(sphere(size, 16, 8), at)


def neck(obj):
    obj.part("cork", "cork")
    cork = [(0.15, 1.3, 0), (0.185, 1.55, 0.03), (0.18, 1.62, 0.03), (0, 1.62, 0)]
    obj.grids(lathe(profile(cork), 40))
    obj.part("collar", "gold")
    ring = [(0.17, 1.15, 0), (0.225, 1.15, 0.015), (0.225, 1.2, 0.015), (0.17, 1.2, 0)]
    obj.grids(lathe(profile(ring), SEGMENTS))
    obj.part("cord", "cord")
    for height in (1.235, 1.268, 1.301):
        obj.grids(torus(0.187, 0.018, 48, 10), translate(0, height, 0))


def stand(obj):
    obj.part("stand", "gold")
    foot = [(0, 0.0, 0), (0.36, 0.0, 0.012), (0.36, 0.03, 0.012), (0.27, 0.06, 0.02), (0.31, 0.125, 0.012), (0.28, 0.13, 0)]
    obj.grids(lathe(profile(foot), SEGMENTS))


def files():
    obj = Obj("A potion", "potion.mtl")
    base(obj, 0.72)
    stand(obj)
    flask(obj)
    liquid(obj)
    neck(obj)
    return {"potion.obj": obj, "potion.mtl": MATERIALS, "potion.json": scene([{"obj": "potion.obj"}])}
