#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare.py LUMI

Draws a small ball of each material of cycles.mtl by `LUMI reference`, and compares what it sends back in a white sky with
what Cycles of Blender 3.4.1 says (cycles.json; commit f9ad7b27 has the script for Blender). The ball has radius 1, is seen
from far away and stands in a white sky of radiance 1. Prints a line for each material, and ends with 1 where a white one
sends back more than arrives, or another one differs from Cycles by more than its limit.
"""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "..", "devices"))
from picture import read_png  # noqa: E402

SIZE_PX, SAMPLES = 40, 64
DISTANCE = 20  # the eye is so far from the centre
HALF_WIDTH = 1.05  # that the picture shows of the plane through the centre
FOV_RADIANS = 2 * math.asin(HALF_WIDTH / DISTANCE)
SEGMENTS, HEIGHTS = 128, 64  # around the axis and from pole to pole
RINGS = 8
OUTERMOST = 0.95  # squared distance; pixels further out may show what is behind
LIMIT = 0.03  # how far from Cycles, as a share of the mean
WHITE_GAIN = 0.01  # how much more than arrives a white material may send back
MULTI = " multi"  # here Cycles lets light leave a material's facets after more than one bounce
# Materials with another limit, and why.
LIMITS = {
    "coat metal": 0.05,  # Cycles loses 4 % of what is under a coat, in the sky only
    "metal 0.9 1 multi": 0.06,  # we estimate what bounces twice (Kulla & Conty)
}
STOPS = -1  # exposure, so that a picture holds radiance up to 2


def sphere_points():
    """From pole to pole: positions that are their own normals."""
    points = [(0.0, 1.0, 0.0)]
    for h in range(1, HEIGHTS):
        polar = math.pi * h / HEIGHTS
        for s in range(SEGMENTS):
            turn = 2 * math.pi * s / SEGMENTS
            points.append((math.sin(polar) * math.cos(turn), math.cos(polar), math.sin(polar) * math.sin(turn)))
    return points + [(0.0, -1.0, 0.0)]


def ball_text():
    """As an OBJ, but for its material."""
    points = sphere_points()

    def index(h, s):
        inner = 2 + (h - 1) * SEGMENTS + s % SEGMENTS
        return 1 if h == 0 else len(points) if h == HEIGHTS else inner

    lines = ["v %.9g %.9g %.9g\nvn %.9g %.9g %.9g" % (p + p) for p in points]
    for h in range(HEIGHTS):
        for s in range(SEGMENTS):
            corners = dict.fromkeys([index(h, s), index(h, s + 1), index(h + 1, s + 1), index(h + 1, s)])
            lines.append("f " + " ".join(f"{c}//{c}" for c in corners))
    return "\n".join(lines) + "\n"


def linear(byte):
    v = byte / 255
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


LINEAR = [linear(byte) / 2**STOPS for byte in range(256)]


def squared_distance(x, y):
    """The sight line through a pixel's centre passes the ball's centre at this distance, squared."""
    tangent = math.tan(FOV_RADIANS / 2)
    u, v = (((c + 0.5) / SIZE_PX * 2 - 1) * tangent for c in (x, y))
    return DISTANCE**2 * (u * u + v * v) / (1 + u * u + v * v)


def ring_means(rgb):
    """Mean radiance in rings of equal area, the middle first."""
    rings = [[] for _ in range(RINGS)]
    for y in range(SIZE_PX):
        for x in range(SIZE_PX):
            ring = int(squared_distance(x, y) / OUTERMOST * RINGS)
            if ring < RINGS:
                rings[ring].append(LINEAR[rgb[3 * (y * SIZE_PX + x)]])
    return [mean(ring) for ring in rings]


def draw(lumi, folder):
    """Ring means of the ball that `folder` holds, in red light."""
    margin = HALF_WIDTH
    scene = {"objects": [{"obj": "ball.obj"}], "sphere": {"centre": [0, 0, 0], "radius": margin}, "exposure": STOPS,
             "environment": 1}
    scene_file, picture = os.path.join(folder, "ball.json"), os.path.join(folder, "ball.png")
    with open(scene_file, "w") as out:
        json.dump(scene, out)
    view = ["--size", f"{SIZE_PX}x{SIZE_PX}", "--orbit", f"0,0,{DISTANCE / margin}"]
    view += ["--fov", str(math.degrees(FOV_RADIANS)), "--spp", str(SAMPLES)]
    result = subprocess.run([lumi, "reference", scene_file, "-o", picture, *view], capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr)
    return ring_means(read_png(picture)[3])


def measure(lumi, names):
    """Mean radiance by name."""
    means, shape = {}, ball_text()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(os.path.join(here, "cycles.mtl"), folder)
        for name in names:
            with open(os.path.join(folder, "ball.obj"), "w") as out:
                out.write(f"mtllib cycles.mtl\nusemtl {name.replace(' ', '_')}\n{shape}")
            means[name] = mean(draw(lumi, folder))
    return means


def mean(rings):
    return sum(rings) / len(rings)


def fault(name, ours, cycles):
    """Why the material is wrong, or an empty text."""
    kind, base = name.split()[:2]
    if kind == "glass" or base == "1":
        return "brighter than the light that arrives" if ours > 1 + WHITE_GAIN else ""
    if name + MULTI in cycles:  # Cycles loses what bounces twice, so the other variant is judged
        return ""
    return "too far from Cycles" if abs(ours / cycles[name] - 1) > LIMITS.get(name, LIMIT) else ""


def main(lumi):
    with open(os.path.join(here, "cycles.json")) as file:
        cycles = {row["name"]: mean(row["sky"]) for row in json.load(file)["materials"]}
    faults = 0
    for name, ours in measure(lumi, cycles).items():
        wrong = fault(name, ours, cycles)
        faults += bool(wrong)
        print(f"{name:20} Cycles {cycles[name]:.3f}, ours {ours:.3f}  {wrong}")
    return faults > 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) == 2 else __doc__)
