#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""add_boot_crc.py IN.bin OUT.bin OUT.uf2

Writes the CRC that the RP2040's boot ROM expects at the end of the first 256 bytes, and the same program as UF2, the
format that the board takes as a USB drive.
"""
import struct
import sys

FLASH, BLOCK, FAMILY = 0x10000000, 256, 0xE48BFF56


def crc32(data):
    """Polynomial 04C11DB7, most significant bit first, begun with ones, not inverted."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = crc << 1 & 0xFFFFFFFF ^ (0x04C11DB7 if crc & 0x80000000 else 0)
    return crc


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    program = open(sys.argv[1], "rb").read()
    program = program[:252] + struct.pack("<I", crc32(program[:252])) + program[256:]
    open(sys.argv[2], "wb").write(program)
    blocks = [program[k : k + BLOCK].ljust(BLOCK, b"\0") for k in range(0, len(program), BLOCK)]
    with open(sys.argv[3], "wb") as file:
        for k, block in enumerate(blocks):
            head = struct.pack("<8I", 0x0A324655, 0x9E5D5157, 0x2000, FLASH + k * BLOCK, BLOCK, k, len(blocks), FAMILY)
            file.write(head + block.ljust(476, b"\0") + struct.pack("<I", 0x0AB16F30))


if __name__ == "__main__":
    main()
