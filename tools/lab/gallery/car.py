# SPDX-License-Identifier: MIT
"""A small car with windows: one sees the seats and the wheel through them."""
import math

from parts import BASE, SEGMENTS, base, circle, loft, rounded_box, scene, smoothed
from mesh import Obj
from shapes import arch, lathe, profile, sphere, superellipse, torus
from transform import AXIS_TO_BACK, AXIS_TO_FRONT, AXIS_TO_RIGHT, lean_back, translate

MATERIALS = BASE + """
newmtl paint
Kd 0.03 0.3 0.34
Ks 0.6 0.6 0.6
Pr 0.18

newmtl roof
Kd 0.8 0.77 0.7
Ks 0.5 0.5 0.5
Pr 0.2

newmtl chrome
Kd 0.62 0.62 0.62
Pm 1
Pr 0.22

newmtl tyre
Kd 0.03 0.03 0.032

newmtl seat
Kd 0.5 0.2 0.08

newmtl dark
Kd 0.06 0.055 0.05

newmtl lamp
Kd 0.9 0.88 0.8
Ke 0.3 0.28 0.22
Ks 0.5 0.5 0.5
Pr 0.1

newmtl tail
Kd 0.6 0.02 0.015
Ks 0.5 0.5 0.5
Pr 0.15

newmtl glass
Kd 0.05 0.08 0.09
Ks 0.5 0.5 0.5
Ni 1.5
d 0.14
illum 2
"""

WHEEL_RADIUS, WHEEL_X, WHEEL_Z = 0.19, (-0.58, 0.58), 0.40
BELT, EAVES = 0.56, 0.86


def body(obj):
    """The front is at +x."""
    obj.part("body", "paint")
    stations = []
    for k in range(49):
        t = 2 * k / 48 - 1
        bulge = (1 - abs(t) ** 3.2) ** (1 / 2.2) if 0 < k < 48 else 0.0
        hood = 0.03 * max(0.0, t - 0.3)
        stations.append((1.02 * t, 0.375 - hood, (0.205 - hood) * bulge, 0.44 * bulge))
    obj.grid(loft(stations, 3.2, 64))
    for x in WHEEL_X:
        for side in (-1, 1):
            points = []
            for k in range(33):
                a = math.radians(-12 + 204 * k / 32)
                row = []
                for depth, proud in ((0.3, 0.0), (0.36, 0.05), (0.44, 0.062), (0.485, 0.045), (0.49, 0.02), (0.48, 0.0)):
                    r = WHEEL_RADIUS + 0.02 + proud
                    row.append((x + r * math.cos(a) * 1.08, WHEEL_RADIUS + r * math.sin(a), side * depth))
                points.append(row)
            obj.grid(smoothed(points if side > 0 else points[::-1], closed=False))


def wheels(obj):
    for x in WHEEL_X:
        for side, axis in ((1, AXIS_TO_FRONT), (-1, AXIS_TO_BACK)):
            place = axis.then(translate(x, WHEEL_RADIUS, side * WHEEL_Z))
            obj.part("tyre", "tyre")
            r = WHEEL_RADIUS
            obj.grids(lathe(profile([(0, -0.08, 0), (r, -0.08, 0.03), (r, 0.08, 0.03), (0.115, 0.075, 0)]), 48), place)
            obj.part("hub", "chrome")
            hub = [(0.118, 0.07, 0), (0.118, 0.09, 0.01), (0.098, 0.088, 0.01), (0.09, 0.07, 0.01), (0.06, 0.1, 0.03), (0, 0.105, 0)]
            obj.grids(lathe(profile(hub), 40), place)


def outline(height):
    """Half length, half width and centre of the cabin at a height."""
    t = (height - BELT) / (EAVES - BELT)
    return 0.60 - 0.17 * t, 0.405 - 0.075 * t, -0.10 - 0.03 * t


def cabin_row(length, width, centre, height, around):
    row = []
    for c, s in circle(around):
        r = superellipse(3.4, c, s)
        row.append((centre + length * r * c, height, width * r * s))
    return row


def cabin(obj):
    around, rows = 96, 10
    heights = [BELT - 0.05] + [BELT + (EAVES - BELT) * k / rows for k in range(rows + 1)]
    points = [cabin_row(*outline(y), y, around) for y in heights]
    length, width, centre = outline(EAVES)
    for k in range(1, 9):
        a = math.radians(90 * k / 8)
        f = math.cos(a) ** 0.6 if k < 8 else 0.0
        points.append(cabin_row(length * f, width * f, centre, EAVES + 0.085 * math.sin(a), around))
    grid = smoothed(points, closed=True)

    def is_glass(i, j):
        if not 1 <= j < rows:
            return False
        turn = (i + 0.5) / around * 360
        return not any(abs((turn - at + 180) % 360 - 180) < wide for at, wide in
                       ((32, 4), (-32, 4), (88, 3.5), (-88, 3.5), (146, 6), (-146, 6)))

    for name, material, take in (("cabin", "paint", lambda i, j: not is_glass(i, j) and j < rows),
                                 ("roof", "roof", lambda i, j: j >= rows), ("windows", "glass", is_glass)):
        obj.part(name, material)
        for j in range(len(grid) - 1):
            for i in range(around):
                if take(i, j):
                    obj.face([grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]])


def inside(obj):
    obj.part("seats", "seat")
    for x, z in ((0.0, 0.17), (0.0, -0.17)):
        obj.grid(rounded_box((0.13, 0.05, 0.13)), translate(x, 0.6, z))
        obj.grid(rounded_box((0.045, 0.13, 0.125)), translate(x - 0.15, 0.7, z))
    obj.grid(rounded_box((0.12, 0.05, 0.29)), translate(-0.38, 0.6, 0))
    obj.grid(rounded_box((0.05, 0.12, 0.28)), translate(-0.5, 0.68, 0))
    obj.part("dashboard", "dark")
    obj.grid(rounded_box((0.06, 0.055, 0.31)), translate(0.34, 0.6, 0))
    obj.grids(torus(0.085, 0.013, 32, 8), AXIS_TO_RIGHT.then(translate(0.22, 0.70, 0.17)))


def trim(obj):
    obj.part("lamps", "lamp")
    for z in (-0.27, 0.27):
        obj.grids(sphere(0.085, 32, 16), translate(0.905, 0.41, z))
    obj.part("lamp_rings", "chrome")
    for z in (-0.27, 0.27):
        obj.grids(torus(0.087, 0.016, 40, 10), AXIS_TO_RIGHT.then(translate(0.905, 0.41, z)))
    for x, z in ((1.0, 0), (-1.0, 0)):
        obj.grid(rounded_box((0.045, 0.04, 0.40), 4, 24, 16), translate(x, 0.25, z))
    for side in (-1, 1):
        obj.grid(rounded_box((0.07, 0.012, 0.012), 4, 16, 8), translate(-0.02, 0.49, side * 0.425))
    obj.part("tails", "tail")
    for z in (-0.28, 0.28):
        obj.grid(rounded_box((0.05, 0.065, 0.055), 3), translate(-0.945, 0.41, z))


def files():
    obj = Obj("A small car with windows", "car.mtl")
    base(obj, 1.17)
    body(obj)
    wheels(obj)
    cabin(obj)
    inside(obj)
    trim(obj)
    return {"car.obj": obj, "car.mtl": MATERIALS, "car.json": scene([{"obj": "car.obj", "rotate": [0, -90, 0]}])}
