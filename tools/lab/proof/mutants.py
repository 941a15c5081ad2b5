#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mutants.py [--count N] [--minutes M] [--again]

Changes core by one operator at a time, and counts which changes core's tests see. A change is one of: + and -, < and <=,
<< and >>, & and |, && and ||, == and != put for each other; a whole number one more or one less; a condition negated.
N of them (100), as many of each kind, are drawn with a fixed seed from the lines that tests/core runs
(gcovr's build/coverage/lines.json, of tools/test.sh --all). What does not compile, or compiles to the same code, is exchanged for the next. A change is
seen where a test of lumi_core_tests fails, crashes or takes far longer. Those that survive, and are no equal of core by the
proof in tests/core/equal_mutants.txt, lack a test.

Results are kept in build/mutants/results.json, and the next call goes on from there; it ends after M minutes. --again
tries the survivors again.
"""
import argparse
import collections
import itertools
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = ROOT / "build/mutants"
TREE = BUILD / "tree"  # a copy of core and its tests, in which one file differs
RESULTS = BUILD / "results.json"
EQUAL = ROOT / "tests/core/equal_mutants.txt"
SEED = 40
OBJECTS = "tests/core/CMakeFiles/lumi_core_tests.dir/"
MEMORY = 4 << 30

SWAPS = {" + ": " - ", " - ": " + ", " += ": " -= ", " -= ": " += ", " < ": " <= ", " <= ": " < ", " > ": " >= ",
         " >= ": " > ", " << ": " >> ", " >> ": " << ", " & ": " | ", " | ": " & ", " && ": " || ", " || ": " && ",
         " == ": " != ", " != ": " == "}
SWAP = re.compile("|".join(re.escape(swap) for swap in sorted(SWAPS, key=len, reverse=True)))
NUMBER = re.compile(r"(?<![\w.'])(0x[0-9A-Fa-f']+|\d[\d']*)(?=[uUlL]{0,3}\b)(?![\w']*\.)")
CONDITION = re.compile(r"\b(?:if|while) \((?=\S)")
ANGLES = re.compile(r"(?<=\w)<[^<>;&|]*>")
NO_CODE = re.compile(r"\s*(?://|\*|#|static_assert|template|using|enum|case|\"|inline constexpr)")

Mutant = collections.namedtuple("Mutant", "path line column old new kind code")


def stop(text):
    sys.exit(f"mutants.py: {text}")


def masked(line):
    """Blanks strings, comments and the angle brackets of templates in a line."""
    blank = lambda found: "\0" * len(found[0])
    line = re.sub(r"\"(?:\\.|[^\"])*\"|'(?:\\.|[^'])'|//.*", blank, line)
    before = None
    while before != line:
        before, line = line, ANGLES.sub(blank, line)
    return line


def kind_of(old):
    return {"+": "+ −", "-": "+ −", "+=": "+ −", "-=": "+ −", "<<": "<< >>", ">>": "<< >>", "&": "& |", "|": "& |",
            "&&": "&& ||", "||": "&& ||"}.get(old.strip(), "comparison")


def closing(line, begin):
    """Where the bracket ends whose inside begins there, or None where that is in another line."""
    depth = 1
    for at in range(begin, len(line)):
        depth += {"(": 1, ")": -1}.get(line[at], 0)
        if depth == 0:
            return at
    return None


def mutants_of(path, number, line):
    if NO_CODE.match(line):
        return
    text = masked(line)

    def made(begin, end, new, kind):
        return Mutant(path, number, begin, line[begin:end], new, kind, " ".join(line.split()))
    for found in SWAP.finditer(text):
        yield made(*found.span(), SWAPS[found[0]], kind_of(found[0]))
    for found in NUMBER.finditer(text):
        value = int(found[0].replace("'", ""), 0)
        for new in {value + 1, value - 1} - {-1}:
            yield made(*found.span(), str(new), "number ±1")
    for found in CONDITION.finditer(text):
        end = closing(text, found.end())
        if end is not None:
            yield made(found.end(), end, f"!({line[found.end():end]})", "negated condition")


def drawn():
    """All changes of lines that tests run, in the order in which they are tried: each kind in turn."""
    lines = BUILD.parent / "coverage/lines.json"
    if not lines.exists():
        stop("no build/coverage/lines.json: run tools/test.sh --all first")
    found = []
    for file in sorted(json.loads(lines.read_text())["files"], key=lambda file: file["file"]):
        path, numbers = file["file"], [line["line_number"] for line in file["lines"] if line["count"] > 0]
        text = (ROOT / path).read_text(encoding="utf-8").splitlines()
        for number in numbers:
            found += mutants_of(path, number, text[number - 1])
    found = sorted(set(found))
    random.Random(SEED).shuffle(found)
    by_kind = collections.defaultdict(list)
    for mutant in found:
        by_kind[mutant.kind].append(mutant)
    rounds = itertools.zip_longest(*(by_kind[kind] for kind in sorted(by_kind)))
    return [mutant for turn in rounds for mutant in turn if mutant is not None]


def name_of(mutant):
    return f"{mutant.path}: {mutant.code}: {mutant.column}: {mutant.old.strip()} -> {mutant.new.strip()}"


class Builder:
    """Objects of core's tests, as cmake built them, and those that a change touches, built anew into `work`."""

    def __init__(self):
        self.work = BUILD / "work"
        self.configure()
        self.commands = {re.search(r" -o (\S+)", entry["command"])[1]: entry
                         for entry in json.loads((BUILD / "compile_commands.json").read_text())}
        self.dependents = self.read_dependents()
        self.tests = [o for o in self.commands if o.startswith(OBJECTS) and o.endswith("_test.cpp.o")]
        # Functions that no test calls are not linked.
        self.libraries = [BUILD / "lumi_c.a", *sorted(BUILD.glob("tests/core/*.a")), BUILD / "core/liblumi_core.a",
                          *sorted(BUILD.glob("tools/lab/twin/*.a"))]
        self.main = next(BUILD.glob("tests/CMakeFiles/lumi_catch_main.dir/main.cpp.o"), None)
        self.cpu = self.baseline()

    def configure(self):
        subprocess.run(["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-DLUMI_BUILD_HOST=OFF", "-DLUMI_BUILD_TESTS=ON",
                        "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                        "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", BUILD, "--parallel", "1", "--target", "lumi_core_tests"], check=True,
                       stdout=subprocess.DEVNULL)
        shutil.rmtree(TREE, ignore_errors=True)
        for folder in ("core", "tests"):
            shutil.copytree(ROOT / folder, TREE / folder)
        archive = BUILD / "lumi_c.a"
        archive.unlink(missing_ok=True)
        subprocess.run(["ar", "qc", archive, *(BUILD / OBJECTS).rglob("core/src/c/*.o")], check=True)

    @staticmethod
    def read_dependents():
        """{file of core: objects that include it or are made of it}"""
        dependents, made = collections.defaultdict(list), None
        for line in subprocess.run(["ninja", "-C", BUILD, "-t", "deps"], capture_output=True, text=True,
                                   check=True).stdout.splitlines():
            if line and not line.startswith(" "):
                made = line.split(":")[0]
            elif line.strip():
                path = pathlib.Path(os.path.normpath(BUILD / line.strip()))
                if ROOT / "core" in path.parents and (made.startswith((OBJECTS, "core/"))):
                    dependents[str(path.relative_to(ROOT))].append(made)
        return dependents

    def compiled(self, object_name):
        """The object made of the changed tree, or None."""
        out = self.work / object_name.replace("/", "+")
        entry = self.commands[object_name]
        words = [word.replace(f"{ROOT}/core", f"{TREE}/core").replace(f"{ROOT}/tests", f"{TREE}/tests")
                 for word in shlex.split(entry["command"])]
        words[words.index("-o") + 1] = str(out)
        if "ccache" in words[0] or words[0].endswith("ccx"):
            words = words[1:]
        done = subprocess.run([word for word in words if word != "-Werror"], cwd=entry["directory"], capture_output=True,
                              check=False)
        return out if done.returncode == 0 else None

    def is_other_code(self, object_name, made):
        """Whether the object holds other code than the one without the change."""
        return self.code_of(made) != self.code_of(BUILD / object_name)

    @staticmethod
    def code_of(path):
        return subprocess.run(["objdump", "--disassemble", "--reloc", "--full-contents", "--no-show-raw-insn", path],
                              capture_output=True, text=True, check=True).stdout.partition("file format")[2]

    def link(self, name, objects):
        program = self.work / name
        words = ["g++", "-o", program, self.main, *objects, "-Wl,--start-group", *self.libraries, "-Wl,--end-group",
                 "-pthread"]
        done = subprocess.run([word for word in words if word], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            stop(f"{name} does not link:\n{done.stderr[:2000]}")
        return program

    def baseline(self):
        """CPU seconds of each file's tests."""
        self.clean()
        program = self.link("baseline", [BUILD / test for test in self.tests])
        cpu = {}
        for test in self.tests:
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            if run(program, test, 1000) is not None:
                stop(f"{test}: its tests fail without any change")
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            cpu[test] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return cpu

    def clean(self):
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)


def run(program, test, cpu_s):
    """None where the tests of that file pass; else why not."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (int(cpu_s) + 1, int(cpu_s) + 2))
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    done = subprocess.run([program, "--filenames-as-tags", "--abort", f"[#{pathlib.Path(test).stem.split('.')[0]}]"],
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limit, check=False)
    return None if done.returncode == 0 else "fails" if done.returncode > 0 else f"signal {-done.returncode}"


class Trial:
    def __init__(self, builder):
        self.builder = builder
        self.kills = collections.Counter()  # by file of tests

    def order(self, mutant):
        """Files of tests, the likeliest to see the change first."""
        words = set(re.split(r"[/_.]", mutant.path)) - {"core", "src", "include", "lumi", "detail", "h", "cpp"}

        def rank(test):
            alike = len(words & set(re.split(r"[/_.]", test[len(OBJECTS):])))
            return ("same_bits" not in test, -alike - min(3, self.kills[test]) / 2, self.builder.cpu[test])
        return sorted(self.builder.tests, key=rank)

    def try_one(self, mutant):
        """(outcome, by what)"""
        self.builder.clean()
        file = TREE / mutant.path
        original = (ROOT / mutant.path).read_text(encoding="utf-8")
        lines = original.split("\n")
        line = lines[mutant.line - 1]
        lines[mutant.line - 1] = line[:mutant.column] + mutant.new + line[mutant.column + len(mutant.old):]
        file.write_text("\n".join(lines), encoding="utf-8")
        try:
            return self.outcome(mutant)
        finally:
            file.write_text(original, encoding="utf-8")

    def outcome(self, mutant):
        touched = self.builder.dependents[mutant.path]
        tests = [test for test in self.order(mutant) if test in touched]
        changed, is_other = [], False
        for name in touched:
            if name in tests:
                continue
            made = self.builder.compiled(name)
            if made is None:
                return "does not compile", ""
            if self.builder.is_other_code(name, made):
                changed.append(made)
                is_other = True
        for test in tests:  # each by itself, as it takes long to compile them all
            made = self.builder.compiled(test)
            if made is None:
                return "does not compile", ""
            if not is_other and not self.builder.is_other_code(test, made):
                continue
            is_other = True
            program = self.builder.link("one", [made, *changed])
            if self.fails(program, test):
                return "killed", test[len(OBJECTS):-2]
        if not is_other:
            return "same code", ""
        if changed:
            rest = [test for test in self.order(mutant) if test not in tests]
            program = self.builder.link("all", [*(BUILD / test for test in rest), *changed])
            for test in rest:
                if self.fails(program, test):
                    return "killed", test[len(OBJECTS):-2]
        return "survived", ""

    def fails(self, program, test):
        if run(program, test, 3 * self.builder.cpu[test] + 4) is None:
            return False
        self.kills[test] += 1
        return True


def equal_names():
    """Reads the changes that equal core: two lines each, the name and its proof."""
    blocks = [block.strip().splitlines() for block in EQUAL.read_text(encoding="utf-8").split("\n\n")]
    return {lines[0]: " ".join(lines[1:]) for lines in blocks if lines and not lines[0].startswith("#")}


def rows_of(results):
    equal = equal_names()
    rows = collections.defaultdict(lambda: {"changes": 0, "killed": 0, "equal": 0})
    for result in results:
        for kind in (result["kind"], "all"):
            row = rows[kind]
            row["changes"] += 1
            row["killed"] += result["outcome"] == "killed"
            row["equal"] += result["outcome"] == "survived" and result["name"] in equal
    return [{"kind": kind, **rows[kind]} for kind in sorted(rows, key=lambda kind: (kind == "all", kind))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--minutes", type=float, default=1e9)
    parser.add_argument("--again", action="store_true")
    options = parser.parse_args()
    results = json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else []
    if options.again:
        results = [result for result in results if result["outcome"] != "survived"]
    known = {result["name"] for result in results}
    counts = lambda: sum(result["outcome"] in ("killed", "survived") for result in results)
    end = time.monotonic() + 60 * options.minutes
    trial = None
    for mutant in drawn():
        if counts() >= options.count or time.monotonic() > end:
            break
        if name_of(mutant) in known:
            continue
        trial = trial or Trial(Builder())
        begin = time.monotonic()
        outcome, by = trial.try_one(mutant)
        results.append({"name": name_of(mutant), "line": mutant.line, "kind": mutant.kind, "outcome": outcome, "by": by,
                        "seconds": round(time.monotonic() - begin, 1)})
        print(json.dumps(results[-1], ensure_ascii=False), flush=True)
        RESULTS.write_text(json.dumps(results, ensure_ascii=False, indent=0), encoding="utf-8")
    tried = [result for result in results if result["outcome"] in ("killed", "survived")]
    rows = rows_of(tried)
    for row in rows:
        print(json.dumps(row, ensure_ascii=False))
    unseen = [result for result in tried if result["outcome"] == "survived" and result["name"] not in equal_names()]
    if unseen:
        stop("\n".join(["no test sees these changes:", *(f"line {r['line']}: {r['name']}" for r in unseen)]))


if __name__ == "__main__":
    main()
