#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""core_names.py page | firmware COMPILER... | layouts COMPILER... | modes COMPILER... | samples COMPILER...

Reads the names that core's public headers declare, from the headers themselves.

page       docs/api.md has each name of namespace lumi in the row of its header, and no other; the table of
           core/README.md has each call of lumi.h, and no other.
firmware   A firmware that has a global of its own for every name of namespace lumi::detail, and for every short name
           that the headers use, says `using namespace lumi;` and draws fields of both layouts. Compiles it with all
           warnings as errors; then the headers alone, with warnings in them shown.
modes      Compiles a firmware for each mode of surface fields, and fails where it links what another one takes.
samples    Compiles a firmware whose views share samples, and two that must not compile and must say why.
layouts    Compiles a firmware for each layout, and fails where it includes a header of the other one.
"""
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "core" / "include"
HEADERS = sorted(path for path in (INCLUDE / "lumi").rglob("*.h") if path.name != "lumi.h")
PAGE = ROOT / "docs" / "api.md"
C_HEADER, C_PAGE = INCLUDE / "lumi" / "lumi.h", ROOT / "core" / "README.md"

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.MULTILINE)
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|' r"'(?:\\.|[^'\\])+'" r"|[A-Za-z_]\w*|::|\[\[|\]\]|\d[\w']*|\S")
NO_NAMES = {"asm", "auto", "bool", "case", "char", "class", "const", "do", "else", "enum", "for", "if", "int", "long",
            "new", "this", "true", "using", "void", "while", "false", "short", "float"}
LONGEST_SHORT = 5

Name = collections.namedtuple("Name", "scope kind name")


# Clang calls the declarations of each kind so.
KINDS = {**dict.fromkeys(("CXXRecordDecl", "ClassTemplateDecl", "EnumDecl", "TypeAliasDecl", "TypeAliasTemplateDecl"), "type"),
         **dict.fromkeys(("FunctionDecl", "FunctionTemplateDecl"), "function"),
         **dict.fromkeys(("VarDecl", "VarTemplateDecl"), "variable")}
CORES = ("cortex-m0plus", "cortex-m4")  # both have declarations of their own
CLANG = ["clang++", "-std=c++17", "-fsyntax-only", "-w", "-ffreestanding", "--target=arm-none-eabi", "-mthumb", "-x", "c++",
         "-Xclang", "-ast-dump=json", "-I", str(INCLUDE), "-"]


class Declarations:
    """The names that core's headers declare in namespaces, as clang sees them for a core."""

    def __init__(self, core):
        self.file, self.found = "", collections.defaultdict(list)
        source = "".join(f"#include <{path.relative_to(INCLUDE)}>\n" for path in HEADERS)
        said = subprocess.run([*CLANG, f"-mcpu={core}"], input=source, capture_output=True, text=True, check=True).stdout
        self.visit(json.loads(said), "")

    def visit(self, node, scope):
        """scope: None inside of what is no namespace. Clang names a file only where it is another than before."""
        place = node.get("loc", {})
        for begin in (place.get("spellingLoc", place), place.get("expansionLoc", {}), *node.get("range", {}).values()):
            self.file = begin.get("file", self.file)
        kind, name = node["kind"], node.get("name", "")
        if scope and kind in KINDS and name.isidentifier() and self.is_defined(node):
            self.found[self.file].append(Name(scope, KINDS[kind], name))
        if kind == "NamespaceDecl":
            scope = f"{scope}::{name}".strip(":")
        elif kind not in ("TranslationUnitDecl", "LinkageSpecDecl"):
            scope = None
        for inner in node.get("inner", []):
            if "kind" in inner:
                self.visit(inner, scope)

    @staticmethod
    def is_defined(node):
        if node["kind"] == "ClassTemplateDecl":
            return any(inner.get("completeDefinition") for inner in node["inner"] if inner["kind"] == "CXXRecordDecl")
        return {"CXXRecordDecl": "completeDefinition", "EnumDecl": "inner"}.get(node["kind"], "kind") in node


def all_names():
    """{header's path below lumi/: names}"""
    found = [Declarations(core).found for core in CORES]
    return {str(path.relative_to(INCLUDE / "lumi")): sorted({name for of in found for name in of.get(str(path), [])})
            for path in HEADERS}


def tokens_of(path):
    return TOKEN.findall(DIRECTIVE.sub("", COMMENT.sub("", path.read_text(encoding="utf-8"))))


def public_names(names):
    return {(n.name, header) for header, found in names.items() for n in found if n.scope == "lumi"}


# The page

ROW = re.compile(r"^\|\s*`([\w/]+\.h)`\s*\|([^|]*`[^|]*)\|[^|]*\w[^|]*\|$", re.MULTILINE)


def page_problems(page, names):
    rows = [(name, header) for header, cell in ROW.findall(page) for name in re.findall(r"`(\w+)`", cell)]
    problems = [f"docs/api.md: `{name}` stands there twice" for (name, header), n in collections.Counter(rows).items() if n > 1]
    problems += [f"docs/api.md: `{name}` of {header} is missing" for name, header in sorted(names - set(rows))]
    return problems + [f"docs/api.md: {header} has no `{name}`" for name, header in sorted(set(rows) - names)]


def c_page_problems(page, header):
    calls = set(re.findall(r"^[a-z][\w *]*[ *](lumi_\w+)\(", COMMENT.sub("", header), re.MULTILINE))
    rows = "\n".join(re.findall(r"^\| (`lumi_.*?) \|", page, re.MULTILINE))
    told = set(re.findall(r"`(lumi_\w+)`", rows))
    return [f"core/README.md: no row has {name}" for name in sorted(calls - told)] + \
           [f"core/README.md: {name} is no call of lumi.h" for name in sorted(told - calls)]


def check_page():
    return page_problems(PAGE.read_text(encoding="utf-8"), public_names(all_names())) + \
        c_page_problems(C_PAGE.read_text(encoding="utf-8"), C_HEADER.read_text(encoding="utf-8"))


# Firmware

OWN = {
    "type": "struct {0} {{\n    int own;\n}};\n",
    "function": "inline int {0}(int)\n{{\n    return 1;\n}}\n",
    "variable": "[[maybe_unused]] static int {0} = 1;\n",
}
USE = {"type": "    sum_of_own += {0}{{1}}.own;\n", "function": "    sum_of_own += {0}(1);\n",
       "variable": "    sum_of_own += {0};\n"}

VIEWS = """
static View<SurfaceDrawing<100, 100, SurfaceMode::two_by_two>, Screen<>> surface_view_1;
static View<ChordDrawing<TexelRgb888>, Screen<>> chord_view_1;
static View<ExactChordDrawing<TexelPalette8, Paper<5>>, Screen<240, 240, 16, PixelArgb8888>> chord_view_2;
static View<ChordDrawing<TexelRgb565, Nearest>, Screen<240, 240, 16, PixelGrey8>> chord_view_3;
static View<ExactChordDrawing<TexelLuma8, Paper<1>>, Screen<240, 240, 16, PixelBgr555>> chord_view_4;
static View<ExactChordDrawing<TexelPalette8>, Screen<>> chord_view_5;

template <class V>
bool draws_with(V& some_view, const uint8_t* field_bytes)
{
    return some_view.open(field_bytes, 1) == ViewError::none && some_view.verify() == ViewError::none &&
           some_view.look(Orbit{degrees(30), degrees(20), radii(3)}) == ViewError::none &&
           some_view.draw({nullptr, 0, 0, 240, 16, 480}) == ViewError::none &&
           some_view.draw({nullptr, 0, 0, 240, 16, 480}, OverStripe{}) == ViewError::none;
}

bool draws_all(const uint8_t* field_bytes)
{
    return draws_with(surface_view_1, field_bytes) && surface_view_1.draw_coverage({}) == ViewError::none &&
           draws_with(chord_view_1, field_bytes) && draws_with(chord_view_2, field_bytes) && draws_with(chord_view_3, field_bytes) &&
           draws_with(chord_view_4, field_bytes) && draws_with(chord_view_5, field_bytes);
}
"""


def is_public(header):
    return "detail/" not in header


def includes(headers):
    return "".join(f"#include <lumi/{header}>\n" for header in headers if is_public(header))


def own_names(names):
    """{name: kind} of everything below lumi::detail, its namespaces too, and of short names in the headers."""
    own = {}
    for found in names.values():
        for n in found:
            if n.scope.startswith("lumi::detail"):
                own.setdefault(n.name, n.kind)
                for scope in n.scope.split("::")[2:]:
                    own.setdefault(scope, "variable")
    for path in HEADERS:
        for token in tokens_of(path):
            if re.match(r"[a-z]\w*$", token) and len(token) <= LONGEST_SHORT and token not in NO_NAMES:
                own.setdefault(token, "variable")
    for name, _ in public_names(names):
        own.pop(name, None)
    own.pop("lumi", None), own.pop("none", None)
    return own


def compile_with(compiler, source, flags):
    command = [*compiler, "-std=c++17", "-O1", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror", *flags,
               "-I", str(INCLUDE), "-x", "c++", "-S", "-o", "/dev/null", "-"]
    result = subprocess.run(command, input=source, capture_output=True, text=True)
    return [] if result.returncode == 0 else [f"{' '.join(command)}\n{result.stderr[:6000]}"]


def check_firmware(compiler):
    names = all_names()
    own = own_names(names)
    globals_ = "".join(OWN[kind].format(name) for name, kind in sorted(own.items()))
    uses = "".join(USE[kind].format(name) for name, kind in sorted(own.items()))
    drawing = includes(names) + "using namespace lumi;\n" + VIEWS
    firmware = f"#include <stddef.h>\n#include <stdint.h>\n{globals_}{drawing}int uses_own()\n{{\n    int sum_of_own = 0;\n{uses}" \
               "    return sum_of_own;\n}\n"
    print(f"{len(own)} names of a firmware's own")
    return compile_with(compiler, firmware, ["-pedantic"]) + compile_with(compiler, drawing, ["-Wsystem-headers"])


def check_layouts(compiler):
    problems = []
    for layout, other in (("surface", "chord"), ("chord", "surface")):
        headers = [h for h in map(str, (p.relative_to(INCLUDE / "lumi") for p in HEADERS)) if not h.startswith(other + "/")]
        source = includes(headers) + "#define LUMI_C_" + ("TEXEL TexelRgb565" if layout == "chord" else "NO_TEXEL") + \
            f'\n#include "{ROOT}/core/src/c/lumi.cpp"\n'
        listed = subprocess.run([*compiler, "-std=c++17", "-M", "-I", str(INCLUDE), "-x", "c++", "-"], input=source,
                                capture_output=True, text=True, check=True).stdout.split()
        problems += [f"a firmware for {layout} fields includes {path}" for path in listed if f"/lumi/{other}/" in path]
        if not any(f"/lumi/{layout}/" in path for path in listed):
            problems.append(f"a firmware for {layout} fields includes nothing of them: {listed}")
    return problems


# A firmware that draws in a mode of surface fields, 5-6-5 pixels, must link the first and must not link the second.
MODE_SYMBOLS = {
    "one_sample": (["565_swapped_nearest"], ["outlines", "two_taps", "bilinear", "packed"]),
    "antialiased": (["mark_outlines", "565_swapped_two_taps"], ["packed"]),
    "two_by_two": (["packed_nearest", "packed_bilinear", "mark_outlines"], ["packed_two_taps"]),
}


def check_modes(compiler):
    problems = []
    for mode, (needed, forbidden) in MODE_SYMBOLS.items():
        source = f"""#include <lumi/surface/view.h>
using namespace lumi;
static View<SurfaceDrawing<100, 100, SurfaceMode::{mode}>, Screen<>> view;
bool draws(const uint8_t* bytes)
{{
    return view.open(bytes, 1) == ViewError::none && view.look(Orbit{{1, 2, 3}}) == ViewError::none &&
           view.draw({{nullptr, 0, 0, 240, 16, 480}}) == ViewError::none;
}}
"""
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "firmware.o"
            subprocess.run([*compiler, "-std=c++17", "-O1", "-c", "-I", str(INCLUDE), "-x", "c++", "-o", str(program), "-"],
                           input=source, text=True, check=True)
            symbols = subprocess.run(["nm", program], capture_output=True, text=True, check=True).stdout
        problems += [f"{mode}: nothing is linked for {name}" for name in needed if name not in symbols]
        problems += [f"{mode}: {name} is linked" for name in forbidden if name in symbols]
    return problems


SHARING = """#include <lumi/surface/view.h>
using namespace lumi;
using Panel = SharedSamples<Screen<>>;
static View<SurfaceDrawing<100, 100, SurfaceMode::two_by_two>, Panel> fine;
static View<SurfaceDrawing<300, 200>, Panel> plain;
static SamplesFor<decltype(%s)> samples;
bool draws(const Stripe& stripe)
{
    return plain.draw(stripe, OverBlack{}, samples) == ViewError::none && fine.draw(stripe%s) == ViewError::none;
}
"""
SHARING_CASES = [("fine), decltype(plain", ", OverBlack{}, samples", ""),
                 ("plain", ", OverBlack{}, samples", "the samples are too few for this view: see SamplesFor"),
                 ("fine", "", "a view of SharedSamples draws with the samples that it is given")]


def check_samples(compiler):
    problems = []
    for views, call, reason in SHARING_CASES:
        done = subprocess.run([*compiler, "-std=c++17", "-fsyntax-only", "-I", str(INCLUDE), "-x", "c++", "-"],
                              input=SHARING % (views, call), text=True, capture_output=True)
        if bool(reason) != bool(done.returncode):
            problems.append(f"samples for {views}, draw(stripe{call}): ended with {done.returncode}, {done.stderr}")
        elif reason not in done.stderr:
            problems.append(f"samples for {views}, draw(stripe{call}): not said: {reason}; but: {done.stderr}")
    return problems


def main(arguments):
    compiler_checks = {"firmware": check_firmware, "layouts": check_layouts, "modes": check_modes,
                       "samples": check_samples}
    if arguments == ["page"]:
        problems = check_page()
    elif len(arguments) > 1 and arguments[0] in compiler_checks:
        problems = compiler_checks[arguments[0]](arguments[1:])
    else:
        print(__doc__, file=sys.stderr)
        return 2
    print("\n".join(problems) or "as it should be")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
