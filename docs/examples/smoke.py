# SPDX-License-Identifier: MIT
"""smoke.py [smoke.nii.gz]

Writes a rising plume of smoke as a NIfTI file of 56 x 56 x 88 voxels, values 0 to 255. Needs nothing but Python.
"""
import gzip
import math
import random
import struct
import sys

SIZE = (56, 56, 88)
MM_A_VOXEL = 2.0
CELLS = 16  # of the noise's lattice, a side; it repeats

rng = random.Random(5)
LATTICE = [rng.random() for _ in range(CELLS**3)]


def noise(x, y, z):
    """Smooth noise between 0 and 1."""
    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = (t * t * (3 - 2 * t) for t in (x - i, y - j, z - k))
    i, j, k = i % CELLS, j % CELLS, k % CELLS
    i1, j1, k1 = (i + 1) % CELLS, (j + 1) % CELLS, (k + 1) % CELLS

    def line(j, k):
        row = (k * CELLS + j) * CELLS
        return LATTICE[row + i] * (1 - u) + LATTICE[row + i1] * u

    def plane(k):
        return line(j, k) * (1 - v) + line(j1, k) * v

    return plane(k) * (1 - w) + plane(k1) * w


def billows(x, y, z):
    """Ridged octaves of noise, about -1 to 1."""
    total, size = 0, 1
    for octave in range(4):
        s = 2**octave
        total += size * (1 - 2 * abs(2 * noise(x * s, y * s, z * s + 7 * octave) - 1))
        size /= 2
    return total / 1.5


def density(x, y, z):
    """x and y from -1 to 1, z from 0 (the source) to 1 (the top)."""
    bend_x = 0.3 * z * math.sin(5 * z + 0.5)
    bend_y = 0.25 * z * math.cos(4 * z)
    distance = math.hypot(x - bend_x, y - bend_y)
    width = 0.06 + 0.55 * z**0.8
    if distance > 2 * width:
        return 0
    edge = 0.7 - distance / width + (0.25 + 0.6 * z) * billows(2.2 * x + 3, 2.2 * y + 5, 4 * z)
    ends = min(1, z / 0.04) * min(1, (1 - z) / 0.25)
    return max(0, min(1, edge)) * ends * (1 - 0.6 * z)


def voxels():
    nx, ny, nz = SIZE
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                yield round(255 * density(2 * i / (nx - 1) - 1, 2 * j / (ny - 1) - 1, k / (nz - 1)))


def header():
    """Of NIfTI-1: https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h"""
    h = bytearray(352)
    struct.pack_into("<i", h, 0, 348)
    struct.pack_into("<8h", h, 40, 3, *SIZE, 1, 1, 1, 1)
    struct.pack_into("<2h", h, 70, 2, 8)  # unsigned bytes
    struct.pack_into("<8f", h, 76, 1, MM_A_VOXEL, MM_A_VOXEL, MM_A_VOXEL, 0, 0, 0, 0)
    struct.pack_into("<3f", h, 108, 352, 1, 0)  # where voxels begin; slope and intercept
    h[123] = 2  # millimetres
    struct.pack_into("<2h", h, 252, 0, 1)  # the matrix below counts
    for axis in range(3):
        row = [0.0, 0.0, 0.0, 0.0 if axis == 2 else -MM_A_VOXEL * (SIZE[axis] - 1) / 2]
        row[axis] = MM_A_VOXEL
        struct.pack_into("<4f", h, 280 + 16 * axis, *row)
    h[344:348] = b"n+1\0"
    return bytes(h)


def main():
    name = sys.argv[1] if len(sys.argv) > 1 else "smoke.nii.gz"
    data = header() + bytes(voxels())
    if name.endswith(".gz"):
        data = gzip.compress(data, mtime=0)
    with open(name, "wb") as file:
        file.write(data)


if __name__ == "__main__":
    main()
