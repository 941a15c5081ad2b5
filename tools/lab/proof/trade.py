#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""trade.py [--docs] [--kept] [--quick SCENES] [--scene SCENES] [--work FOLDER]

The trade of speed against accuracy of three scenes that differ, by `lumi report --for` with every named part: the desk clock
(matt and glossy), a bottle of tinted glass, and a block in fog, which no surface can stand for. Each gets a page,
FOLDER/SCENE.html. --docs writes docs/log/data/trade.json, of which pages.py makes the tables of README.md, docs/tradeoff.md
and docs/log/tradeoff.md, and with --plots their picture. --quick: reports of these scenes, or of all, have few light paths.
Fields and references stay in FOLDER [build/trade]. LUMI names the program.
"""
import argparse
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import bench  # noqa: E402
from figures.table import DATA, load, save  # noqa: E402

PARTS = ["rp2040", "rp2350", "esp32s3", "stm32f4", "stm32h7", "nrf52840", "stm32u5", "esp32c3"]
SCENES = {"clock": "the desk clock", "bottle": "a bottle of tinted glass", "volume": "a block in fog"}


def scene_file(name, work):
    if name == "clock":
        return bench.ROOT / "baker/scenes/product.obj"
    subprocess.run([sys.executable, bench.ROOT / "tools/lab/scenes/write_scenes.py", work / "scenes"], check=True)
    return work / "scenes" / f"{name}.json"


def report(name, work, is_quick):
    text = bench.lumi("report", scene_file(name, work), "--for", ",".join(PARTS), "--cache", work / "cache", "-o",
                      work / f"{name}.html", "--json", *["--quick"] * is_quick)
    (work / f"{name}.json").write_text(text)
    return json.loads(text)


def of_scene(name, told, is_quick):
    """Rows of the scene, and what is recommended for each part."""
    trade = told["trade"]

    def field(row):
        return "-".join(pathlib.Path(row["field"]).stem.split("-")[:2])  # surface-250kB

    rows = [{"scene": name, "field": field(row), **{key: row[key] for key in ("layout", "mode", "flash_bytes", "ram_bytes")},
             "psnr_db": round(row["psnr_db"], 2), "ssim": row["ssim"], "flip": row["flip"],
             "parts": {part: [round(of["frames_per_second"], 2), round(of["worst"], 2), of["fits"], of["on_front"]]
                       for part, of in row["parts"].items()}} for row in trade["rows"]]
    parts = [{"scene": name, "part": part["part"], "wanted": part["wanted"], "keeps_pace": part.get("keeps_pace"),
              "field": field(trade["rows"][part["recommended"]]), "mode": trade["rows"][part["recommended"]]["mode"],
              "firmware": part["firmware"]} for part in trade["parts"] if part["front"]]
    scene = {"scene": name, "title": SCENES[name], "views": len(told["views"]), "reference_samples": told["reference_samples"],
             "quick": is_quick}
    return {"scenes": [scene], "parts": parts, "rows": rows}


def main(arguments):
    parser = argparse.ArgumentParser(prog="trade.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--docs", action="store_true", help="write docs/log/data/trade.json; scenes that are not asked for stay")
    parser.add_argument("--quick", nargs="?", const=",".join(SCENES), default="", metavar="SCENES")
    parser.add_argument("--kept", action="store_true", help="take the reports that lie in FOLDER, and run none")
    parser.add_argument("--scene", default=",".join(SCENES), metavar="SCENES", help="[%(default)s]")
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/trade", help="[build/trade]")
    options = parser.parse_args(arguments)
    work = options.work.absolute()
    work.mkdir(parents=True, exist_ok=True)
    told = {}
    try:
        for name in options.scene.split(","):
            is_quick = name in options.quick.split(",")
            bench.announce(name)
            kept = work / f"{name}.json"
            told[name] = of_scene(name, json.loads(kept.read_text()) if options.kept else report(name, work, is_quick), is_quick)
    except bench.BenchError as error:
        sys.exit(f"trade.py: {error}")
    if not options.docs:
        return
    old = load("trade") if (DATA / "trade.json").exists() else {}
    data = {part: [row for row in old.get(part, []) if row["scene"] not in told] for part in ("scenes", "parts", "rows")}
    for of in told.values():
        for part, rows in of.items():
            data[part] += rows
    save("trade", data)


if __name__ == "__main__":
    main(sys.argv[1:])
