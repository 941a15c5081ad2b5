#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""cost_model.py [--fit] [--core LIST] [--work FOLDER]

How far the planner's model of instructions is from what boards execute. `lumi-lab work` counts what a frame takes
(triangles, rows, samples, texels), the model makes instructions of that, and `lumi-lab bench`'s boards count them on
QEMU: six surface fields and six chord fields, in three views, by every mode, and two more fields that no fit has seen.

--fit writes the model's costs anew, tools/src/planner/instruction_costs.h, from those counts, those of other
heights of stripes and those of poses all around; then build `lumi-lab` again. What was counted of the same program and
field stays in FOLDER [build/model], so a stop loses little. LUMI and LUMI_LAB name programs, as for lumi-lab bench.
"""
import argparse
import hashlib
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import bench  # noqa: E402
from proof import cost_fit  # noqa: E402

CORES = ["m0plus", "m4", "m7"]
SCENES = bench.ROOT / "baker/scenes"
SURFACE = ["--layout", "surface", "--paths", "10"]
# Name, scene, options. Those whose name begins with "unseen" are left out of the fit.
SURFACE_FIELDS = [
    ("clock, 60 kB", SCENES / "product.obj", ["--fit", "60kB"]),
    ("clock, 250 kB", SCENES / "product.obj", ["--fit", "250kB"]),
    ("test card, 150 kB", SCENES / "testcard.obj", ["--fit", "150kB"]),
    ("finishes, 120 kB", SCENES / "finishes.json", ["--fit", "120kB"]),
    ("sheet with holes", "cut_outs.json", ["--triangles", "600", "--longest-edge", "0.3", "--texel-density", "60"]),
    ("bottle, 150 kB", "bottle.json", ["--fit", "150kB"]),
    ("car, 150 kB", "car.json", ["--fit", "150kB"]),
    ("unseen: pane, 60 kB", "pane.json", ["--fit", "60kB"]),
    ("unseen: block", "texture.json", ["--triangles", "300", "--longest-edge", "0.6", "--texel-density", "60"]),
]
CHORD = ["--layout", "chord", "--spp", "1"]
# Name, scene, options, texel of exact pixels.
CHORD_FIELDS = [
    ("clock, 1024 × 2048", SCENES / "product.obj", ["--origins", "1024", "--directions", "2048"], "rgb565"),
    ("clock, 2048 × 1024", SCENES / "product.obj", ["--origins", "2048", "--directions", "1024"], "palette8"),
    ("test card, 300 × 777", SCENES / "testcard.obj", ["--origins", "300", "--directions", "777"], "rgb888"),
    ("clock above, 1500 × 600", SCENES / "product.obj", ["--origins", "1500", "--directions", "600", "--cap", "50%"], "luma8"),
    ("fog, 256 × 512", "volume.json", ["--origins", "256", "--directions", "512"], "palette8"),
    ("clock, 64 × 64", SCENES / "product.obj", ["--origins", "64", "--directions", "64"], "rgb565"),
    ("bottle, 700 × 900", "bottle.json", ["--origins", "700", "--directions", "900"], "rgb888"),
    ("unseen: finishes, 600 × 400", SCENES / "finishes.json", ["--origins", "600", "--directions", "400"], "palette8"),
]
SMALL_FIELDS = [
    ("clock, 63 × 20", SCENES / "product.obj", ["--origins", "63", "--directions", "20"], "rgb565"),
    ("clock, 8 × 100", SCENES / "product.obj", ["--origins", "8", "--directions", "100"], "rgb888"),
    ("clock, 40 × 40", SCENES / "product.obj", ["--origins", "40", "--directions", "40"], "luma8"),
    ("clock, 16 × 50", SCENES / "product.obj", ["--origins", "16", "--directions", "50"], "palette8"),
]
TRANSPARENT = "volume.json"  # which palette8 alone can hold
SPANS = [4, 8, 16]
COSTS = bench.ROOT / "tools/src/planner/instruction_costs.h"


def slug(name):
    return "".join(c if c.isalnum() else "-" for c in name.replace("unseen: ", ""))


class Counter:
    """Counts on boards, each once for a program and a field."""

    def __init__(self, cores, work):
        self.work, self.boards, self.built = work, [bench.Board(core, work) for core in cores], set()
        (work / "counts").mkdir(exist_ok=True)
        self.hashes = {}

    def digest(self, path):
        key = (path, path.stat().st_mtime_ns)
        if key not in self.hashes:
            self.hashes[key] = hashlib.sha256(path.read_bytes()).hexdigest()
        return self.hashes[key]

    def build(self, renderers):
        for board in self.boards:
            bench.announce(f"build for {board.core}")
            bench.run("cmake", "--build", board.folder, "--target", *[f"lumi_bench_{r}" for r in renderers])

    def count(self, board, renderer, field, words, names):
        program = board.programs / f"lumi_bench_{renderer}.elf"
        code = program.with_suffix(".bin")
        if (program, "bin") not in self.built:
            bench.run("arm-none-eabi-objcopy", "-O", "binary", program, code)
            self.built.add((program, "bin"))
        key = hashlib.sha256(" ".join([board.core, self.digest(code), self.digest(field), *map(str, words)]).encode()).hexdigest()
        kept = self.work / "counts" / f"{key[:24]}.json"
        if not kept.exists():
            kept.write_text(json.dumps(board.count(renderer, field, words, names)))
        return json.loads(kept.read_text())


def scene_of(scene, work):
    return scene if isinstance(scene, pathlib.Path) else work / "scenes" / scene


def surface_fields(work):
    return [(name, bench.bake(work / f"{slug(name)}.lumi", scene_of(scene, work), *SURFACE, *options))
            for name, scene, options in SURFACE_FIELDS]


def chord_fields(work, fields, texels):
    return [(name, texel, own, bench.bake(work / f"{slug(name)}.{texel}.lumi", scene_of(scene, work), *CHORD, *options,
                                          "--texel", texel))
            for name, scene, options, own in fields
            for texel in (texels if texels and scene != TRANSPARENT else [own])]


def work_of(field, *words):
    return next(iter(bench.lab("work", field, *words).values()))


def rows_of_surface(counter, fields):
    """Puts the counts of boards beside those of the model, for each frame of surface fields."""
    kinds = {}
    for name, field in fields:
        kinds[name] = "see_through" if work_of(field)[0]["counts"]["see_frame"] else "surface"
    counter.build([f"{kind}_rgb565" for kind in sorted(set(kinds.values()))])
    rows = []
    for name, field in fields:
        renderer = f"{kinds[name]}_rgb565"
        works = {}
        for row in work_of(field):
            works["views", row["view"], row["mode"], 16] = row
        for height in (2, 4, 8, 12, 24):
            for row in work_of(field, "--rows", height):
                works["stripes", row["view"], row["mode"], height] = row
        for row in work_of(field, "--rows", 24, "--poses", 200):
            works["poses", row["view"], row["mode"], 24] = row
        for board in counter.boards:
            def put(kind, view, count, height, parts=None):
                work = works.get((kind, view, count["mode"], height))
                if work is not None:
                    rows.append({"field": name, "core": board.core, "kind": kind, "view": view, "mode": count["mode"],
                                 "stripe": height, "counted": count["instructions"], "parts": parts,
                                 "modelled": work.get("modelled", {}).get(board.core), "counts": work["counts"]})
            for count in counter.count(board, renderer, field, [], bench.SURFACE_COUNTS):
                put("views", count["view"], count, 16, {part: count[part] for part in bench.PARTS + bench.SEE_THROUGH_PARTS})
            for count in counter.count(board, renderer, field, ["stripes"], bench.STRIPE_COUNTS):
                put("stripes", count["view"], count, count["stripes"])
            for count in counter.count(board, renderer, field, ["poses"], bench.POSE_COUNTS):
                put("poses", count["pose"], count, 24)
    return rows


def rows_of_chord(counter, fields, small):
    """Puts the counts of boards beside those of the model, for each frame of chord fields."""
    exact = {(f"exact_{mode}_{own}") for mode in bench.CHORD_MODES for _, _, own, _ in [*fields, *small]}
    spans = {f"spans_{mode}_{texel}" for mode in bench.SPAN_MODES for _, texel, _, _ in fields}
    counter.build(sorted(exact | spans))
    rows = []
    for name, texel, own, field in [*fields, *small]:
        works = {(row["view"], row["mode"], row["span"]): row for row in work_of(field)}
        has_spans = any(span != 0 for _, _, span in works)
        for board in counter.boards:
            for mode in bench.CHORD_MODES:
                counts = []
                if texel == own:
                    counts += counter.count(board, f"exact_{mode}_{texel}", field, [*bench.VIEWS, 0], bench.CHORD_COUNTS)
                if has_spans and mode in bench.SPAN_MODES:
                    counts += counter.count(board, f"spans_{mode}_{texel}", field, [*bench.VIEWS, *SPANS], bench.CHORD_COUNTS)
                for count in counts:
                    work = works[count["view"], mode, count["span"]]
                    rows.append({"field": name, "core": board.core, "texel": texel, "own": texel == own, "mode": mode,
                                 "span": count["span"], "view": count["view"], "counted": count["instructions"],
                                 "setup": count["setup"], "modelled": work.get("modelled", {}).get(board.core),
                                 "counts": work["counts"]})
    return rows


def percent(error):
    return round(100 * error, 1)


def worst(rows):
    return percent(max((row["error"] for row in rows), key=abs))


def surface_cells(rows):
    """By field, core and mode: the error in each view, and what is known besides: lower stripes and poses all around."""
    cells = []
    for key in dict.fromkeys((row["field"], row["core"], row["mode"]) for row in rows):
        of = [row for row in rows if (row["field"], row["core"], row["mode"]) == key]
        views = {row["view"]: row for row in of if row["kind"] == "views"}
        poses = [row for row in of if row["kind"] == "poses"]
        cells.append({"field": key[0], "core": key[1], "mode": key[2],
                      **{view: percent(row["error"]) for view, row in views.items()},
                      "counted": views["generic"]["counted"], "modelled": round(views["generic"]["modelled"]),
                      "stripes": worst([row for row in of if row["kind"] == "stripes"]),
                      "pose": worst(poses),
                      "poses": percent(sum(row["modelled"] for row in poses) / sum(row["counted"] for row in poses) - 1)})
    return cells


def chord_cells(rows):
    """By field, core, mode and kind of drawing: the worst of texels and span lengths in each view."""
    cells = []
    for key in dict.fromkeys((row["field"], row["core"], row["mode"], row["span"] != 0) for row in rows):
        of = [row for row in rows if (row["field"], row["core"], row["mode"], row["span"] != 0) == key]
        generic = next(row for row in of if row["view"] == "generic")
        cells.append({"field": key[0], "core": key[1], "mode": key[2], "drawn": "spans" if key[3] else "exact",
                      **{view: worst([row for row in of if row["view"] == view]) for view in bench.VIEWS},
                      "counted": generic["counted"], "modelled": round(generic["modelled"])})
    return cells


def main(arguments):
    parser = argparse.ArgumentParser(prog="cost_model.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fit", action="store_true", help="write the model's costs")
    parser.add_argument("--core", default=",".join(CORES), help="[%(default)s]")
    parser.add_argument("--layout", default="surface,chord", help="[%(default)s]")
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/model", help="[build/model]")
    options = parser.parse_args(arguments)
    work = options.work.absolute()
    (work / "scenes").mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, bench.ROOT / "tools/lab/scenes/write_scenes.py", work / "scenes"], check=True)
    try:
        counter = Counter(options.core.split(","), work)
        rows = {}
        if "surface" in options.layout:
            rows["surface"] = rows_of_surface(counter, surface_fields(work))
        if "chord" in options.layout:
            rows["chord"] = rows_of_chord(counter, chord_fields(work, CHORD_FIELDS, bench.TEXELS),
                                          chord_fields(work, SMALL_FIELDS, None))
    except bench.BenchError as error:
        sys.exit(f"cost_model.py: {error}")
    for layout, of in rows.items():
        for row in of:
            row["error"] = row["modelled"] / row["counted"] - 1
    (work / "rows.json").write_text(json.dumps(rows))
    if options.fit:
        header = COSTS.read_text()
        for layout, of in rows.items():
            header = cost_fit.renewed(header, layout, of)
        COSTS.write_text(header)
        print(f"{COSTS.relative_to(bench.ROOT)} is written: build lumi-lab, and look at the errors without --fit")
        return
    cells_of = {"surface": surface_cells, "chord": chord_cells}
    for layout, of in rows.items():
        for cell in cells_of[layout](of):
            print(layout, cell)


if __name__ == "__main__":
    main(sys.argv[1:])
