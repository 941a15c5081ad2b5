# SPDX-License-Identifier: MIT
"""The clock's dial: hour batons, a minute track and a Fibonacci spiral, flat kin of the project's lattice."""
import math

import png

SIZE_PX = 320
LEVELS = 7  # steps of coverage between the paper colour and an ink
PAPER = (244, 238, 222)
INK = (22, 30, 46)
ACCENT = (224, 84, 44)

# Radii in units of the dial's radius.
BATON_FROM, BATON_TO = 0.58, 0.85
BATON_HALF_WIDTH, QUARTER_HALF_WIDTH = 0.042, 0.072
TRACK_FROM, TRACK_TO, TRACK_HALF_WIDTH = 0.885, 0.925, 0.010
SPIRAL_RADIUS, SPIRAL_POINTS, SPIRAL_DOT_RADIUS = 0.48, 55, 0.030
GOLDEN_TURN = (math.sqrt(5) - 1) / 2


def _spiral():
    points = []
    for i in range(SPIRAL_POINTS):
        r = SPIRAL_RADIUS * math.sqrt((i + 0.5) / SPIRAL_POINTS)
        a = 2 * math.pi * math.fmod(i * GOLDEN_TURN, 1)
        points.append((r * math.sin(a), r * math.cos(a)))
    return points


def _bar_distance(r, sideways, first, last, half_width):
    """Signed distance to a bar that points along the radius."""
    along = max(first - r, r - last)
    across = abs(sideways) - half_width
    if along > 0 and across > 0:
        return math.hypot(along, across)
    return max(along, across)


def _nearest_mark(r, turn, count):
    """How far a point lies to the side of the nearest of `count` radial marks, and which mark that is."""
    mark = round(turn * count)
    return r * math.sin(2 * math.pi * (turn - mark / count)), mark % count


def _ink_distance(x, y):
    r = math.hypot(x, y)
    turn = math.atan2(x, y) / (2 * math.pi)
    hour_side, hour = _nearest_mark(r, turn, 12)
    half_width = QUARTER_HALF_WIDTH if hour % 3 == 0 else BATON_HALF_WIDTH
    baton = _bar_distance(r, hour_side, BATON_FROM, BATON_TO, half_width)
    minute_side, _ = _nearest_mark(r, turn, 60)
    return min(baton, _bar_distance(r, minute_side, TRACK_FROM, TRACK_TO, TRACK_HALF_WIDTH))


def _level(distance):
    """Coverage of a pixel whose centre has this signed distance, in steps of 1/LEVELS."""
    coverage = 0.5 - distance * SIZE_PX / 2
    return math.floor(min(1.0, max(0.0, coverage)) * LEVELS + 0.5)


def _pixel(x, y, spiral):
    ink = _level(_ink_distance(x, y))
    if ink:
        return ink
    dots = min(math.hypot(x - px, y - py) for px, py in spiral) - SPIRAL_DOT_RADIUS
    accent = _level(dots)
    return LEVELS + accent if accent else 0


def _ramp(ink):
    return [tuple(p + (q - p) * k // LEVELS for p, q in zip(PAPER, ink)) for k in range(1, LEVELS + 1)]


def texture():
    """The PNG file's bytes."""
    spiral = _spiral()
    centres = [(2 * i + 1) / SIZE_PX - 1 for i in range(SIZE_PX)]
    rows = [[_pixel(x, -y, spiral) for x in centres] for y in centres]
    return png.encode16([PAPER] + _ramp(INK) + _ramp(ACCENT), rows)
