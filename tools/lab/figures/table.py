# SPDX-License-Identifier: MIT
"""Tables as pages show them, and the data that they are made of."""
import datetime
import json
import math
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
DATA = ROOT / "docs/log/data"
NONE = "–"  # not measured
NUMBER = re.compile(r"[+\-−–∞●*]|\d")  # how a cell begins that stands at the right of its column


shown = {}  # data in place of that of docs/log/data, by name


def load(name):
    if name in shown:
        return shown[name]
    return json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))


def text_of(data):
    """JSON with a line for each row of a list, so that changes are seen."""
    def line(value):
        return json.dumps(value, ensure_ascii=False)

    def part(value):
        return "[\n  " + ",\n  ".join(map(line, value)) + "\n ]" if isinstance(value, list) and value else line(value)
    return "{\n " + ",\n ".join(f"{line(key)}: {part(value)}" for key, value in data.items()) + "\n}\n"


# Figures depend on all code, but for the programs that write tables of data.
MEASURED = ["core", "baker", "platform", "tools", "toolchains", ":!tools/lab/pages.py", ":!tools/lab/figures", ":!*.md"]


def measured_commit():
    """The commit that a measurement is of: the last one that changed MEASURED."""
    return os.environ.get("LUMI_MEASURED") or subprocess.run(
        ["git", "-C", ROOT, "log", "-1", "--format=%h", "--abbrev=10", "--", *MEASURED], capture_output=True, text=True,
        check=True).stdout.strip()


def save(name, data):
    """Each file of data begins with the commit that it is of, and the day."""
    DATA.mkdir(exist_ok=True)
    of = {"commit": measured_commit(), "date": datetime.date.today().isoformat()}
    rest = {key: data[key] for key in data if key not in of}
    (DATA / f"{name}.json").write_text(text_of({**of, **rest}), encoding="utf-8")


def commits():
    """{name of the data: its commit}, but for those that tools/lab/figures.sh does not measure."""
    apart = ("cycles", "front", "once")
    return {path.stem: load(path.stem)["commit"] for path in sorted(DATA.glob("*.json")) if path.stem not in apart}


def rows_of(text):
    """Rows of JSON one after the other, or lists of them."""
    decoder, rows = json.JSONDecoder(), []
    while text := text.lstrip():
        value, end = decoder.raw_decode(text)
        rows += value if isinstance(value, list) else [value]
        text = text[end:]
    return rows


def put(name, part, text):
    """The rows become that part of the data."""
    save(name, {**(load(name) if (DATA / f"{name}.json").exists() else {}), part: rows_of(text)})


def decimal(value, digits=1):
    """'12.3'; '∞' for null, which JSON has in place of infinity."""
    return "∞" if value is None else f"{value:.{digits}f}"


def or_none(value):
    return NONE if value is None else str(value)


def byte_text(count, digits=2):
    return f"{count / 1e6:.{digits}f} MB" if count >= 1e6 else f"{count / 1e3:.0f} kB"


def whole(value):
    """Halves go up, as readers expect."""
    return math.floor(value + 0.5)


def mean(values):
    values = list(values)
    return sum(values) / len(values)


class Table:
    def __init__(self, columns, rows):
        self.columns, self.rows = columns, [[str(cell) for cell in row] for row in rows]

    @staticmethod
    def of(columns, rows, cells):
        """A row of cells(row) for each row of data."""
        return Table(columns, [cells(row) for row in rows])

    def selected(self, pattern, names):
        """The rows that match a regular expression, and these columns of them; without names all."""
        rows = [row for row in self.rows if re.search(pattern, "| " + " | ".join(row) + " |")]
        kept = [self.columns.index(name) for name in names or self.columns]
        return Table([self.columns[k] for k in kept], [[row[k] for k in kept] for row in rows])

    def markdown(self):
        def is_right(k):
            return k > 0 and all(not row[k] or NUMBER.match(row[k]) for row in self.rows)
        rule = "|" + "|".join("---:" if is_right(k) else "---" for k in range(len(self.columns))) + "|"
        lines = ["| " + " | ".join(cells) + " |" for cells in [self.columns, *self.rows]]
        return "\n".join([lines[0], rule, *lines[1:]]) + "\n"
