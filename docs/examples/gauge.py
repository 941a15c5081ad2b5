# SPDX-License-Identifier: MIT
"""Writes a gauge whose needle turns: gauge.obj, gauge.mtl and gauge.json, the scene file. Run: python3 gauge.py"""
import json
import math

SEGMENTS, MOST = 96, 130  # the needle turns so many degrees to either side of the upright

MATERIALS = {  # Kd, roughness, metalness
    "steel": ((0.62, 0.63, 0.65), 0.25, 1), "case": ((0.03, 0.03, 0.035), 0.45, 0), "dial": ((0.02, 0.022, 0.025), 0.6, 0),
    "mark": ((0.85, 0.85, 0.82), 0.6, 0), "green": ((0.05, 0.45, 0.12), 0.6, 0), "amber": ((0.9, 0.45, 0.03), 0.6, 0),
    "red": ((0.75, 0.03, 0.02), 0.6, 0), "needle": ((0.95, 0.2, 0.03), 0.5, 0)}

lines, points = ["mtllib gauge.mtl"], 0


def add(name, material, corners, faces):
    """An object: its corners, and faces that count them from 0, counter-clockwise seen from outside."""
    global points
    lines.extend([f"o {name}", f"usemtl {material}", *(f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in corners)])
    lines.extend("f " + " ".join(str(points + k + 1) for k in face) for face in faces)
    points += len(corners)


def lathe(name, material, profile):
    """Turns (radius, z) pairs about z."""
    ring = [2 * math.pi * k / SEGMENTS for k in range(SEGMENTS)]
    corners = [(r * math.cos(a), r * math.sin(a), z) for a in ring for r, z in profile]
    count = len(profile)
    faces = [(k * count + p, (k + 1) % SEGMENTS * count + p, (k + 1) % SEGMENTS * count + p + 1, k * count + p + 1)
             for k in range(SEGMENTS) for p in range(count - 1)]
    add(name, material, corners, faces)


def arc(name, material, inner, outer, begin, end, z):
    """A flat piece of a ring, from one angle to another: degrees clockwise from the upright."""
    steps = max(1, math.ceil((end - begin) / 4))
    angles = [math.radians(begin + (end - begin) * k / steps) for k in range(steps + 1)]
    corners = [(r * math.sin(a), r * math.cos(a), z) for a in angles for r in (inner, outer)]
    add(name, material, corners, [(2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1) for k in range(steps)])


def prism(name, material, outline, low, high):
    """An outline, counter-clockwise, between two heights."""
    n = len(outline)
    corners = [(x, y, z) for z in (low, high) for x, y in outline]
    add(name, material, corners, [tuple(range(n, 2 * n)), tuple(reversed(range(n))),
                                  *((k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n))])


lathe("case", "case", [(0, -0.3), (0.9, -0.3), (0.98, -0.24), (0.98, 0.02)])
lathe("bezel", "steel", [(0.98, 0), (1, 0.04), (0.98, 0.12), (0.93, 0.14), (0.89, 0.1), (0.87, 0)])
lathe("dial", "dial", [(0.88, 0), (0, 0)])
for zone, begin, end in (("green", -MOST, 40), ("amber", 40, 90), ("red", 90, MOST)):
    arc(f"zone_{zone}", zone, 0.73, 0.79, begin, end, 0.006)
for k in range(27):
    angle = -MOST + 10 * k
    half, inner = (1.1, 0.55) if k % 13 == 0 else (0.7, 0.62)
    arc(f"mark_{k}", "mark", inner, 0.7, angle - half, angle + half, 0.006)
prism("needle", "needle", [(-0.03, -0.2), (0.03, -0.2), (0.008, 0.7), (-0.008, 0.7)], 0.05, 0.07)
lathe("cap", "steel", [(0.09, 0), (0.09, 0.1), (0.07, 0.12), (0, 0.12)])

with open("gauge.obj", "w") as file:
    file.write("\n".join(lines) + "\n")
with open("gauge.mtl", "w") as file:
    for name, (colour, roughness, metalness) in MATERIALS.items():
        file.write(f"newmtl {name}\nKd {colour[0]} {colour[1]} {colour[2]}\nPr {roughness}\nPm {metalness}\n")
with open("gauge.json", "w") as file:
    needle = {"name": "needle", "turn": "-z", "pivot": [0, 0, 0], "from": -MOST, "to": MOST}
    json.dump({"objects": [{"obj": "gauge.obj"}], "parts": [needle]}, file, indent=4)
