#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lumi-lab bench: counts what drawing costs on emulated microcontrollers, and how exact the pictures are.

Builds the firmware of platform/mps2/bench with the toolchain files of the project, runs it on QEMU, where an
instruction takes one virtual nanosecond, and compares every frame's CRC with the one that `lumi-lab frames` draws. A
row is a core, mode, texel or pixel format, span and view.
"""
import argparse
import hashlib
import json
import os
import pathlib
import subprocess
import sys

from figures.table import save

CORES = ["m0plus", "m3", "m4", "m7"]
CHORD_MODES = ["nearest", "linear", "paper"]
SPAN_MODES = ["nearest", "linear"]  # those that render_spans() draws
SURFACE_MODES = ["one-sample", "antialiased", "2x2"]
TEXELS = ["rgb888", "rgb565", "palette8", "luma8"]
PIXELS = ["rgb565", "rgb888"]
VIEWS = ["generic", "pole", "close"]
SPANS = [0, 2, 4, 8, 16]  # 0: render() in place of render_spans(), every pixel exact
CHORD_COUNTS = ["view", "span", "covered", "instructions", "setup", "stack", "crc"]
PARTS = ["palette", "vertices", "lists", "lights", "edges", "samples", "outlines", "resolve"]
SEE_THROUGH_PARTS = ["order", "blends"]  # of gloss maps, too; 0 for fields without both
# The host's row counts these features of a field, and these programs draw them: without accuracy.
UNJUDGED = {"states": "states", "gloss": "gloss", "see_through_patches": "see_through"}
# "tall": instructions in stripes of 24 rows; "weigh": of another weight of a light state; "halves": until two cores have prepared the frame.
SURFACE_COUNTS = ["view", "mode", "covered", "instructions", *PARTS, *SEE_THROUGH_PARTS, "tall", "stack", "ram", "weigh", "halves", "crc"]
POSE_COUNTS = ["pose", "mode", "covered", "instructions", "crc"]
STRIPE_COUNTS = ["stripes", "view", "mode", "covered", "instructions", "crc"]
LIGHT = ["--sky", "gradient"]  # without gloss maps, so accuracy can be told
ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/release/tools"


class BenchError(Exception):
    pass


def announce(text):
    print(text, file=sys.stderr, flush=True)


def run(*command):
    """Returns what the command wrote to standard output."""
    command = [str(word) for word in command]
    try:
        result = subprocess.run(command, capture_output=True, text=True)
    except FileNotFoundError:
        raise BenchError(f"{command[0]} is missing: install it, or put it into PATH") from None
    if result.returncode != 0:
        raise BenchError(f"{command[0]} failed; it said:\n{(result.stdout + result.stderr)[-2000:]}")
    return result.stdout


def program(name, path):
    return os.environ.get(name, str(BUILD / path))


def lumi(*words):
    return run(program("LUMI", "lumi"), *words)


def lab(*words):
    return json.loads(run(program("LUMI_LAB", "lab/lumi-lab"), *words))


def parse_counts(text, names):
    """Lines of the firmware, as its main.cpp and surface_main.cpp state them."""
    counts = []
    for line in text.splitlines():
        words = line.split()
        if words[::2] != names or "0" in (words[names.index("covered") * 2 + 1], words[names.index("instructions") * 2 + 1]):
            raise BenchError(f'the firmware wrote "{line}": clear the work folder and build anew')
        count = dict(zip(names, words[1::2]))
        count["crc"] = int(count["crc"], 16)
        counts.append({name: value if name in ("view", "mode", "crc") else int(value) for name, value in count.items()})
    return counts


class Board:
    """The firmware for one core."""

    def __init__(self, core, work):
        self.core, self.folder = core, work / f"cortex-{core}"
        run("cmake", "-S", ROOT, "-B", self.folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=RelWithDebInfo",
            f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/toolchains/cortex-{core}.cmake", "-DLUMI_BUILD_FIRMWARE=ON",
            "-DLUMI_BUILD_TESTS=OFF")
        self.programs = self.folder / "platform/mps2/bench"
        self.machine, self.field_address = (self.programs / "board.txt").read_text().split()

    def build(self, renderers):
        targets = ["lumi_bench_size_empty"]
        for renderer in renderers:
            targets += [f"lumi_bench_{renderer}", f"lumi_bench_size_{renderer}"]
        run("cmake", "--build", self.folder, "--target", *targets)

    def flash_bytes(self, name):
        text, data = run("arm-none-eabi-size", self.programs / f"lumi_bench_size_{name}.elf").splitlines()[1].split()[:2]
        return int(text) + int(data)

    def code_bytes(self, renderer):
        """Flash that the renderer takes: instructions, constants and library routines."""
        return self.flash_bytes(renderer) - self.flash_bytes("empty")

    def count(self, renderer, field, words, names):
        announce(f"{self.core}: {renderer}")
        semihosting = "enable=on,target=native,chardev=console,arg=bench" + "".join(f",arg={word}" for word in words)
        loader = f"loader,file={str(field).replace(',', ',,')},addr={self.field_address},force-raw=on"
        return parse_counts(run("qemu-system-arm", "-M", self.machine, "-display", "none", "-serial", "none", "-monitor",
                                "none", "-chardev", "stdio,id=console", "-semihosting-config", semihosting, "-icount",
                                "shift=0", "-device", loader, "-kernel", self.programs / f"lumi_bench_{renderer}.elf"),
                            names)


def bake(field, *words):
    """Fields lie in the work folder from run to run."""
    if not field.exists():
        announce(f"field {field.name}")
        lumi("bake", *words, "-o", field)
    return field


def chord_field(options, texel):
    """Noise is part of any field; what is judged is how it is drawn."""
    lattices = f"{options.origins}x{options.directions}-{options.spp}"
    return bake(options.work / f"{options.scene.stem}-{lattices}.{texel}.lumi", options.scene, "--layout", "chord", *LIGHT,
                "--origins", options.origins, "--directions", options.directions, "--spp", options.spp, "--texel", texel)


def surface_field(options):
    """With few light paths: noise costs nothing to draw."""
    if options.field:
        return options.field
    return bake(options.work / f"{options.scene.stem}.surface.lumi", options.scene, "--layout", "surface", *LIGHT,
                "--fit", "250kB", "--paths", 20)


def hundredths(value):
    return round(value, 2)


def facts_of(row, frames):
    """Finds the host's facts about the row's frame."""
    keys = [key for key in ("texel", "pixel", "mode", "span", "view") if key in row]
    return next(frame for frame in frames if all(frame.get(key) == row[key] for key in keys))


def put_facts(row, facts):
    of_field = ("crc", "triangles", "vertices", *UNJUDGED)
    row.update({key: value for key, value in facts.items() if key not in of_field})
    return row


def with_facts(row, count, frames):
    """The row with what the host says of that frame; no board may draw other bits."""
    facts = facts_of(row, frames)
    if facts["crc"] != count["crc"]:
        raise BenchError(f"{row['core']} draws other bits than this machine: {row}; build both from the same source")
    return put_facts(row, facts)


def chord_frames(options, modes, fields):
    return lab("frames", *fields.values(), "--mode", ",".join(modes), "--span", ",".join(map(str, options.span)),
               "--view", ",".join(options.view))


def chord_rows(options, boards):
    modes = [mode for mode in options.mode if mode in CHORD_MODES]
    if not modes or options.field:
        return []
    fields = {texel: chord_field(options, texel) for texel in options.texel}
    frames = chord_frames(options, modes, fields)
    spans = [span for span in options.span if span]
    kinds = [("exact", [0])] * (0 in options.span) + [("spans", spans)] * bool(spans)
    programs = [(f"{kind}_{mode}_{texel}", mode, texel, of_kind) for mode in modes for texel in options.texel
                for kind, of_kind in kinds if kind == "exact" or mode in SPAN_MODES]
    rows = []
    for board in boards:
        board.build([renderer for renderer, *_ in programs])
        for renderer, mode, texel, of_kind in programs:
            code_bytes = board.code_bytes(renderer)
            for count in board.count(renderer, fields[texel], [*options.view, *of_kind], CHORD_COUNTS):
                whole, setup = count["instructions"] / count["covered"], count["setup"] / count["covered"]
                rows.append(with_facts({
                    "layout": "chord", "core": board.core, "mode": mode, "texel": texel, "span": count["span"],
                    "view": count["view"], "instructions_per_pixel": hundredths(whole), "setup": hundredths(setup),
                    "inner": hundredths(whole - setup), "instructions_per_frame": count["instructions"],
                    "covered_pixels": count["covered"], "code_bytes": code_bytes, "stack_bytes": count["stack"]},
                    count, frames))
    return rows


def surface_rows(options, boards):
    modes = [mode for mode in options.mode if mode in SURFACE_MODES]
    if not modes:
        return [], None
    field = surface_field(options)
    content = field.read_bytes()
    frames = lab("frames", field, "--mode", ",".join(modes), "--pixel", ",".join(options.pixel), "--view",
                 ",".join(options.view))
    facts = {"file": field.name, "file_bytes": len(content), "triangles": frames[0]["triangles"],
             "sha256": hashlib.sha256(content).hexdigest()}
    features = {key: frames[0][key] for key in UNJUDGED if frames[0][key]}
    facts.update(features)
    kind = UNJUDGED[next(iter(features))] if features else "surface"
    parts = PARTS + SEE_THROUGH_PARTS * (kind in ("see_through", "gloss"))
    rows = []
    for board in boards:
        board.build([f"{kind}_{pixel}" for pixel in options.pixel])
        for pixel in options.pixel:
            code_bytes = board.code_bytes(f"{kind}_{pixel}")
            for count in board.count(f"{kind}_{pixel}", field, [*options.view, *modes], SURFACE_COUNTS):
                row = {"layout": "surface", "core": board.core, "mode": count["mode"], "pixel": pixel,
                       "view": count["view"], "instructions_per_pixel": hundredths(count["instructions"] / count["covered"])}
                row.update({part: hundredths(count[part] / count["covered"]) for part in [*parts, "tall", "halves"]})
                row.update({"instructions_per_frame": count["instructions"], "covered_pixels": count["covered"],
                            "code_bytes": code_bytes, "stack_bytes": count["stack"], "ram_bytes": count["ram"]})
                if kind == "states":
                    row["instructions_to_weigh"] = count["weigh"]
                rows.append({**with_facts(row, count, frames), **facts})
    return rows, {**facts, "vertices": frames[0]["vertices"]}


def measure(options):
    boards = [Board(core, options.work) for core in options.core]
    chord = chord_rows(options, boards)
    surface, facts = surface_rows(options, boards)
    rows = chord + surface
    if options.docs:
        save("tradeoff", {"parts": lab("parts"), "rows": rows, "surface_field": facts,
                          "field": {"scene": options.scene.name, "origins": options.origins,
                                    "directions": options.directions, "spp": options.spp}})
    return written(options, rows)


def written(options, rows):
    if options.json:
        pathlib.Path(options.json).write_text(json.dumps(rows, indent=1) + "\n")
    return rows


def print_rows(rows):
    columns = ["core", "mode", "texel", "pixel", "span", "view", "instructions_per_pixel", "code_bytes", "stack_bytes",
               "psnr_db", "worst_pixel"]
    for row in rows:
        print("  ".join(f"{str(row[key]):>8}" for key in columns if key in row))


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="lumi-lab bench", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="Needs cmake, ninja, the arm-none-eabi toolchain and qemu-system-arm.\n"
               "Example:\n  lumi-lab bench --core m4,m0plus --mode linear --span 8,16 --json bench.json")

    def add_list(name, words, what):
        def parsed(text):
            found = [type(words[0])(word) for word in text.split(",")]
            if not set(found) <= set(words):
                raise argparse.ArgumentTypeError(f"takes words of {', '.join(map(str, words))}, not '{text}'")
            return found
        default = [word for word in words if word != 2]  # spans of 2 pixels pay nowhere
        parser.add_argument(name, type=parsed, metavar="LIST", default=default, help=f"{what} [{','.join(map(str, default))}]")
    add_list("--core", CORES, "cores")
    add_list("--mode", CHORD_MODES + SURFACE_MODES, "reconstructions of chord fields, modes of surface fields")
    add_list("--texel", TEXELS, "texel formats of chord fields")
    add_list("--pixel", PIXELS, "pixels of surface fields")
    add_list("--view", VIEWS, "views")
    add_list("--span", SPANS, "pixels between exact ones, 0 for the exact renderer")
    parser.add_argument("--json", metavar="FILE", help="write the rows here")
    parser.add_argument("--docs", action="store_true",
                        help="write rows and parts into docs/log/data/tradeoff.json")
    parser.add_argument("--work", type=pathlib.Path, default="lumi-bench", help="builds and fields, kept [lumi-bench]")
    parser.add_argument("--scene", type=pathlib.Path, default=ROOT / "baker/scenes/product.obj", help="[product.obj]")
    parser.add_argument("--field", type=pathlib.Path, help="a surface field to draw alone, in place of the scene's; with see-through parts, gloss "
                        "maps or light states, of which one shines half, there is no accuracy")
    parser.add_argument("--origins", type=int, default=1024, help="M of the baked field [1024]")
    parser.add_argument("--directions", type=int, default=2048, help="N of the baked field [2048]")
    parser.add_argument("--spp", type=int, default=4, help="light paths a texel [4]")
    options = parser.parse_args(arguments)
    options.work = options.work.absolute()
    options.work.mkdir(parents=True, exist_ok=True)
    return options


def main(arguments):
    try:
        print_rows(measure(parse(arguments)))
    except BenchError as error:
        sys.exit(f"lumi-lab: {error}")


if __name__ == "__main__":
    main(sys.argv[1:])
