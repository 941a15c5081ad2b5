#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# write_features.py OUT
# Pairs of scenes that differ in one property alone; tools/lab/proof/features.py measures what each property adds. The same
# bytes on every run. Beside each NAME.json lies NAME-bare.json, the same scene without the property.
#   gloss        a ball on a block, polished or matt
#   texture      the same, with a picture on the block or plain
#   see_through  the same, behind a pane or not
#   cut_outs     a sheet, with holes that a picture cuts or whole
#   sides        the same sheet; baked from all around or from above alone, where it has one side
#   volume       the ball and the block, in fog or not
import json
import math
import pathlib
import struct
import sys

from write_failures import Obj, encode16

WHITE, BLACK, RED, BLUE = (255, 255, 255), (0, 0, 0), (180, 60, 40), (40, 80, 170)
PICTURE_PX = 64


def thing():
    obj = Obj("thing")
    obj.material("ball", True)
    obj.ball((0, 0.1, 0), 0.5, 48)
    obj.material("block")
    for square in (((-0.6, 0.6), (0.6, 0.6), (0.6, -0.6), (-0.6, -0.6)),):
        top = [obj.vertex((x, -0.4, z)) for x, z in square]
        low = [obj.vertex((x, -0.7, z)) for x, z in square]
    places = [obj.coordinate(u, v) for u, v in ((0, 0), (1, 0), (1, 1), (0, 1))]
    obj.face(top, places)
    obj.face(low[::-1], places)
    for k in range(4):
        n = (k + 1) % 4
        obj.face([low[k], low[n], top[n], top[k]], places)
    return obj


def sheet():
    obj, cells = Obj("sheet"), 24
    obj.material("sheet", True)

    def place(i, j):
        x, z = 1.6 * i / cells - 0.8, 1.6 * j / cells - 0.8
        return x, 0, z

    corners = [[(obj.vertex(place(i, j)), obj.coordinate(i / cells, j / cells)) for i in range(cells + 1)]
               for j in range(cells + 1)]
    for j in range(cells):
        for i in range(cells):
            quad = corners[j][i], corners[j + 1][i], corners[j + 1][i + 1], corners[j][i + 1]
            obj.face([c[0] for c in quad], [c[1] for c in quad])
    return obj


MATT = "newmtl ball\nKd 0.6 0.2 0.1\nKs 0 0 0\nnewmtl block\nKd 0.5 0.5 0.5\nKs 0 0 0\n"
SHEET = "newmtl sheet\nKd 0.5 0.6 0.3\nKs 0 0 0\n"


def gloss(is_there):
    return thing(), MATT.replace("Kd 0.6 0.2 0.1\nKs 0 0 0", "Kd 0.6 0.2 0.1\nKs 0.8 0.8 0.8\nNs 120") if is_there else MATT


def texture(is_there):
    return thing(), MATT + "map_Kd colours.png\n" if is_there else MATT


def see_through(is_there):
    obj, materials = thing(), MATT
    if is_there:
        obj.material("pane")
        obj.face([obj.vertex((x, y, 0.75)) for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))])
        materials += "newmtl pane\nKd 0.3 0.4 0.5\nKs 0 0 0\nd 0.4\n"
    return obj, materials


def cut_outs(is_there):
    return sheet(), SHEET + "map_d holes.png\n" if is_there else SHEET


def sides(_):
    return sheet(), SHEET


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
    folder.joinpath("holes.png").write_bytes(encode16([BLACK, WHITE], picture(
        lambda x, y: int((x % 32 - 15.5) ** 2 + (y % 32 - 15.5) ** 2 > 90))))
    write_fog(folder / "fog.nii")


def main(out):
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    write_pictures(folder)
    for name, make in (("gloss", gloss), ("texture", texture), ("see_through", see_through), ("cut_outs", cut_outs),
                       ("sides", sides), ("volume", lambda _: (thing(), MATT))):
        for is_there in (True, False):
            full = name if is_there else name + "-bare"
            obj, materials = make(is_there)
            obj.lines[0] = "mtllib %s.mtl" % full
            folder.joinpath(full + ".obj").write_text("\n".join(obj.lines) + "\n")
            folder.joinpath(full + ".mtl").write_text(materials)
            scene = {"objects": [{"obj": full + ".obj"}], "environment": {"zenith": 1.0, "horizon": 0.6, "nadir": 0.2}}
            if name == "volume" and is_there:
                scene["volume"] = {"file": "fog.nii", "transfer": [{"value": 0, "density": 0, "colour": [0.9, 0.9, 0.9]},
                                                                  {"value": 1, "density": 2, "colour": [0.9, 0.9, 0.9]}]}
            folder.joinpath(full + ".json").write_text(json.dumps(scene, indent=1) + "\n")


if __name__ == "__main__":
    main(sys.argv[1])
