# SPDX-License-Identifier: MIT
"""The trade of a chord field: what tools/lab/sweep.sh measured, with the instructions of the trade-off's data."""
import json
import pathlib

from . import tradeoff
from .table import NONE, Table, byte_text, decimal, load, mean, or_none, whole

SPAN = 16  # pixels of the spans that instructions are told for


def collect(folder):
    """The data, of all that was measured so far."""
    folder = pathlib.Path(folder)
    data = {"views": 0, "reference_samples": 0, "rows": [], "kernel": [], "cost": []}
    for file in sorted(folder.glob("*.report.json")):
        report, (scene, lattice, *texel) = json.loads(file.read_text()), file.name.split(".")[0].split("-")
        data["views"], data["reference_samples"] = len(report["views"]), report["reference_samples"]
        measured = [("linear" if texel else "2x2", report["fields"][0])]
        measured += [(variant["layout"], variant) for variant in report["variants"]]
        for mode, of_mode in measured:
            data["rows"].append({"scene": scene, "kind": "chord" if texel else "surface", "lattice": lattice,
                                 "texel": "".join(texel), "mode": mode, "bytes": of_mode["flash_bytes"],
                                 "psnr_db": of_mode["psnr_db"], "ssim": of_mode["ssim"]})
    for file in sorted(folder.glob("*.kernel.json")):
        for variant in json.loads(file.read_text())["variants"]:
            data["kernel"].append({"scene": file.name.split(".")[0], "k": int(variant["layout"][5:]),
                                   **{key: variant[key] for key in ("psnr_db", "ssim", "draw_ms")}})
    for file in sorted(folder.glob("*.cost.json")):
        origins, directions = map(int, file.name.split(".")[0].split("x"))
        data["cost"] += [{"origins": origins, "directions": directions, "mode": row["mode"], "span": row["span"],
                          "instructions_per_pixel": row["instructions_per_pixel"]} for row in json.loads(file.read_text())]
    return data


def grouped(rows, *keys):
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), []).append(row)
    return groups


def cost_of(row):
    """Instructions a covered pixel on M4."""
    if row["kind"] == "surface":
        return tradeoff.surface_cost_of(row["mode"].replace(" ", "-"), "m4")
    found = tradeoff.find(load("tradeoff")["rows"], layout="chord", core="m4", mode=row["mode"].rstrip("5"),
                          texel=row["texel"], span=SPAN, view="generic")
    return found and whole(found["instructions_per_pixel"])


def is_beaten(row, other):
    """Whether the other takes no more of anything, shows no less, and is not the same."""
    mine, theirs = ((r["bytes"], r["instructions"] or 0, -r["psnr_db"]) for r in (row, other))
    return other["kind"] == row["kind"] and theirs != mine and all(t <= m for t, m in zip(theirs, mine))


def means():
    """The same field of every scene as one row, cheapest first; `front` where no other of its kind beats it."""
    rows = load("sweep")["rows"]
    scenes = sorted({row["scene"] for row in rows})
    found = [{**group[0], "scenes": group, "instructions": cost_of(group[0]),
              **{key: mean(row[key] for row in group) for key in ("bytes", "psnr_db", "ssim")}}
             for group in grouped(rows, "kind", "lattice", "texel", "mode").values() if len(group) == len(scenes)]
    found.sort(key=lambda row: (row["bytes"], row["instructions"] or 0))
    for row in found:
        row["front"] = not any(is_beaten(row, other) for other in found)
    return found


def both(row):
    return f"{decimal(row['psnr_db'], 2)} / {decimal(row['ssim'], 3)}"


def trade():
    rows = means()
    scenes = [row["scene"] for row in rows[0]["scenes"]] if rows else []
    return Table(
        ["field", "mode", "flash", "instructions a pixel, M4", "dB", "SSIM", *(f"{scene}, dB / SSIM" for scene in scenes),
         "front"],
        [[f"surface, {row['lattice']}" if row["kind"] == "surface" else f"{row['lattice'].replace('x', ' × ')} {row['texel']}",
          row["mode"], byte_text(row["bytes"]), or_none(row["instructions"]), decimal(row["psnr_db"], 2),
          decimal(row["ssim"], 4), *map(both, row["scenes"]), "●" if row["front"] else ""] for row in rows])


def kernel():
    groups = grouped(load("sweep")["kernel"], "k")
    scenes = [row["scene"] for row in next(iter(groups.values()), [])]
    return Table(["K", "dB", "SSIM", *(f"{scene}, dB / SSIM" for scene in scenes), "ms a picture, host"],
                 [[k, decimal(mean(row["psnr_db"] for row in rows), 2), decimal(mean(row["ssim"] for row in rows), 4),
                   *map(both, rows), decimal(mean(row["draw_ms"] for row in rows), 0)] for (k,), rows in groups.items()])


def kernel_verdict():
    """What the table of K says in words."""
    db = [mean(row["psnr_db"] for row in rows) for rows in grouped(load("sweep")["kernel"], "k").values()]
    enough = next(k for k, value in enumerate(db) if db[-1] - value < 0.05) + 1
    return (f"From K = {enough} on nothing gains 0.05 dB; from 1 to {enough} it is {db[enough - 1] - db[0]:.2f} dB.\n")


def cost():
    """Square lattices and those of more origins first, then those of more directions."""
    groups = grouped(load("sweep")["cost"], "origins", "directions")

    def text(rows, mode, span):
        row = tradeoff.find(rows, mode=mode, span=span)
        return NONE if row is None else decimal(row["instructions_per_pixel"], 0)
    return Table(["M", "N", "nearest, exact", f"nearest, S = {SPAN}", "linear, exact", f"linear, S = {SPAN}"],
                 [[m, n, *(text(groups[m, n], mode, span) for mode in ("nearest", "linear") for span in (0, SPAN))]
                  for m, n in sorted(groups, key=lambda key: (key[0] < key[1], key))])
