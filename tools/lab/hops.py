#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""hops.py [ROOT]

Prints the functions that a reader passes in core, the project's at ROOT or this one: from View::draw to the texels that
a sample shows, and from View::look to a vertex. Of several ways it prints the longest, such as that through glass. The
compiler says who calls whom: it compiles a view and core's sources with nothing inlined. Overloads and instances of a
template count as one function, a lambda as the function it stands in, and no way has a function twice. Exits with 1
where a way is longer than it may be.
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

VIEW = """
#include "lumi/surface/view.h"
using Panel = lumi::Screen<240, 240, 16, PIXEL>;
static lumi::View<lumi::SurfaceDrawing<64, 64, lumi::SurfaceMode::two_by_two, GLASS>, Panel> view;
lumi::ViewError use(const lumi::Stripe& stripe)
{
    view.look(lumi::Orbit{});
    return view.draw(stripe), view.draw(stripe, lumi::OverStripe{});
}
"""
# From, to, where that lies, and how many functions there may be.
WAYS = [("View::draw", r"palette\[.*texels\[|\bFourTexels t = ", 7), ("View::look", r"SamplePoint projected\(", 6)]


def compiled(root, folder):
    """The files in which the compiler says who calls whom."""
    sources = [path for path in sorted((root / "core/src").rglob("*.cpp")) if "/c/" not in str(path)]
    for pixel in ("PixelRgb565", "PixelRgb888"):
        for glass in (0, 8):
            source = folder / f"view_{pixel}_{glass}.cpp"
            source.write_text(VIEW.replace("PIXEL", f"lumi::{pixel}").replace("GLASS", str(glass)))
            sources.append(source)
    for number, source in enumerate(sources):
        subprocess.run(["g++", "-std=c++17", "-O0", "-w", "-g1", "-Dalways_inline=unused", "-fcallgraph-info",
                        f"-I{root}/core/include", f"-I{root}/core/src", "-c", source, "-o", folder / f"{number}.o"],
                       check=True)
    return sorted(folder.glob("*.ci"))


def plain(name):
    """A demangled name without its parameters, templates' arguments, namespaces and lambdas."""
    name = re.sub(r"\{lambda.*|\(anonymous namespace\)::", "", name.replace("operator()", ""))
    depth, kept = 0, ""
    for letter in name.replace("->", ""):
        depth += letter in "<(["
        if depth == 0:
            kept += letter
        depth -= letter in ">)]"
    words = kept.replace(" const", "").split()
    return re.sub(r"^lumi::|detail::", "", words[-1].rstrip(":")) if words else ""


def read_graph(files):
    text = "".join(path.read_text() for path in files)
    nodes = re.findall(r'node: \{ title: "([^"]+)" label: "([^"]+)" \}', text)  # others are only declared
    titles = sorted({title for title, _ in nodes})
    demangled = subprocess.run(["c++filt"], input="\n".join(t.split(":")[-1] for t in titles), text=True,
                               capture_output=True, check=True).stdout.splitlines()
    name = {title: plain(of) for title, of in zip(titles, demangled)}
    place = {}
    for title, label in nodes:
        found = re.search(r"\\n(\S*core/\S+):(\d+):", label)
        if found:
            place[name[title]] = (found[1], int(found[2]))
    calls = collections.defaultdict(set)
    for source, target in re.findall(r'edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', text):
        if source in name and target in name:
            calls[name[source]].add(name[target])
    return calls, place


def ends_at(place, pattern):
    """Functions in whose lines the pattern is found: those that begin last before it."""
    ends = set()
    for path in {path for path, _ in place.values()}:
        begins = sorted((line, name) for name, (of, line) in place.items() if of == path)
        for number, line in enumerate(pathlib.Path(path).read_text().splitlines(), 1):
            if re.search(pattern, line):
                ends.add([name for begin, name in begins if begin <= number][-1])
    return ends


def longest_way(calls, begin, ends):
    best = []

    def go_on(way):
        nonlocal best
        if way[-1] in ends and len(way) > len(best):
            best = way
        for called in sorted(calls[way[-1]] - set(way)):
            go_on(way + [called])
    go_on([begin])
    return best


def main(arguments):
    root = pathlib.Path(arguments[0] if arguments else __file__).resolve()
    root = root if arguments else root.parents[2]
    with tempfile.TemporaryDirectory() as folder:
        calls, place = read_graph(compiled(root, pathlib.Path(folder)))
    failed = False
    for begin, pattern, most in WAYS:
        way = longest_way(calls, begin, ends_at(place, pattern))
        failed = failed or not 0 < len(way) <= most
        files = {place[name][0] for name in way}
        print(f"{begin}: {len(way)} functions of at most {most}, in {len(files)} files")
        for name in way:
            print(f"  {name}  {pathlib.Path(place[name][0]).relative_to(root)}:{place[name][1]}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
