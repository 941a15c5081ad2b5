#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# write_see_through.py OUT
# Scenes that one sees through; tools/lab/see_through.sh bakes and measures them. The same bytes on every run. Beside each
# NAME.json lies NAME-bare.json, the same scene without what is see-through, but for `faint`, which is nothing else.
#   faint    a cube that covers a quarter of what is behind it
#   pane     a red cube behind a pane
#   bottle   a bottle of tinted glass with two sides, a label, a cap and something in it
#   car      a body with windows, and seats behind them
#   watch    hands and ticks under a flat crystal
import json
import math
import pathlib
import sys

from write_failures import PLAIN, Obj

GLASS = "Ks 0.5 0.5 0.5\nNi 1.5\nillum 2\n"


def lathe(obj, profile, sides=64):
    """Turns points (radius, height), from the top down, around the vertical axis."""
    def place(i, j):
        radius, height = profile[j]
        angle = 2 * math.pi * i / sides
        return [radius * math.cos(angle), height, -radius * math.sin(angle)]
    obj.grid(sides, len(profile) - 1, place, True)


def disc(obj, radius, height, sides=48):
    lathe(obj, [(0, height), (radius, height)], sides)


def faint(glass):
    obj = Obj("faint")
    obj.material("faint")
    obj.box([-1, -1, -1], [1, 1, 1])
    return obj, "newmtl faint\nKd 0.64 0.64 0.64\nKs 0.5 0.5 0.5\nNi 1.0\nd 0.25\nillum 2\n"


def pane(glass):
    obj = Obj("pane")
    obj.material("red")
    obj.box([-1, -1, -1], [1, 1, 1])
    if glass:
        obj.material("glass")
        obj.face([obj.vertex(p) for p in ([-1.5, -1.5, 1.5], [1.5, -1.5, 1.5], [1.5, 1.5, 1.5], [-1.5, 1.5, 1.5])])
    return obj, "newmtl red\nKd 0.8 0.05 0.05\nnewmtl glass\nKd 0.6 0.7 0.8\nd 0.3\nillum 2\n"


def bottle(glass):
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
    if glass:
        obj.material("glass", True)
        lathe(obj, outer)
        lathe(obj, list(reversed(inner)))
    return obj, ("newmtl cap\nKd 0.6 0.1 0.1\n" + PLAIN + "newmtl ball\nKd 0.8 0.6 0.2\nnewmtl paper\nKd 0.8 0.8 0.75\n"
                 "newmtl ink\nKd 0.1 0.1 0.4\nnewmtl glass\nKd 0.15 0.4 0.2\nd 0.35\n" + GLASS)


def car(glass):
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
    if glass:
        obj.material("glass")
        for corners in (([-1.05, 0.05, 0.58], [-0.75, 0.55, 0.58], [-0.75, 0.55, -0.58], [-1.05, 0.05, -0.58]),
                        ([0.95, 0.05, -0.58], [0.55, 0.55, -0.58], [0.55, 0.55, 0.58], [0.95, 0.05, 0.58]),
                        ([-1.05, 0.05, 0.58], [0.95, 0.05, 0.58], [0.55, 0.55, 0.58], [-0.75, 0.55, 0.58]),
                        ([0.95, 0.05, -0.58], [-1.05, 0.05, -0.58], [-0.75, 0.55, -0.58], [0.55, 0.55, -0.58])):
            obj.face([obj.vertex(p) for p in corners])
    return obj, ("newmtl paint\nKd 0.1 0.25 0.6\n" + PLAIN + "newmtl seat\nKd 0.6 0.3 0.15\nnewmtl tyre\nKd 0.03 0.03 0.03\n"
                 "newmtl glass\nKd 0.2 0.25 0.3\nd 0.3\n" + GLASS)


def watch(glass):
    obj = Obj("watch")
    obj.material("case", True)
    lathe(obj, [(0.80, 0.24), (0.95, 0.24), (1.0, 0.15), (1.0, -0.2), (0.9, -0.25), (0, -0.25)])
    lathe(obj, [(0.80, 0.0), (0.80, 0.24)])
    obj.material("face")
    disc(obj, 0.80, 0.0)
    obj.material("mark")

    def bar(angle, near, far, width, low, high):
        along, across = (math.cos(angle), -math.sin(angle)), (math.sin(angle), math.cos(angle))
        at = [obj.vertex([r * along[0] + s * across[0], y, r * along[1] + s * across[1]])
              for y in (low, high) for r in (near, far) for s in (-width / 2, width / 2)]
        for face in ((4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)):
            obj.face([at[k] for k in face])

    for hour in range(12):
        bar(hour * math.pi / 6, 0.64, 0.76, 0.06 if hour % 3 == 0 else 0.03, 0, 0.02)
    bar(0.9, -0.08, 0.42, 0.07, 0.05, 0.07)
    bar(2.4, -0.08, 0.62, 0.045, 0.09, 0.11)
    obj.material("second")
    bar(4.4, -0.15, 0.68, 0.02, 0.12, 0.13)
    if glass:
        obj.material("crystal")
        disc(obj, 0.80, 0.22)
    return obj, ("newmtl case\nKd 0.75 0.72 0.68\nPm 1\nPr 0.35\nnewmtl face\nKd 0.85 0.85 0.8\nnewmtl mark\nKd 0.05 0.05 0.08\n"
                 "newmtl second\nKd 0.8 0.1 0.05\nnewmtl crystal\nKd 0.3 0.3 0.3\nd 0.12\n" + GLASS)


def main(out):
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    for make in (faint, pane, bottle, car, watch):
        for name, glass in ((make.__name__, True), (make.__name__ + "-bare", False)):
            if make is faint and not glass:
                continue
            obj, materials = make(glass)
            obj.lines[0] = "mtllib %s.mtl" % name
            (folder / (name + ".mtl")).write_text(materials)
            (folder / (name + ".obj")).write_text("\n".join(obj.lines) + "\n")
            (folder / (name + ".json")).write_text(json.dumps({"objects": [{"obj": name + ".obj"}]}) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
