#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""compare_lvgl.py LOG FRAME SCREEN EXPECTED COVERAGE

Compares an object on the screen of platform/lvgl with what the host draws: SCREEN (320 x 240) and EXPECTED are RGB565,
COVERAGE a byte a pixel. LOG says where the object is and what lies over it. There every pixel that the object covers, or
does not cover, has the same bits; outlines, which LVGL blends itself, in 1/32, are within two steps of 31.
"""
import re
import struct
import sys

SCREEN_WIDTH = 320
STEP = 2  # levels out of 31 that an outline may differ by: one for LVGL's blend, one for ours
EDGE = 255


def places(log, frame):
    """(x, y, side of the object, rectangles over it)"""
    text = re.search(rf"^frame {frame} .*\n(over .*\n)+", open(log).read(), re.MULTILINE).group(0)
    x, y, side = (int(n) for n in re.search(r"at (\d+) (\d+) side (\d+)", text).groups())
    return x, y, side, [tuple(map(int, over.split())) for over in re.findall(r"^over (.*)", text, re.MULTILINE)]


def words_of(path):
    return [v for (v,) in struct.iter_unpack("<H", open(path, "rb").read())]


def channels(v):
    return v >> 11, v >> 6 & 31, v & 31


def main(log, frame, screen_path, expected_path, coverage_path):
    left, top, side, over = places(log, frame)
    screen, expected, coverage = words_of(screen_path), words_of(expected_path), open(coverage_path, "rb").read()
    same = blended = 0
    for k, wanted in enumerate(expected):
        x, y = left + k % side, top + k // side
        if any(x1 <= x <= x2 and y1 <= y <= y2 for x1, y1, x2, y2 in over):
            continue
        shown = screen[y * SCREEN_WIDTH + x]
        if 0 < coverage[k] < EDGE:
            blended += 1
            if any(abs(a - b) > STEP for a, b in zip(channels(shown), channels(wanted))):
                sys.exit(f"{screen_path}: outline at {x}, {y} is {shown:04x}, not about {wanted:04x}")
        elif shown != wanted:
            sys.exit(f"{screen_path}: {x}, {y} is {shown:04x}, not {wanted:04x}")
        else:
            same += coverage[k] == EDGE
    if same < side * side // 8:
        sys.exit(f"{screen_path}: only {same} pixels were compared")
    print(f"frame {frame}: {same} pixels of the object have the same bits, {blended} of outlines are LVGL's blend")


if __name__ == "__main__":
    main(*sys.argv[1:])
