#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""features.py [--docs] [--work FOLDER]

What each property of a scene costs a device, measured by leaving it out: bytes of the field, flash of the renderer, RAM of a
view, and instructions for each covered pixel on emulated boards. Scenes come in pairs that differ in the property alone
(tools/lab/scenes/write_features.py) and are baked with equal settings. Then it tells what a property costs where the firmware
can draw it and the field has none. --docs writes the tables of docs/log/features.md. Builds and fields stay in FOLDER
[build/features]. LUMI and LUMI_LAB name programs, as for lumi-lab bench, which it shares its boards with.
"""
import argparse
import pathlib
import struct
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import bench  # noqa: E402
from figures.table import save  # noqa: E402

CORES = ["m4", "m0plus"]
SURFACE = ["--layout", "surface", "--triangles", "600", "--longest-edge", "0.3", "--texel-density", "60", "--paths", "20"]
CHORD = ["--layout", "chord", "--origins", "256", "--directions", "512", "--spp", "4"]
MODE, FLASH_OF_MODE, PLAIN = "antialiased", "antialiased_rgb565", "no_views_rgb565"
VERTEX_TABLES, NEIGHBOURS = b"SVIE", b"SNEI"


def bake(work, name, words, field):
    return bench.bake(work / f"{field}.lumi", work / f"{name}.json", *words)


def section_bytes(field, wanted):
    """Bytes of that section and of its entry in the table; 0 where there is none."""
    content = field.read_bytes()
    entries = [32 + 20 * k for k in range(struct.unpack_from("<H", content, 16)[0])]
    sizes = [struct.unpack_from("<I", content, at + 12)[0] for at in entries if content[at:at + 4] == wanted]
    return sizes[0] if sizes else 0


class Costs:
    """Of fields on boards; each is counted once."""

    def __init__(self, work):
        self.boards = [bench.Board(core, work) for core in CORES]
        for board in self.boards:
            board.build(["surface_rgb565", "see_through_rgb565", "antialiased_rgb565", "one_sample_rgb565",
                         PLAIN, "spans_linear_palette8"])
        self.kept = {}

    def flash(self, renderer):
        return {board.core: board.code_bytes(renderer) for board in self.boards}

    def drawing(self, field, renderer, mode):
        """RAM, and instructions a covered pixel by core."""
        key = (field, renderer, mode)
        if key not in self.kept:
            is_chord = renderer.startswith("spans")
            words, names = (["generic", "16"], bench.CHORD_COUNTS) if is_chord else (["generic", mode], bench.SURFACE_COUNTS)
            counts = {board.core: board.count(renderer, field, words, names)[0] for board in self.boards}
            self.kept[key] = {"ram": next(iter(counts.values())).get("ram", 0),
                              **{core: c["instructions"] / c["covered"] for core, c in counts.items()}}
        return self.kept[key]


def row(name, without, of_field, flash, drawing):
    """Each of the latter is (with, without)."""
    return {"property": name, "left_out": without, "bytes": of_field[0], "bytes_without": of_field[1],
            **{f"code_{core}": flash[0][core] - flash[1][core] for core in CORES},
            "ram": drawing[0]["ram"] - drawing[1]["ram"],
            **{core: bench.hundredths(drawing[0][core]) for core in CORES},
            **{f"{core}_without": bench.hundredths(drawing[1][core]) for core in CORES}}


def pair_row(costs, name, without, fields, renderers=("surface_rgb565", "surface_rgb565"), flashes=None):
    flash = tuple(costs.flash(f) for f in flashes or (FLASH_OF_MODE, FLASH_OF_MODE))
    sizes = tuple(f.stat().st_size for f in fields)
    return row(name, without, sizes, flash, tuple(costs.drawing(f, r, MODE) for f, r in zip(fields, renderers)))


def pairs(work, costs):
    def both(name):
        return [bake(work, full, SURFACE, full) for full in (name, name + "-bare")]

    gloss = both("gloss")
    if section_bytes(gloss[0], VERTEX_TABLES) == 0:
        raise bench.BenchError("the polished ball got no view tables: give it more light paths (SURFACE in features.py)")
    yield pair_row(costs, "gloss", "a ball is matt", gloss, ("surface_rgb565", PLAIN), (FLASH_OF_MODE, PLAIN))
    yield pair_row(costs, "texture", "a block has one colour", both("texture"))
    yield pair_row(costs, "two sides", "a sheet is baked from above alone",
                   [bake(work, "sides", SURFACE, "sides"), bake(work, "sides", [*SURFACE, "--cap", "50%"], "sides-above")])
    yield pair_row(costs, "cut-outs", "a sheet has no holes", both("cut_outs"))
    yield pair_row(costs, "see-through", "no pane in front", both("see_through"), ("see_through_rgb565", "surface_rgb565"),
                   ("see_through_rgb565", "surface_rgb565"))
    plain = gloss[1]
    size, neighbours = plain.stat().st_size, section_bytes(plain, NEIGHBOURS)
    yield row("outlines", "drawn by one-sample, no neighbours in the field", (size, size - neighbours),
              (costs.flash("antialiased_rgb565"), costs.flash("one_sample_rgb565")),
              tuple(costs.drawing(plain, "surface_rgb565", mode) for mode in ("antialiased", "one-sample")))
    yield row("four samples a pixel", "drawn by antialiased", (size, size),
              (costs.flash("surface_rgb565"), costs.flash("antialiased_rgb565")),
              tuple(costs.drawing(plain, "surface_rgb565", mode) for mode in ("2x2", "antialiased")))
    chord = "spans_linear_palette8"
    yield pair_row(costs, "volume, a chord field", "no fog", [bake(work, n, CHORD, n) for n in ("volume", "volume-bare")],
                   (chord, chord), (chord, chord))


def absent(work, costs):
    """Where the firmware has a property's code, and the field has none of it."""
    plain = bake(work, "gloss-bare", SURFACE, "gloss-bare")
    size = plain.stat().st_size
    yield row("see-through", "a firmware that draws opaque fields alone", (size, size),
              (costs.flash("see_through_rgb565"), costs.flash("surface_rgb565")),
              tuple(costs.drawing(plain, renderer, MODE) for renderer in ("see_through_rgb565", "surface_rgb565")))
    yield row("view tables", "a firmware that draws fields without them alone", (size, size),
              (costs.flash(FLASH_OF_MODE), costs.flash(PLAIN)),
              tuple(costs.drawing(plain, renderer, MODE) for renderer in ("surface_rgb565", PLAIN)))
    yield row("outlines", "a field without neighbours, drawn by one-sample",
              (size, size - section_bytes(plain, NEIGHBOURS)), (costs.flash("antialiased_rgb565"),
                                                                costs.flash("one_sample_rgb565")),
              tuple(costs.drawing(plain, "surface_rgb565", "one-sample") for _ in range(2)))


def main(arguments):
    parser = argparse.ArgumentParser(prog="features.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--docs", action="store_true", help="write docs/log/data/features.json; pages.py writes the page")
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/features", help="[build/features]")
    options = parser.parse_args(arguments)
    work = options.work.absolute()
    work.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, bench.ROOT / "tools/lab/scenes/write_features.py", work], check=True)
    try:
        costs = Costs(work)
        data = {"present": list(pairs(work, costs)), "absent": list(absent(work, costs))}
    except bench.BenchError as error:
        sys.exit(f"features.py: {error}")
    for part, rows in data.items():
        for r in rows:
            print(part, r)
    if options.docs:
        save("features", data)


if __name__ == "__main__":
    main(sys.argv[1:])
