#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py LUMI [--docs | --check]

Draws a ball of each material of docs/log/data/cycles.mtl by `LUMI reference` and compares what it sends back with what
Cycles says (docs/log/data/cycles.json, which cycles.py writes where Blender is installed). Prints the tables; --docs
also writes docs/log/data/materials.json and the pages; --check draws small pictures and ends with 1 where a material is
not as figures/materials.py wants it.
"""
import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.dirname(here), os.path.join(here, "..", "devices")]
import ball  # noqa: E402
import pages  # noqa: E402
from figures import materials  # noqa: E402
from figures.table import DATA, load, save, shown  # noqa: E402
from picture import read_png  # noqa: E402

SAMPLES = {"sky": 256, "sun": 64}
QUICK_SIZE_PX, QUICK_SAMPLES = 40, {"sky": 64}
STOPS = -1  # of exposure: a picture holds radiance up to 2
LIGHTS = {
    "sky": {"environment": 1},
    "sun": {
        "environment": "black",
        "lights": [{"type": "directional", "direction": [0, -1, -1], "irradiance": ball.SUN_IRRADIANCE}],
    },
}


def sphere_points():
    """From pole to pole: positions that are their own normals."""
    points = [(0.0, 1.0, 0.0)]
    for h in range(1, ball.HEIGHTS):
        polar = math.pi * h / ball.HEIGHTS
        for s in range(ball.SEGMENTS):
            turn = 2 * math.pi * s / ball.SEGMENTS
            points.append((math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn)))
    return points + [(0.0, -1.0, 0.0)]


def ball_text():
    """As an OBJ, but for its material."""
    points = sphere_points()

    def index(h, s):
        inner = 2 + (h - 1) * ball.SEGMENTS + s % ball.SEGMENTS
        return 1 if h == 0 else len(points) if h == ball.HEIGHTS else inner

    lines = ["v %.9g %.9g %.9g\nvn %.9g %.9g %.9g" % (p + p) for p in points]
    for h in range(ball.HEIGHTS):
        for s in range(ball.SEGMENTS):
            corners = dict.fromkeys([index(h, s), index(h, s + 1), index(h + 1, s + 1), index(h + 1, s)])
            lines.append("f " + " ".join(f"{c}//{c}" for c in corners))
    return "\n".join(lines) + "\n"


def linear(byte):
    v = byte / 255
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


LINEAR = [linear(byte) / 2**STOPS for byte in range(256)]


def draw(lumi, folder, light, size, samples):
    """Ring means of the ball that `folder` holds, in red light."""
    margin = ball.HALF_WIDTH
    scene = {"objects": [{"obj": "ball.obj"}], "sphere": {"centre": [0, 0, 0], "radius": margin}, "exposure": STOPS}
    scene_file, picture = os.path.join(folder, "ball.json"), os.path.join(folder, "ball.png")
    with open(scene_file, "w") as out:
        json.dump({**scene, **LIGHTS[light]}, out)
    view = ["--size", f"{size}x{size}", "--orbit", f"0,0,{ball.DISTANCE / margin}"]
    view += ["--fov", str(math.degrees(ball.FOV_RADIANS)), "--spp", str(samples)]
    result = subprocess.run([lumi, "reference", scene_file, "-o", picture, *view], capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr)
    width, _, rgb = read_png(picture)
    return ball.ring_means(lambda x, y: LINEAR[rgb[3 * (y * width + x)]], size)


def measure(lumi, size, samples):
    rows, shape = [], ball_text()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(DATA / "cycles.mtl", folder)
        for name in (row["name"] for row in load("cycles")["materials"]):
            with open(os.path.join(folder, "ball.obj"), "w") as out:
                out.write(f"mtllib cycles.mtl\nusemtl {name.replace(' ', '_')}\n{shape}")
            rows.append({"name": name})
            for light, count in samples.items():
                rows[-1][light] = [round(mean, 5) for mean in draw(lumi, folder, light, size, count)]
    return {"materials": rows}


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("lumi")
    parser.add_argument("--docs", action="store_true")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    quick = (QUICK_SIZE_PX, QUICK_SAMPLES)
    shown["materials"] = measure(arguments.lumi, *(quick if arguments.check else (ball.SIZE_PX, SAMPLES)))
    print(materials.coloured().markdown(), materials.white().markdown(), sep="\n")
    if arguments.docs:
        save("materials", shown["materials"])
        pages.write_pages()
    if arguments.check and materials.wrong():
        sys.exit("too far from Cycles, or brighter than the light that arrives: " + ", ".join(materials.wrong()))


if __name__ == "__main__":
    main()
