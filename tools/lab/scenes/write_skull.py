#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""write_skull.py CRANIUM.inv3 OUT

Writes OUT/skull.nii.gz, the CT of a head in the example of Debian's package invesalius-examples (a packed tar of a raw
matrix and property lists), in Hounsfield units, and OUT/skull.json, the scene of its bone. The same bytes on every run.
"""
import gzip
import json
import os
import plistlib
import struct
import sys
import tarfile

BONE = 226  # Hounsfield units; where the example's own mask of bone begins
PIECES = 0.2  # leaves out what the head rests on
HEADER_BYTES, INT16, MILLIMETRES, SCANNER = 352, 4, 2, 1


def member(project, name):
    for entry in project.getmembers():
        if os.path.basename(entry.name) == name:
            return project.extractfile(entry).read()
    sys.exit(f"write_skull.py: no {name} in the project; is it Cranium.inv3?")


def header(size, spacing):
    """The header of NIfTI-1. Rows run to the patient's left, as DICOM has them; slices to the front and up, as the voxels show."""
    head = bytearray(HEADER_BYTES)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, *size, 1, 1, 1, 1)
    struct.pack_into("<hh", head, 70, INT16, 16)
    struct.pack_into("<8f", head, 76, 1, *spacing, 1, 1, 1, 1)
    struct.pack_into("<3f", head, 108, HEADER_BYTES, 1, 0)
    head[123] = MILLIMETRES
    struct.pack_into("<h", head, 254, SCANNER)
    for axis, step in enumerate((-spacing[0], spacing[1], spacing[2])):  # NIfTI's x is the right
        struct.pack_into("<f", head, 280 + (16 + 4) * axis, step)
    head[344:348] = b"n+1\0"
    return bytes(head)


def main(project_file, out):
    with tarfile.open(project_file) as project:
        about = plistlib.loads(member(project, "main.plist"))
        voxels = member(project, os.path.basename(about["matrix"]["filename"]))
    size = about["matrix"]["shape"][::-1]
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, "skull.nii.gz"), "wb") as file:
        file.write(gzip.compress(header(size, about["spacing"]) + voxels, 6, mtime=0))
    with open(os.path.join(out, "skull.json"), "w", encoding="utf-8") as file:
        json.dump({"objects": [{"volume": "skull.nii.gz", "iso": BONE, "pieces": PIECES}], "up": "z"}, file, indent=2)
        file.write("\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
