# SPDX-License-Identifier: MIT
"""Finishes: the same metal plain, brushed level and brushed upright, and the same cloth without and with sheen.

No texture coordinates: the metal is brushed around the vertical axis.
"""
import math

from mesh import Obj
from shapes import lathe, profile, sphere
from transform import translate

BASE_RADIUS, BASE_TOP = 0.95, 0.05
BALL_RADIUS, BALL_RING_RADIUS = 0.28, 0.6
# Blue cloth lies beside blue cloth, so that one picture shows the difference.
BALLS = ("plain", "level", "upright", "velvet", "cloth")

MATERIALS = """# SPDX-License-Identifier: MIT
newmtl base
Kd 0.3 0.3 0.3

newmtl plain
Kd 0.91 0.92 0.92
Pr 0.45
Pm 1

# The highlight is drawn out level ...
newmtl level
Kd 0.91 0.92 0.92
Pr 0.45
Pm 1
aniso 0.95

# ... and by a quarter of a turn upright.
newmtl upright
Kd 0.91 0.92 0.92
Pr 0.45
Pm 1
aniso 0.95
anisor 0.25

newmtl cloth
Kd 0.05 0.08 0.25

newmtl velvet
Kd 0.05 0.08 0.25
"""


SCENE = """// SPDX-License-Identifier: MIT
// Finishes under two small lamps, which show how highlights are drawn out.
{
  "objects": [{"obj": "finishes.obj"}],
  "environment": {"zenith": 0.35, "horizon": 0.15, "nadir": 0.05},
  "lights": [
    {"type": "sphere", "position": [3, 2, -0.5], "radius": 0.5, "radiance": 24},
    {"type": "sphere", "position": [-1.5, 2.5, -2], "radius": 0.5, "radiance": [16, 14, 12]}
  ],
  "materials": {"velvet": {"sheen": 1}},
  "tone": "aces"
}
"""


def files():
    obj = Obj("Finishes: plain and brushed metal, cloth without and with sheen", "finishes.mtl")
    obj.part("base", "base")
    obj.grids(lathe(profile([(0, 0, 0), (BASE_RADIUS, 0, 0), (BASE_RADIUS, BASE_TOP, 0.02), (0, BASE_TOP, 0)]), 64))
    for i, material in enumerate(BALLS):
        angle = 2 * math.pi * (i + 0.4) / len(BALLS)
        obj.part(material, material)
        obj.grids(sphere(BALL_RADIUS, 40, 20), translate(BALL_RING_RADIUS * math.sin(angle), BASE_TOP + BALL_RADIUS,
                                                         BALL_RING_RADIUS * math.cos(angle)))
    return {"finishes.obj": obj, "finishes.mtl": MATERIALS, "finishes.json": SCENE}
