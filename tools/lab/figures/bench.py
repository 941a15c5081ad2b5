# SPDX-License-Identifier: MIT
"""Speed against accuracy: what `lumi-lab bench --docs` counted."""
from .table import NONE, Table, decimal, load

CORES = ["m0plus", "m4"]
SPLIT = ["vertices", "lists", "lights", "edges", "samples", "outlines", "resolve", "palette"]
# A reader looks for these first.
GLANCES = [("nearest", "rgb565", 16), ("linear", "luma8", 16), ("linear", "palette8", 16), ("linear", "rgb888", 16),
           ("linear", "luma8", 8), ("linear", "palette8", 8), ("linear", "rgb888", 8)]


def distinct(rows, *keys):
    return list(dict.fromkeys(tuple(row[key] for key in keys) for row in rows))


def find(rows, **wanted):
    return next((row for row in rows if all(row[key] == value for key, value in wanted.items())), None)


def cell(row, text):
    return NONE if row is None else text(row)


def per_pixel(digits=1):
    return lambda row: decimal(row["instructions_per_pixel"], digits)


def psnr(row):
    return decimal(row["psnr_db"])


class Tradeoff:
    def __init__(self, data):
        self.data = data
        self.chord = [row for row in data["rows"] if row["layout"] == "chord"]
        self.surface = [row for row in data["rows"] if row["layout"] == "surface"]
        self.renderers = distinct(self.chord, "mode", "texel")
        self.spans = sorted({row["span"] for row in self.chord})

    def by_renderer(self, title, columns, texts):
        """A row for each mode and texel that has a cell; `texts` makes these."""
        rows = [(f"{mode} {texel}", texts(mode, texel)) for mode, texel in self.renderers]
        return Table([title, *columns], [[name, *cells] for name, cells in rows if any(cell != NONE for cell in cells)])

    def chord_row(self, core, mode, texel, span, view="generic"):
        return find(self.chord, core=core, mode=mode, texel=texel, span=span, view=view)

    def glance(self):
        return Table(["renderer", "M4", "M0+ code", "dB generic", "dB pole"],
                     [[f"{mode} {texel}, S = {span}", cell(self.chord_row("m4", mode, texel, span), per_pixel()),
                       cell(self.chord_row("m0plus", mode, texel, span), per_pixel()),
                       cell(self.chord_row("m4", mode, texel, span), psnr),
                       cell(self.chord_row("m4", mode, texel, span, "pole"), psnr)] for mode, texel, span in GLANCES])

    def cost(self):
        keys = [(core, span) for core in CORES for span in self.spans]
        return self.by_renderer("renderer", [f"{core} exact" if span == 0 else f"{core} S{span}" for core, span in keys],
                                lambda mode, texel: [cell(self.chord_row(core, mode, texel, span), per_pixel(0))
                                                     for core, span in keys])

    def split(self):
        keys = [(core, span) for core in ("m4", "m0plus") for span in (8, 16)]
        return self.by_renderer("renderer", [f"{core} S{span} set-up + inner" for core, span in keys],
                                lambda mode, texel: [cell(self.chord_row(core, mode, texel, span), lambda row:
                                                          f"{decimal(row['setup'])} + {decimal(row['inner'])}")
                                                     for core, span in keys])

    def parts(self):
        def shape(cache):
            return f"{cache['bytes']} B, {cache['ways']}, {cache['line_bytes']} B"
        return Table(["part", "code", "MHz", "clocks/instruction", "cache, ways, line", "miss, ns", "remark"],
                     [[part["title"], part["core"], decimal(part["clock_mhz"], 0),
                       decimal(part["clocks_per_instruction"], 2), shape(part["cache"]), decimal(part["miss_ns"], 0),
                       part["remark"]] for part in self.data["parts"]])

    def surface_renderers(self):
        return distinct(sorted(self.surface, key=lambda row: row["pixel"]), "mode", "pixel")

    def surface_row(self, core, mode, pixel, view="generic"):
        return find(self.surface, core=core, mode=mode, pixel=pixel, view=view)

    def by_surface_renderer(self, columns, texts, cores=("",)):
        order = [mode for mode, in distinct(self.surface, "mode")]
        renderers = sorted(self.surface_renderers(), key=lambda renderer: order.index(renderer[0]))
        return Table(["renderer", *columns], [[f"{core} {mode} {pixel}".strip(), *texts(core, mode, pixel)]
                                              for core in cores for mode, pixel in renderers])

    def surface_cost(self):
        def texts(_, mode, pixel):
            return [*(cell(self.surface_row(core, mode, pixel), per_pixel()) for core in CORES),
                    cell(find(self.surface, mode=mode, pixel=pixel), lambda row: row["ram_bytes"])]
        return self.by_surface_renderer([*CORES, "RAM, bytes"], texts)

    def surface_split(self):
        return self.by_surface_renderer(
            ["view tables" if part == "lights" else part for part in SPLIT],
            lambda core, mode, pixel: [cell(self.surface_row(core, mode, pixel), lambda row: decimal(row[part]))
                                       for part in SPLIT], ("m4", "m0plus"))


def table(name):
    return getattr(Tradeoff(load("tradeoff")), name)()
