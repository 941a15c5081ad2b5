# SPDX-License-Identifier: MIT
"""The ball that both renderers draw, and how its pictures are measured.

A ball of radius 1 is seen from far away. It stands in a white sky of radiance 1, or in the dark under a sun that shines
from behind the camera, 45 degrees above. Rings hold pixels by the squared distance of their sight lines from the
centre, so that each ring has the same area.
"""
import math

SIZE_PX = 96
DISTANCE = 20  # the eye is so far from the centre
HALF_WIDTH = 1.05  # that the picture shows of the plane through the centre
FOV_RADIANS = 2 * math.asin(HALF_WIDTH / DISTANCE)
SEGMENTS, HEIGHTS = 128, 64  # around the axis and from pole to pole
RINGS = 8
OUTERMOST = 0.95  # squared distance; pixels further out may show what is behind


def squared_distance(x, y, size):
    """The squared distance of the sight line through a pixel's centre from the ball's."""
    tangent = math.tan(FOV_RADIANS / 2)
    u, v = (((c + 0.5) / size * 2 - 1) * tangent for c in (x, y))
    return DISTANCE**2 * (u * u + v * v) / (1 + u * u + v * v)


def ring_means(value_at, size):
    """Means of value_at(x, y) over the rings, the middle first."""
    sums, counts = [0.0] * RINGS, [0] * RINGS
    for y in range(size):
        for x in range(size):
            ring = int(squared_distance(x, y, size) / OUTERMOST * RINGS)
            if ring < RINGS:
                sums[ring] += value_at(x, y)
                counts[ring] += 1
    return [total / count for total, count in zip(sums, counts)]
