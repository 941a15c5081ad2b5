#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""front.py [--work FOLDER] [--paths N] [--sizes LIST] [--for LIST] SCENE...

Measures dB against bytes: bakes each scene with --fill at each size, and once as a bake without options chooses. Prints a
row of JSON a field, with PSNR in each mode of 12 views that no bake aimed at; all fields of a scene share the references.
With --for rp2040@10fps,rp2040@15fps, and so on, also bakes with --fill what --for plans for each of these rates within
the last size, in place of the bake without options, and tells on standard error the best picture that it shows at the
rate beside the best of the sizes that keep it, by the rates of `lumi inspect`.
Fields and references stay in FOLDER [build/front], and what is there is not made again. The documents' rows:
    tools/lab/front.py SCENE... | tools/lab/pages.py put front rows
    tools/lab/front.py --for PACES SCENE... | tools/lab/pages.py put front rates
"""
import argparse
import json
import pathlib
import resource
import sys

import bench
from figures.front import beside

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


def rates(field, chip):
    """Modelled frames a second, by mode."""
    told = json.loads(bench.lumi("inspect", field, "--json", "--for", chip))["frames_per_second"]
    return {mode: round(of[chip], 2) for mode, of in told.items()}


def rows(scene, options):
    paces = options.paces.split(",") if options.paces else []
    sizes = options.sizes.split(",")
    wanted = {**({} if paces else {"default": []}), **{size: ["--fit", size, "--fill"] for size in sizes},
              **{pace: ["--fit", sizes[-1], "--fill", "--for", pace] for pace in paces}}
    folder = options.work / scene.parent.name
    folder.mkdir(parents=True, exist_ok=True)
    fields = {name: folder / f"{scene.stem}-{name}-{options.paths}.lumi" for name in wanted}
    seconds = {name: baked(scene, name, [*wanted[name], "--paths", options.paths], field) for name, field in fields.items()}
    told = json.loads(bench.lumi("report", scene, *fields.values(), "--json", "--spp", "128", "--cache", options.work / "cache"))
    found = []
    for name, field in fields.items():
        modes = {MODES.get(row["layout"], "2x2"): round(row["psnr_db"], 2)
                 for row in told["fields"] + told["variants"] if row["name"] == str(field)}
        found.append({"scene": scene.stem, "asked": name, "bytes": field.stat().st_size, "paths": options.paths,
                      "seconds": seconds[name], "psnr_db": modes})
        if paces:
            found[-1]["fps"] = rates(field, paces[0].partition("@")[0])
    for row in beside(found):
        bench.announce(json.dumps(row))
    yield from found


def main():
    parser = argparse.ArgumentParser(prog="front.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/front", help="[build/front]")
    parser.add_argument("--paths", type=int, default=20, help="light paths a texel [20]")
    parser.add_argument("--sizes", default="120kB,250kB,500kB,750kB", help="[120kB,250kB,500kB,750kB]")
    parser.add_argument("--for", dest="paces", help="paces of one part, such as rp2040@10fps,rp2040@15fps")
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
