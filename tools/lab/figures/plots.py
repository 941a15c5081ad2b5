# SPDX-License-Identifier: MIT
"""Draws the plot of docs/tradeoff.md by matplotlib (Debian: python3-matplotlib). Equal data give equal bytes."""
import sys

from .table import ROOT, load

FOLDER = ROOT / "docs/img"


def labelled(front, part):
    """Those of a front that do not lie beside another one that has a label."""
    spread = max(row["psnr_db"] for row in front) - min(row["psnr_db"] for row in front)
    shown = []
    for row in sorted(front, key=lambda row: -row["psnr_db"]):
        if not shown or shown[-1]["psnr_db"] - row["psnr_db"] > 0.035 * spread:
            shown.append(row)
    return shown


def draw_front(part="rp2040"):
    """A panel a scene: frames a second across, dB up, the area of a mark its flash; beaten ways are grey."""
    try:
        import matplotlib  # needed only here
    except ImportError:
        sys.exit("matplotlib is missing: apt-get install python3-matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot
    matplotlib.rcParams.update({"svg.hashsalt": "lumi", "svg.fonttype": "none", "font.size": 9})
    data = load("trade")
    figure, panels = pyplot.subplots(1, len(data["scenes"]), figsize=(12, 4.6), layout="constrained", squeeze=False)
    colours = {"surface": "#1668b8", "chord": "#c8541a"}
    for axes, scene in zip(panels[0], data["scenes"]):
        rows = [row for row in data["rows"] if row["scene"] == scene["scene"] and row["parts"][part][2]]
        for row in sorted(rows, key=lambda row: row["parts"][part][3]):
            fps, _, _, is_front = row["parts"][part]
            axes.scatter(fps, row["psnr_db"], s=8 + 90 * (row["flash_bytes"] / 4e6) ** 0.5, marker="o" if row["layout"] == "surface" else "s",
                         color=colours[row["layout"]] if is_front else "#c4c4c4", linewidths=0, zorder=3 if is_front else 2)
        front = [row for row in rows if row["parts"][part][3]]
        front.sort(key=lambda row: row["parts"][part][0])
        axes.plot([row["parts"][part][0] for row in front], [row["psnr_db"] for row in front], color="#888888", linewidth=0.8, zorder=1)
        for row in labelled(front, part):
            axes.annotate(f"{row['field'].split('-')[1]} {row['mode']}", (row["parts"][part][0], row["psnr_db"]), xytext=(-7, -3),
                          textcoords="offset points", fontsize=7, ha="right")
        axes.axvline(10, color="#888888", linewidth=0.8, linestyle="--")
        axes.set(title=scene["title"], xlabel="frames a second", xscale="log")
        axes.set_xticks([0.2, 0.5, 1, 2, 5, 10, 20, 40], ["0.2", "0.5", "1", "2", "5", "10", "20", "40"])
        axes.minorticks_off()
        axes.margins(x=0.12)
        axes.grid(True, color="#e6e6e6")
    panels[0][0].set_ylabel("PSNR against path-traced pictures, dB")
    figure.savefig(FOLDER / "front.svg", metadata={"Date": None})
    pyplot.close(figure)
