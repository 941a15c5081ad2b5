#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages.py [--check | --plots]
pages.py put NAME PART          (rows of JSON on standard input)
pages.py collect|show paper FOLDER

Writes every table of figures from docs/log/data/*.json into the pages: README.md, SECURITY.md, core/README.md,
platform/README.md, docs/*.md and docs/log/*.md. --check writes nothing. It fails where a page differs from its data, and
where two files of data are of two commits. --plots also draws docs/img/front.svg. put and
collect bring what scripts measured into the data first; show prints its tables alone. tools/lab/figures.sh measures all.

A page says what it wants in comments; TABLE is a name of TABLES below, ROWS a regular expression, and without them the
table is whole:
    <!-- table: TABLE; ROWS; COLUMN | COLUMN -->
    <!-- table: end -->
A value within a line, of data by the names that lead to it, or the first group of an expression in another file:
    <!-- value: FILE; EXPRESSION -->1,024<!-- end -->
"""
import json
import re
import sys

from figures import bench, boards, front, paper, plots, trade
from figures.table import ROOT, Table, commits, put, save, shown

TABLES = {
    **{f"tradeoff {name}": (lambda name=name: bench.table(name)) for name in (
        "glance", "cost", "split", "parts", "surface_cost", "surface_split")},
    "quality": trade.quality,
    "quality first": trade.first_table,
    "beside": trade.beside,
    "trade clock": lambda: trade.front("clock"),
    "trade volume": lambda: trade.front("volume"),
    "trade modes": trade.modes,
    "front rates": front.rates,
    **{f"paper {name}": (lambda name=name: getattr(paper, name)()) for name in (
        "bakes", "likeness", "background", "times", "eyes", "m4")},
    "licences": boards.licences,
    "scene pictures": boards.pictures,
    "devices": boards.devices,
    "board memory": boards.memory,
}
BLOCK = re.compile(r"(<!-- table: (?!end)(.*?) -->\n).*?(<!-- table: end -->)", re.DOTALL)
VALUE = re.compile(r"(<!-- value: ([^;]*); (.*?) -->)[^<]*(<!-- end -->)")


def table(order):
    name, *more = (part.strip() for part in order.split(";"))
    made = TABLES[name]()
    if isinstance(made, Table):
        rows, columns = [*more, "", ""][:2]
        made = made.selected(rows, columns.split(" | ") if columns else []).markdown()
    return made


def value(file, expression):
    """A number as a page writes it."""
    text = (ROOT / file).read_text(encoding="utf-8")
    if not file.endswith(".json"):
        return f"{int(re.search(expression, text)[1]):,}"
    found = json.loads(text)
    for name in expression.split("."):
        found = found[int(name) if isinstance(found, list) else name]
    return f"{found:,}" if isinstance(found, int) else str(found)


def filled(text):
    text = BLOCK.sub(lambda found: found[1] + table(found[2]) + found[3], text)
    return VALUE.sub(lambda found: found[1] + value(found[2], found[3]) + found[4], text)


def pages():
    names = ["README.md", "SECURITY.md", "core/README.md", "platform/README.md"]
    return [*map(ROOT.joinpath, names), *sorted(ROOT.glob("docs/*.md")), *sorted(ROOT.glob("docs/log/*.md"))]


def write_pages():
    for page in pages():
        text = page.read_text(encoding="utf-8")
        if filled(text) != text:
            page.write_text(filled(text), encoding="utf-8")


def faults():
    """Yields a line for each fault."""
    stale = [str(page.relative_to(ROOT)) for page in pages() if filled(text := page.read_text(encoding="utf-8")) != text]
    if stale:
        yield "other than their data: " + ", ".join(stale) + "; run tools/lab/pages.py and commit them"
    if len(set(commits().values())) > 1:
        yield "data of two commits: " + ", ".join(f"{name} {commit}" for name, commit in commits().items()) + (
            "; run tools/lab/figures.sh")


def main(words):
    if words[:1] == ["put"] and len(words) == 3:
        put(words[1], words[2], sys.stdin.read())
    elif words[:2] in (["collect", "paper"], ["show", "paper"]) and len(words) == 3:
        data = paper.collect(words[2])
        if words[0] == "show":
            shown["paper"] = data
            print("\n".join(f"\n{title}\n\n{table(title)}" for title in TABLES if title.startswith("paper ")))
            return
        save("paper", data)
    elif words == ["--check"]:
        sys.exit("\n".join(faults()) or None)
    elif words == ["--plots"]:
        plots.draw_front()
    elif words:
        sys.exit(__doc__)
    write_pages()


if __name__ == "__main__":
    main(sys.argv[1:])
