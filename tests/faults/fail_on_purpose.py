#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""fail_on_purpose.py LUMI SHIM [--all]

Runs bake (both layouts), merge and embed again and again, and makes one allocation, read, write, sync or rename fail
each time, or all threads from one on (fault_shim.c). Each run must end with exit code 1 and a message that holds a mend, with the earlier output as
it was; or with exit code 0 and the output of an undisturbed run. Then the same command, undisturbed, must give that
output. A few calls of each kind; with --all every call, of allocations 300 spread over the run and the last 30. Prints
what was tried.
"""
import os
import shutil
import subprocess
import sys
import tempfile

KINDS = ["alloc", "read", "write", "sync", "rename", "thread"]
FEW = 2
FIRST_THREADS = 3  # the first belong to Embree's TBB, the next to the bake
MOST_ALLOCATIONS = 300
LAST_ALLOCATIONS = 30
EARLIER = b"/* Written by `lumi embed`. */"

CUBE = """v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1
f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"""
ROWS = "--layout chord --origins 12 --directions 20 --spp 4 --texel rgb565 --threads 1".split()
SURFACE = "--layout surface --triangles 12 --longest-edge 2 --texel-density 3 --paths 20 --screen 16x16 --threads 1".split()


class Command:
    """A command, the files it reads, made once, and the one it writes."""

    def __init__(self, name, arguments, output):
        self.name, self.arguments, self.output = name, arguments, output


def run(lumi, shim, command, folder, environment):
    call = [lumi] + command.arguments
    return subprocess.run(call, cwd=folder, env=dict(os.environ, LD_PRELOAD=shim, **environment),
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, check=False)


def content(path):
    with open(path, "rb") as file:
        return file.read()


def counts_of(lumi, shim, command, folder):
    outcome = run(lumi, shim, command, folder, {"LUMI_FAULT_COUNT": os.path.join(folder, "counts")})
    if outcome.returncode != 0:
        sys.exit(f"{command.name}: {outcome.stderr.decode()}")
    return {kind: int(n) for kind, n in (line.split() for line in content(os.path.join(folder, "counts")).decode().splitlines())}


def chosen(kind, count, every):
    most = count if every else FEW
    if kind == "alloc" and every:
        most = MOST_ALLOCATIONS
    if kind == "thread" and not every:
        return range(1, min(count, FIRST_THREADS) + 1)
    if count <= most:
        return range(1, count + 1)
    spread = {1 + (2 * k + 1) * count // (2 * most) for k in range(most)}  # away from both ends
    last = range(count - LAST_ALLOCATIONS + 1, count + 1) if kind == "alloc" and every else ()
    return sorted(spread.union(last))


def fresh(sound, folder):
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(sound, folder)


def complaint(command, outcome, folder, expected):
    message = outcome.stderr.decode(errors="replace")
    if outcome.returncode == 0:
        return None if content(os.path.join(folder, command.output)) == expected else "exit 0 with another output"
    if outcome.returncode != 1:
        return f"exit code {outcome.returncode}"
    if "lumi: " not in message or "; " not in message:
        return "a message without a mend"
    return None if content(os.path.join(folder, command.output)) == EARLIER else "the earlier output is gone"


def check_again(lumi, shim, command, folder, expected):
    outcome = run(lumi, shim, command, folder, {})
    if outcome.returncode != 0:
        return "undisturbed afterwards: " + outcome.stderr.decode(errors="replace")
    return None if content(os.path.join(folder, command.output)) == expected else "another output afterwards"


def try_all(lumi, shim, command, sound, folder, every):
    """Returns what was wrong."""
    fresh(sound, folder)
    counts = counts_of(lumi, shim, command, folder)
    expected = content(os.path.join(folder, command.output))
    wrong = []
    if command.name == "merge rows" and expected != content(os.path.join(folder, "whole.lumi")):
        wrong.append("merge rows: other bytes than those of one bake")
    for kind in KINDS:
        tried = survived = 0
        for n in chosen(kind, counts[kind], every):
            fresh(sound, folder)
            with open(os.path.join(folder, command.output), "wb") as file:
                file.write(EARLIER)
            outcome = run(lumi, shim, command, folder, {"LUMI_FAULT": f"{kind}:{n}"})
            found = complaint(command, outcome, folder, expected) or check_again(lumi, shim, command, folder, expected)
            if found:
                wrong.append(f"{command.name}, {kind} {n}: {found}\n{outcome.stderr.decode(errors='replace')}")
            tried += 1
            survived += outcome.returncode == 0
        print(f"{command.name:14} {kind:7} {counts[kind]:6} calls, {tried:4} failed in turn, {survived:4} did no harm", flush=True)
    return wrong


def prepare(lumi, sound):
    with open(os.path.join(sound, "s.obj"), "w", encoding="ascii") as file:
        file.write(CUBE)
    calls = [["bake", "s.obj", "-o", "whole.lumi"] + ROWS]
    for shard in ("1/2", "2/2"):
        calls.append(["bake", "s.obj", "-o", "rows.lumi", "--shard", shard] + ROWS)
        calls.append(["bake", "s.obj", "-o", "surface.lumi", "--shard", shard] + SURFACE)
    for call in calls:
        subprocess.run([lumi] + call, cwd=sound, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def main():
    lumi, shim = map(os.path.abspath, sys.argv[1:3])
    every = "--all" in sys.argv
    commands = [
        Command("bake rows", ["bake", "s.obj", "-o", "a.lumi"] + ROWS, "a.lumi"),
        Command("bake surface", ["bake", "s.obj", "-o", "a.lumi"] + SURFACE, "a.lumi"),
        Command("merge rows", ["merge", "-o", "a.lumi"] + [f"rows.lumi.{k}-of-2.shard" for k in (1, 2)], "a.lumi"),
        Command("merge surface", ["merge", "-o", "a.lumi"] + [f"surface.lumi.{k}-of-2.shard" for k in (1, 2)], "a.lumi"),
        Command("embed", ["embed", "whole.lumi", "-o", "a.S"], "a.S"),
    ]
    wrong = []
    with tempfile.TemporaryDirectory() as scratch:
        sound = os.path.join(scratch, "sound")
        os.mkdir(sound)
        prepare(lumi, sound)
        for command in commands:
            wrong += try_all(lumi, shim, command, sound, os.path.join(scratch, "run"), every)
    for text in wrong:
        print("WRONG: " + text)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
