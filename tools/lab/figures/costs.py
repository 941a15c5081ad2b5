# SPDX-License-Identifier: MIT
"""What the planner's model makes of frames, beside what boards executed (tools/lab/proof/cost_model.py)."""
from .table import NONE, Table, load

VIEWS = ["generic", "pole", "close"]
LIMIT = 5  # per cent, which the model should keep


def signed(value):
    return f"{value:+.1f}".replace("-", "−")


def cores(cells):
    return list(dict.fromkeys(cell["core"] for cell in cells))


def errors(part):
    """A row for each field and mode: the errors of the three views, by core."""
    cells = load("cost-model")[part]
    keys = ["field", "mode"] + ["drawn"] * (part == "chord")
    rows = []
    for key in dict.fromkeys(tuple(cell[k] for k in keys) for cell in cells):
        of = {cell["core"]: cell for cell in cells if tuple(cell[k] for k in keys) == key}
        rows.append([*key, *(" ".join(signed(of[core][view]) for view in VIEWS) if core in of else NONE for core in cores(cells))])
    return Table([*keys, *cores(cells)], rows)


def worst():
    """By mode: the largest error of the fields that were fitted, of those that were not, and how many cells are beyond the
    limit."""
    rows = []
    for part, cells in load("cost-model").items():
        for key in dict.fromkeys((cell["mode"], cell.get("drawn", "")) for cell in cells):
            of = [cell for cell in cells if (cell["mode"], cell.get("drawn", "")) == key]
            seen = [cell[view] for cell in of for view in VIEWS if not cell["field"].startswith("unseen")]
            unseen = [cell[view] for cell in of for view in VIEWS if cell["field"].startswith("unseen")]
            beyond = sum(abs(value) > LIMIT for value in seen + unseen)

            def most(values):
                return signed(max(values, key=abs)) if values else NONE

            has_poses = part == "surface"
            rows.append([" ".join(key).strip(), most(seen), most(unseen), f"{beyond} of {len(seen + unseen)}",
                         most([cell["stripes"] for cell in of]) if has_poses else NONE,
                         most([cell["pose"] for cell in of]) if has_poses else NONE,
                         most([cell["poses"] for cell in of]) if has_poses else NONE])
    return Table(["mode", "worst, %", "worst of unseen fields, %", "beyond 5 %", "in stripes of 2 to 24 rows, %", "of 200 poses, %",
                  "mean of the poses, %"], rows)
