#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""release.py [--check | --set-version X.Y.Z | --tag | --dry-run] [--lumi COMMAND] [--field FILE.lumi]
           [--samples FOLDER] [OUT]

Writes core's archives for firmware ecosystems, bills of materials (SPDX 2.3) and SHA256SUMS into OUT (out/release): the
same bytes from the same sources, but for the versions of Debian's packages in that of the lumi command. Only files that
git tracks are packed. core/VERSION is
the version; --set-version writes it wherever a tool wants to read it, --check finds where it differs. --tag also tags
the commit vX.Y.Z, of a tree without changes, before it writes. Archives: core for CMake, Zephyr, the Pico SDK and
PlatformIO; the same as a component of ESP-IDF, whose folder is its name; the Arduino library; the CMSIS-Pack. Each holds
the part for LVGL, an example with live data and the changelog. OUT/trees has a folder for each channel, as it takes it
(channels.py).

core/PROJECT.json says where the project lives and who keeps it. While it holds placeholders, there is no release:
--dry-run writes it nevertheless.

COMMAND (build/release/tools/lumi) bakes the field of Arduino's sketches, which takes minutes; with --field it only embeds
that file. With --samples there is also an archive of the fields in FOLDER, with pages that turn them.
"""
import argparse
import hashlib
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile

import arduino
import channels
import npm
import samples
import spdx
from project import CORE, PROJECT, ROOT, placeholders, version

HOME = PROJECT["home"]
EPOCH = (2020, 1, 1, 0, 0, 0)
# Files that hold the version, each with a pattern whose group it is.
COPIES = {
    CORE / "idf_component.yml": r'^version: "([^"]+)"',
    CORE / "library.json": r'"version": "([^"]+)"',
    ROOT / "library.json": r'"version": "([^"]+)"',
    ROOT / "CITATION.cff": r"^version: (\S+)",
}


def copies():
    """(file, version that it holds or None)"""
    for path, pattern in COPIES.items():
        if path.exists():
            match = re.search(pattern, path.read_text(), re.MULTILINE)
            yield path, match.group(1) if match else None


def set_version(new):
    if not re.fullmatch(r"\d+\.\d+\.\d+", new):
        sys.exit(f"error: {new}: a version is three numbers, such as 0.2.0")
    (CORE / "VERSION").write_text(new + "\n")
    for path, old in copies():
        text = path.read_text()
        match = re.search(COPIES[path], text, re.MULTILINE)
        path.write_text(text[: match.start(1)] + new + text[match.end(1):])


def content(path):
    """The bytes of a file, but not through a link: it could lead out of the project."""
    if path.resolve() != path:
        sys.exit(f"error: {path.relative_to(ROOT)}: leads to {path.resolve()}, and a link is not packed; put the file in its place")
    return path.read_bytes()


def tracked(folder):
    """{name in the folder: bytes} of what git tracks: nothing that an editor or a build left there."""
    names = git("ls-files", "-z", "--", folder).split("\0")
    files = (ROOT / name for name in names if name)
    return {path.relative_to(folder).as_posix(): content(path) for path in files if path.is_symlink() or path.is_file()}


def lvgl_files():
    """The image decoder and the widget, whose renderer includes a file of core from beside it."""
    files = {name: text for name, text in tracked(ROOT / "platform/lvgl").items() if name.startswith("lv_lumi")}
    renderer = files["lv_lumi_renderer.cpp"]
    files["lv_lumi_renderer.cpp"] = renderer.replace(b'"../../core/src/', b'"../src/')
    if files["lv_lumi_renderer.cpp"] == renderer:
        sys.exit("error: platform/lvgl/lv_lumi_renderer.cpp: it includes no file of core/src, which archives hold elsewhere")
    return files


def core_files():
    files = tracked(CORE)
    files["CHANGELOG.md"] = content(ROOT / "CHANGELOG.md")
    for name, path in {"main.cpp": "platform/overlay/main.cpp", "board.h": "platform/bare/board.h"}.items():
        files["examples/live_data/" + name] = content(ROOT / path)
    files.update({f"lvgl/{name}": text for name, text in lvgl_files().items()})
    return files


def write_zip(path, files, top=""):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(top + name, EPOCH)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name])


def write_tar(path, files, top):
    with tarfile.open(path, "w:xz", format=tarfile.USTAR_FORMAT) as archive:
        for name in sorted(files):
            entry = tarfile.TarInfo(top + name)
            entry.size = len(files[name])
            entry.mode = 0o644
            archive.addfile(entry, io.BytesIO(files[name]))


def write_bills(out, core, lumi):
    (out / f"lumi-core-{version()}.spdx.json").write_bytes(spdx.of_core(core, version(), HOME))
    listed = subprocess.run([ROOT / "tools/install_packages.sh", "build", "--print"], capture_output=True, text=True)
    try:
        bill = spdx.of_tool(sorted(listed.stdout.split()), lumi, version(), HOME)
    except (FileNotFoundError, subprocess.CalledProcessError) as error:  # not Debian, or a package or lumi is missing
        print(f"SKIPPED lumi-{version()}.spdx.json: {error}", file=sys.stderr)
    else:
        (out / f"lumi-{version()}.spdx.json").write_bytes(bill)


def write_trees(folder, trees):
    shutil.rmtree(folder, ignore_errors=True)
    for channel, files in trees.items():
        for name, content_of in files.items():
            path = folder / channel / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content_of)
            path.chmod(0o755 if content_of.startswith(b"#!") else 0o644)
        print(f"{len(files):5} files  trees/{channel}")


def write_archives(out, fields, lumi, sample_files):
    out.mkdir(parents=True, exist_ok=True)
    core = core_files()
    top = f"lumi-core-{version()}/"
    trees = channels.trees(core, tracked(ROOT), tracked(arduino.ADDED), fields)
    module = lumi.parent.parent / "platform/wasm/element_viewer.wasm.gz"
    if module.is_file():
        trees["npm"] = npm.files(module)
    else:
        print(f"SKIPPED trees/npm: {module} is missing: build lumi with clang and lld", file=sys.stderr)
    write_tar(out / f"lumi-core-{version()}.tar.xz", core, top)
    write_zip(out / f"lumi-esp-idf-{version()}.zip", trees["esp-idf"], "lumi/")
    write_zip(out / f"lumi-arduino-{version()}.zip", trees["arduino"], "Lumi/")
    write_zip(out / f"{PROJECT['namespace']}.lumi.{version()}.pack", trees["cmsis"])
    (out / f"{PROJECT['namespace']}.pidx").write_text(channels.pack_index())
    if sample_files:
        write_zip(out / f"lumi-samples-{version()}.zip", {**sample_files, "LICENSE": core["LICENSE"]}, f"lumi-samples-{version()}/")
    write_bills(out, core, lumi)
    names = sorted(p.name for p in out.iterdir() if p.is_file() and p.name != "SHA256SUMS")
    sums = "".join(f"{hashlib.sha256((out / n).read_bytes()).hexdigest()}  {n}\n" for n in names)
    (out / "SHA256SUMS").write_text(sums)
    print(sums, end="")
    write_trees(out / "trees", trees)


def git(*arguments):
    result = subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"error: git {' '.join(arguments)}: {result.stderr.strip()}")
    return result.stdout


def require_committed():
    changes = git("status", "--porcelain")
    if changes:
        sys.exit(f"error: what is released is not committed; commit or remove\n{changes.rstrip()}")


def parsed(arguments):
    parser = argparse.ArgumentParser(usage=__doc__, add_help=False, allow_abbrev=False)
    what = parser.add_mutually_exclusive_group()
    for flag in ("--check", "--tag", "--dry-run"):
        what.add_argument(flag, action="store_true")
    what.add_argument("--set-version")
    parser.add_argument("--lumi", type=pathlib.Path, default=ROOT / "build/release/tools/lumi")
    parser.add_argument("--field", type=pathlib.Path)
    parser.add_argument("--samples", type=pathlib.Path)
    parser.add_argument("out", nargs="?", type=pathlib.Path, default=ROOT / "out/release")
    return parser.parse_args(arguments)


def main(arguments):
    options = parsed(arguments)
    if options.set_version:
        set_version(options.set_version)
        return
    wrong = [f"error: {path}: version {held} is not {version()} of core/VERSION; mend it by tools/packaging/release.py "
             f"--set-version {version()}" for path, held in copies() if held != version()]
    json.loads((CORE / "library.json").read_text())
    if wrong:
        sys.exit("\n".join(wrong))
    if content(CORE / "LICENSE") != content(ROOT / "LICENSE"):
        sys.exit("error: LICENSE: differs from core/LICENSE; copy the latter")
    if options.check:
        return
    if placeholders() and not options.dry_run:
        sys.exit(f"error: core/PROJECT.json: {', '.join(placeholders())} are placeholders; say where the project lives, or "
                 "add --dry-run")
    if options.tag:
        require_committed()
    fields = arduino.field_files(options.lumi, options.field)
    sample_files = samples.files(options.lumi, options.samples, version()) if options.samples else {}
    if options.tag:
        git("tag", "--annotate", f"v{version()}", "--message", f"LumiPath {version()}")
    write_archives(options.out, fields, options.lumi, sample_files)


if __name__ == "__main__":
    main(sys.argv[1:])
