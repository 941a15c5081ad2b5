#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""balls.py LUMI OUT.png

Draws eight balls (matte, plastic, black plastic, rubber, gold, glass, coated paint, velvet) under a lamp of each kind by
`LUMI reference`: a row for a point, a ball of light, a spot, a square and a sun, which all bring the same light to the
middle of the row by the table of docs/blender.md. So the rows must be equally bright there, at one exposure.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.join(here, "..", "devices")]
from compare import sphere_points  # noqa: E402
import ball  # noqa: E402
from picture import read_png, write_png  # noqa: E402

MATERIALS = {
    "matte": "Kd 0.6 0.2 0.15",
    "plastic": "Kd 0.1 0.35 0.6\nKs 0.5 0.5 0.5\nPr 0.3",
    "black_plastic": "Kd 0 0 0\nKs 0.5 0.5 0.5\nNs 200\nillum 2",
    "rubber": "Kd 0.02 0.02 0.02\nKs 0.1 0.1 0.1\nNs 5\nillum 2",
    "gold": "Kd 1 0.77 0.34\nPm 1\nPr 0.2",
    "glass": "Kd 1 1 1\nNi 1.5\nillum 7",
    "coat": "Kd 0.1 0.3 0.1\nPr 0.6\nPc 1\nPcr 0.05",
    "velvet": "Kd 0.3 0.05 0.1\nPr 1\nPs 1",
}
SPACING = 2.3
PLACE = (0, 8, 6)  # of the lamp, in metres
DISTANCE = math.hypot(*PLACE)
IRRADIANCE = 50  # that each lamp brings to the middle of the row
POINT_WATTS = IRRADIANCE * 4 * math.pi * DISTANCE**2
SQUARE_WATTS = IRRADIANCE * 4 * DISTANCE**2
RADIUS, SIDE = 0.5, 1
STOPS = -3.3  # of exposure: what lumi chooses for the sun
LAMPS = [
    {"type": "point", "intensity": POINT_WATTS / (4 * math.pi)},
    {"type": "sphere", "radius": RADIUS, "radiance": POINT_WATTS / (4 * math.pi**2 * RADIUS**2)},
    {"type": "spot", "target": [0, 0, 0], "angle": 60, "inner_angle": 55, "intensity": POINT_WATTS / (4 * math.pi)},
    {"type": "rectangle", "target": [0, 0, 0], "size": [SIDE, SIDE], "radiance": SQUARE_WATTS / (4 * SIDE**2)},
    {"type": "directional", "direction": [-v for v in PLACE], "irradiance": IRRADIANCE},
]
VIEW = ["--size", "640x104", "--orbit", "0,14,3", "--fov", "36", "--spp", "32", "--background", "000000"]


def faces():
    """Of a ball, as indices of sphere_points()."""
    last = 1 + (ball.HEIGHTS - 1) * ball.SEGMENTS

    def index(h, s):
        return 0 if h == 0 else last if h == ball.HEIGHTS else 1 + (h - 1) * ball.SEGMENTS + s % ball.SEGMENTS

    for h in range(ball.HEIGHTS):
        for s in range(ball.SEGMENTS):
            yield dict.fromkeys([index(h, s), index(h, s + 1), index(h + 1, s + 1), index(h + 1, s)])


def row_text():
    points, corners = sphere_points(), list(faces())
    lines = ["mtllib balls.mtl"]
    for k, name in enumerate(MATERIALS):
        x = (k - (len(MATERIALS) - 1) / 2) * SPACING
        lines += [f"v {p[0] + x:.9g} {p[1]:.9g} {p[2]:.9g}\nvn {p[0]:.9g} {p[1]:.9g} {p[2]:.9g}" for p in points]
        lines.append(f"usemtl {name}")
        first = 1 + k * len(points)
        lines += ["f " + " ".join(f"{first + c}//{first + c}" for c in face) for face in corners]
    return "\n".join(lines) + "\n"


def draw(lumi, folder, lamp):
    light = {**lamp} if lamp["type"] == "directional" else {**lamp, "position": PLACE}
    scene = {
        "objects": [{"obj": "balls.obj"}],
        "ground": {"radius": 9.5, "height": -1, "material": {"colour": 0.4}},
        "environment": 0.1 * IRRADIANCE / math.pi,
        "lights": [light],
        "exposure": STOPS,
        "tone": "agx",
    }
    scene_file, picture = os.path.join(folder, "balls.json"), os.path.join(folder, "balls.png")
    with open(scene_file, "w") as out:
        json.dump(scene, out)
    result = subprocess.run([lumi, "reference", scene_file, "-o", picture, *VIEW], capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr)
    return read_png(picture)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "balls.mtl"), "w") as out:
            out.write("".join(f"newmtl {name}\n{text}\n" for name, text in MATERIALS.items()))
        with open(os.path.join(folder, "balls.obj"), "w") as out:
            out.write(row_text())
        rows = [draw(sys.argv[1], folder, lamp) for lamp in LAMPS]
    width = rows[0][0]
    write_png(sys.argv[2], width, sum(row[1] for row in rows), b"".join(row[2] for row in rows))


if __name__ == "__main__":
    main()
