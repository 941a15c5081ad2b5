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


def licences(part):
    return table(["package", "loaded", "licence of most files", "loaded by"], load("licences")[part], lambda row: [
        row["package"], ", ".join(row["objects"]), row["licence"], ", ".join(f"`{name}`" for name in row["by"])])


def scene_pictures():
    return table(["scene, `--orbit`", "path-traced", "drawn from flash", "field", "likeness"], load("scenes")["pictures"], lambda row: [
        f"`{row['scene']}`, {row['orbit']}", f"![traced](img/{row['picture']}.png)", f"![drawn](img/{row['picture']}-drawn.png)",
        f"{row['layout']}, {row['bytes'] / 1000:.0f} kB", f"{decimal(row['psnr_db'])} dB"])


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


def board_memory():
    return table(["core", "RAM: view and stripe", "stack of `open`", "stack of `look` and `draw`"],
                 load("devices")["memory"],
                 lambda row: [row[key] for key in ("cpu", "ram_bytes", "open_stack_bytes", "draw_stack_bytes")])
