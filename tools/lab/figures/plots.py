# SPDX-License-Identifier: MIT
"""The plot of docs/tradeoff.md, docs/img/front.svg: a panel a scene, frames a second across, dB up."""
import math

from .table import ROOT, load

WIDTH, HEIGHT, LEFT, TOP, BOTTOM = 400, 330, 44, 34, 44  # a panel and its margins, in px
TICKS = [0.2, 0.5, 1, 2, 5, 10, 20, 50, 100]
WANTED = 10  # frames a second, marked by a line
COLOURS = {"surface": "#1668b8", "chord": "#c8541a"}
BEATEN = "#c4c4c4"


def text(x, y, words, anchor="middle", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{words}</text>'


def line(x1, y1, x2, y2, colour="#e6e6e6", more=""):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" {more}/>'


class Panel:
    """Maps frames a second and dB to the panel's px."""

    def __init__(self, left, rows, part):
        self.left = left
        rates = [math.log(row["parts"][part][0]) for row in rows]
        levels = [row["psnr_db"] for row in rows]
        self.low, self.high = min(rates) - 0.3, max(rates) + 0.2
        self.bottom, self.top = min(levels) - 1, max(levels) + 1

    def x(self, rate):
        return self.left + LEFT + (math.log(rate) - self.low) / (self.high - self.low) * (WIDTH - LEFT - 10)

    def y(self, level):
        return TOP + (self.top - level) / (self.top - self.bottom) * (HEIGHT - TOP - BOTTOM)

    def holds(self, rate):
        return self.low < math.log(rate) < self.high


def axes(panel, title):
    bottom = HEIGHT - BOTTOM
    yield text(panel.left + WIDTH / 2, 20, title, more='font-size="13"')
    for rate in filter(panel.holds, TICKS):
        yield line(panel.x(rate), TOP, panel.x(rate), bottom)
        yield text(panel.x(rate), bottom + 15, f"{rate:g}")
    yield text(panel.left + WIDTH / 2, bottom + 32, "frames a second")
    for level in range(math.ceil(panel.bottom), math.floor(panel.top) + 1, 2):
        yield line(panel.left + LEFT, panel.y(level), panel.left + WIDTH - 10, panel.y(level))
        yield text(panel.left + LEFT - 6, panel.y(level) + 4, level, "end")
    if panel.holds(WANTED):
        yield line(panel.x(WANTED), TOP, panel.x(WANTED), bottom, "#888888", 'stroke-dasharray="4 3"')


def marks(panel, rows, part):
    """The area of a mark is the flash; ways that another one beats are grey and behind."""
    for row in sorted(rows, key=lambda row: row["parts"][part][3]):
        rate, _, _, is_front = row["parts"][part]
        radius = 2 + 5 * (row["flash_bytes"] / 4e6) ** 0.25
        colour = COLOURS[row["layout"]] if is_front else BEATEN
        yield f'<circle cx="{panel.x(rate):.1f}" cy="{panel.y(row["psnr_db"]):.1f}" r="{radius:.1f}" fill="{colour}"/>'


def labels(panel, rows, part):
    """Names of the ways that none beats, but for those that lie close below another label."""
    last = math.inf
    for row in sorted((row for row in rows if row["parts"][part][3]), key=lambda row: -row["psnr_db"]):
        y = panel.y(row["psnr_db"])
        if last == math.inf or y - last > 11:
            last = y
            yield text(panel.x(row["parts"][part][0]) - 9, y + 3, f"{row['field'].split('-')[1]} {row['mode']}", "end",
                       'font-size="9"')


def draw_front(part="rp2040"):
    data, drawn = load("trade"), []
    for k, scene in enumerate(data["scenes"]):
        rows = [row for row in data["rows"] if row["scene"] == scene["scene"] and row["parts"][part][2]]
        panel = Panel(k * WIDTH, rows, part)
        drawn += [*axes(panel, scene["title"]), *marks(panel, rows, part), *labels(panel, rows, part)]
    drawn.append(text(0, 0, "PSNR, dB", more=f'transform="translate(12 {HEIGHT // 2}) rotate(-90)"'))
    size = f'width="{WIDTH * len(data["scenes"])}" height="{HEIGHT}"'
    (ROOT / "docs/img/front.svg").write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="11">\n'
        f'<rect {size} fill="white"/>\n' + "\n".join(drawn) + "\n</svg>\n", encoding="utf-8")
