#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""write_scenes.py OUT

Writes small scenes that show one property each, for measurements and soaks. Every run writes the same bytes.
  pane       a red cube behind a pane
  bottle     a bottle of tinted glass with two sides, a label, a cap and something in it
  car        a body with windows, and seats behind them
  texture    a ball on a block with a picture
  volume     a ball on a block, in fog
"""
import json
import math
import pathlib
import struct
import sys

from png import encode16

PLAIN = "Ks 0.5 0.5 0.5\nNi 1.5\n"
GLASS = "Ks 0.5 0.5 0.5\nNi 1.5\nillum 2\n"
RED, BLUE = (180, 60, 40), (40, 80, 170)
PICTURE_PX = 64
SKY = {"zenith": 1.0, "horizon": 0.6, "nadir": 0.2}


class Obj:
    """Lines of an OBJ file; corners are counted from 0, texture coordinates are optional."""

    def __init__(self, name):
        self.lines = ["mtllib %s.mtl" % name]
        self.vertices = self.coordinates = 0

    def material(self, name, smooth=False):
        self.lines += ["usemtl " + name, "s " + ("1" if smooth else "off")]

    def vertex(self, p):
        self.lines.append("v %.5f %.5f %.5f" % tuple(p))
        self.vertices += 1
        return self.vertices

    def coordinate(self, u, v):
        self.lines.append("vt %.5f %.5f" % (u, v))
        self.coordinates += 1
        return self.coordinates

    def face(self, corners, coordinates=None):
        if coordinates is None:
            self.lines.append("f " + " ".join(str(c) for c in dict.fromkeys(corners)))
        else:
            self.lines.append("f " + " ".join("%d/%d" % pair for pair in zip(corners, coordinates)))

    def box(self, low, high):
        at = [self.vertex([(low, high)[k >> a & 1][a] for a in range(3)]) for k in range(8)]
        for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)):
            self.face([at[k] for k in face])

    def grid(self, columns, rows, place, closed=False):
        """A surface place(i, j) of columns × rows cells; closed: the last column is the first; ends may be points."""
        wide = columns if closed else columns + 1
        at = [self.row([place(i, j) for i in range(wide)]) for j in range(rows + 1)]
        for j in range(rows):
            for i in range(columns):
                k = (i + 1) % wide
                self.face([at[j][i], at[j][k], at[j + 1][k], at[j + 1][i]])

    def row(self, points):
        if points[0] == points[len(points) // 2]:
            return [self.vertex(points[0])] * len(points)
        return [self.vertex(p) for p in points]

    def ball(self, centre, radius, sides=96):
        rings = sides // 2

        def place(i, j):
            a, b = math.pi * j / rings, 2 * math.pi * i / sides
            across = 0 if j in (0, rings) else math.sin(a)
            unit = (across * math.sin(b), -math.cos(a), across * math.cos(b))
            return [c + radius * u for c, u in zip(centre, unit)]

        self.grid(sides, rings, place, True)


def lathe(obj, profile, sides=64):
    """Turns points (radius, height), from the top down, around the vertical axis."""
    def place(i, j):
        radius, height = profile[j]
        angle = 2 * math.pi * i / sides
        return [radius * math.cos(angle), height, -radius * math.sin(angle)]
    obj.grid(sides, len(profile) - 1, place, True)


def pane():
    obj = Obj("pane")
    obj.material("red")
    obj.box([-1, -1, -1], [1, 1, 1])
    obj.material("glass")
    obj.face([obj.vertex(p) for p in ([-1.5, -1.5, 1.5], [1.5, -1.5, 1.5], [1.5, 1.5, 1.5], [-1.5, 1.5, 1.5])])
    return obj, "newmtl red\nKd 0.8 0.05 0.05\nnewmtl glass\nKd 0.6 0.7 0.8\nd 0.3\nillum 2\n"


def bottle():
    outer = [(0.12, 1.05), (0.13, 0.75), (0.20, 0.60), (0.36, 0.40), (0.42, 0.20), (0.42, -0.90), (0.38, -1.0), (0, -1.0)]
    inner = [(0.09, 1.05), (0.10, 0.74), (0.17, 0.58), (0.33, 0.38), (0.39, 0.19), (0.39, -0.88), (0.36, -0.96), (0, -0.96)]
    obj = Obj("bottle")
    obj.material("cap", True)
    lathe(obj, [(0, 1.16), (0.15, 1.16), (0.15, 1.0)])
    obj.material("ball", True)
    obj.ball([0, -0.62, 0], 0.26, 40)

    def label(i, j):
        angle = 2 * math.pi * i / 48
        return [0.427 * math.cos(angle), -0.05 - 0.6 * j / 8, -0.427 * math.sin(angle)]

    for ink in (0, 1):
        obj.material("ink" if ink else "paper")
        for j in range(8):
            for i in range(26):
                if ((i // 2 + j // 2) % 3 == 0) == bool(ink):
                    corners = ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))
                    obj.face([obj.vertex(label(*c)) for c in corners])
    obj.material("glass", True)
    lathe(obj, outer)
    lathe(obj, list(reversed(inner)))
    return obj, ("newmtl cap\nKd 0.6 0.1 0.1\n" + PLAIN + "newmtl ball\nKd 0.8 0.6 0.2\nnewmtl paper\nKd 0.8 0.8 0.75\n"
                 "newmtl ink\nKd 0.1 0.1 0.4\nnewmtl glass\nKd 0.15 0.4 0.2\nd 0.35\n" + GLASS)


def car():
    obj = Obj("car")
    obj.material("paint")
    obj.box([-1.6, -0.45, -0.7], [1.6, 0.05, 0.7])
    obj.box([-0.75, 0.55, -0.6], [0.55, 0.62, 0.6])
    for x, top in ((-1.05, -0.75), (0.95, 0.55)):
        for z in (-0.62, 0.54):
            low, high = [x, 0.05, z], [top, 0.55, z]
            width = 0.08
            ring = [obj.vertex([p[0] + dx, p[1], p[2] + dz]) for p in (low, high) for dx in (-width / 2, width / 2)
                    for dz in (0, width)]
            for face in ((0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)):
                obj.face([ring[k] for k in face])
    obj.material("seat")
    for x in (-0.6, 0.1):
        for z in (-0.35, 0.35):
            obj.box([x, 0.05, z - 0.2], [x + 0.4, 0.15, z + 0.2])
            obj.box([x - 0.08, 0.1, z - 0.2], [x, 0.45, z + 0.2])
    obj.material("tyre", True)
    for x in (-1.0, 1.0):
        for side in (-1, 1):
            def tyre(i, j):
                angle, z = 2 * math.pi * i / 32, side * (0.72 + 0.1 * min(j, 1))
                radius = 0.3 if j < 2 else 0
                return [x + radius * math.cos(angle), -0.45 + radius * math.sin(angle) * side, z]
            obj.grid(32, 2, tyre, True)
    obj.material("glass")
    for corners in (([-1.05, 0.05, 0.58], [-0.75, 0.55, 0.58], [-0.75, 0.55, -0.58], [-1.05, 0.05, -0.58]),
                    ([0.95, 0.05, -0.58], [0.55, 0.55, -0.58], [0.55, 0.55, 0.58], [0.95, 0.05, 0.58]),
                    ([-1.05, 0.05, 0.58], [0.95, 0.05, 0.58], [0.55, 0.55, 0.58], [-0.75, 0.55, 0.58]),
                    ([0.95, 0.05, -0.58], [-1.05, 0.05, -0.58], [-0.75, 0.55, -0.58], [0.55, 0.55, -0.58])):
        obj.face([obj.vertex(p) for p in corners])
    return obj, ("newmtl paint\nKd 0.1 0.25 0.6\n" + PLAIN + "newmtl seat\nKd 0.6 0.3 0.15\nnewmtl tyre\nKd 0.03 0.03 0.03\n"
                 "newmtl glass\nKd 0.2 0.25 0.3\nd 0.3\n" + GLASS)


def thing():
    obj = Obj("thing")
    obj.material("ball", True)
    obj.ball((0, 0.1, 0), 0.5, 48)
    obj.material("block")
    square = ((-0.6, 0.6), (0.6, 0.6), (0.6, -0.6), (-0.6, -0.6))
    top = [obj.vertex((x, -0.4, z)) for x, z in square]
    low = [obj.vertex((x, -0.7, z)) for x, z in square]
    places = [obj.coordinate(u, v) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))]
    obj.face(top, places)
    obj.face(low[::-1], places)
    for k in range(4):
        n = (k + 1) % 4
        obj.face([low[k], low[n], top[n], top[k]], places)
    return obj


def write_fog(path):
    """NIfTI-1: 16³ values, denser in the middle."""
    side, half = 16, 0.85
    step = 2 * half / side
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, side, side, side, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 16, 32)  # float32
    struct.pack_into("<8f", header, 76, 1, step, step, step, 1, 1, 1, 1)
    struct.pack_into("<2f", header, 108, 352, 1)
    struct.pack_into("<2h", header, 252, 0, 1)
    for axis in range(3):
        row = [0.0] * 4
        row[axis], row[3] = step, step / 2 - half
        struct.pack_into("<4f", header, 280 + 16 * axis, *row)
    header[344:348] = b"n+1\0"

    def value(k):
        place = (k % side, k // side % side, k // side // side)
        return max(0.0, 1 - math.dist(place, (7.5, 7.5, 7.5)) / 8)

    path.write_bytes(bytes(header) + struct.pack("<%df" % side ** 3, *map(value, range(side ** 3))))


def write_pictures(folder):
    def picture(of):
        return [[of(x, y) for x in range(PICTURE_PX)] for y in range(PICTURE_PX)]
    folder.joinpath("colours.png").write_bytes(encode16([RED, BLUE], picture(lambda x, y: (x // 8 + y // 8) % 2)))
    write_fog(folder / "fog.nii")


MATT = "newmtl ball\nKd 0.6 0.2 0.1\nKs 0 0 0\nnewmtl block\nKd 0.5 0.5 0.5\nKs 0 0 0\n"
FOG = {"file": "fog.nii", "transfer": [{"value": value, "density": density, "colour": [0.9, 0.9, 0.9]}
                                       for value, density in ((0, 0), (1, 2))]}


def scenes():
    """For each scene its name, what `Obj` wrote, its materials and more members of its JSON."""
    for make in (pane, bottle, car):
        yield make.__name__, *make(), {}
    yield "texture", thing(), MATT + "map_Kd colours.png\n", {"environment": SKY}
    yield "volume", thing(), MATT, {"environment": SKY, "volume": FOG}


def main(out):
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    write_pictures(folder)
    for name, obj, materials, more in scenes():
        obj.lines[0] = f"mtllib {name}.mtl"
        (folder / f"{name}.obj").write_text("\n".join(obj.lines) + "\n")
        (folder / f"{name}.mtl").write_text(materials)
        (folder / f"{name}.json").write_text(json.dumps({"objects": [{"obj": f"{name}.obj"}], **more}, indent=1) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
