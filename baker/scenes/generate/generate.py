#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the project's own scenes (OBJ, MTL, PNG, ...) next to this folder, or checks that they are what it would write."""
import argparse
import pathlib
import sys

import cornell
import finishes
import gallery
import product
import testcard
from mesh import Obj

SCENES = (product, cornell, testcard, gallery, finishes)


def _contents():
    """File name -> bytes, for every scene; prints how many triangles each has."""
    contents = {}
    for scene in SCENES:
        for name, value in scene.files().items():
            if isinstance(value, Obj):
                print(f"{name}: {value.triangles} triangles")
                value = value.text()
            contents[name] = value.encode("ascii") if isinstance(value, str) else value
    return contents


def _is_same(path, data):
    if path.is_file() and path.read_bytes() == data:
        return True
    print(f"{path}: differs from what generate.py writes; run generate.py and commit the result", file=sys.stderr)
    return False


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent,
                        help="folder of the scenes (default: the one above this script)")
    parser.add_argument("--check", action="store_true", help="write nothing; exit with 1 if a file differs")
    options = parser.parse_args()
    contents = _contents()
    if options.check:
        return 0 if all([_is_same(options.out / name, data) for name, data in contents.items()]) else 1
    for name, data in contents.items():
        (options.out / name).write_bytes(data)
    return 0


if __name__ == "__main__":
    sys.exit(main())
