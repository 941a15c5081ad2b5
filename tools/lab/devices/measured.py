#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""measured.py LOG <INSPECTED

Adds to each line of a measuring program's LOG what `lumi inspect --screen WxH --for rp2040 --json` models.
"""
import json
import sys


def main(log):
    rates = json.load(sys.stdin)["frames_per_second"]
    with open(log, encoding="utf-8") as lines:
        for line in lines:
            row = json.loads(line)
            print(json.dumps({**row, "modelled_frames_a_second": round(rates[row["mode"]]["rp2040"], 2)}))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
