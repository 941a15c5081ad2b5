# SPDX-License-Identifier: MIT
"""Writes Wavefront OBJ. Coordinates are rounded once, here; equal records are shared, so that the files stay small."""
import collections

from transform import Transform

POSITION_FORMAT = "{:.5g}"
NORMAL_FORMAT = "{:.3f}"
UV_FORMAT = "{:.4f}"

# A corner of a face. `normal` and `uv` may be None.
Corner = collections.namedtuple("Corner", "point normal uv", defaults=(None, None))


def _subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def _text(tag, style, values):
    # Adding 0.0 after rounding turns a negative zero into a plain one.
    return tag + " " + " ".join(style.format(float(style.format(v)) + 0.0) for v in values)


class Obj:
    """Collects faces in order and renders them as one OBJ file with one material library."""

    def __init__(self, title, library):
        self._head = ["# SPDX-License-Identifier: MIT", "# " + title, "mtllib " + library]
        self._records = {"v": {}, "vt": {}, "vn": {}}
        self._faces = []
        self.triangles = 0

    def part(self, name, material):
        self._faces += ["o " + name, "usemtl " + material]

    def face(self, corners, place=Transform()):
        """Adds one convex polygon, turned so that its winding agrees with its normals."""
        corners = [Corner(place.point(c.point), c.normal and place.vector(c.normal), c.uv) for c in corners]
        corners = self._without_repeats(corners)
        if len(corners) < 3:
            return
        if corners[0].normal and self._is_turned(corners):
            corners.reverse()
        self._faces.append("f " + " ".join(self._reference(c) for c in corners))
        self.triangles += len(corners) - 2

    def grid(self, rows, place=Transform()):
        """Adds the quads between neighbouring rows of corners; poles collapse into triangles."""
        for low, high in zip(rows, rows[1:]):
            for i in range(len(low) - 1):
                self.face([low[i], low[i + 1], high[i + 1], high[i]], place)

    def grids(self, grids, place=Transform()):
        for rows in grids:
            self.grid(rows, place)

    def text(self):
        records = [line for kind in ("v", "vt", "vn") for line in self._records[kind]]
        return "\n".join(self._head + records + self._faces) + "\n"

    @staticmethod
    def _without_repeats(corners):
        written = [_text("v", POSITION_FORMAT, c.point) for c in corners]
        return [c for i, c in enumerate(corners) if written[i] != written[i - 1]]

    @staticmethod
    def _is_turned(corners):
        points = [c.point for c in corners]
        area = (0, 0, 0)
        for a, b in zip(points[1:], points[2:]):
            part = cross(_subtract(a, points[0]), _subtract(b, points[0]))
            area = tuple(x + y for x, y in zip(area, part))
        return sum(_dot(area, c.normal) for c in corners) < 0

    def _reference(self, corner):
        def index(kind, style, values):
            if values is None:
                return ""
            table = self._records[kind]
            return str(table.setdefault(_text(kind, style, values), len(table) + 1))

        names = [index("v", POSITION_FORMAT, corner.point), index("vt", UV_FORMAT, corner.uv),
                 index("vn", NORMAL_FORMAT, corner.normal)]
        return "/".join(names).rstrip("/")


def smoothed(points, closed):
    """A grid of corners with normals from central differences; rows are closed loops if `closed`.

    A closed row repeats its first point at its end. Rows may shrink to a point only at the first and last row.
    """
    last = len(points) - 1
    rows = []
    for j, row in enumerate(points):
        below, above = points[max(j - 1, 0)], points[min(j + 1, last)]
        rows.append([Corner(p, _unit(cross(_across(row, i, closed), _subtract(above[i], below[i]))))
                     for i, p in enumerate(row)])
    return rows


def _across(row, i, closed):
    end = len(row) - 1
    if closed:
        return _subtract(row[i + 1 if i < end else 1], row[i - 1 if i > 0 else end - 1])
    return _subtract(row[min(i + 1, end)], row[max(i - 1, 0)])


def _unit(v):
    length = _dot(v, v) ** 0.5
    return tuple(x / length for x in v)
