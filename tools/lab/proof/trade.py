#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""trade.py [--docs] [--quick] [--work FOLDER]

Measures the trade of speed against accuracy of three scenes that differ, by `lumi report --for` with every named part: the
desk clock (matt and glossy), a bottle of tinted glass, and a block in fog, which no surface can stand for. The last two have
few light paths, as by `lumi report --quick`. --docs writes docs/log/data/trade.json and the pages. --quick: the clock has few light paths, too. Fields,
references and reports stay in FOLDER [build/trade], and what is there is not made again. LUMI names the program.
"""
import argparse
import json
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import bench  # noqa: E402
from figures.table import save  # noqa: E402

PARTS = ["rp2040", "rp2350", "esp32s3", "stm32f4", "stm32h7", "nrf52840", "stm32u5", "esp32c3"]
TITLES = {"clock": "the desk clock", "bottle": "a bottle of tinted glass", "volume": "a block in fog"}
CLOCK = bench.ROOT / "baker/scenes/product.obj"
QUALITY = ["layout", "flash_bytes", "triangles", "psnr_db", "ssim", "cw_ssim", "flip", "mask_psnr_db", "worst_view"]


def kept(path, *words):
    """Returns the JSON that the command writes, and keeps it in the file."""
    if not path.exists():
        text = words[0](*words[1:])
        path.write_text(text if isinstance(text, str) else json.dumps(text))
    return json.loads(path.read_text())


def report(name, work, is_quick):
    scene = CLOCK if name == "clock" else work / f"scenes/{name}.json"
    return kept(work / f"{name}.json", bench.lumi, "report", scene, "--for", ",".join(PARTS), "--cache", work / "cache", "-o",
                work / f"{name}.html", "--json", *["--quick"] * is_quick)


def trade_rows(name, told):
    def field(row):
        return "-".join(pathlib.Path(row["field"]).stem.split("-")[:2])  # surface-250kB

    return [{"scene": name, "field": field(row), **{key: row[key] for key in ("layout", "mode", "flash_bytes", "ram_bytes")},
             "psnr_db": round(row["psnr_db"], 2), "ssim": row["ssim"], "flip": row["flip"],
             "parts": {part: [round(of["frames_per_second"], 2), round(of["worst"], 2), of["fits"], of["on_front"]]
                       for part, of in row["parts"].items()}} for row in told["trade"]["rows"]]


def quality_rows(told):
    """Compares the clock's fields and modes with the same references."""
    modes = [row for row in told["variants"] if row["layout"] in ("antialiased", "one sample")]
    measured = [*told["fields"], *modes]
    return [{key: row[key] for key in QUALITY if key in row} for row in measured]


def main(arguments):
    parser = argparse.ArgumentParser(prog="trade.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--docs", action="store_true", help="write docs/log/data/trade.json")
    parser.add_argument("--quick", action="store_true", help="few light paths for all scenes")
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/trade", help="[build/trade]")
    options = parser.parse_args(arguments)
    work = options.work.absolute()
    work.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, "-B", bench.ROOT / "tools/lab/scenes/write_scenes.py", work / "scenes"], check=True)
    data = {"scenes": [], "rows": []}
    try:
        for name, title in TITLES.items():
            is_quick = options.quick or name != "clock"
            bench.announce(name)
            told = report(name, work, is_quick)
            data["scenes"].append({"scene": name, "title": title, "views": len(told["views"]),
                                   "reference_samples": told["reference_samples"], "quick": is_quick})
            data["rows"] += trade_rows(name, told)
            if name == "clock":
                data["quality"] = quality_rows(told)
    except bench.BenchError as error:
        sys.exit(f"trade.py: {error}")
    if options.docs:
        save("trade", data)
    else:
        print(json.dumps(data, indent=1))


if __name__ == "__main__":
    main(sys.argv[1:])
