# SPDX-License-Identifier: MIT
"""What a field that is planned for a rate shows beside those of a size, as tools/lab/front.py measured it."""
from .table import NONE, Table, decimal, load


def best(rows, rate):
    """The most dB that some field and mode show at a rate, and which."""
    shown = [(row["psnr_db"][mode], row["asked"], mode) for row in rows for mode in row["psnr_db"] if row["fps"][mode] >= rate]
    return max(shown) if shown else (None, None, None)


def beside(rows):
    """For each rate that fields of a scene were planned for: what those show, and the best of those of a size."""
    of_size = [row for row in rows if "@" not in row["asked"]]
    for pace in dict.fromkeys(row["asked"] for row in rows if "@" in row["asked"]):
        rate = 0.98 * float(pace.partition("@")[2].removesuffix("fps"))  # plans know the rates of 40 poses, not of all
        planned, _, mode = best([row for row in rows if row["asked"] == pace], rate)
        size_db, size, size_mode = best(of_size, rate)
        yield {"scene": rows[0]["scene"], "for": pace, "db": planned, "mode": mode, "size_db": size_db, "size": size, "size_mode": size_mode}


def rates():
    """dB of the planned field, and of the best size, by scene and rate."""
    def db(value):
        return NONE if value is None else decimal(value)
    rows = load("front")["rates"]
    found = {scene: list(beside([row for row in rows if row["scene"] == scene])) for scene in dict.fromkeys(row["scene"] for row in rows)}
    paces = [row["for"].partition("@")[2].replace("fps", " fps") for row in next(iter(found.values()))]
    return Table(["scene", *paces], [[scene, *(f"{db(row['db'])} ({db(row['size_db'])})" for row in of)] for scene, of in found.items()])
