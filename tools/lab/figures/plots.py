# SPDX-License-Identifier: MIT
"""Plots of docs/img, by matplotlib (Debian: python3-matplotlib). The same bytes of the same data."""
import sys

from .table import ROOT, load
from .tradeoff import CORES, Tradeoff

FOLDER = ROOT / "docs/img"


def draw(name, title, x_title, y_title, series, log=True):
    """`series`: name to points (x, y, label)."""
    try:
        import matplotlib  # needed only here
    except ImportError:
        sys.exit("matplotlib is missing: apt-get install python3-matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot
    matplotlib.rcParams.update({"svg.hashsalt": "lumi", "svg.fonttype": "none", "font.size": 9})
    figure, axes = pyplot.subplots(figsize=(9, 5), layout="constrained")
    styles = [(colour, dash) for dash in ("-", "--", ":") for colour in pyplot.colormaps["tab10"].colors]
    for (label, points), (colour, dash) in zip(series.items(), styles):
        axes.plot([p[0] for p in points], [p[1] for p in points], dash, color=colour, marker="o", markersize=3.5, label=label)
        for x, y, text in points:
            axes.annotate(text, (x, y), xytext=(4, 4), textcoords="offset points", fontsize=7)
    axes.set(title=title, xlabel=x_title, ylabel=y_title, xscale="log" if log else "linear")
    axes.grid(True, which="both", color="#dddddd")
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5), fontsize=7)
    figure.savefig(FOLDER / name, metadata={"Date": None})
    pyplot.close(figure)


def draw_tradeoff():
    """A plot a core; exact pictures, which do not differ, have no place on it."""
    trade = Tradeoff(load("tradeoff"))
    for core in CORES:
        series = {}
        for mode, texel in trade.renderers:
            rows = [trade.chord_row(core, mode, texel, span) for span in trade.spans]
            points = [(row["instructions_per_pixel"], row["psnr_db"], str(row["span"] or "exact")) for row in rows
                      if row and row["psnr_db"] is not None]
            if points:
                series[f"{mode} {texel}"] = points
        draw(f"tradeoff-{core}.svg", f"Cost and accuracy on {core}, generic view; labels are span lengths in pixels",
             "instructions per covered pixel", "PSNR against exact, dB", series)


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
    import matplotlib
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


def draw_all():
    draw_front()
    draw_tradeoff()
