#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages.py [--check | --plots]
pages.py put NAME PART | fuzzing          (rows of JSON on standard input)
pages.py collect|show paper FOLDER | collect|show quality FOLDER SCENE...

Writes every table of figures from docs/log/data/*.json into the pages: README.md, SECURITY.md, core/README.md, platform/README.md,
docs/*.md and docs/log/*.md. --check writes nothing, names each page that differs from its data, and then fails. --plots also draws
docs/img/*.svg (Debian: python3-matplotlib). put and collect bring what scripts measured into the data first;
show prints its tables alone.

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

from figures import paper, quality, scripts, trade, tradeoff
from figures.table import ROOT, Table, save, shown

TABLES = {
    **{f"tradeoff {name}": (lambda name=name: tradeoff.table(name)) for name in (
        "glance", "cost", "split", "parts", "surface_cost", "surface_split", "baselines")},
    "quality": quality.flash_table,
    "quality first": quality.first_table,
    "quality readme": quality.readme_table,
    "paper bakes": paper.bakes,
    "paper likeness": paper.likeness,
    "paper background": paper.background,
    "paper times": paper.times,
    "paper eyes": paper.eyes,
    "paper m4": paper.m4,
    "soak": scripts.soak,
    "coverage": scripts.coverage,
    "mutants": scripts.mutants,
    "fuzzing": scripts.fuzzing,
    "cases": scripts.cases,
    "model_sheet": scripts.model_sheet,
    "licences": lambda: scripts.licences("rows"),
    "scene pictures": scripts.scene_pictures,
    **{f"trade {scene}": (lambda scene=scene: trade.front(scene)) for scene in ("clock", "volume")},
    "trade modes": trade.modes,
    "devices": scripts.devices,
    "board memory": scripts.board_memory,
}
COLLECTORS = {"quality": quality.collect, "paper": paper.collect}
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
    return [ROOT / "README.md", ROOT / "SECURITY.md", ROOT / "core/README.md", ROOT / "platform/README.md", *sorted(ROOT.glob("docs/*.md")),
            *sorted(ROOT.glob("docs/log/*.md"))]


def write_pages(check=False):
    stale = []
    for page in pages():
        text = page.read_text(encoding="utf-8")
        new = filled(text)
        if new != text:
            stale.append(str(page.relative_to(ROOT)))
            if not check:
                page.write_text(new, encoding="utf-8")
    if check and stale:
        sys.exit("other than their data: " + ", ".join(stale) + "; run tools/lab/pages.py and commit them")


def show(name, data):
    shown[name] = data
    for title in TABLES:
        if title.split()[0] == name and title != "quality readme":
            print(f"\n{title}\n\n{table(title)}", end="")


def main(words):
    if words[:1] == ["put"] and len(words) == 3:
        scripts.put(words[1], words[2], sys.stdin.read())
    elif words == ["fuzzing"]:
        scripts.add_fuzzing(sys.stdin.read())
    elif words[:1] in (["collect"], ["show"]) and len(words) >= 3 and words[1] in COLLECTORS:
        data = COLLECTORS[words[1]](*words[2:])
        if words[0] == "show":
            show(words[1], data)
            return
        save(words[1], data)
    elif words not in ([], ["--check"], ["--plots"]):
        sys.exit(__doc__)
    if words == ["--plots"]:
        from figures import plots
        plots.draw_front()
    write_pages(check=words == ["--check"])


if __name__ == "__main__":
    main(sys.argv[1:])
