# SPDX-License-Identifier: MIT
"""Palette PNGs of 16 colours, in stored (uncompressed) blocks: no compressor's version can change a byte.

Follows the PNG specification (third edition, W3C 2025) and RFC 1950/1951.
"""
import struct
import zlib

MAX_STORED_BYTES = 65535


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _stored(data):
    blocks = []
    for start in range(0, len(data), MAX_STORED_BYTES):
        block = data[start:start + MAX_STORED_BYTES]
        last = start + MAX_STORED_BYTES >= len(data)
        blocks.append(struct.pack("<BHH", last, len(block), len(block) ^ 0xFFFF) + block)
    return b"\x78\x01" + b"".join(blocks) + struct.pack(">I", zlib.adler32(data))


def encode16(palette, rows):
    """The PNG of `rows` of palette indices 0..15; every row has the same even length, palette entries are (r, g, b)."""
    width = len(rows[0])
    lines = [b"\0" + bytes(row[i] << 4 | row[i + 1] for i in range(0, width, 2)) for row in rows]
    header = struct.pack(">IIBBBBB", width, len(rows), 4, 3, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) + _chunk(b"PLTE", b"".join(map(bytes, palette))) +
            _chunk(b"IDAT", _stored(b"".join(lines))) + _chunk(b"IEND", b""))
