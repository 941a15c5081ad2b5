#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""baker_mutants.py [--count N] [--minutes M] [--again]

Changes the baker by one operator at a time, as mutants.py changes core, and counts which changes the baker's tests see. N
of them (60), as many of each kind in each of these folders, are drawn with a fixed seed from files that are no headers;
constants with a name are choices, and stay. A change is compiled by itself and linked with what the host's tree has. It is
seen where a test of its folder fails, crashes or takes far longer, else where one of a folder behind it does.

The list is tests/baker/mutants.txt: two lines a change, its name, and what saw it or why it is none ("equal: ..."). The
next call goes on from there, draws anew what no longer applies, and ends after M minutes; --again tries the survivors again. At least nine of ten must be
seen, those aside that are equal.
"""
import collections
import itertools
import json
import pathlib
import random
import re
import resource
import shlex
import subprocess
import sys
import time

from mutants import ROOT, SEED, Builder, mutants_of, name_of, options_of, run

HOST = ROOT / "build/release"
BUILD = ROOT / "build/baker_mutants"
CPU = BUILD / "cpu.json"
LIST = ROOT / "tests/baker/mutants.txt"
# The folders whose tests are run for a folder, its own first.
TESTS = {"fit": ["fit", "surface"], "shadow": ["shadow", "surface"], "mesh": ["mesh", "surface"], "pack": ["pack", "fit", "surface"],
         "model": ["model", "scene"], "light": ["light", "trace"], "material": ["material", "trace"]}
PROGRAM = "tests/baker/lumi_baker_tests"
CONSTANT = re.compile(r"\s*(?:static )?constexpr [\w:<> ]+ k[A-Z]")
LEAST_SHARE = 0.9
MEMORY = 8 << 30  # threads reserve some


def stop(text):
    sys.exit(f"baker_mutants.py: {text}")


def drawn():
    """Changes in the order in which they are tried: each kind in each folder in turn, one a line."""
    cells = collections.defaultdict(list)
    for folder in TESTS:
        for path in sorted((ROOT / "baker/src" / folder).rglob("*.cpp")):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if not CONSTANT.match(line):
                    for mutant in mutants_of(str(path.relative_to(ROOT)), number, line):
                        cells[mutant.kind, folder].append(mutant)
    for cell in sorted(cells):
        random.Random(SEED).shuffle(cells[cell])
    rounds = itertools.zip_longest(*(cells[cell] for cell in sorted(cells)))
    lines = {}
    for mutant in (mutant for turn in rounds for mutant in turn if mutant is not None):
        lines.setdefault((mutant.path, mutant.line), mutant)
    return list(lines.values())


def folder_of(mutant):
    return mutant.path.split("/")[2]


def commands_of(target):
    return subprocess.run(["ninja", "-C", HOST, "-t", "commands", target], capture_output=True, text=True,
                          check=True).stdout.splitlines()


class Tests:
    """The baker's tests with one file of the baker in place of its own."""

    def __init__(self):
        subprocess.run(["cmake", "--preset", "host"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", HOST, "--parallel", "2", "--target", "lumi_baker_tests"], check=True,
                       stdout=subprocess.DEVNULL)
        BUILD.mkdir(parents=True, exist_ok=True)
        self.groups = {}  # file: (object of several files, its command, those files)
        for command in commands_of("baker/liblumi_baker.a"):
            unity = re.search(r" -o (baker/CMakeFiles/lumi_baker\.dir/Unity/\S+\.o) -c (\S+)$", command)
            if unity:
                files = re.findall(r'#include "(.*)"', pathlib.Path(unity[2]).read_text(encoding="utf-8"))
                self.groups.update({file: (unity[1], command, files) for file in files})
        self.link = shlex.split(commands_of("lumi_baker_tests")[-1].split("&&")[1])
        self.cpu = json.loads(CPU.read_text()) if CPU.exists() else {}

    def compiled(self, source, original, out):
        """The object made of `source` as the tree makes that of `original`, or None."""
        words = shlex.split(self.groups[original][1])
        words = [word for word in words[:words.index("-MD")] if "ccache" not in word and word != "-Werror"]
        # Sanitizers see reads behind the end, which these assertions see, too.
        words += ["-D_GLIBCXX_ASSERTIONS", f"-iquote{pathlib.Path(original).parent}", "-o", out, "-c", source]
        done = subprocess.run(words, cwd=HOST, capture_output=True, check=False)
        return out if done.returncode == 0 else None

    def original_object(self, file):
        out = BUILD / ("+".join(pathlib.Path(file).relative_to(ROOT).parts) + ".o")
        if not out.exists() or out.stat().st_mtime < pathlib.Path(file).stat().st_mtime:
            self.compiled(file, file, out)
        return out

    def archive_without(self, group):
        out = BUILD / (pathlib.Path(group).stem + ".a")
        out.write_bytes((HOST / "baker/liblumi_baker.a").read_bytes())
        subprocess.run(["ar", "d", out, pathlib.Path(group).name], check=True)
        return out

    def program(self, original, made):
        group, _, files = self.groups[original]
        objects = [made, *(self.original_object(file) for file in files if file != original)]
        words = list(self.link)
        words[words.index("-o") + 1] = str(BUILD / "lumi_baker_tests")
        at = words.index("baker/liblumi_baker.a")
        words[at:at + 1] = [*map(str, objects), str(self.archive_without(group))]
        done = subprocess.run(words, cwd=HOST, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            stop(f"{original} does not link:\n{done.stderr[:2000]}")
        return BUILD / "lumi_baker_tests"

    def files_of(self, folder):
        return [str(path.relative_to(ROOT / "tests")) for path in (ROOT / "tests/baker" / folder).rglob("*_test.cpp")]

    def cpu_of(self, test):
        """CPU seconds that the file's tests take without a change."""
        if test not in self.cpu:
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            if run(HOST / PROGRAM, test, 1000, MEMORY) is not None:
                stop(f"{test}: its tests fail without any change")
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.cpu[test] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
            CPU.write_text(json.dumps(self.cpu))
        return self.cpu[test]

    def outcome(self, mutant):
        original = str(ROOT / mutant.path)
        lines = pathlib.Path(original).read_text(encoding="utf-8").split("\n")
        line = lines[mutant.line - 1]
        lines[mutant.line - 1] = line[:mutant.column] + mutant.new + line[mutant.column + len(mutant.old):]
        source = BUILD / "changed.cpp"
        source.write_text("\n".join(lines), encoding="utf-8")
        made = self.compiled(source, original, BUILD / "changed.o")
        if made is None:
            return "does not compile"
        program = self.program(original, made)
        for folder in TESTS[folder_of(mutant)]:
            for test in sorted(self.files_of(folder), key=self.cpu_of):
                if run(program, test, 3 * self.cpu_of(test) + 4, MEMORY) is not None:
                    return "seen by " + test.removeprefix("baker/").removesuffix("_test.cpp")
        same = Builder.code_of(made) == Builder.code_of(self.original_object(original))
        return "same code" if same else "not seen"


def read_list():
    blocks = LIST.read_text(encoding="utf-8").split("\n\n") if LIST.exists() else []
    return dict(block.strip().split("\n", 1) for block in blocks if block.strip() and not block.startswith("#"))


def write_list(outcomes):
    LIST.write_text("# Changes of the baker by one operator, and what sees them (tools/lab/proof/baker_mutants.py).\n\n" +
                    "\n\n".join(f"{name}\n{outcome}" for name, outcome in outcomes.items()) + "\n", encoding="utf-8")


def main():
    options = options_of(__doc__, 60)
    mutants = {name_of(mutant): mutant for mutant in drawn()}
    outcomes = {name: outcome for name, outcome in read_list().items()
                if name in mutants and (outcome != "not seen" or not options.again)}
    skipped = {"does not compile", "same code"}
    end = time.monotonic() + 60 * options.minutes
    tests = None
    for name, mutant in mutants.items():
        if len(outcomes) >= options.count or time.monotonic() > end:
            break
        if name in outcomes:
            continue
        tests = tests or Tests()
        outcome = tests.outcome(mutant)
        print(f"{name} ({mutant.line}): {outcome}", flush=True)
        if outcome not in skipped:
            outcomes[name] = outcome
            write_list(outcomes)
    seen = sum(outcome.startswith("seen") for outcome in outcomes.values())
    equal = sum(outcome.startswith("equal: ") for outcome in outcomes.values())
    print(json.dumps({"changes": len(outcomes), "seen": seen, "equal": equal}))
    if seen < LEAST_SHARE * (len(outcomes) - equal):
        stop("fewer than nine of ten changes are seen")


if __name__ == "__main__":
    main()
