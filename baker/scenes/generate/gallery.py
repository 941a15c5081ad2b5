# SPDX-License-Identifier: MIT
"""The gallery: glass, metal, coats, textures of every kind, many lamps, extra lights and a picture of the sky."""
import math

import hdr
import png
from mesh import Obj
from shapes import lathe, profile, sphere, textured_disc, torus
from transform import AXIS_TO_BACK, lean_back, translate

BASE_RADIUS, BASE_TOP = 1.0, 0.06
LAMPS, LAMP_RADIUS, LAMP_RING = 40, 0.014, 0.98
PICTURE_SIDE = 64
SKY_WIDTH, SKY_HEIGHT = 64, 32

MATERIALS = """# SPDX-License-Identifier: MIT
newmtl base
Kd 0.08 0.08 0.09
Pr 0.3

newmtl tiles
Pr 0.25
map_Kd -s 4 4 1 gallery_tiles.png

newmtl clear
illum 7
Ni 1.5
Tf 1 1 1

# Tf: what is left of light after one unit of length.
newmtl amber
illum 7
Ni 1.55
Tf 0.35 0.06 0.002

newmtl frosted
illum 7
Ni 1.45
Tf 0.5 0.9 0.8
Pr 0.45

newmtl gold
Kd 1 0.782 0.344
Pr 0.15
Pm 1

newmtl copper
Kd 0.955 0.638 0.538
Pr 0.6
Pm 1

newmtl paint
Kd 0.5 0.01 0.02
Pr 0.55
Pm 0.3

newmtl coin
Kd 0.9 0.88 0.82
Pr 0.3
Pm 1
map_Bump -bm 2 gallery_bumps.png

newmtl sieve
Kd 0.7 0.7 0.72
Pr 0.35
Pm 1
map_d gallery_holes.png

newmtl screen
Kd 0.02 0.02 0.02
Ke 3 3 3
map_Ke gallery_screen.png

newmtl lamp
Kd 0 0 0
Ke 40 26 12
"""

SCENE = """// SPDX-License-Identifier: MIT
// The gallery, as lumi bake and lumi reference take it.
{
  "objects": [{"obj": "gallery.obj"}],
  "environment": {"picture": "gallery_sky.hdr", "rotate": 20},
  "lights": [
    {"type": "sphere", "position": [1.5, 2.5, 1.5], "radius": 0.25, "radiance": [14, 12, 10]},
    {"type": "rectangle", "position": [-2.5, 1.2, 0.5], "target": [0, 0.3, 0], "size": [1.2, 1.8], "radiance": [1.2, 1.5, 2]},
    {"type": "spot", "position": [0, 3, 0.5], "target": [0, 0, 0], "angle": 14, "intensity": 8}
  ],
  "materials": {"base": {"coat": 1, "coat_roughness": 0.05}, "paint": {"coat": 1, "coat_roughness": 0.02}},
  "tone": "aces"
}
"""

GREYS = [(17 * k, 17 * k, 17 * k) for k in range(16)]


def _solids(obj):
    obj.part("ball_clear", "clear")
    obj.grids(sphere(0.24, 40, 20), translate(0.3, BASE_TOP + 0.241, 0.42))
    obj.part("ball_amber", "amber")
    obj.grids(sphere(0.17, 40, 20), translate(-0.12, BASE_TOP + 0.171, 0.62))
    obj.part("bottle", "frosted")
    outline = [(0, 0, 0), (0.16, 0, 0.04), (0.16, 0.34, 0.08), (0.06, 0.44, 0.04), (0.06, 0.6, 0), (0, 0.6, 0)]
    obj.grids(lathe(profile(outline), 48), translate(-0.5, BASE_TOP + 0.001, 0.25))
    obj.part("ring", "gold")
    obj.grids(torus(0.2, 0.07, 64, 24), translate(0.66, BASE_TOP + 0.07, 0.02))
    obj.part("ball_copper", "copper")
    obj.grids(sphere(0.2, 40, 20), translate(0.35, BASE_TOP + 0.2, -0.42))
    obj.part("ball_paint", "paint")
    obj.grids(sphere(0.3, 40, 20), translate(-0.25, BASE_TOP + 0.3, -0.35))


def _pictures(obj):
    obj.part("tiles", "tiles")
    obj.grids(textured_disc(0.95, 64, 4), AXIS_TO_BACK.then(translate(0, BASE_TOP, 0)))
    obj.part("coin", "coin")
    obj.grids(textured_disc(0.22, 48, 2), lean_back(20).then(translate(0.05, BASE_TOP + 0.21, 0.05)))
    obj.part("sieve", "sieve")
    obj.grids(textured_disc(0.26, 48, 2), lean_back(10).then(translate(-0.72, BASE_TOP + 0.27, -0.1)))
    obj.part("screen", "screen")
    obj.grids(textured_disc(0.28, 48, 2), lean_back(15).then(translate(0.3, 0.85, -0.55)))


def _lamps(obj):
    obj.part("lamps", "lamp")
    for k in range(LAMPS):
        angle = 2 * math.pi * (k + 0.5) / LAMPS  # none at 0, where a pole's rim would not round to one point
        x, z = LAMP_RING * math.sin(angle), LAMP_RING * math.cos(angle)
        obj.grids(sphere(LAMP_RADIUS, 8, 4), translate(x, BASE_TOP + LAMP_RADIUS, z))


def _picture(value):
    """A picture of 16 greys from a function of the pixel, 0 to 15."""
    return png.encode16(GREYS, [[value(x, y) for x in range(PICTURE_SIDE)] for y in range(PICTURE_SIDE)])


def _tiles():
    palette = [(205, 200, 190), (60, 66, 78)] + [(120, 120, 120)] * 14
    half = PICTURE_SIDE // 2
    return png.encode16(palette, [[(x // half + y // half) % 2 for x in range(PICTURE_SIDE)]
                                  for y in range(PICTURE_SIDE)])


def _bump(x, y):
    distance = math.hypot((x + 0.5) % 16 - 8, (y + 0.5) % 16 - 8)
    return max(0, min(15, round(15 * (1 - distance / 7))))


def _hole(x, y):
    return 0 if math.hypot((x + 0.5) % 8 - 4, (y + 0.5) % 8 - 4) < 2.6 else 15


def _screen():
    palette = [(0, 0, 0), (40, 220, 255), (255, 90, 30), (250, 250, 250)] + [(0, 0, 0)] * 12

    def colour(x, y):
        wave = PICTURE_SIDE / 2 + 14 * math.sin(x / 5) * math.exp(-((x - 32) / 18) ** 2)
        return 1 if abs(y - wave) < 1.6 else 2 if y > 52 and x // 4 % 2 else 3 if y < 8 and 8 < x < 40 else 0

    return png.encode16(palette, [[colour(x, y) for x in range(PICTURE_SIDE)] for y in range(PICTURE_SIDE)])


def _sky():
    """A dim room with two soft boxes, a window and a bright lamp."""
    def colour(x, y):
        height = 1 - 2 * (y + 0.5) / SKY_HEIGHT
        base = 0.25 + 0.2 * height
        if 8 <= x < 16 and 6 <= y < 14:
            return (4, 4.2, 4.6)
        if 40 <= x < 43 and 4 <= y < 16:
            return (6, 5, 4)
        if 26 <= x < 30 and 2 <= y < 4:
            return (30, 28, 24)
        return (base, base * 1.02, base * 1.1)

    return hdr.encode([[colour(x, y) for x in range(SKY_WIDTH)] for y in range(SKY_HEIGHT)])


def files():
    obj = Obj("Gallery: glass, metal, coats, textures and many lamps", "gallery.mtl")
    obj.part("base", "base")
    obj.grids(lathe(profile([(0, 0, 0), (BASE_RADIUS, 0, 0), (BASE_RADIUS, BASE_TOP - 0.005, 0.02),
                             (0, BASE_TOP - 0.005, 0)]), 96))
    _solids(obj)
    _pictures(obj)
    _lamps(obj)
    return {"gallery.obj": obj, "gallery.mtl": MATERIALS, "gallery.json": SCENE, "gallery_tiles.png": _tiles(),
            "gallery_bumps.png": _picture(_bump), "gallery_holes.png": _picture(_hole),
            "gallery_screen.png": _screen(), "gallery_sky.hdr": _sky()}
