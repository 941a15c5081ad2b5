#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""picture.py FORMAT WIDTHxHEIGHT PIXELS [-o OUT.png] [--same-as EXPECTED [EXPECTED_FORMAT]]

Turns the pixels of a display into a PNG and compares them with expected ones, bit by bit. FORMAT: rgb565, rgb565-swapped,
grey4 (two pixels a byte, the left one in the high bits), rgb888, or png. Ends with 1 if a pixel differs.
"""
import argparse
import struct
import sys
import zlib


def five(v):
    return v << 3 | v >> 2


def six(v):
    return v << 2 | v >> 4


def unpack(name, data):
    """The pixels as bytes of red, green and blue."""
    out = bytearray()
    if name == "rgb888":
        return bytes(data)
    if name == "grey4":
        for byte in data:
            out += bytes([(byte >> 4) * 17] * 3 + [(byte & 15) * 17] * 3)
        return bytes(out)
    order = ">" if name == "rgb565-swapped" else "<"
    for (v,) in struct.iter_unpack(order + "H", data):
        out += bytes([five(v >> 11), six(v >> 5 & 63), five(v & 31)])
    return bytes(out)


def read_png(path):
    """(width, height, channels, the pixels' bytes) of a PNG of 8 bits a channel, not interlaced."""
    data = open(path, "rb").read()
    at, packed = 8, b""
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    channels = {0: 1, 2: 3, 6: 4}.get(colour)
    if depth != 8 or interlaced or not channels:
        raise ValueError(path + ": only grey, RGB and RGBA of 8 bits are read")
    raw, stride = zlib.decompress(packed), width * channels
    above, out = bytearray(stride), bytearray()
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for x in range(stride):
            left = row[x - channels] if x >= channels else 0
            up, corner = above[x], above[x - channels] if x >= channels else 0
            paeth = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))
            row[x] = (row[x] + (0, left, up, (left + up) >> 1, paeth[2])[kind]) & 255
        above = row
        out += row
    return width, height, channels, bytes(out)


def write_png(path, width, height, rgb):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    rows = b"".join(b"\0" + rgb[y * width * 3 : (y + 1) * width * 3] for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + parts)


def read(name, path, size):
    if name == "png":
        width, height, channels, pixels = read_png(path)
        colours = [pixels[k : k + 3] if channels > 1 else pixels[k : k + 1] * 3 for k in range(0, len(pixels), channels)]
        rgb = b"".join(colours)
    else:
        (width, height), rgb = size, unpack(name, open(path, "rb").read())
    if (width, height) != size or len(rgb) != width * height * 3:
        sys.exit(f"{path}: {width} x {height} pixels in {len(rgb)} bytes are not {size[0]} x {size[1]}")
    return rgb


def compare(ours, theirs, paths, width):
    differing = [k for k in range(0, len(ours), 3) if ours[k : k + 3] != theirs[k : k + 3]]
    if differing:
        first = differing[0] // 3
        sys.exit(f"{paths[0]} and {paths[1]}: {len(differing)} pixels differ, the first at {first % width}, {first // width}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("format")
    parser.add_argument("size")
    parser.add_argument("pixels")
    parser.add_argument("-o", dest="output")
    parser.add_argument("--same-as", nargs=2, metavar=("EXPECTED", "FORMAT"))
    options = parser.parse_args()
    size = tuple(int(side) for side in options.size.split("x"))
    rgb = read(options.format, options.pixels, size)
    if not any(rgb):
        sys.exit(f"{options.pixels}: every pixel is black")
    if options.output:
        write_png(options.output, *size, rgb)
    if options.same_as:
        expected = read(options.same_as[1], options.same_as[0], size)
        compare(rgb, expected, (options.pixels, options.same_as[0]), size[0])


if __name__ == "__main__":
    main()
