#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_includes.py

Reads all #include lines. Fails where an area includes from one that it must not know, where a second file includes a
third party, where an include goes back up the order of folders, where files include each other in a circle, and where a
file of the tools prints past visible().
"""
import collections
import graphlib
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

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
tools/src/math
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
tools/lab/src/bench
tools/lab/src/measure
tools/lab/src
tools/lab/devices

tests
""".split()

# Folders of which neither includes anything of the other one: what draws surface fields, and what draws chord fields.
APART = [("core/include/lumi/surface", "core/include/lumi/chord"), ("core/src/surface", "core/src/chord"),
         ("core/src/surface", "core/include/lumi/chord"), ("core/src/chord", "core/include/lumi/surface")]

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
    "meshoptimizer.h": "baker/src/model/gltf/meshopt.cpp",
    "nifti": "baker/src/volume/nifti_header.cpp",
    "openvdb/": "baker/src/volume/openvdb_module/module.cpp",
    "zlib.h": "baker/src/util/gzip.cpp platform/host/src/png_writer.cpp",
    "kissfft": "tools/src/metrics/steerable_pyramid.cpp",
    "torch/": "tools/src/filter/torch/unet.h",
    "SDL": "platform/simulator/window.cpp",
}

# These calls print text as it is, and only these files of the tools may use them: names in files are strangers', and may
# hold commands for terminals.
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


def row_of(path):
    """Finds the folder of ORDER that a file counts in."""
    row = os.path.dirname(path).split("/detail")[0]
    while row and row not in ORDER:
        row = os.path.dirname(row)
    return row


def source_files():
    return sorted(str(path.relative_to(ROOT)) for area in ("core", "platform", "baker", "tools", "tests")
                  for path in (ROOT / area).rglob("*") if path.suffix in SOURCES)


def include_roots(files):
    """Folders that includes are named from: every include/ and src/, and the roots of the tests."""
    roots = set()
    for path in files:
        parts = path.split("/")
        at = next((k for k, part in enumerate(parts[:-1]) if part in ("include", "src")), None)
        if at is not None:
            roots.add("/".join(parts[:at + 1]))
        if parts[0] == "tests":
            roots.add("/".join(parts[:2]))
    return sorted(roots)


class Includes:
    """Finds the file of ours that an include names."""

    def __init__(self, files):
        self.known, self.roots = set(files), include_roots(files)
        self.by_name = collections.defaultdict(list)
        for path in files:
            self.by_name[os.path.basename(path)].append(path)

    def target(self, path, quote, name):
        candidates = [os.path.normpath(os.path.join(folder, name)) for folder in [os.path.dirname(path), *self.roots]]
        candidates = [c for c in candidates if c in self.known]
        # Firmware and tests also name folders of programs as include paths.
        if not candidates and quote == '"' and "/" not in name and path.split("/")[0] in ("platform", "tests"):
            candidates = self.by_name[name]
        own = [c for c in candidates if area_of(c) == area_of(path)]
        return (own or candidates or [None])[0]


def faults_of_text(path, text):
    if area_of(path) == "tests":
        return
    if lies_in(path, "tools/src") and path not in PRINTERS and PRINTS.search(text):
        yield "prints past visible(); use print() of terminal/text.h"
    for quote, name in INCLUDE.findall(text):
        for start, only in THIRD_PARTIES.items():
            if quote == "<" and name.startswith(start) and path not in only.split():
                yield f"includes <{name}>, which only {only} may"


def fault_of_include(a, b):
    """Why file a may not include file b, or nothing."""
    area, other = area_of(a), area_of(b)
    if area != "tests" and any(lies_in(b, plugin) and not lies_in(a, plugin) for plugin in PLUGINS):
        return "which belongs to a plug-in"
    if area != other:
        return "" if other in ARROWS[area] else f"and {area} must not know {other}"
    if are_apart(a, b):
        return "and what draws one layout must not know the other"
    return "back up the order of folders" if ORDER.index(row_of(a)) < ORDER.index(row_of(b)) else ""


def faults():
    files = source_files()
    yield from (f"{path}: has no place in the order of folders" for path in files if not row_of(path))
    includes, edges = Includes(files), collections.defaultdict(set)
    for path in files:
        text = (ROOT / path).read_text(encoding="utf-8")
        yield from (f"{path}: {fault}" for fault in faults_of_text(path, text))
        for quote, name in INCLUDE.findall(text):
            target = includes.target(path, quote, name)
            if target:
                edges[path].add(target)
                if fault := fault_of_include(path, target):
                    yield f"{path}: includes {target}, {fault}"
            elif name not in WRITTEN_BY_BUILDS and quote == '"' and area_of(path) != "tests":
                yield f"{path}: includes \"{name}\", which no folder of ours has"
    try:
        graphlib.TopologicalSorter(edges).prepare()
    except graphlib.CycleError as error:
        yield "files include each other in a circle: " + " -> ".join(error.args[1])


if __name__ == "__main__":
    sys.exit("\n".join(faults()) or None)
