# SPDX-License-Identifier: MIT
"""The Cornell box.

Geometry: the published measurements of the Cornell Program of Computer Graphics ("Cornell Box Data",
https://www.graphics.cornell.edu/online/box/data.html), in their units. Reflectances and the lamp's emission: the usual
linear RGB renditions of the measured spectra given there, as in Bitterli's Tungsten scene and many others.
"""
from mesh import Corner, Obj

CEILING = 548.8
# Corners of the lamp and of the ceiling as (x, z), in the same turn. The lamp lies in the ceiling's plane: the ceiling
# leaves a hole for it, and a housing above, which is ours, keeps its light from the outside.
LAMP = ((343, 227), (343, 332), (213, 332), (213, 227))
CEILING_EDGE = ((556, 0), (556, 559.2), (0, 559.2), (0, 0))
HOUSING_HEIGHT = 15

MATERIALS = """# SPDX-License-Identifier: MIT
# Linear RGB renditions of the measured Cornell box spectra.
newmtl white
Kd 0.725 0.71 0.68

newmtl red
Kd 0.63 0.065 0.05

newmtl green
Kd 0.14 0.45 0.091

newmtl lamp
Kd 0.78 0.78 0.78
Ke 17 12 4
"""


def _at(corners, height):
    return tuple((x, height, z) for x, z in corners)


def _band(low, high):
    """The quads between two closed loops of corners."""
    return tuple(zip(low, low[1:] + low[:1], high[1:] + high[:1], high))


_lamp, _housing_top = _at(LAMP, CEILING), _at(LAMP, CEILING + HOUSING_HEIGHT)

# name, material, faces of four (x, y, z) corners; the box opens towards -z.
PARTS = (
    ("floor", "white", (((552.8, 0, 0), (0, 0, 0), (0, 0, 559.2), (549.6, 0, 559.2)),)),
    ("ceiling", "white", _band(_at(CEILING_EDGE, CEILING), _lamp)),
    ("back_wall", "white", (((549.6, 0, 559.2), (0, 0, 559.2), (0, 548.8, 559.2), (556, 548.8, 559.2)),)),
    ("right_wall", "green", (((0, 0, 559.2), (0, 0, 0), (0, 548.8, 0), (0, 548.8, 559.2)),)),
    ("left_wall", "red", (((552.8, 0, 0), (549.6, 0, 559.2), (556, 548.8, 559.2), (556, 548.8, 0)),)),
    ("short_block", "white", (
        ((130, 165, 65), (82, 165, 225), (240, 165, 272), (290, 165, 114)),
        ((290, 0, 114), (290, 165, 114), (240, 165, 272), (240, 0, 272)),
        ((130, 0, 65), (130, 165, 65), (290, 165, 114), (290, 0, 114)),
        ((82, 0, 225), (82, 165, 225), (130, 165, 65), (130, 0, 65)),
        ((240, 0, 272), (240, 165, 272), (82, 165, 225), (82, 0, 225)))),
    ("tall_block", "white", (
        ((423, 330, 247), (265, 330, 296), (314, 330, 456), (472, 330, 406)),
        ((423, 0, 247), (423, 330, 247), (472, 330, 406), (472, 0, 406)),
        ((472, 0, 406), (472, 330, 406), (314, 330, 456), (314, 0, 456)),
        ((314, 0, 456), (314, 330, 456), (265, 330, 296), (265, 0, 296)),
        ((265, 0, 296), (265, 330, 296), (423, 330, 247), (423, 0, 247)))),
    ("lamp", "lamp", (_lamp,)),
    ("lamp_housing", "white", _band(_lamp, _housing_top) + (_housing_top,)),
)


def files():
    obj = Obj("The Cornell box, from the published measurements", "cornell.mtl")
    for name, material, faces in PARTS:
        obj.part(name, material)
        for face in faces:
            obj.face([Corner(point) for point in face])
    return {"cornell.obj": obj, "cornell.mtl": MATERIALS}
