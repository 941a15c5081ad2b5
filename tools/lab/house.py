#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""house.py [--build] [REVISION...]

Counts what a newcomer to this project meets, at the given revisions of git (default: HEAD), and writes it as JSON to
standard output, an object for each revision: lines and files of C++ without tests, entries of tools/, the fullest folder,
and how many files name one texel format, pixel format, material parameter, scene reader, processor and board. A further
one of the same kind touches about as many files. The page docs/log/house.md gets its table by
`tools/lab/house.py 2118bb6 HEAD | tools/lab/pages.py put house revisions`.

With --build it builds the `lumi` command of each revision instead, from nothing, without ccache and by two jobs, and
writes what that takes: CPU seconds of all compilers, which other programs disturb little, and seconds by the clock
(`tools/lab/house.py --build 2118bb6 HEAD | tools/lab/pages.py put house builds`).
"""
import collections
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

AREAS = ("core", "baker", "tools", "platform")
CODE = (".h", ".cpp", ".c", ".S")
# One of each kind, as a pattern for git grep without regard to case. Generated files and tests do not count.
KINDS = {
    "texel format (luma8)": "luma8",
    "pixel format (bgr555)": "bgr555",
    "material parameter (coat roughness)": r"coat_alpha|coat_roughness|\bPcr\b",
    "scene reader (NIfTI)": "nifti",
    "processor (Cortex-M33)": "cortex-m33",
    "board (lm3s_oled)": "lm3s",
}


def git(*arguments):
    ended = subprocess.run(["git", *arguments], capture_output=True, text=True, check=False)
    if ended.returncode > 1 or ended.stderr:  # git grep ends with 1 where it finds nothing
        sys.exit(f"house.py: git {' '.join(arguments)}: {ended.stderr.strip()}")
    return ended.stdout.splitlines()


def without_revision(line):
    return line.split(":", 1)[1]


def lines_by_area(revision):
    lines, files = collections.Counter(), collections.Counter()
    for line in git("grep", "-c", "", revision, "--", *(f"{area}/*{ending}" for area in AREAS for ending in CODE)):
        path, count = without_revision(line).rsplit(":", 1)
        area = path.split("/")[0]
        lines[area] += int(count)
        files[area] += 1
    return lines, files


def fullest_folder(paths):
    """Entries, folders and files alike, of each folder of sources; the fullest one."""
    entries = collections.defaultdict(set)
    for path in paths:
        while os.path.dirname(path):
            folder, name = os.path.split(path)
            entries[folder].add(name)
            path = folder
    inside = {f: len(e) for f, e in entries.items() if f.split("/")[0] in AREAS and "/scenes" not in f}
    return max(inside.items(), key=lambda item: (item[1], item[0]))


def files_naming(pattern, revision):
    found = git("grep", "-liE", pattern, revision, "--", *AREAS, "toolchains", "CMakeLists.txt", "CMakePresets.json")
    return len([line for line in found if "/scenes/" not in line and not line.endswith(".md")])


def measure(revision):
    paths = git("ls-tree", "-r", "--name-only", revision)
    lines, files = lines_by_area(revision)
    folder, count = fullest_folder(paths)
    return {
        "revision": git("rev-parse", "--short", revision)[0],
        "lines": {**lines, "all": sum(lines.values())},
        "files": {**files, "all": sum(files.values())},
        "entries_of_tools": len({p.split("/")[1] for p in paths if p.startswith("tools/")}),
        "fullest_folder": {"name": folder, "entries": count},
        "files_naming": {kind: files_naming(pattern, revision) for kind, pattern in KINDS.items()},
    }


def build(revision):
    with tempfile.TemporaryDirectory() as folder:
        archive = subprocess.run(["git", "archive", revision], capture_output=True, check=True)
        subprocess.run(["tar", "-x"], input=archive.stdout, cwd=folder, check=True)
        environment = {name: text for name, text in os.environ.items() if not name.endswith("_COMPILER_LAUNCHER")}
        environment["CCACHE_DISABLE"] = "1"

        def run(*command):
            subprocess.run(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL, check=True)
        run("cmake", "--preset", "release")
        begin, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
        run("cmake", "--build", "--preset", "release", "--parallel", "2", "--target", "lumi")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return {
            "revision": git("rev-parse", "--short", revision)[0],
            "cpu_seconds": round(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime),
            "seconds": round(time.monotonic() - begin),
        }


def main(arguments):
    count = build if arguments[:1] == ["--build"] else measure
    revisions = arguments[1:] if count is build else arguments
    if any(a.startswith("-") for a in revisions):
        print(__doc__, file=sys.stderr)
        return 2
    json.dump([count(revision) for revision in revisions or ["HEAD"]], sys.stdout, indent=1)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
