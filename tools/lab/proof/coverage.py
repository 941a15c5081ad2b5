#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""coverage.py [--list] [--again]

Builds core's tests for the host without optimization and under `gcc --coverage`, runs lumi_core_tests (but for those of
threads) and lumi_c_tests, and prints the share of core's branches that they take, as gcov counts them: exceptions are off,
as core is built; nothing is left out; templates are merged by source line, so a branch counts as taken where one instance
takes it. Every branch that is not taken must have a sentence in tests/core/untaken_branches.txt that says why. One without
a sentence is an error, and so is a sentence whose branch is taken.

--list prints the lines of that file that are missing, to be completed.
--again builds and runs nothing, and counts what the last run left.
"""
import collections
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = ROOT / "build/coverage"
REASONS = ROOT / "tests/core/untaken_branches.txt"
# Threads lose counts of each other, from which gcov then derives wrong ones.
RUNS = [["lumi_core_tests", "--filenames-as-tags", "~[#halves_threads_test]"], ["lumi_c_tests"]]
# Branches of headers are counted where tests include them: there, too, exceptions are off, and statics have no guards.
# Functions that are inlined always are not: gcov would count each place of theirs by itself.
FLAGS = ("--coverage -fno-exceptions -fno-threadsafe-statics -fprofile-filter-files=/core/[is][nr]c "
         "-DCATCH_CONFIG_DISABLE_EXCEPTIONS -Dalways_inline=unused")
FILES_A_CALL = 16

Branch = collections.namedtuple("Branch", "path line index of")  # the index counts from 1 to `of` on its line


def stop(text):
    sys.exit(f"coverage.py: {text}")


def build_and_run():
    for old in BUILD.rglob("*.gcda"):
        old.unlink()
    jobs = str(os.cpu_count())
    commands = [["cmake", "-S", ROOT, "-B", BUILD, "-G", "Ninja", "-DLUMI_BUILD_HOST=OFF", "-DLUMI_BUILD_TESTS=ON",
                 "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DNDEBUG", f"-DCMAKE_CXX_FLAGS={FLAGS}",
                 "-DCMAKE_EXE_LINKER_FLAGS=--coverage"],
                ["cmake", "--build", BUILD, "--parallel", jobs, "--target", *(run[0] for run in RUNS)],
                *([BUILD / "tests/core" / run[0], *run[1:]] for run in RUNS)]
    for command in commands:
        log = BUILD / "coverage.log"
        BUILD.mkdir(parents=True, exist_ok=True)
        with log.open("w") as output:
            if subprocess.run(command, stdout=output, stderr=subprocess.STDOUT, check=False).returncode != 0:
                stop(f"{' '.join(map(str, command))} failed: see {log}")


def notes_of_gcov():
    """Yields gcov's JSON for every object, also for those that no test links."""
    # Objects of tests that are gone, and of the compiler's own checks, tell of lines that are no longer there.
    subprocess.run(["ninja", "-C", BUILD, "-t", "cleandead"], check=True, stdout=subprocess.DEVNULL)
    notes = [note for note in sorted(BUILD.rglob("*.gcno")) if note.with_suffix(".o").exists()]
    for begin in range(0, len(notes), FILES_A_CALL):
        said = subprocess.run(["gcov", "--json-format", "--stdout", "--branch-probabilities",
                               *notes[begin:begin + FILES_A_CALL]], cwd=BUILD, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, check=True).stdout
        yield from map(json.loads, said.splitlines())


def instances_at(functions, number):
    """How many instances of a template's lambda gcov joins on a line that it gives to no function; and where the lambda
    begins. Where it ends gcov does not know."""
    before = [(f["start_line"], f["start_column"]) for f in functions if f["start_line"] <= number]
    last = max(before, default=None)
    return max(1, before.count(last)), last


def counted():
    """{function on a line: {Branch: times taken}} of core's files. A lambda has its own branches on the line of its
    function."""
    taken = collections.defaultdict(collections.Counter)
    for note in notes_of_gcov():
        for file in note["files"]:
            path = pathlib.Path(os.path.normpath(BUILD / file["file"]))
            if ROOT / "core" not in path.parents:
                continue
            path = str(path.relative_to(ROOT))
            places = {f["name"]: (f["start_line"], f["start_column"]) for f in file["functions"]}
            for line in file["lines"]:
                number, branches = line["line_number"], line["branches"]
                instances, place = 1, places.get(line.get("function_name"))
                if place is None:
                    instances, place = instances_at(file["functions"], number)
                of = len(branches) // instances if len(branches) % instances == 0 else len(branches)
                for index, branch in enumerate(branches):
                    taken[place][Branch(path, number, index % of + 1, of)] += branch["count"]
    return taken


def sums_by_area(taken):
    """Rows of the table: branches and branches taken by folder of core's concepts."""
    sums = collections.defaultdict(lambda: [0, 0])
    for branches in taken.values():
        for branch, count in branches.items():
            parts = branch.path.split("/")[1:]  # src or include/lumi first
            parts = parts[2:] if parts[0] == "include" else parts[1:]
            area = parts[0] if len(parts) > 1 and parts[0] != "detail" else "headers for both layouts"
            for row in (sums[area], sums["all"]):
                row[0] += 1
                row[1] += count > 0
    order = sorted(sums, key=lambda area: (area == "all", area))
    return [{"area": area, "branches": sums[area][0], "taken": sums[area][1]} for area in order]


def untaken_lines(taken):
    """{(path, code): {"index/of"}} of the branches that are not taken, and where each is."""
    found, places = collections.defaultdict(set), {}
    texts = {}
    for branches in taken.values():
        for branch, count in branches.items():
            if count == 0:
                lines = texts.setdefault(branch.path, (ROOT / branch.path).read_text(encoding="utf-8").splitlines())
                key = (branch.path, " ".join(lines[branch.line - 1].split()))
                found[key].add(f"{branch.index}/{branch.of}")
                places.setdefault(key, branch.line)
    return found, places


def numbers(names):
    return sorted(names, key=lambda name: tuple(map(int, name.split("/")[::-1])))


def sentences():
    """{(path, code): ({"index/of"}, sentence)}: three lines each, with an empty line between."""
    said = {}
    for block in REASONS.read_text(encoding="utf-8").split("\n\n"):
        lines = [line for line in block.strip().splitlines() if not line.startswith("#")]
        if not lines:
            continue
        if len(lines) != 3:
            stop(f"{REASONS.relative_to(ROOT)}: not file, code and sentence: {lines[0]}")
        path, *names = lines[0].split()
        said[(path, " ".join(lines[1].split()))] = (set(names), lines[2].strip())
    return said


def main(words):
    if not set(words) <= {"--list", "--again"}:
        sys.exit(__doc__)
    if "--again" not in words:
        build_and_run()
    taken = counted()
    rows = sums_by_area(taken)
    if rows[-1]["branches"] < 1000:
        stop("gcov knows hardly a branch: is it the gcc's?")
    found, places = untaken_lines(taken)
    said = sentences()
    faults = []
    for key in sorted(found):
        names, sentence = said.get(key, (set(), ""))
        print(f"{key[0]}:{places[key]}: {' '.join(numbers(found[key]))}: {key[1]}\n    {sentence or 'no sentence'}")
        if found[key] - names:
            faults.append(f"{key[0]}:{places[key]}: not taken, and no sentence: {' '.join(numbers(found[key] - names))}")
    for key, (names, _) in said.items():
        if names - found.get(key, set()):
            faults.append(f"{key[0]}: taken, or gone, but there is a sentence: {' '.join(numbers(names - found.get(key, set())))}: {key[1]}")
    for row in rows:
        print(json.dumps(row))
    print(f"{100 * rows[-1]['taken'] / rows[-1]['branches']:.2f} % of core's {rows[-1]['branches']} branches are taken")
    if "--list" in words:
        print("\n" + "\n\n".join(f"{key[0]} {' '.join(numbers(found[key]))}\n{key[1]}\n" for key in sorted(found)
                                  if found[key] - said.get(key, (set(), ""))[0]))
    if faults:
        stop("\n".join(["untaken_branches.txt is not right:", *faults]))


if __name__ == "__main__":
    main(sys.argv[1:])
