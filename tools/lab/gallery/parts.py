# SPDX-License-Identifier: MIT
"""What the gallery's objects share: the generators of the project's scenes, a base, and a light."""
import json
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "baker/scenes/generate"))
import mesh  # noqa: E402
from shapes import lathe, profile, superellipse  # noqa: E402

SEGMENTS = 72

# A large warm lamp in front, a pale one behind, and a soft sky: shadows under the object are dark but never black.
LIGHT = {
    "environment": {"zenith": [0.95, 0.92, 0.88], "horizon": [0.55, 0.53, 0.5], "nadir": [0.3, 0.27, 0.24]},
    "lights": [
        {"type": "rectangle", "position": [2.6, 3.6, 2.6], "target": [0, 0.2, 0], "size": [2.2, 2.2],
         "radiance": [6.8, 5.7, 4.4]},
        {"type": "rectangle", "position": [-3.4, 1.8, -1.5], "target": [0, 0.4, 0], "size": [2, 2.4],
         "radiance": [1.6, 2, 2.6]}],
    "tone": "aces"}

BASE = "newmtl base\nKd 0.4 0.37 0.33\nKs 0 0 0\n"


def smoothed(points, closed):
    """As mesh.smoothed; the first and the last row may be one point each, whose normal is the mean of its neighbours'."""
    first, last = points[0][0] == points[0][-2], points[-1][0] == points[-1][-2]
    rows = mesh.smoothed(points[first:len(points) - last], closed)
    if first:
        rows.insert(0, _pole(points[0], rows[0]))
    if last:
        rows.append(_pole(points[-1], rows[-1]))
    return rows


def _pole(points, beside):
    total = [sum(corner.normal[axis] for corner in beside[1:]) for axis in range(3)]
    length = math.hypot(*total)
    return [mesh.Corner(p, tuple(x / length for x in total)) for p in points]


def scene(objects):
    return json.dumps({"objects": objects, **LIGHT}, indent=1) + "\n"


def base(obj, radius, height=0.08):
    """A round base whose top is at y = 0."""
    obj.part("base", "base")
    corners = [(0, -height, 0), (radius - 0.02, -height, 0.015), (radius, 0, 0.03), (0, 0, 0)]
    obj.grids(lathe(profile(corners), SEGMENTS))


def circle(steps):
    """(cos, sin) around a full turn, the first pair repeated exactly at the end."""
    turns = [2 * math.pi * (k % steps) / steps for k in range(steps + 1)]
    return [(math.cos(a), math.sin(a)) for a in turns]


def loft(stations, exponent, around):
    """A body along x through superelliptic sections (x, height of the centre, half height, half width)."""
    points = []
    for x, centre, tall, wide in stations:
        row = []
        for c, s in circle(around):
            r = superellipse(exponent, c, s)
            row.append((x, centre + tall * r * c, wide * r * s))
        points.append(row)
    return smoothed(points, closed=True)


def rounded_box(half, exponent=5, around=32, steps=12):
    """A box of these half sizes with round edges, about the origin."""
    stations = []
    for k in range(steps + 1):
        a = math.pi * (k / steps - 0.5)
        c = math.cos(a) if 0 < k < steps else 0.0
        x = half[0] * math.copysign(abs(math.sin(a)) ** (2 / exponent), math.sin(a))
        stations.append((x, 0, half[1] * c ** (2 / exponent), half[2] * c ** (2 / exponent)))
    return loft(stations, exponent, around)
