# SPDX-License-Identifier: MIT
"""Radiance .hdr pictures, uncompressed: G. Ward, "Real Pixels", Graphics Gems II, 1991."""
import math


def _rgbe(colour):
    top = max(colour)
    if top < 1e-32:
        return bytes(4)
    mantissa, exponent = math.frexp(top)
    scale = mantissa * 256 / top
    return bytes(int(c * scale) for c in colour) + bytes([exponent + 128])


def encode(rows):
    """The file of rows of (r, g, b) linear radiance, top row first."""
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {len(rows)} +X {len(rows[0])}\n"
    return head.encode("ascii") + b"".join(_rgbe(colour) for row in rows for colour in row)
