#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_includes.py [--self-test] [FOLDER]

Counts #include lines between the folders of core, platform, baker and tools, and prints a table for each area. Fails
where an area includes from one that it must not know, where a second file includes a third party, where includes go back
up the order of folders more often than allowed, where folders or files include each other in a circle, and where a file of
the tools prints past visible(). --self-test plants such faults in a made-up tree.
"""
import collections
import os
import re
import sys
import tempfile

# Which areas an area may include from, besides itself.
ARROWS = {
    "core": [],
    "host": ["core"],
    "platform": ["host", "core"],
    "baker": ["host", "core"],
    "tools": ["baker", "platform", "host", "core"],
    "lab": ["tools", "baker", "platform", "host", "core"],
    "tests": ["lab", "tools", "baker", "platform", "host", "core"],
}
# Areas that lie in a folder of another one: workstations share the host, and what only we run is no part of what users run.
WITHIN = {"platform/host": "host", "tools/lab": "lab", "platform/mps2/bench": "lab"}
# Folders that register themselves with the program: nothing else includes them, but for tests.
PLUGINS = ["tools/src/filter"]

# The order of folders: each includes from those above it in this list, or from itself. A folder that is not listed
# takes the place of the nearest one around it. A folder named "detail" is a part of the one around it, for whose
# templates it is there.
ORDER = """
core/include/lumi
core/include/lumi/surface
core/include/lumi/chord
core/src
core/src/math
core/src/field
core/src/camera
core/src/lattice
core/src/control
core/src/pixel
core/src/view
core/src/surface
core/src/chord/stepping
core/src/chord
core/src/chord/armv6m
core/zephyr
core/examples

platform/host
platform/wasm
platform/mps2
platform/mps2/bench
platform/bare
platform/overlay
platform/riscv
platform/lm3s_oled
platform/pico_st7789
platform/simulator
platform/lvgl
platform/arduino
platform/measure

baker/include/lumi/baker
baker/src/math
baker/src/util
baker/src/image
baker/src/geometry
baker/src/material
baker/src/light
baker/src/volume
baker/src/model
baker/src/model/gltf
baker/src/model/ply
baker/src/model/stl
baker/src/scene
baker/src/trace
baker/src/store
baker/src/mesh
baker/src/fit
baker/src/shadow
baker/src/pack
baker/src/chord
baker/src/surface
baker/src

tools/src/terminal
tools/src/files
tools/src/image
tools/src/metrics
tools/src/draw
tools/src/program
tools/src/quality
tools/src/planner
tools/src/trade
tools/src/viewer
tools/src/commands
tools/src/filter
tools/src

tools/lab/twin
tools/lab/src/comparison
tools/lab/src/bench
tools/lab/src/baking
tools/lab/src/measure
tools/lab/src
tools/lab/devices

tests
"""

# Folders of which neither includes anything of the other one: what draws surface fields, and what draws chord fields.
APART = [("core/include/lumi/surface", "core/include/lumi/chord"), ("core/src/surface", "core/src/chord"),
         ("core/src/surface", "core/include/lumi/chord"), ("core/src/chord", "core/include/lumi/surface")]

# How many includes may go back up that order.
ALLOWED_BACK_UP = {}

# Third parties by what their headers' names begin with, and the one file that may include them; zlib also packs for the
# writer of PNG. Tests may include all.
THIRD_PARTIES = {
    "embree": "baker/src/geometry/accelerator.cpp",
    "tiny_gltf.h": "baker/src/model/gltf/model.cpp",
    "draco/": "baker/src/model/gltf/draco.cpp",
    "tiny_obj_loader.h": "baker/src/model/tiny_obj.cpp",
    "png.h": "platform/host/src/png_reader.cpp",
    "stb_image_write.h": "platform/host/src/png_writer.cpp",
    "turbojpeg.h": "baker/src/image/jpeg_file.cpp",
    "webp/": "baker/src/image/webp_file.cpp tools/src/image/animation.cpp",
    "Imf": "baker/src/image/exr_file.cpp",
    "meshoptimizer.h": "baker/src/mesh/simplify/simplify.cpp baker/src/model/gltf/meshopt.cpp",
    "nifti": "baker/src/volume/nifti_header.cpp",
    "openvdb/": "baker/src/volume/openvdb_module/module.cpp",
    "zlib.h": "baker/src/util/gzip.cpp platform/host/src/png_writer.cpp",
    "kissfft": "tools/src/metrics/steerable_pyramid.cpp",
    "torch/": "tools/src/filter/torch/unet.h",
    "SDL": "platform/simulator/window.cpp",
}

# What prints text as it is, and the only files of the tools that may: names in files are strangers', and may hold commands
# for terminals.
PRINTS = re.compile(r"\b(?:v?f?printf|f?puts|f?putc|putchar|fwrite|perror)\(|\bstd::(?:cout|cerr) *<<")
PRINTERS = ["tools/src/terminal/text.cpp", "tools/src/terminal/progress_printer.cpp"]

SOURCES = (".h", ".cpp", ".c", ".S", ".inc")
# By lumi_add_field, in a build's own folder.
WRITTEN_BY_BUILDS = ["lumi_version.h", "desk_clock.h", "running_clock.h", "product.h", "rates.inc"]

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]', re.MULTILINE)


def lies_in(path, folder):
    return path == folder or path.startswith(folder + "/")


def area_of(path):
    return next((area for folder, area in WITHIN.items() if lies_in(path, folder)), path.split("/")[0])


def are_apart(a, b):
    return any(a.startswith(x + "/") and b.startswith(y + "/") for pair in APART for x, y in (pair, pair[::-1]))


class Order:
    def __init__(self, text):
        self.places = {folder: number for number, folder in enumerate(filter(None, text.splitlines()))}

    @staticmethod
    def row_of(path):
        """The row of the table that a file counts in."""
        return os.path.dirname(path).split("/detail")[0]

    def place_of(self, row):
        """None where neither the folder nor one around it is listed."""
        while row and row not in self.places:
            row = os.path.dirname(row)
        return self.places.get(row)


def source_files(root):
    files = []
    for area in sorted({area_of(path).split("/")[0] for path in os.listdir(root)} & set(ARROWS)):
        for folder, _, names in os.walk(os.path.join(root, area)):
            files += [os.path.relpath(os.path.join(folder, name), root) for name in names if name.endswith(SOURCES)]
    return sorted(files)


def include_roots(files):
    """Folders that includes are named from: every include/ and src/, and the roots of the tests."""
    roots = set()
    for path in files:
        parts = path.split("/")
        for k, part in enumerate(parts[:-1]):
            if part in ("include", "src"):
                roots.add("/".join(parts[:k + 1]))
                break
        if parts[0] == "tests":
            roots.add("/".join(parts[:2]))
    return sorted(roots)


def third_party_problems(path, names):
    """Lists third parties that a file includes although another file is there for them."""
    if area_of(path) == "tests":
        return []
    return [f"{path}: includes <{name}>, which only {only} may"
            for name in names for start, only in THIRD_PARTIES.items()
            if name.startswith(start) and path not in only.split()]


class Tree:
    """All includes of our own files, as pairs of paths."""

    def __init__(self, root):
        self.files = source_files(root)
        self.problems, self.includes = [], []
        known, roots = set(self.files), include_roots(self.files)
        by_name = collections.defaultdict(list)
        for path in self.files:
            by_name[os.path.basename(path)].append(path)
        for path in self.files:
            with open(os.path.join(root, path), encoding="utf-8") as source:
                text = source.read()
            found = INCLUDE.findall(text)
            if lies_in(path, "tools/src") and path not in PRINTERS and PRINTS.search(text):
                self.problems.append(f"{path}: prints past visible(); use print() of terminal/text.h")
            self.problems += third_party_problems(path, [name for quote, name in found if quote == "<"])
            for quote, name in found:
                target = self.resolve(path, name, known, roots, by_name if quote == '"' else {})
                if target:
                    self.includes.append((path, target))
                elif name not in WRITTEN_BY_BUILDS and quote == '"' and area_of(path) != "tests":
                    self.problems.append(f"{path}: includes \"{name}\", which no folder of ours has")

    @staticmethod
    def resolve(path, name, known, roots, by_name):
        candidates = [os.path.normpath(os.path.join(folder, name)) for folder in [os.path.dirname(path)] + roots]
        candidates = list(dict.fromkeys(c for c in candidates if c in known))
        # Firmware and tests also name folders of programs as include paths.
        if not candidates and "/" not in name and path.split("/")[0] in ("platform", "tests"):
            candidates = by_name.get(name, [])
        own = [c for c in candidates if area_of(c) == area_of(path)]
        return (own or candidates or [None])[0]


def circle(edges):
    """One circle of a graph {node: iterable of nodes}, as a list of nodes; empty if there is none."""
    done, on_path = set(), []

    def visit(node):
        if node in on_path:
            return on_path[on_path.index(node):] + [node]
        if node in done:
            return []
        on_path.append(node)
        for following in sorted(edges.get(node, ())):
            found = visit(following)
            if found:
                return found
        on_path.pop()
        done.add(node)
        return []

    for node in sorted(edges):
        found = visit(node)
        if found:
            return found
    return []


def graph(pairs):
    edges = collections.defaultdict(set)
    for a, b in pairs:
        if a != b:
            edges[a].add(b)
    return edges


def print_table(area, rows, counts):
    width = max(len(row) for row in rows) + 5
    print("\n" + area.ljust(width) + "".join(f"{k + 1:4}" for k in range(len(rows))))
    for k, row in enumerate(rows):
        cells = (counts[row, other] for other in rows)
        print(f"{k + 1:3} {row}".ljust(width) + "".join(f"{n:4}" if n else "   ." for n in cells))


def check(root, order, allowed, quiet=False):
    """Returns what is wrong, one line each."""
    tree = Tree(root)
    problems = []
    for row in sorted({order.row_of(path) for path in tree.files}):
        if order.place_of(row) is None:
            problems.append(f"{row}: has no place in the order of folders")
    if problems:
        return problems
    problems = list(tree.problems)

    counts, between, back_up, kept = collections.Counter(), collections.Counter(), collections.defaultdict(list), []
    for a, b in tree.includes:
        row, other = order.row_of(a), order.row_of(b)
        counts[row, other] += 1
        between[area_of(a), area_of(b)] += 1
        for plugin in PLUGINS:
            if lies_in(b, plugin) and not lies_in(a, plugin) and area_of(a) != "tests":
                problems.append(f"{a}: includes {b}, which belongs to a plug-in")
        if area_of(a) != area_of(b):
            if area_of(b) not in ARROWS[area_of(a)]:
                problems.append(f"{a}: includes {b}, and {area_of(a)} must not know {area_of(b)}")
        elif are_apart(a, b):
            problems.append(f"{a}: includes {b}, and what draws one layout must not know the other")
        elif order.place_of(row) < order.place_of(other):
            back_up[area_of(a)].append(f"{a}: includes {b}, back up the order of folders")
        else:
            kept.append((row, other))

    for area in (a for a in ARROWS if a != "tests"):
        rows = sorted({order.row_of(p) for p in tree.files if area_of(p) == area},
                      key=lambda row: (order.place_of(row), row))
        total = sum(n for (a, b), n in counts.items() if a != b and area_of(a) == area_of(b) == area)
        most = allowed.get(area, 0)
        if not quiet and rows:
            print_table(area, rows, counts)
            print(f"{total} includes between folders, {len(back_up[area])} back up (at most {most})")
            print("".join(f"  {line}\n" for line in back_up[area]), end="")
        if len(back_up[area]) > most:
            problems += back_up[area] if quiet or not rows else []
            problems.append(f"{area}: {len(back_up[area])} includes go back up the order of folders, "
                            f"and at most {most} may")
    if not quiet:
        print("\nbetween areas: " + ", ".join(f"{a} -> {b} {n}" for (a, b), n in sorted(between.items()) if a != b))

    # Includes that go back up in core are counted above; without them no folders may need each other.
    for what, edges in (("folders", graph(kept)), ("files", graph(tree.includes))):
        found = circle(edges)
        if found:
            problems.append(f"{what} include each other in a circle: " + " -> ".join(found))
    return problems


def self_test():
    order = Order("core/include/lumi\ncore/src\nplatform/host\nbaker/src\nbaker/src/high\ntools/src\ntools/lab/src\ntools/src/filter")
    sound = {
        "core/include/lumi/word.h": "",
        "core/include/lumi/door.h": '#include "lumi/word.h"\n',
        "core/src/one/one.h": "#include <vector>\n#include <lumi/door.h>\n",
        "core/src/two/two.cpp": '#include "one/one.h"\n',
        "baker/src/low/low.h": "",
        "baker/src/high/high.h": '  # include "low/low.h"\n#include "lumi/door.h"\n',
    }
    cases = [
        ("a sound tree", {}, 0, None),
        ("a circle of folders", {"core/src/two/two.h": "", "core/src/one/o.cpp": '#include "two/two.h"\n'}, 0, "circle"),
        ("a circle of files", {"baker/src/low/low.h": '#include "other.h"\n',
                               "baker/src/low/other.h": '#include "low.h"\n'}, 0, "files include each other"),
        ("an include back up", {"core/include/lumi/detail/other.h": '#include "one/one.h"\n'}, 0, "back up"),
        ("an include back up that is allowed", {"core/include/lumi/x.h": '#include "one/other.h"\n', "core/src/one/other.h": ""}, 1, None),
        ("a folder and its details include each other",
         {"core/include/lumi/detail/part.h": '#include "lumi/word.h"\n',
          "core/include/lumi/door.h": '#include "lumi/detail/part.h"\n'}, 0, None),
        ("an arrow against the areas", {"core/src/x.cpp": '#include "low/low.h"\n'}, 8, "must not know"),
        ("a program that includes the laboratory", {"tools/lab/src/judge.h": "", "tools/src/x.cpp": '#include "judge.h"\n'}, 8,
         "must not know"),
        ("the laboratory includes a program", {"tools/lab/src/x.cpp": '#include "x.h"\n', "tools/src/x.h": ""}, 0, None),
        ("a plug-in that another folder includes", {"tools/src/filter/f.h": "", "tools/src/x.cpp": '#include "filter/f.h"\n'}, 8,
         "belongs to a plug-in"),
        ("an include of the other layout", {"core/include/lumi/chord/a.h": "",
                                            "core/include/lumi/surface/b.h": '#include "lumi/chord/a.h"\n'}, 8, "layout"),
        ("an include of nothing", {"core/src/x.cpp": '#include "gone.h"\n'}, 8, "no folder of ours has"),
        ("a third party in a second file", {"tools/src/x.cpp": "#include <png.h>\n"}, 0, "which only"),
        ("a third party in its file", {"platform/host/src/png_reader.cpp": "#include <png.h>\n"}, 0, None),
        ("a name that is printed as it is", {"tools/src/x.cpp": 'std::printf("%s", name);\n'}, 0, "past visible"),
        ("a folder without a place", {"platform/new/x.h": ""}, 8, "no place"),
    ]
    for title, planted, allowed, expected in cases:
        with tempfile.TemporaryDirectory() as root:
            for path, text in {**sound, **planted}.items():
                os.makedirs(os.path.join(root, os.path.dirname(path)), exist_ok=True)
                with open(os.path.join(root, path), "w", encoding="utf-8") as source:
                    source.write(text)
            problems = check(root, order, {"core": allowed}, quiet=True)
        if not (any(expected in p for p in problems) if expected else not problems):
            print(f"{title}: expected {expected or 'no problem'}, found {problems}")
            return 1
    print(f"{len(cases)} made-up trees judged as they should be")
    return 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) > 1 or any(a.startswith("-") for a in arguments):
        print(__doc__, file=sys.stderr)
        return 2
    root = arguments[0] if arguments else os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
    problems = check(root, Order(ORDER), ALLOWED_BACK_UP)
    for problem in problems:
        print(problem, file=sys.stderr)
    if not problems:
        print("no circles")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
