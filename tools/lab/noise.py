#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""noise.py NAME=LUMI_LAB... [--scene FILE]... [--rays N] [--rounds N] [--docs]

Compares the noise that light paths bring at equal time, of programs that were built from different sources: the first one
is what the others are compared with. NAME says what a program is. Each program traces the same rays of each scene twice,
with different random numbers, so that the difference is noise alone (`lumi-lab noise`). Time is CPU time of one thread,
the least of --rounds [5], in which the programs take turns. --rays: that meet the scene [20000]. --scene: these alone;
else those of the project and those that tools/lab/scenes and the scripts beside this one wrote into build/.
Noise at equal time is variance times time: 0.5 says that a picture of equal noise takes half the time. Prints the table;
--docs also writes docs/log/data/noise.json and the pages.
"""
import argparse
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import pages  # noqa: E402
from figures import scripts  # noqa: E402
from figures.table import ROOT, save, shown  # noqa: E402

PROJECT = ["cornell.obj", "testcard.obj", "product.obj", "finishes.json", "gallery.json"]
WRITTEN = ["dragon.json", "bunny.json", "skull.json", "smoke.json", "wisps.obj", "faint.json", "pane.json", "bottle.json",
           "car.json", "watch.json", "wires.json", "plant.json", "mirror.json", "glass.json", "mouth.json",
           "terrain.json", "curtain.json"]


def scene_files():
    found = [ROOT / "baker/scenes" / name for name in PROJECT]
    for name in WRITTEN:
        found += sorted((ROOT / "build").glob(f"*/scenes/{name}"))[:1] or sorted((ROOT / "build").glob(f"*/{name}"))[:1]
    return found


def measured(program, scene, rays):
    result = subprocess.run([program, "noise", scene, str(rays)], capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr)
    return json.loads(result.stdout)[0]


def rows_of(programs, scene, rays, rounds):
    """The noise is the same in each round, the time is not."""
    best = {}
    for _ in range(rounds):
        for name, program in programs:
            row = measured(program, scene, rays)
            time = min(row["microseconds_a_path"], best.get(name, row)["microseconds_a_path"])
            best[name] = {"program": name, **row, "microseconds_a_path": time}
    return [{key: float(f"{value:.4g}") if isinstance(value, float) else value for key, value in row.items()}
            for row in best.values()]


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--scene", action="append", type=pathlib.Path)
    parser.add_argument("--rays", type=int, default=20000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--docs", action="store_true")
    arguments = parser.parse_args()
    programs = [word.split("=", 1) for word in arguments.programs]
    if any(len(pair) != 2 for pair in programs):
        sys.exit("name each program: NAME=LUMI_LAB")
    rows = []
    for scene in arguments.scene or scene_files():
        rows += rows_of(programs, scene, arguments.rays, arguments.rounds)
        print(f"{scene.name} done", file=sys.stderr)
    shown["noise"] = {"rays": arguments.rays, "paths": rows}
    print(scripts.noise().markdown())
    if arguments.docs:
        save("noise", shown["noise"])
        pages.write_pages()


if __name__ == "__main__":
    main()
