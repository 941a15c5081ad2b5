#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""release.py [--check | --set-version X.Y.Z | --tag] [OUT]

Writes core's archives for firmware ecosystems, bills of materials (SPDX 2.3) and SHA256SUMS into OUT (out/release): the
same bytes from the same sources, but for the versions of Debian's packages in that of the lumi command. core/VERSION is
the version; --set-version writes it wherever a tool wants to read it, --check finds where it differs. --tag also tags
the commit vX.Y.Z, of a tree without changes, before it writes. Archives: core for CMake, ESP-IDF, Zephyr, the Pico SDK
and PlatformIO; the Arduino library; the CMSIS-Pack.
"""
import hashlib
import io
import json
import pathlib
import re
import subprocess
import sys
import tarfile
import zipfile

import spdx

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORE = ROOT / "core"
HOME = "https://example.invalid/lumi"  # where the project lives
EPOCH = (2020, 1, 1, 0, 0, 0)
# Files that hold the version, each with a pattern whose group it is.
COPIES = {
    CORE / "idf_component.yml": r'^version: "([^"]+)"',
    CORE / "library.json": r'"version": "([^"]+)"',
    ROOT / "CITATION.cff": r"^version: (\S+)",
}
ARDUINO_PROPERTIES = """name=Lumi
version={version}
author=The LumiPath developers
maintainer=The LumiPath developers
sentence=Path-traced objects, drawn from flash by integers.
paragraph=Draws fields that the lumi tool baked, on displays of any size, without floating point or heap.
category=Display
url={home}
architectures=rp2040,esp32,esp8266,stm32,renesas_uno,renesas_portenta,teensy
includes=lumi/view.h
"""
ARDUINO_SKETCH = """// Draws one frame of a field. Write product.c and product.h into this folder first:
//     lumi embed product.lumi -o product.c
#include <lumi/surface/view.h>
#include "product.h"

static product_view<lumi::Screen<240, 240, 8>> view;
alignas(4) static uint8_t stripe[240 * 8 * 2];

void setup()
{
  Serial.begin(115200);
  lumi::ViewError error = view.open(product, product_size());
  if (error == lumi::ViewError::none) error = view.look({lumi::degrees(30), lumi::degrees(20), lumi::radii(3)});
  for (int y = 0; y < 240 && error == lumi::ViewError::none; y += 8) {
    error = view.draw({stripe, 0, y, 240, 8, 480});
    // here send the stripe to the display
  }
  Serial.println(lumi::error_text(error));
}

void loop() {}
"""


def version():
    return (CORE / "VERSION").read_text().strip()


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


def core_files():
    files = {}
    for path in sorted(CORE.rglob("*")):
        if path.is_file():
            files[path.relative_to(CORE).as_posix()] = path.read_bytes()
    files["LICENSE"] = (ROOT / "LICENSE").read_bytes()
    return files


def arduino_files():
    """Arduino compiles all of src and has src alone in its include path: headers and sources lie there together."""
    files = {"LICENSE": (ROOT / "LICENSE").read_bytes(),
             "library.properties": ARDUINO_PROPERTIES.format(version=version(), home=HOME).encode(),
             "examples/OneFrame/OneFrame.ino": ARDUINO_SKETCH.encode()}
    for name, content in core_files().items():
        for folder in ("include/", "src/"):
            if name.startswith(folder):
                files["src/" + name[len(folder):]] = content
    return files


def pack_description(names):
    sources = "\n".join(f'        <file category="source" name="{n}"/>' for n in names if n.endswith((".cpp", ".S")))
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<package schemaVersion="1.7.28" xmlns:xs="http://www.w3.org/2001/XMLSchema-instance"
         xs:noNamespaceSchemaLocation="PACK.xsd">
  <vendor>Lumi</vendor>
  <name>lumi</name>
  <description>Path-traced objects, drawn from flash by integers</description>
  <url>{HOME}/</url>
  <license>LICENSE</license>
  <releases>
    <release version="{version()}">See CHANGELOG.md of the project.</release>
  </releases>
  <conditions>
    <condition id="CortexM">
      <require Cclass="CMSIS" Cgroup="CORE"/>
    </condition>
  </conditions>
  <components>
    <component Cclass="Graphics" Cgroup="LumiPath" Cversion="{version()}" condition="CortexM">
      <description>Renderers of surface and chord fields; C++17, gcc or clang</description>
      <files>
        <file category="include" name="include/"/>
        <file category="include" name="src/"/>
{sources}
      </files>
    </component>
  </components>
</package>
"""


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


def write_bills(out, core):
    (out / f"lumi-core-{version()}.spdx.json").write_bytes(spdx.of_core(core, version(), HOME))
    listed = subprocess.run([ROOT / "tools/install_packages.sh", "build", "--print"], capture_output=True, text=True)
    try:
        bill = spdx.of_tool(sorted(listed.stdout.split()), version(), HOME)
    except FileNotFoundError as error:  # not Debian, or a package is missing
        print(f"SKIPPED lumi-{version()}.spdx.json: {error}", file=sys.stderr)
    else:
        (out / f"lumi-{version()}.spdx.json").write_bytes(bill)


def write_archives(out):
    out.mkdir(parents=True, exist_ok=True)
    core = core_files()
    top = f"lumi-core-{version()}/"
    write_tar(out / f"lumi-core-{version()}.tar.xz", core, top)
    write_zip(out / f"lumi-arduino-{version()}.zip", arduino_files(), "Lumi/")
    pack = dict(core)
    pack["Lumi.lumi.pdsc"] = pack_description(sorted(core)).encode()
    write_zip(out / f"Lumi.lumi.{version()}.pack", pack)
    write_bills(out, core)
    names = sorted(p.name for p in out.iterdir() if p.name != "SHA256SUMS")
    sums = "".join(f"{hashlib.sha256((out / n).read_bytes()).hexdigest()}  {n}\n" for n in names)
    (out / "SHA256SUMS").write_text(sums)
    print(sums, end="")


def git(*arguments):
    result = subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"error: git {' '.join(arguments)}: {result.stderr.strip()}")
    return result.stdout


def tag_commit():
    changes = git("status", "--porcelain")
    if changes:
        sys.exit(f"error: what is released is not committed; commit or remove\n{changes.rstrip()}")
    git("tag", "--annotate", f"v{version()}", "--message", f"LumiPath {version()}")


def main(arguments):
    if arguments[:1] == ["--set-version"] and len(arguments) == 2:
        set_version(arguments[1])
        return
    wrong = [f"error: {path}: version {held} is not {version()} of core/VERSION; mend it by tools/packaging/release.py "
             f"--set-version {version()}" for path, held in copies() if held != version()]
    json.loads((CORE / "library.json").read_text())
    if wrong:
        sys.exit("\n".join(wrong))
    if arguments[:1] == ["--tag"]:
        tag_commit()
        arguments = arguments[1:]
    elif arguments and arguments[0].startswith("-") and arguments[0] != "--check":
        sys.exit(__doc__)
    if arguments[:1] != ["--check"]:
        write_archives(pathlib.Path(arguments[0]) if arguments else ROOT / "out" / "release")


if __name__ == "__main__":
    main(sys.argv[1:])
