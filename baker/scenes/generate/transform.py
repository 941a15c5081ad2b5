# SPDX-License-Identifier: MIT
"""Rigid placements of parts: right-handed, y up, angles in degrees, lengths in scene units."""
import math


class Transform:
    """p -> A p + b, with A a rotation, so that normals turn like directions."""

    def __init__(self, rows=((1, 0, 0), (0, 1, 0), (0, 0, 1)), origin=(0, 0, 0)):
        self.rows = rows
        self.origin = origin

    def vector(self, v):
        return tuple(sum(a * x for a, x in zip(row, v)) for row in self.rows)

    def point(self, p):
        return tuple(x + o for x, o in zip(self.vector(p), self.origin))

    def then(self, outer):
        """The placement that applies this one first and `outer` afterwards."""
        columns = [outer.vector(column) for column in zip(*self.rows)]
        return Transform(tuple(zip(*columns)), outer.point(self.origin))


def translate(x, y, z):
    return Transform(origin=(x, y, z))


def lean_back(degrees):
    """Turns about x so that +y tips towards -z and +z looks upwards."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return Transform(((1, 0, 0), (0, c, s), (0, -s, c)))


def roll(degrees):
    """Turns about z, clockwise as seen from +z: a clock hand at 12 moves towards 3."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return Transform(((c, s, 0), (-s, c, 0), (0, 0, 1)))


# Shapes of revolution are made about y; these point their axis elsewhere.
AXIS_TO_FRONT = Transform(((1, 0, 0), (0, 0, -1), (0, 1, 0)))
AXIS_TO_BACK = Transform(((1, 0, 0), (0, 0, 1), (0, -1, 0)))
AXIS_TO_RIGHT = Transform(((0, 1, 0), (-1, 0, 0), (0, 0, 1)))
