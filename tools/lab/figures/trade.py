# SPDX-License-Identifier: MIT
"""Speed against accuracy of scenes, as `lumi report --for` measured it (tools/lab/proof/trade.py)."""
from .table import NONE, Table, byte_text, decimal, load, or_none, whole

PARTS = {"rp2040": "RP2040", "rp2350": "RP2350", "esp32s3": "ESP32-S3*", "stm32f4": "STM32F407", "stm32h7": "STM32H743",
         "nrf52840": "nRF52840", "stm32u5": "STM32U585", "esp32c3": "ESP32-C3*"}
SHOWN = ["rp2040", "rp2350", "esp32s3", "stm32f4", "stm32h7"]


def rate(of, part):
    fps, worst, fits, on_front = of[part]
    if not fits:
        return NONE
    text = decimal(fps) if fps < 10 else decimal(fps, 0)
    return f"**{text}**" if on_front else text


def is_on_front(row, parts=PARTS):
    return any(row["parts"][part][3] for part in parts if part in row["parts"])


def what(row):
    return f"{row['field'].replace('-', ', ', 1).replace('kB', ' kB').replace('MB', ' MB')}, {row['mode']}"


def front(scene):
    """The rows of a scene that no other one beats on a part, the most accurate first."""
    rows = [row for row in load("trade")["rows"] if row["scene"] == scene and is_on_front(row, SHOWN)]
    rows.sort(key=lambda row: -row["psnr_db"])
    return Table(["field and mode", "flash", "RAM, kB", "dB", *(PARTS[part] for part in SHOWN)],
                 [[what(row), byte_text(row["flash_bytes"]), decimal(row["ram_bytes"] / 1e3, 0), decimal(row["psnr_db"]),
                   *(rate(row["parts"], part) for part in SHOWN)] for row in rows])


def modes():
    """On how many parts a mode stands on the front, by scene, and by how much it is beaten."""
    data = load("trade")
    scenes = [scene["scene"] for scene in data["scenes"]]
    names = dict.fromkeys((row["layout"], row["mode"]) for row in data["rows"])

    def count(name, scene):
        rows = [row for row in data["rows"] if (row["layout"], row["mode"]) == name and row["scene"] == scene]
        if not rows:
            return NONE
        on = {part for row in rows for part, of in row["parts"].items() if of[3]}
        return str(len(on))

    return Table(["layout", "mode", *scenes], [[*name, *(count(name, scene) for scene in scenes)] for name in names])


CHIPS = {"rp2040": "RP2040", "rp2350": "RP2350", "esp32s3": "ESP32-S3", "stm32f4": "STM32F407", "stm32h7": "STM32H743"}


def clock_rows(mode_of):
    """Rows of the desk clock without its smallest fields; `mode_of` gives the mode of each layout."""
    least = {"surface": 100_000, "chord": 500_000}
    return [row for row in load("trade")["rows"]
            if row["scene"] == "clock" and row["mode"] == mode_of[row["layout"]] and row["flash_bytes"] > least[row["layout"]]]


def first_table():
    """Answers a visitor's first question: how large, how like the truth and how fast antialiased surface fields are."""
    return Table(["mode", "flash", "RAM", "likeness", *CHIPS.values()],
                 [[row["mode"], byte_text(row["flash_bytes"], 1), f"{decimal(row['ram_bytes'] / 1e3, 0)} kB",
                   f"{decimal(row['psnr_db'])} dB",
                   *("{} ({})".format(*map(whole, row["parts"][chip][:2])) for chip in CHIPS)]
                  for row in clock_rows({"surface": "antialiased", "chord": None})])


def beside():
    """Instructions a covered pixel of another renderer, which was measured once, by hand."""
    return Table.of(["renderer", "with an FPU", "Cortex-M0+"], load("once")["renderers"],
                    lambda row: [row["renderer"], row["fpu"], row["m0plus"]])


def quality():
    """Compares fields and other ways to show the desk clock; those were measured once."""
    others = load("once")["quality"]
    fields = [row for row in load("trade")["quality"] if row["layout"] not in {row["layout"] for row in others}]
    return Table.of(["layout", "flash", "triangles", "PSNR dB", "SSIM", "CW-SSIM", "FLIP", "mask PSNR", "worst view"],
                    [*fields, *others], lambda row: [
        row["layout"], byte_text(row["flash_bytes"]) if row["flash_bytes"] else NONE, or_none(row.get("triangles")),
        decimal(row["psnr_db"], 2), decimal(row["ssim"], 4), decimal(row["cw_ssim"], 4), decimal(row["flip"], 4),
        decimal(row["mask_psnr_db"], 2), f"{decimal(row['worst_view']['psnr_db'])} ({row['worst_view']['view'] + 1})"])
