#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# write_failures.py OUT
# Scenes that a mesh with a few thousand triangles and tables of 40 directions finds hard; tools/lab/failure_scenes.sh bakes
# and draws them. The same bytes on every run.
#   wires    three cubes of thin bars, one in the other
#   plant    leaves cut out of rectangles by pictures (map_d), in a pot
#   mirror   a ball of chromium on chequers
#   glass    a glass ball above chequers
#   mouth    a head with an open mouth and teeth: a deep cavity that few rays enter
#   terrain  a knot on a noisy ground of a million triangles
#   curtain  a folded cloth with a lamp behind it: one side is bright, the other one dark
import json
import math
import pathlib
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "baker/scenes/generate"))
from png import encode16  # noqa: E402

PLAIN = "Ks 0.5 0.5 0.5\nNi 1.5\n"


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

    def chequers(self, side, height, cells):
        step = 2 * side / cells
        for colour in ("light", "dark"):
            self.material(colour)
            for j in range(cells):
                for i in range(cells):
                    if (i + j) % 2 == (colour == "dark"):
                        x, z = -side + i * step, -side + j * step
                        square = ((x, z), (x, z + step), (x + step, z + step), (x + step, z))
                        self.face([self.vertex((a, height, b)) for a, b in square])


def wires():
    obj = Obj("wires")
    for size, thick, colour in ((1, 0.012, "red"), (0.62, 0.008, "white"), (0.3, 0.005, "blue")):
        obj.material(colour)
        for axis in range(3):
            for k in range(4):
                low, high = [0] * 3, [0] * 3
                for other, sign in (((axis + 1) % 3, k & 1), ((axis + 2) % 3, k >> 1)):
                    middle = size if sign else -size
                    low[other], high[other] = middle - thick, middle + thick
                low[axis], high[axis] = -size - thick, size + thick
                obj.box(low, high)
    return obj, "".join("newmtl %s\nKd %s\nPr 0.5\n%s" % (name, colour, PLAIN) for name, colour in
                        (("red", "0.7 0.1 0.08"), ("white", "0.8 0.8 0.8"), ("blue", "0.1 0.2 0.7")))


LEAF_PX = 128


LEAF_COLOURS = [(0, 0, 0), (255, 255, 255), (110, 150, 60), (40, 100, 36), (40, 116, 36), (40, 132, 36), (40, 148, 36)]


def leaf(x, y):
    """Whether a lobed leaf with veins covers the point, and the place of its colour in the palette."""
    u, v = 2 * x / (LEAF_PX - 1) - 1, 1 - y / (LEAF_PX - 1)
    half = 0.9 * math.sin(math.pi * v) ** 0.7 * (0.75 + 0.25 * math.cos(22 * v)) if 0 < v < 1 else 0
    is_vein = abs(u) < 0.04 or abs((v * 9 + abs(u) * 4) % 1 - 0.5) < 0.06
    return abs(u) < max(half, 0.03), 2 if is_vein else 3 + int(3.99 * v)


def leaf_pictures():
    """Colour and cut-out."""
    texels = [[leaf(x, y) for x in range(LEAF_PX)] for y in range(LEAF_PX)]
    yield "plant_leaf.png", encode16(LEAF_COLOURS, [[t[1] for t in row] for row in texels])
    yield "plant_cut.png", encode16(LEAF_COLOURS, [[int(t[0]) for t in row] for row in texels])


def plant():
    obj, rng = Obj("plant"), random.Random(2)
    obj.material("pot", True)
    profile = ((0, -1), (0.34, -1), (0.45, -0.35), (0.38, -0.35), (0.36, -0.45), (0, -0.45))

    def turned(i, j):
        radius, turn = profile[j][0], 2 * math.pi * i / 48
        return radius * math.sin(turn), profile[j][1], radius * math.cos(turn)

    obj.grid(48, len(profile) - 1, turned, True)
    obj.material("leaf")
    for k in range(42):
        turn, rise = 2.399963 * k, 0.15 + 1.2 * (k / 42)
        lean, length, width = rng.uniform(0.35, 1.0), rng.uniform(0.5, 0.75), 0.2
        along = (math.sin(turn) * lean, 1 - lean, math.cos(turn) * lean)
        side = (math.cos(turn), 0, -math.sin(turn))
        strip = []
        for step in range(5):
            s = step / 4
            middle = [a * length * s for a in along]
            middle[1] += -0.45 + rise * 0.6 - 0.5 * lean * s * s
            strip.append([(obj.vertex([m + sign * width * e for m, e in zip(middle, side)]),
                           obj.coordinate((sign + 1) / 2, s)) for sign in (-1, 1)])
        for (a, b), (c, d) in zip(strip, strip[1:]):
            obj.face([a[0], b[0], d[0], c[0]], [a[1], b[1], d[1], c[1]])
    return obj, ("newmtl pot\nKd 0.5 0.2 0.1\nPr 0.6\n" + PLAIN +
                 "newmtl leaf\nmap_Kd plant_leaf.png\nmap_d plant_cut.png\nPr 0.4\n" + PLAIN)


CHEQUERS = "".join("newmtl %s\nKd %s\nPr 0.5\n%s" % (n, c, PLAIN) for n, c in
                   (("light", "0.75 0.73 0.68"), ("dark", "0.05 0.09 0.16")))


def mirror():
    obj = Obj("mirror")
    obj.chequers(1.2, -0.7, 12)
    obj.material("mirror", True)
    obj.ball((0, 0, 0), 0.7)
    return obj, CHEQUERS + "newmtl mirror\nKd 0 0 0\nKs 0.55 0.55 0.55\nPr 0\nPm 1\n"


def glass():
    obj = Obj("glass")
    obj.chequers(1.2, -0.9, 12)
    obj.material("glass", True)
    obj.ball((0, 0, 0), 0.7)
    return obj, CHEQUERS + "newmtl glass\nKd 0 0 0\nTf 1 1 1\nNi 1.5\nillum 7\n"


def soft(x):
    x = min(1, max(0, x))
    return x * x * (3 - 2 * x)


def head_radius(x, y, z):
    """The head's radius in that direction, and how far in the mouth that is: a cavity down to a third of the radius."""
    if z <= 0:
        return 0.86 + 0.14 * y, 0
    inside = soft(1.6 - (x / 0.24) ** 2 - ((y + 0.36) / 0.13) ** 2)
    nose = 0.16 * math.exp(-(x / 0.12) ** 2 - ((y - 0.03) / 0.17) ** 2)
    eyes = sum(math.exp(-((x - s) / 0.11) ** 2 - ((y - 0.28) / 0.08) ** 2) for s in (-0.33, 0.33))
    return (0.86 + 0.14 * y) * (1 + nose - 0.07 * eyes) * (1 - 0.68 * inside), inside


def mouth():
    obj, sides, rings = Obj("mouth"), 320, 200
    rows, is_inner = [], []
    for j in range(rings + 1):
        points = []
        for i in range(sides):
            a, b = math.pi * j / rings, 2 * math.pi * i / sides
            across = 0 if j in (0, rings) else math.sin(a)
            d = (across * math.sin(b), -math.cos(a), across * math.cos(b))
            radius, inside = head_radius(*d)
            points.append([0.85 * radius * d[0], 1.1 * radius * d[1], radius * d[2]])
            is_inner.append(inside > 0.5)
        rows.append(obj.row(points))
    for gums in (False, True):
        obj.material("gums" if gums else "skin", True)
        for j in range(rings):
            for i in range(sides):
                if is_inner[j * sides + i] == gums:
                    k = (i + 1) % sides
                    obj.face([rows[j][i], rows[j][k], rows[j + 1][k], rows[j + 1][i]])
    obj.material("teeth")
    for y in (-0.245, -0.425):
        for k in range(-3, 4):
            x, z = 0.05 * k, 0.7 - 1.1 * (0.05 * k) ** 2
            obj.box((x - 0.021, y - 0.03, z - 0.03), (x + 0.021, y + 0.03, z + 0.03))
    return obj, ("newmtl skin\nKd 0.6 0.36 0.26\nPr 0.5\n" + PLAIN + "newmtl gums\nKd 0.4 0.05 0.06\nPr 0.3\n" + PLAIN +
                 "newmtl teeth\nKd 0.8 0.78 0.7\nPr 0.2\n" + PLAIN)


def terrain():
    obj, rng, side = Obj("terrain"), random.Random(5), 708
    waves = [(rng.uniform(2, 60), rng.uniform(0, 2 * math.pi), rng.uniform(0, 2 * math.pi)) for _ in range(40)]
    turns = [(f * math.cos(t), f * math.sin(t), p, 0.12 / f) for f, t, p in waves]

    def ground(i, j):
        x, z = 2.4 * j / side - 1.2, 2.4 * i / side - 1.2
        y = sum(h * math.sin(a * x + b * z + p) for a, b, p, h in turns)
        return x, y - 0.6 + rng.uniform(-0.003, 0.003), z

    def knot(i, j):
        t, s = 2 * math.pi * i / 400, 2 * math.pi * j / 24
        middle = lambda t: [0.3 * (2 + math.cos(3 * t)) * math.cos(2 * t), 0.35 * math.sin(3 * t) + 0.25,
                            0.3 * (2 + math.cos(3 * t)) * math.sin(2 * t)]
        p, q = middle(t), middle(t + 1e-3)
        along = [b - a for a, b in zip(p, q)]
        length = math.hypot(*along)
        along = [a / length for a in along]
        level = math.hypot(along[0], along[2])
        right = [along[2] / level, 0, -along[0] / level]
        up = [along[1] * right[2] - along[2] * right[1], along[2] * right[0] - along[0] * right[2],
              along[0] * right[1] - along[1] * right[0]]
        return [m + 0.13 * (math.cos(s) * a + math.sin(s) * b) for m, a, b in zip(p, right, up)]

    obj.material("ground", True)
    obj.grid(side, side, ground)
    obj.material("knot", True)
    obj.grid(400, 24, knot, True)
    return obj, "newmtl ground\nKd 0.3 0.26 0.2\nPr 0.9\n" + PLAIN + "newmtl knot\nKd 0.1 0.3 0.5\nPr 0.15\n" + PLAIN


def curtain():
    obj = Obj("curtain")
    obj.material("cloth", True)
    fold = lambda i, j: [i / 60 - 0.8, 0.9 - 1.8 * j / 12, 0.12 * math.sin(i / 96 * 12 * math.pi) * (0.6 + 0.4 * j / 12)]
    obj.grid(96, 12, fold)
    return obj, "newmtl cloth\nKd 0.7 0.6 0.5\nKs 0 0 0\n"


LIGHTS = {
    "curtain": {"environment": "black", "exposure": 0,
                "lights": [{"type": "rectangle", "position": [0, 0.5, -3], "target": [0, 0, 0], "size": [2, 2],
                            "radiance": 8}]},
}


def main(out):
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in leaf_pictures():
        (folder / name).write_bytes(content)
    for make in (wires, plant, mirror, glass, mouth, terrain, curtain):
        name = make.__name__
        obj, materials = make()
        (folder / (name + ".mtl")).write_text(materials)
        (folder / (name + ".obj")).write_text("\n".join(obj.lines) + "\n")
        scene = {"objects": [{"obj": name + ".obj"}], **LIGHTS.get(name, {})}
        (folder / (name + ".json")).write_text(json.dumps(scene) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
