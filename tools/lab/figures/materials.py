# SPDX-License-Identifier: MIT
"""What materials send back, here and in Cycles: data of tools/lab/materials."""
from .table import Table, decimal, load, mean

LIMIT = 0.03  # from Cycles, of the mean under the sky
WHITE_GAIN = 0.01  # of white materials; what they lose is told
MULTI = " multi"  # the same material, whose facets Cycles lets light leave after more than one bounce
# Materials that are judged by another limit, and why.
EXPLAINED = {
    "coat metal": (0.05, "Cycles loses 4 % of what is under a coat, in the sky only"),
    "metal 0.9 1 multi": (0.06, "we estimate what bounces twice (Kulla & Conty)"),
}
# With highlights under the sun that are brighter than a picture holds.
NARROW = ("metal 0.9 0.05", "metal 0.9 0.2", "coat", " 0.2", "specular")


def is_white(name):
    kind, base = name.split()[:2]
    return kind == "glass" or base == "1"


def by_name(data):
    return {row["name"]: row for row in load(data)["materials"]}


def pairs(white):
    """Names with Cycles' row and ours."""
    ours = by_name("materials")
    return [(name, row, ours[name]) for name, row in by_name("cycles").items() if is_white(name) == white]


def difference(ours, cycles):
    return mean(ours) / mean(cycles) - 1


def limit(name):
    """Nothing where Cycles loses what bounces twice: its other variant is judged in place."""
    return None if name + MULTI in by_name("cycles") else EXPLAINED.get(name, (LIMIT, ""))[0]


def note(name):
    return "Cycles loses what bounces twice" if limit(name) is None else EXPLAINED.get(name, (0, ""))[1]


def wrong():
    gaining = [name for name, _, ours in pairs(white=True) if mean(ours["sky"]) > 1 + WHITE_GAIN]
    far = [name for name, cycles, ours in pairs(white=False)
           if limit(name) is not None and abs(difference(ours["sky"], cycles["sky"])) > limit(name)]
    return gaining + far


def percent(share):
    return f"{100 * share:+.1f} %"


def coloured_row(name, cycles, ours):
    rings = [a / b - 1 for a, b in zip(ours["sky"], cycles["sky"])]
    wide = "sun" in ours and not any(part in name for part in NARROW)
    return [name, decimal(mean(cycles["sky"]), 3), decimal(mean(ours["sky"]), 3),
            percent(difference(ours["sky"], cycles["sky"])), f"{percent(min(rings))} … {percent(max(rings))}",
            percent(difference(ours["sun"], cycles["sun"])) if wide else "", note(name)]


def coloured():
    columns = ["material", "Cycles", "ours", "difference", "of the rings", "under the sun", "why"]
    return Table(columns, [coloured_row(*pair) for pair in pairs(white=False)])


def white():
    rows = [[name, *(percent(mean(side["sky"]) - 1) for side in sides)] for name, *sides in pairs(white=True)]
    return Table(["white material", "Cycles", "ours"], rows)
