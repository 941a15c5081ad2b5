#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""write_wisps.py OUT: a tuft of 4,000 hairs, each a ribbon of crossed strips, around a glass ball.

No single surface tells what a ray sees: the scene that should get a chord field by default. Writes
OUT/wisps.obj and OUT/wisps.mtl, the same bytes on every run.
"""
import math
import pathlib
import random
import sys

HAIRS, STEPS, WIDTH, BALL = 4000, 5, 0.008, 0.45
MATERIALS = """newmtl glass
Kd 0 0 0
Tf 0.95 0.97 1
Ni 1.5
illum 7
newmtl hair
Kd 0.75 0.5 0.25
Ks 0.5 0.5 0.5
Ns 60
newmtl dark
Kd 0.15 0.08 0.05
"""


def direction(rng):
    z = rng.uniform(-1, 1)
    turn = rng.uniform(0, 2 * math.pi)
    r = math.sqrt(1 - z * z)
    return [r * math.cos(turn), z, r * math.sin(turn)]


def hair(rng):
    """Points of a curl that leaves the ball's middle shell and bends to a random side."""
    start, bend = direction(rng), direction(rng)
    inner, length = rng.uniform(0.5, 0.6), rng.uniform(0.25, 0.5)
    for k in range(STEPS + 1):
        t = k / STEPS
        yield [(inner + length * t) * s + 0.3 * length * t * t * b for s, b in zip(start, bend)]


def ribbon(points, side):
    """Vertices left and right of the curl."""
    for p in points:
        yield [c + WIDTH / 2 * s for c, s in zip(p, side)]
        yield [c - WIDTH / 2 * s for c, s in zip(p, side)]


def ball(lines, count):
    rings, sides = 24, 48
    for i in range(rings + 1):
        for j in range(sides):
            a, b = math.pi * i / rings, 2 * math.pi * j / sides
            p = [BALL * math.sin(a) * math.cos(b), BALL * math.cos(a), BALL * math.sin(a) * math.sin(b)]
            lines.append("v %.6f %.6f %.6f" % tuple(p))
    lines.append("usemtl glass")
    for i in range(rings):
        for j in range(sides):
            a, b = count + i * sides + j + 1, count + i * sides + (j + 1) % sides + 1
            if i > 0:
                lines.append("f %d %d %d" % (a, b, a + sides))
            if i < rings - 1:
                lines.append("f %d %d %d" % (b, b + sides, a + sides))
    return count + (rings + 1) * sides


def main(out):
    rng = random.Random(4)
    lines = ["mtllib wisps.mtl"]
    count = ball(lines, 0)
    for number in range(HAIRS):
        points = list(hair(rng))
        lines.append("usemtl " + ("dark" if number % 3 == 0 else "hair"))
        for _ in range(2):
            vertices = list(ribbon(points, direction(rng)))
            lines += ["v %.6f %.6f %.6f" % tuple(v) for v in vertices]
            for k in range(STEPS):
                a = count + 2 * k + 1
                lines.append("f %d %d %d" % (a, a + 1, a + 2))
                lines.append("f %d %d %d" % (a + 1, a + 3, a + 2))
            count += len(vertices)
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "wisps.obj").write_text("\n".join(lines) + "\n")
    (folder / "wisps.mtl").write_text(MATERIALS)


if __name__ == "__main__":
    main(sys.argv[1])
