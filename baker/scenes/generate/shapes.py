# SPDX-License-Identifier: MIT
"""Parametric shapes as grids (lists of rows of corners) or faces for `mesh.Obj`; y is the axis of revolution."""
import math

from mesh import Corner, smoothed

ARC_STEP_DEGREES = 18


def profile(corners):
    """Turns (radius, height, fillet) corners into smooth runs of (point, normal) pairs for `lathe`.

    The outside lies to the right of the path: go from the bottom over the outside to the top. A corner with a fillet
    becomes an arc of that radius; one with fillet 0 stays sharp and starts a new run.
    """
    runs = []
    run = [(corners[0][:2], _right_of(corners[0], corners[1]))]
    for before, here, after in zip(corners, corners[1:], corners[2:]):
        if here[2] > 0:
            run += _arc(before, here, after)
            continue
        runs.append(run + [(here[:2], _right_of(before, here))])
        run = [(here[:2], _right_of(here, after))]
    runs.append(run + [(corners[-1][:2], _right_of(corners[-2], corners[-1]))])
    return runs


def _right_of(a, b):
    dr, dy = b[0] - a[0], b[1] - a[1]
    length = math.hypot(dr, dy)
    return (dy / length, -dr / length)


def _arc(before, here, after):
    n0, n1 = _right_of(before, here), _right_of(here, after)
    turn = math.atan2(n0[0] * n1[1] - n0[1] * n1[0], n0[0] * n1[0] + n0[1] * n1[1])
    side = math.copysign(here[2], turn)
    back = here[2] * math.tan(abs(turn) / 2)
    start = (here[0] + n0[1] * back, here[1] - n0[0] * back)
    centre = (start[0] - side * n0[0], start[1] - side * n0[1])
    steps = max(2, math.ceil(abs(math.degrees(turn)) / ARC_STEP_DEGREES))
    points = []
    for k in range(steps + 1):
        c, s = math.cos(turn * k / steps), math.sin(turn * k / steps)
        n = (n0[0] * c - n0[1] * s, n0[0] * s + n0[1] * c)
        points.append(((centre[0] + side * n[0], centre[1] + side * n[1]), n))
    return points


def lathe(runs, segments):
    """Revolves the runs of a profile about y."""
    return [[_ring(point, normal, segments) for point, normal in run] for run in runs]


def _ring(point, normal, segments):
    row = []
    for c, s in _circle(segments):
        row.append(Corner((point[0] * s, point[1], point[0] * c), (normal[0] * s, normal[1], normal[0] * c)))
    return row


def _circle(segments):
    """(cos, sin) around a full turn, the first pair repeated exactly at the end."""
    angles = [2 * math.pi * (i % segments) / segments for i in range(segments + 1)]
    return [(math.cos(a), math.sin(a)) for a in angles]


def torus(radius, tube, around, across):
    ring = [((radius + tube * c, tube * s), (c, s)) for c, s in _circle(across)]
    return lathe([ring], around)


def sphere(radius, around, across):
    angles = [math.pi * (k / across - 0.5) for k in range(across + 1)]
    ring = [((radius * math.cos(a), radius * math.sin(a)), (math.cos(a), math.sin(a))) for a in angles]
    return lathe([ring], around)


def textured_disc(radius, around, rings):
    """A flat disc that faces +z; the texture's square is the disc's bounding square, its top at +y."""
    rows = []
    for k in range(rings + 1):
        r = radius * k / rings
        rows.append([Corner((r * s, r * c, 0), (0, 0, 1), (0.5 + s * k / rings / 2, 0.5 + c * k / rings / 2))
                     for c, s in _circle(around)])
    return [rows]


def superellipse(exponent, c, s):
    """The distance of the curve |x|^e + |y|^e = 1 from its centre in the direction (c, s)."""
    return (abs(c) ** exponent + abs(s) ** exponent) ** (-1 / exponent)


def cushion(stations, around):
    """A body about z through superelliptic outlines (size, z, exponent): 2 is a circle, 4 and up a rounded square."""
    points = []
    for size, z, exponent in stations:
        row = []
        for c, s in _circle(around):
            r = size * superellipse(exponent, c, s)
            row.append((r * s, r * c, z))
        points.append(row)
    return [smoothed(points, closed=True)]


def arch(half_span, rise, exponent, section, steps, around):
    """A band bent over an arch from -x to +x; `section` holds its half thickness and its half width along z."""
    points = []
    for k in range(steps + 1):
        a = math.pi * k / steps
        c, s = -math.cos(a), math.sin(a) if 0 < k < steps else 0.0
        r = superellipse(exponent, c, s)
        x, y = r * c, r * s
        normal = (math.copysign(abs(x) ** (exponent - 1), x) / half_span, abs(y) ** (exponent - 1) / rise)
        scale = section[0] / math.hypot(*normal)
        row = []
        for cc, ss in _circle(around):
            f = superellipse(4, cc, ss)
            row.append((half_span * x + normal[0] * scale * f * cc, rise * y + normal[1] * scale * f * cc,
                        section[1] * f * ss))
        points.append(row)
    return [smoothed(points, closed=True)]


def prism(outline, z0, z1):
    """Faces of a convex outline (x, y; clockwise as seen from +z) extruded from z0 to z1, with flat normals."""
    faces = [[Corner((x, y, z1), (0, 0, 1)) for x, y in outline], [Corner((x, y, z0), (0, 0, -1)) for x, y in outline]]
    for (x0, y0), (x1, y1) in zip(outline, outline[1:] + outline[:1]):
        length = math.hypot(x1 - x0, y1 - y0)
        n = ((y0 - y1) / length, (x1 - x0) / length, 0)
        faces.append([Corner(p, n) for p in ((x0, y0, z0), (x1, y1, z0), (x1, y1, z1), (x0, y0, z1))])
    return faces
