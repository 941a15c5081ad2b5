# SPDX-License-Identifier: MIT
"""Quality for the flash: what tools/lab/bench_quality.sh and tools/lab/proof/trade.py measured."""
import json
import pathlib

from .table import Table, byte_text, decimal, load, or_none, whole

MODES = {"surface": "2x2", "antialiased": "antialiased", "one sample": "one-sample"}  # by what a row shows
ORDER = ["surface", "antialiased", "one sample", "mean alone", "chord", "sprites", "JPEG sprites", "one ray"]
KEPT = ["layout", "flash_bytes", "triangles", "psnr_db", "ssim", "cw_ssim", "flip", "mask_psnr_db", "worst_view",
        "worst_block"]


def counted(measured, core):
    """Instructions of a frame of this file in RGB565, from FIELD.bench.json; nothing where it was not counted."""
    counts = pathlib.Path(measured["name"] + ".bench.json")
    if measured["layout"] not in MODES or not counts.exists():
        return None
    for row in json.loads(counts.read_text()):
        if (row["core"], row["mode"], row["pixel"]) == (core, MODES[measured["layout"]], "rgb565"):
            return whole(row["instructions_per_pixel"])
    return None


def rows_of(report):
    """Rows of a report, or of what `lumi-lab baselines` writes in its form."""
    ring = report["view_set"] == "ring"
    rows = []
    for measured in [*report["fields"], *report.get("variants", [])]:
        rows.append({"scene": pathlib.Path(report["scene"]).stem, "views": report["view_set"],
                     "reference_samples": report["reference_samples"],
                     **{key: measured[key] for key in KEPT if key in measured},
                     **({} if ring else {"m4": counted(measured, "m4"), "m0plus": counted(measured, "m0plus")})})
    return rows


def collect(folder, *scenes):
    """The data, with the scenes that were measured in the folder; the others as they were."""
    folder, data = pathlib.Path(folder), load("quality")
    rows, note = [], {}
    for scene in scenes:
        measured = []
        for names in (["report", "others"], ["ring", "ring-others"]):
            files = [folder / f"{scene}.{name}.json" for name in names]
            if all(file.exists() for file in files):
                found = [row for file in files for row in rows_of(json.loads(file.read_text()))]
                measured += sorted(found, key=lambda row: (ORDER.index(row["layout"]), row["flash_bytes"]))
        if not measured:  # the note is about such rows
            measured, note = [row for row in data["rows"] if row["scene"] == scene], {"note": data.get("note", "")}
        rows += measured
    return {**note, "rows": rows}


def flash(row):
    return byte_text(row["flash_bytes"]) if row["flash_bytes"] else "–"


def how(row):
    return row["layout"] + (", turntable" if row["views"] == "ring" else "")


def flash_table():
    def place(block):
        return f"{decimal(block['psnr_db'])} ({block['view'] + 1}: {block['x']}, {block['y']})"
    return Table(
        ["scene", "layout", "flash", "triangles", "PSNR dB", "SSIM", "CW-SSIM", "FLIP", "mask PSNR", "worst view",
         "worst block", "instructions a pixel, M4 · M0+"],
        [[row["scene"], how(row), flash(row),
          or_none(row.get("triangles")), decimal(row["psnr_db"], 2), decimal(row["ssim"], 4), decimal(row["cw_ssim"], 4),
          decimal(row["flip"], 4), decimal(row["mask_psnr_db"], 2),
          f"{decimal(row['worst_view']['psnr_db'])} ({row['worst_view']['view'] + 1})", place(row["worst_block"]),
          f"{or_none(row.get('m4'))} · {or_none(row.get('m0plus'))}"] for row in load("quality")["rows"]])


CHIPS = {"rp2040": "RP2040", "rp2350": "RP2350", "esp32s3": "ESP32-S3", "stm32f4": "STM32F407", "stm32h7": "STM32H743"}


def clock_rows(mode_of):
    """Of the desk clock in `lumi report`, without its smallest fields; `mode_of` says by layout which mode."""
    least = {"surface": 100_000, "chord": 500_000}
    return [row for row in load("trade")["rows"]
            if row["scene"] == "clock" and row["mode"] == mode_of[row["layout"]] and row["flash_bytes"] > least[row["layout"]]]


def first_table():
    """What a visitor asks first: how large, how like the truth, how fast; surface fields, antialiased."""
    return Table(["mode", "flash", "RAM", "likeness", *CHIPS.values()],
                 [[row["mode"], byte_text(row["flash_bytes"], 1), f"{decimal(row['ram_bytes'] / 1e3, 0)} kB",
                   f"{decimal(row['psnr_db'])} dB",
                   *(whole(row["parts"][chip][0]) for chip in CHIPS)]
                  for row in clock_rows({"surface": "antialiased", "chord": None})])


def readme_table():
    fast = clock_rows({"surface": "antialiased", "chord": "nearest, S = 16"})
    good = {row["field"]: row for row in clock_rows({"surface": "2x2", "chord": "linear, S = 8"})}

    def text(row):
        return f"{decimal(row['psnr_db'])} dB / {decimal(row['ssim'], 3)}"
    return Table(["field", "flash", "antialiased; nearest", "2×2; linear"],
                 [[row["field"].replace("-", ", ").replace("kB", " kB").replace("MB", " MB"),
                   f"{row['flash_bytes'] / 1e6:.2f} MB", text(row), text(good[row["field"]])] for row in fast])

