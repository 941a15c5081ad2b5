#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""front.py [--work FOLDER] [--paths N] [--sizes LIST] SCENE...

Measures dB against bytes: bakes each scene with --fill at each size, and once as a bake without options chooses. Prints a
row of JSON a field, with PSNR in each mode of 12 views that no bake aimed at; all fields of a scene share the references.
Fields and references stay in FOLDER [build/front], and what is there is not made again. The documents' rows:
    tools/lab/front.py SCENE... | tools/lab/pages.py put front rows
"""
import argparse
import json
import pathlib
import resource
import sys

import bench

MODES = {"antialiased": "antialiased", "one sample": "one-sample"}  # variants of a report; fields are drawn by 2x2


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def baked(scene, name, options, field):
    """Returns the bake's CPU seconds, which lie beside the field."""
    told = field.with_suffix(".seconds")
    if not told.exists():
        bench.announce(f"{scene.stem}, {name}")
        before = cpu_seconds()
        bench.lumi("bake", scene, "--layout", "surface", "-o", field, *options)
        told.write_text(f"{cpu_seconds() - before:.1f}")
    return float(told.read_text())


def rows(scene, options):
    wanted = {"default": [], **{size: ["--fit", size, "--fill"] for size in options.sizes.split(",")}}
    folder = options.work / scene.parent.name
    folder.mkdir(parents=True, exist_ok=True)
    fields = {name: folder / f"{scene.stem}-{name}-{options.paths}.lumi" for name in wanted}
    seconds = {name: baked(scene, name, [*wanted[name], "--paths", options.paths], field) for name, field in fields.items()}
    told = json.loads(bench.lumi("report", scene, *fields.values(), "--json", "--spp", "128", "--cache", options.work / "cache"))
    for name, field in fields.items():
        modes = {MODES.get(row["layout"], "2x2"): round(row["psnr_db"], 2)
                 for row in told["fields"] + told["variants"] if row["name"] == str(field)}
        yield {"scene": scene.stem, "asked": name, "bytes": field.stat().st_size, "paths": options.paths,
               "seconds": seconds[name], "psnr_db": modes}


def main():
    parser = argparse.ArgumentParser(prog="front.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/front", help="[build/front]")
    parser.add_argument("--paths", type=int, default=20, help="light paths a texel [20]")
    parser.add_argument("--sizes", default="120kB,250kB,500kB,750kB", help="[120kB,250kB,500kB,750kB]")
    parser.add_argument("scenes", nargs="+", type=pathlib.Path, metavar="SCENE")
    options = parser.parse_args()
    try:
        for scene in options.scenes:
            for row in rows(scene.absolute(), options):
                print(json.dumps(row), flush=True)
    except bench.BenchError as error:
        sys.exit(f"front.py: {error}")


if __name__ == "__main__":
    main()
