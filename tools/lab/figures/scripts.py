# SPDX-License-Identifier: MIT
"""What shell scripts of the laboratory measured: each puts rows into a part of docs/log/data/NAME.json."""
import json
import re

from .table import DATA, NONE, Table, byte_text, decimal, load, or_none, save


def rows_of(text):
    """Rows of JSON one after the other, or lists of them."""
    decoder, rows = json.JSONDecoder(), []
    while text := text.lstrip():
        value, end = decoder.raw_decode(text)
        rows += value if isinstance(value, list) else [value]
        text = text[end:]
    return rows


def put(name, part, text):
    """The rows become that part of the data."""
    data = load(name) if (DATA / f"{name}.json").exists() else {}
    save(name, {**data, part: rows_of(text)})


def add_fuzzing(text):
    """The sums of all runs; of edges the last."""
    data = load("tests")
    sums = {row["target"]: row for row in data["fuzzing"]}
    for row in rows_of(text):
        before = sums.get(row["target"], {"executions": 0, "cpu_s": 0})
        sums[row["target"]] = {**row, **{key: before[key] + row[key] for key in ("executions", "cpu_s")}}
    save("tests", {**data, "fuzzing": [sums[target] for target in sorted(sums)]})


def table(columns, rows, texts):
    return Table(columns, [texts(row) for row in rows])


def soak():
    return table(["emulated", "minutes", "frames", "stripes", "views refused", "deepest stack, bytes"], load("tests")["soak"],
                 lambda row: [row[key] for key in ("cpu", "minutes", "frames", "stripes", "refused", "stack_bytes")])


def coverage():
    return table(["part of core", "branches", "taken", "share"], load("tests")["coverage"], lambda row: [
        row["area"], row["branches"], row["taken"], f"{100 * row['taken'] / row['branches']:.1f} %"])


def mutants():
    return table(["change", "tried", "seen by a test", "equal, proven", "not seen"], load("tests")["mutants"], lambda row: [
        row["kind"].replace("|", "\\|"), row["changes"], row["killed"], row["equal"], row["changes"] - row["killed"] - row["equal"]])


def cases():
    return table(["kind", "cases", "right before", "right now"], load("cases")["cases"],
                 lambda row: [row["kind"], row["cases"], row["before"], row["after"]])


def model_sheet():
    return table(["model", "bytes", "dB of two sides", "what `lumi bake` warns of"], load("model_sheet")["models"],
                 lambda row: [row["model"], f"{row['bytes']:,}" if row["bytes"] else "refused",
                              " · ".join(decimal(value) for value in row["psnr_db"]),
                              "<br>".join(row["said"]).replace("|", "\\|")])


def people_sheet(first, last):
    def said(row):
        drawn = [line for line in row["said"] if re.match("the mesh|the scene|of [0-9]|[0-9.]+ %|refused", line)]
        others = len(row["said"]) - len(drawn)
        return "<br>".join([*drawn, *([f"({others} of what the file says)"] if others else [])]).replace("|", "\\|")

    def psnr(row):
        values = [value for value in row["psnr_db"] if value is not None]
        return [decimal(sum(values) / len(values)), decimal(min(values))] if values else ["", ""]
    models = [row for row in load("people_sheet")["models"] if first <= int(row["model"].split("-")[0]) <= last]
    return table(["model", "bytes", "dB", "worst side", "what `lumi bake` warns of"], models,
                 lambda row: [row["model"], f"{row['bytes']:,}" if row["bytes"] else "refused", *psnr(row), said(row)])


def licences(part):
    return table(["package", "loaded", "licence of most files", "loaded by"], load("licences")[part], lambda row: [
        row["package"], ", ".join(row["objects"]), row["licence"], ", ".join(f"`{name}`" for name in row["by"])])


def scene_pictures():
    return table(["scene, `--orbit`", "path-traced", "drawn from flash", "field", "likeness"], load("scenes")["pictures"], lambda row: [
        f"`{row['scene']}`, {row['orbit']}", f"![traced](img/{row['picture']}.png)", f"![drawn](img/{row['picture']}-drawn.png)",
        f"{row['layout']}, {row['bytes'] / 1000:.0f} kB", f"{decimal(row['psnr_db'])} dB"])


def extremes(part):
    """Worst errors of chord fields by `render` or `render_spans`: within nine tenths of the disc's radius, and anywhere."""
    def cell(row, place, name):
        value = (row[part] or {}).get(place, {}).get(name)
        return NONE if value is None else f"{value:.2f}" if name.endswith("spacings") else f"{value:.1f}"

    def both(row, name):
        inside, anywhere = (cell(row, place, name) for place in ("inside", "all"))
        return f"{inside} · {anywhere}"
    names = ["nearest_spacings", "linear_levels", "paper_levels"]
    rim = "left_out" if part == "spans" else "wrong_rim"
    return table(["case", "pixels", "wrong at the rim", *(name.replace("_", ", ") for name in names)],
                 [row for row in load("extremes")["chord"] if row[part]],
                 lambda row: [row["case"], row["pixels"], row[rim], *(both(row, name) for name in names)])


def surface_extremes(part):
    """Of each mode: root mean square, worst, and worst beside all that shows within a pixel."""
    def cells(row):
        modes = ["one-sample", "antialiased", "2x2"]
        errors = [" · ".join(decimal(row[mode][name]) for name in ("rms", "worst", "beyond")) for mode in modes]
        return [row["case"], row["2x2"]["pixels"], sum(row[mode][name] for mode in modes for name in ("missing", "added")), *errors]
    return table(["case", "pixels", "holes, specks", "one-sample", "antialiased", "2x2"], load("extremes")[part], cells)


def speed_steps(steps):
    return table(["step", "M4", "M0+"], load("speed")[steps],
                 lambda row: [row["step"], decimal(row["m4"]), decimal(row["m0plus"])])


def speed_parts():
    def cells(row, core):
        prototype = row[f"{core}_prototype"]
        return [" → ".join(map(decimal, row[core])), NONE if prototype is None else decimal(prototype)]
    return table(["part", "M4", "prototype", "M0+", "prototype, M0+"], load("speed")["parts_24"], lambda row: [
        row["part"], *cells(row, "m4"), *cells(row, "m0plus")])


def speed_modes():
    return table(["mode", "M4", "M0+", "RAM, bytes"], load("speed")["modes"], lambda row: [
        row["mode"], *(" → ".join(map(decimal, row[core])) for core in ("m4", "m0plus")), " → ".join(map(str, row["ram"]))])


def speed_poses():
    rows = load("speed")["poses"]

    def of_core(core, row):
        return next(r for r in rows if r["core"] == core and all(r[key] == row[key] for key in ("field", "mode", "pixel")))
    return table(["field", "mode", "M4, mean", "M4, worst", "M0+, mean", "M0+, worst", "dearest pose"],
                 [row for row in rows if row["core"] == "m0plus"], lambda row: [
                     row["field"], row["mode"], *(decimal(of_core(core, row)[key]) for core in ("m4", "m0plus")
                                                  for key in ("mean", "worst")), row["worst_pose"]])


def speed_stripes():
    rows = [row for row in load("speed")["stripes"] if row["mode"] == "antialiased" and row["view"] == "generic"]
    heights = sorted({row["stripe_rows"] for row in rows})

    def of_height(row, height):
        found = [r for r in rows if r["stripe_rows"] == height and all(r[key] == row[key] for key in ("field", "core", "pixel"))]
        return decimal(found[0]["instructions_per_pixel"]) if found else NONE
    return table(["field", "bytes", "code", *(f"{height} rows" for height in heights)],
                 [row for row in rows if row["stripe_rows"] == heights[0]], lambda row: [
                     row["field"], row["file_bytes"], row["core"],
                     *(of_height(row, height) for height in heights)])


def speed_halves():
    """Instructions a covered pixel, and rates of the part that runs this code with two cores."""
    def rates(row):
        key = {"m0plus": "rp2040", "m4": "rp2350"}[row["core"]]
        return f"{decimal(row['fps_' + key])} → {decimal(row['fps2_' + key])}"
    return table(["code", "mode", "a frame", "preparing, one core", "preparing, two", "frames a second, one core → two"],
                 load("speed")["halves"], lambda row: [
                     row["core"], row["mode"], decimal(row["instructions_per_pixel"]),
                     decimal(sum(row[part] for part in ("palette", "vertices", "lists", "lights"))), decimal(row["halves"]),
                     rates(row)])


def fuzzing():
    return table(["target", "executions", "CPU minutes", "edges"], load("tests")["fuzzing"],
                 lambda row: [row["target"], row["executions"], decimal(row["cpu_s"] / 60), row["edges"]])


def devices():
    def kilobytes(row, key):
        return f"{row[key] / 1e3:.1f} kB" if key in row else NONE
    return table(
        ["`platform/`", "glue lines", "flash", "RAM", "stack", "frames a second", "with flash misses", "counted by",
         "same bits"], load("devices")["rows"],
        lambda row: [f"`{row['source']}`", row["glue_lines"], kilobytes(row, "flash_bytes"), kilobytes(row, "ram_bytes"),
                     f"{row['stack']} B" if "stack" in row else NONE, or_none(row.get("fps")),
                     or_none(row.get("fps_with_misses")), row["counted_by"], row["same_bits"]])


def emulated_rates():
    """What the measuring program says on an emulator, and the model's rate of an RP2040 at its usual clock."""
    usual_mhz = next(part["clock_mhz"] for part in load("tradeoff")["parts"] if part["key"] == "rp2040")

    def cells(row):
        modelled = row["modelled_frames_a_second"] * row["clock_mhz"] / usual_mhz
        return [row["mode"], f"{row['width']}×{row['height']}", row["clock_mhz"], decimal(modelled),
                decimal(row["frames_a_second"]), f"{100 * (row['frames_a_second'] / modelled - 1):+.0f} %",
                decimal(row["cycles_a_pixel"])]
    return table(["mode", "screen", "MHz", "modelled frames a second", "on the emulator", "difference", "cycles a pixel"],
                 load("measured")["emulated"], cells)


def ram_of_examples():
    """RAM of each example, and of README's firmware, at commit 2118bb6 and now. The old page had kilobytes."""
    def subject(row):
        return row["source"], "SDK" in row["counted_by"]
    data = load("devices")
    now = {subject(row): row["ram_bytes"] / 1e3 for row in data["rows"] if "ram_bytes" in row}
    now["README's firmware", False] = data["memory"][0]["ram_bytes"] / 1e3

    def cells(row):
        source, has_sdk = subject(row)
        bytes_now = now[source, has_sdk]
        return [f"`{source}`" + (", Pico SDK" if has_sdk else ""), f"{row['ram_kb']:.1f} kB", f"{bytes_now:.1f} kB",
                f"{100 * (bytes_now / row['ram_kb'] - 1):+.0f} %"]
    return table(["example", "before", "now", "change"], data["before"], cells)


def board_memory():
    return table(["core", "RAM: view and stripe", "stack of `open`", "stack of `look` and `draw`"],
                 load("devices")["memory"],
                 lambda row: [row[key] for key in ("cpu", "ram_bytes", "open_stack_bytes", "draw_stack_bytes")])


def quoted(scene):
    return f"`{scene}`"


def baker_adaptive():
    return table(["scene", "paths", "levels", "error, all", "error, adaptive", "paths taken", "shift"],
                 load("baker")["adaptive"],
                 lambda row: [quoted(row["scene"]), row["paths"], decimal(row["levels"], 0), decimal(row["error_all"], 2),
                              decimal(row["error_adaptive"], 2), decimal(row["paths_taken"], 0), f"{row['shift']:+.2f}"])


def baker_footprint():
    def figures(mode):
        return f"{decimal(mode['psnr_db'])} dB / {decimal(mode['ssim'], 3)}"
    return table(["scene", "footprint", "nearest", "linear"], load("baker")["footprint"],
                 lambda row: [quoted(row["scene"]), f"`{row['footprint']}`", figures(row["nearest"]), figures(row["linear"])])


def baker_convergence():
    rows = load("baker")["convergence"]
    paths = [f"{count} paths" if k == 0 else str(count) for k, count in enumerate(rows[0]["paths"])]
    return table(["scene", *paths, "exponent"], rows,
                 lambda row: [quoted(row["scene"]), *(decimal(error, 2) for error in row["errors"]),
                              decimal(row["exponent"], 2)])


def baker_threads():
    rows = load("baker")["threads"]
    one = {row["scene"]: row["paths_per_s"] for row in rows if row["threads"] == 1}
    return table(["scene", "threads", "paths", "times one thread"], rows,
                 lambda row: [quoted(row["scene"]), row["threads"], decimal(row["paths_per_s"] / 1e6, 2),
                              decimal(row["paths_per_s"] / one[row["scene"]], 2)])


def baker_memory():
    def megabytes(count):
        return f"{count / 1e6:.0f} MB"
    return table(["triangles", "OBJ file", "held while baking", "most, while loading"], load("baker")["memory"],
                 lambda row: [f"{row['triangles'] / 1e6:.2f} M", megabytes(row["file_bytes"]),
                              megabytes(row["held_bytes_a_million"]), megabytes(row["most_bytes_a_million"])])
