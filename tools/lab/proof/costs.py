#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""costs.py [--fit] [--core LIST] [--work FOLDER]

How far the planner's instructions are from what boards execute. Core counts its own work while a frame is drawn
(core/include/lumi/detail/work.h); `lumi-lab work` tells it and multiplies each kind by its cost, and QEMU counts
instructions: in the bench's 200 poses, of surface and chord fields in every mode, and in stripes of other heights.

--fit writes the costs anew, tools/src/planner/unit_costs.h: least squares of relative errors, none below zero, at most
75 a core. Fields whose name begins with "unseen" take no part. Then build `lumi-lab` again. What boards counted stays in FOLDER
[build/model]. LUMI and LUMI_LAB name programs, as for lumi-lab bench.
"""
import argparse
import concurrent.futures
import hashlib
import json
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import bench  # noqa: E402

CORES = ["m0plus", "m4", "m7"]
FITTED = CORES[:2]  # the third takes the second's costs
SCENES = bench.ROOT / "baker/scenes"
COSTS = bench.ROOT / "tools/src/planner/unit_costs.h"
MOST_COSTS = 75
SURFACE = ["--layout", "surface", "--paths", "10"]
CHORD = ["--layout", "chord", "--spp", "1"]
SURFACE_FIELDS = {
    "clock, 60 kB": (SCENES / "product.obj", "--fit", "60kB"),
    "clock, 250 kB": (SCENES / "product.obj", "--fit", "250kB"),
    "test card, 150 kB": (SCENES / "testcard.obj", "--fit", "150kB"),
    "finishes, 120 kB": (SCENES / "finishes.json", "--fit", "120kB"),
    "bottle, 150 kB": ("bottle.json", "--fit", "150kB"),
    "car, 150 kB": ("car.json", "--fit", "150kB"),
    "unseen: pane, 60 kB": ("pane.json", "--fit", "60kB"),
    "unseen: block": ("texture.json", "--triangles", "300", "--longest-edge", "0.6", "--texel-density", "60"),
}
CHORD_FIELDS = {
    "clock, 1024 × 2048": ("rgb565", SCENES / "product.obj", "--origins", "1024", "--directions", "2048"),
    "clock, 2048 × 1024": ("palette8", SCENES / "product.obj", "--origins", "2048", "--directions", "1024"),
    "test card, 300 × 777": ("rgb888", SCENES / "testcard.obj", "--origins", "300", "--directions", "777"),
    "clock above, 1500 × 600": ("luma8", SCENES / "product.obj", "--origins", "1500", "--directions", "600", "--cap", "50%"),
    "clock, 40 × 40": ("luma8", SCENES / "product.obj", "--origins", "40", "--directions", "40"),
    "clock, 16 × 50": ("palette8", SCENES / "product.obj", "--origins", "16", "--directions", "50"),
    "unseen: finishes, 600 × 400": ("palette8", SCENES / "finishes.json", "--origins", "600", "--directions", "400"),
    "unseen: bottle, 700 × 900": ("rgb888", "bottle.json", "--origins", "700", "--directions", "900"),
}
POSES, FEW_POSES = range(200), range(8, 28)
EXACT_POSES = range(8, 11)  # a pixel takes up to 20,000 instructions
SPANS = {0: EXACT_POSES, 4: FEW_POSES, 8: POSES, 16: FEW_POSES}


def slug(name):
    return "".join(c if c.isalnum() else "-" for c in name.replace("unseen: ", ""))


def scene_of(scene, work):
    return scene if isinstance(scene, pathlib.Path) else work / "scenes" / scene


def counted(board, renderer, field, words, names):
    """What a board counted, kept for this program and field."""
    program = board.programs / f"lumi_bench_{renderer}.elf"
    code = program.with_suffix(".bin")
    bench.run("arm-none-eabi-objcopy", "-O", "binary", program, code)
    said = " ".join([board.core, *(hashlib.sha256(path.read_bytes()).hexdigest() for path in (code, field)), *map(str, words)])
    kept = board.folder.parent / "counts" / f"{hashlib.sha256(said.encode()).hexdigest()[:24]}.json"
    if not kept.exists():
        kept.write_text(json.dumps(board.count(renderer, field, words, names)))
    return json.loads(kept.read_text())


def work_of(field, *words):
    return next(iter(bench.lab("work", field, *words).values()))


def rows_of(name, layout, board, counts, works, key):
    """A row for each frame that both have drawn."""
    of = {key(work): work for work in works}
    for count in counts:
        work = of.get(key(count))
        if work:
            yield {"field": name, "layout": layout, "core": board.core, "mode": work["mode"] + ("" if work.get("span", 1) else ", exact"),
                   "view": work["view"], "counted": count["instructions"], "modelled": work["modelled"][board.core],
                   "counts": {unit: n for unit, n in work["counts"].items() if n}}


def surface_rows(boards, name, field):
    poses = work_of(field, "--rows", 24, "--poses", POSES.stop)
    low = work_of(field, "--rows", 8)
    kind = "see_through" if any(row["counts"]["see_triangle"] for row in poses) else "surface"
    for board in boards:
        counts = counted(board, f"{kind}_rgb565", field, ["poses"], bench.POSE_COUNTS)
        yield from rows_of(name, "surface", board, counts, poses, lambda row: (row.get("pose", row.get("view")), row["mode"]))
        counts = [row for row in counted(board, f"{kind}_rgb565", field, ["stripes"], bench.STRIPE_COUNTS) if row["stripes"] == 8]
        yield from rows_of(name, "surface", board, counts, low, lambda row: (row["view"], row["mode"]))


def chord_rows(boards, name, field, texel):
    names = ["pose", "span", "covered", "instructions", "crc"]
    for span, poses in SPANS.items():
        works = work_of(field, "--span", span, "--first", poses.start, "--poses", poses.stop)
        for board in boards:
            for mode in bench.CHORD_MODES:
                of = [work for work in works if work["mode"] == mode]
                if of:
                    counts = counted(board, f"{'spans' if span else 'exact'}_{mode}_{texel}", field, ["poses", poses.start, poses.stop, span], names)
                    yield from rows_of(name, "chord", board, counts, of, lambda row: row.get("pose", row.get("view")))


def all_rows(boards, work):
    for name, (scene, *options) in SURFACE_FIELDS.items():
        yield from surface_rows(boards, name, bench.bake(work / f"{slug(name)}.lumi", scene_of(scene, work), *SURFACE, *options))
    for name, (texel, scene, *options) in CHORD_FIELDS.items():
        field = bench.bake(work / f"{slug(name)}.{texel}.lumi", scene_of(scene, work), *CHORD, *options, "--texel", texel)
        yield from chord_rows(boards, name, field, texel)


def non_negative(gram, target, start):
    """The x >= 0 with the least x·gram·x - 2 target·x, by one coordinate after the other."""
    x = dict(start)
    names = [name for name in x if gram[name][name] > 0]
    slope = {n: sum(gram[n][m] * x[m] for m in names) - target[n] for n in names}
    for _ in range(3000):
        most = 0
        for n in names:
            to = max(0.0, x[n] - slope[n] / gram[n][n])
            by = to - x[n]
            if by:
                x[n] = to
                for m in names:
                    slope[m] += by * gram[n][m]
                most = max(most, abs(by) * gram[n][n] ** 0.5)
        if most < 1e-9:
            break
    return {n: x.get(n, 0.0) if gram[n][n] > 0 else 0.0 for n in x}


def fitted(rows, units, known):
    """Costs of these units beside known ones. Rows with large errors get more weight, step by step, so that the worst error becomes small."""
    weights = [1 / len(rows)] * len(rows)
    costs = {unit: 0.0 for unit in units}
    for _ in range(5):
        gram = {n: dict.fromkeys(units, 0.0) for n in units}
        target = dict.fromkeys(units, 0.0)
        for row, weight in zip(rows, weights):
            shares = [(n, c / row["counted"]) for n, c in row["counts"].items() if n in costs]
            rest = -error(row, known)
            for n, share in shares:
                target[n] += weight * share * rest
                of = gram[n]
                for m, other in shares:
                    of[m] += weight * share * other
        scale = {n: gram[n][n] ** 0.5 or 1 for n in units}
        costs = non_negative({n: {m: gram[n][m] / scale[n] / scale[m] for m in units} for n in units},
                             {n: target[n] / scale[n] for n in units}, {n: costs[n] * scale[n] for n in units})
        costs = {n: cost / scale[n] for n, cost in costs.items()}
        errors = [abs(error(row, {**known, **costs})) for row in rows]
        worst = max(errors)
        weights = [weight * (0.3 + e / worst) for weight, e in zip(weights, errors)]
        whole = sum(weights)
        weights = [weight / whole for weight in weights]
    return costs


def error(row, costs):
    return sum(costs.get(unit, 0) * n for unit, n in row["counts"].items()) / row["counted"] - 1


def costs_of_core(rows, units):
    """Surface fields first. Then leaves out those of chord fields that matter least until few enough are left."""
    known = {unit: cost for unit, cost in fitted([row for row in rows if row["layout"] == "surface"], units, {}).items() if cost > 0}
    chord = [row for row in rows if row["layout"] == "chord"]
    if not chord:
        return known
    costs = fitted(chord, [unit for unit in units if unit not in known], known)
    while len(known) + sum(cost > 0 for cost in costs.values()) > MOST_COSTS:
        shares = {unit: max(cost * row["counts"].get(unit, 0) / row["counted"] for row in chord) for unit, cost in costs.items()}
        used = sorted((unit for unit in costs if costs[unit] > 0), key=shares.get)
        costs = fitted(chord, used[1:], known)
    return {**known, **{unit: cost for unit, cost in costs.items() if cost > 0}}


def write_costs(rows):
    header = COSTS.read_text()
    units = re.findall(r'^    {"(\w+)",', header, re.MULTILINE)
    with concurrent.futures.ProcessPoolExecutor(1) as pool:
        of = list(pool.map(costs_of_core, [[row for row in rows if row["core"] == core] for core in FITTED], [units] * 2))
    table = "\n".join("    {" + ", ".join([f'"{unit}"', *(f"{costs.get(unit, 0):.4g}" for costs in of)]) + "}," for unit in units)
    COSTS.write_text(re.sub(r"(kUnitCosts\[\] = {\n).*?(\n};)", lambda match: match[1] + table + match[2], header, flags=re.DOTALL))
    print(f"{sum(cost > 0 for costs in of for cost in costs.values())} costs are written: build lumi-lab, and look at the errors without --fit")


def tell(rows):
    for row in rows:
        row["error"] = row["modelled"] / row["counted"] - 1
    for seen in (True, False):
        of_kind = [row for row in rows if row["field"].startswith("unseen") != seen]
        for key in dict.fromkeys((row["layout"], row["core"], row["mode"]) for row in of_kind):
            of = [row for row in of_kind if (row["layout"], row["core"], row["mode"]) == key]
            worst = max(of, key=lambda row: abs(row["error"]))
            mean = sum(abs(row["error"]) for row in of) / len(of)
            print(json.dumps({"layout": key[0], "core": key[1], "mode": key[2], "fields": "fitted" if seen else "unseen", "frames": len(of),
                              "mean": f"{100 * mean:.1f} %", "worst": f"{100 * worst['error']:+.1f} %", "of": worst["field"],
                              "view": worst["view"]}, ensure_ascii=False))


def main(arguments):
    parser = argparse.ArgumentParser(prog="costs.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fit", action="store_true", help="write the costs")
    parser.add_argument("--core", default=",".join(CORES), help="[%(default)s]")
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/model", help="[build/model]")
    options = parser.parse_args(arguments)
    work = options.work.absolute()
    for folder in ("scenes", "counts"):
        (work / folder).mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, bench.ROOT / "tools/lab/scenes/write_scenes.py", work / "scenes"], check=True)
    try:
        boards = [bench.Board(core, work) for core in options.core.split(",")]
        for board in boards:
            exact = {f"exact_{mode}_{texel}" for mode in bench.CHORD_MODES for texel, *_ in CHORD_FIELDS.values()}
            spans = {f"spans_{mode}_{texel}" for mode in bench.SPAN_MODES for texel, *_ in CHORD_FIELDS.values()}
            bench.run("cmake", "--build", board.folder, "--target",
                      *(f"lumi_bench_{name}" for name in ["surface_rgb565", "see_through_rgb565", *sorted(exact | spans)]))
        rows = list(all_rows(boards, work))
    except bench.BenchError as problem:
        sys.exit(f"costs.py: {problem}")
    write_costs([row for row in rows if not row["field"].startswith("unseen")]) if options.fit else tell(rows)


if __name__ == "__main__":
    main(sys.argv[1:])
