# SPDX-License-Identifier: MIT
"""Fits instructions of kinds of work to counts: least squares of relative errors, the larger ones with more weight; no cost below zero."""
import re

import numpy as np


def non_negative(matrix, target):
    """The x >= 0 with the least |matrix x - target| (Lawson and Hanson, 1974)."""
    rows, columns = matrix.shape
    scale = np.sqrt((matrix ** 2).sum(0))
    scale[scale == 0] = 1
    a = matrix / scale
    x, free = np.zeros(columns), np.zeros(columns, bool)
    for _ in range(10 * columns):
        gradient = a.T @ (target - a @ x)
        gradient[free] = -np.inf
        k = int(np.argmax(gradient))
        if gradient[k] <= 1e-9:
            break
        free[k] = True
        while True:
            s = np.zeros(columns)
            s[free] = np.linalg.lstsq(a[:, free], target, rcond=None)[0]
            if (s[free] > 0).all():
                x = s
                break
            down = free & (s <= 0)
            step = np.min(x[down] / (x[down] - s[down] + 1e-30))
            x = x + step * (s - x)
            free &= x > 1e-12
            x[~free] = 0
    return x / scale


# Where chord rows have large errors they get more weight, step by step, so that the worst error becomes small, too.
STEPS, FLOOR = 3, 0.35


def fitted(rows, names, counted, weight=lambda row: 1.0, steps=0):
    """Costs of `names`, by rows' counts. `counted(row)`: instructions; errors are relative to the whole frame."""
    matrix = np.array([[row["counts"][name] for name in names] for row in rows], float)
    target = np.array([counted(row) for row in rows], float)
    relative = np.array([1 / row["counted"] for row in rows])
    weights = np.array([weight(row) for row in rows], float)
    for _ in range(steps + 1):
        scale = relative * weights
        costs = non_negative(matrix * scale[:, None], target * scale)
        errors = np.abs(matrix @ costs - target) * relative
        weights *= np.sqrt(FLOOR + errors / max(errors.max(), 1e-12))
        weights /= weights.mean()
    return dict(zip(names, costs))


def modelled(costs, counts):
    return sum(cost * counts[name] for name, cost in costs.items())


# Kinds of work that prepare a frame, by the parts of the bench's counts; all other kinds belong to the stripes.
PREPARING = {"palette": ["frame"], "vertices": ["vertex"], "lists": ["patch", "listed", "bordered"],
             "lights": ["lit", "cornered"], "order": ["see_frame", "see_patch", "ordered"]}
UNUSED = ["sorted"]
SETUP = ["image_px", "scanline", "band", "tile", "wide_tile", "narrow_tile", "missed_tile", "zone", "capped", "tile_line", "gap",
         "span", "span_pixel", "lone", "checked", "cell_pixel", "pole_pixel", "polar_side", "made_zone", "searched", "shortened"]
INNER = ["tile", "wide_tile", "tile_line", "tile_pixel", "span", "span_pixel", "mixed", "mixed_line", "mixed_pixel", "lone_line", "steep_pixel",
         "checked", "cell_pixel", "pole_pixel", "checked_row", "row", "tap_rgb888", "tap_rgb565",
         "tap_palette8", "tap_luma8"]
# Over black, Nearest alone asks whether a texel shows something.
INNER_OF = {"nearest": [*INNER, "half_clear", "shown"], "linear": INNER}
HITS = ["image_px", "pixel"]
LATTICE = ["pixel", "few_side", "few_point", "cap_side", "pole_side", "blend_side", "zone_step", "row", "tap_rgb888", "tap_rgb565",
           "tap_palette8", "tap_luma8", "clear", "half_clear"]
SURFACE_MODES = ["one-sample", "antialiased", "2x2"]
CHORD_MODES = ["nearest", "linear", "paper"]
TEXELS = ["rgb888", "rgb565", "palette8", "luma8"]


def is_seen(row):
    return not row["field"].startswith("unseen")


def added(*costs):
    names = {name for of in costs for name in of}
    return {name: sum(of.get(name, 0) for of in costs) for name in names}


def surface_costs(rows):
    """Fits the costs of one core and mode to its rows."""
    views = [row for row in rows if row["kind"] == "views"]
    costs = {}
    for part, names in PREPARING.items():
        of = [row for row in views if part != "order" or row["counts"]["see_frame"]]
        costs.update(fitted(of, names, lambda row: row["parts"][part]))
    rest = [name for name in rows[0]["counts"] if name not in costs and name not in UNUSED]
    costs.update(fitted(rows, rest, lambda row: row["counted"] - modelled(costs, row["counts"]),
                        lambda row: 3 if row["kind"] == "views" else 1))
    return costs


def two_parts(rows, setup_rows, of_setup, of_rest):
    setup = fitted(setup_rows, of_setup, lambda row: row["setup"])
    return added(setup, fitted(rows, of_rest, lambda row: row["counted"] - modelled(setup, row["counts"]), steps=STEPS))


def by_core(rows, costs):
    """Costs of each core, from its rows whose fields are seen."""
    return [costs([row for row in rows if row["core"] == core and is_seen(row)])
            for core in dict.fromkeys(row["core"] for row in rows)]


def by_surface_mode(rows):
    return [surface_costs([row for row in rows if row["mode"] == mode]) for mode in SURFACE_MODES]


def by_exact_mode(rows):
    exact = [row for row in rows if not row["span"]]
    of_mode = [[row for row in exact if row["mode"] == mode] for mode in CHORD_MODES]
    return [two_parts(of, of, HITS, LATTICE) for of in of_mode]


def by_span_mode(rows):
    spans = [row for row in rows if row["span"]]
    return [[two_parts([row for row in spans if (row["mode"], row["texel"]) == (mode, texel)], spans, SETUP, INNER_OF[mode])
             for texel in TEXELS] for mode in INNER_OF]


# Arrays of costs that are fitted to the counts of a layout: by core, then by mode; those of spans by texel format, too.
ARRAYS = {"surface": {"kSurfaceCosts": by_surface_mode},
          "chord": {"kExactCosts": by_exact_mode, "kSpanCosts": by_span_mode}}


def initializer(costs, names):
    if isinstance(costs, list):
        return "{" + ",\n".join(initializer(part, names) for part in costs) + "}"
    return "{" + ", ".join(f"{costs.get(name, 0):.4g}" for name in names) + "}"


def renewed(header, layout, rows):
    """The C++ header with the layout's costs fitted to `rows`."""
    for array, costs in ARRAYS[layout].items():
        values = initializer(by_core(rows, costs), rows[0]["counts"])
        header, found = re.subn(rf"( {array}\[[^=]*= ){{.*?}};", lambda match: f"{match[1]}{values};", header, flags=re.DOTALL)
        assert found == 1, array
    return header
