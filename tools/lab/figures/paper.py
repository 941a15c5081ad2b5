# SPDX-License-Identifier: MIT
"""The paper's evaluation: what tools/lab/paper.sh measured, and the model of a Cortex-M4 from the trade-off's data."""
import json
import math
import pathlib

from . import bench
from .table import NONE, Table, byte_text, decimal, load, mean, whole

PAPER_SPP = 1024  # light paths a pixel of the paper's references
FIGURES = [("psnr_db", 2), ("ssim", 3), ("cw_ssim", 3), ("flip", 3)]
TIMED = ["nearest", "paper5", "paper9"]


def is_within_half(view):
    """Whether every ray of the view enters through the upper half of the sphere."""
    return view["elevation_deg"] >= math.degrees(math.acos(1 / view["distance"]))


def likeness_of(scene, measured, views):
    def means(keep):
        kept = [of_view for of_view, view in zip(measured["views"], views) if keep(view)]
        return {key: mean(of_view[key] for of_view in kept) for key, _ in FIGURES} if kept else None
    return {"scene": scene, "mode": measured["layout"], "flash_bytes": measured["flash_bytes"],
            "within": means(is_within_half), "all": means(lambda view: True)}


def collect(folder):
    """The data, of all scenes that were measured so far."""
    folder = pathlib.Path(folder)
    data = {"bakes": [], "likeness": [], "background": [], "times": [], "eyes": []}
    for file in sorted(folder.glob("*.draw.json")):
        scene = file.name.split(".")[0]

        def read(name):
            return json.loads((folder / f"{scene}.{name}").read_text())
        report, reference_s = read("report.json"), read("reference_s")
        chord = [variant for variant in report["variants"] if variant["layout"].startswith(("nearest", "linear", "paper"))]
        data.update(views=len(report["views"]), within=sum(map(is_within_half, report["views"])),
                    reference_samples=report["reference_samples"])
        data["bakes"].append({"scene": scene, **read("bake.json")})
        data["likeness"] += [likeness_of(scene, measured, report["views"]) for measured in [*chord, report["fields"][1]]]
        data["background"] += [{"scene": scene, **row} for row in read("background.json")]
        data["times"] += [{"scene": scene, "mode": variant["layout"], "reference_s": reference_s,
                           "draw_ms": variant["draw_ms"]} for variant in chord if variant["layout"] in TIMED]
        data["eyes"] += [{"scene": scene, **row} for row in read("draw.json")]
    return data


def mode_text(word):
    mode, _, span = word.partition("/")
    if mode == "surface":
        return "surface field, 2×2 samples"
    name = {"nearest": "nearest", "linear": "3×3 (ours)"}.get(mode) or "×".join([mode.replace("paper", "")] * 2)
    return name + (f", spans of {span}" if span else "")


def bakes():
    def minutes(bake):
        return whole(bake["processor_s"] / 60)
    found = load("paper")["bakes"]
    texts = [f"{bake['scene']}: {bake['spp']} light path{'' if bake['spp'] == 1 else 's'} a ray, {minutes(bake)} minutes"
             for bake in found]
    return f"{'; '.join(texts)}; {sum(map(minutes, found))} minutes together.\n"


def likeness():
    def figures(row):
        return [" / ".join(decimal(row[part][key], digits) if row[part] else NONE for part in ("within", "all"))
                for key, digits in FIGURES]
    printed = [["the paper, its scenes, as printed", "5×5", "576 MB", NONE, "0.975", "0.998", NONE],
               ["the paper, with its filter", "5×5", "576 MB", NONE, "0.972", "0.997", NONE]]
    return Table(["scene", "drawn", "flash", "PSNR dB", "SSIM", "CW-SSIM", "FLIP"], printed + [
        [row["scene"], ("" if row["mode"] == "surface" else "chord, ") + mode_text(row["mode"]),
         byte_text(row["flash_bytes"], 1), *figures(row)] for row in load("paper")["likeness"]])


def background():
    return Table(["scene", "the sphere fills of the height", "PSNR dB", "SSIM", "CW-SSIM", "FLIP"],
                 [[row["scene"], row["share"], decimal(row["PSNR"], 2), decimal(row["SSIM"], 3),
                   decimal(row["CW-SSIM"], 3), decimal(row["FLIP"], 3)] for row in load("paper")["background"]])


def times():
    data = load("paper")
    samples = data["reference_samples"]
    return Table(["scene", "drawn", f"reference of {samples} paths, s", "drawing, s", "times faster",
                  f"scaled to the paper's {PAPER_SPP} paths"],
                 [[row["scene"], mode_text(row["mode"]), decimal(row["reference_s"]), decimal(row["draw_ms"] / 1e3, 3),
                   whole(row["reference_s"] * 1e3 / row["draw_ms"]),
                   whole(row["reference_s"] * 1e3 * PAPER_SPP / samples / row["draw_ms"])] for row in data["times"]])


def eyes():
    def reads(row):
        return f"{100 * (1 - row['unread_frame_ms'] / row['frame_ms']):.0f} %" if "unread_frame_ms" in row else NONE
    return Table(["scene", "drawn", "frames/s, one eye", "frames/s, two eyes", "texel reads"],
                 [[row["scene"], mode_text(row["mode"] + (f"/{row['span']}" if row["span"] else "")),
                   decimal(1e3 / row["frame_ms"], 2), decimal(5e2 / row["frame_ms"], 2), reads(row)]
                  for row in load("paper")["eyes"]])


def m4():
    """Share of the time in texel reads on an STM32F407, from counted instructions and the model of that part."""
    data = load("tradeoff")
    part = bench.find(data["parts"], key="stm32f4")
    rows = []
    for mode, span in (("nearest", 16), ("linear", 16), ("paper", 0)):
        row = bench.find(data["rows"], layout="chord", core="m4", mode=mode, texel="rgb565", span=span, view="generic")
        instructions = whole(row["instructions_per_pixel"]) * row["covered_pixels"]
        computing = instructions * part["clocks_per_instruction"] / (part["clock_mhz"] * 1e3)
        reading = row["misses_stm32f4"] * part["miss_ns"] * 1e-6
        rows.append([f"{mode} rgb565" + ("" if span else ", exact"), decimal(computing), decimal(reading), f"{100 * reading / (reading + computing):.0f} %"])
    return Table(["drawn", "computing, ms", "waiting for flash, ms", "share"], rows)
