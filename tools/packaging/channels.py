# SPDX-License-Identifier: MIT
"""The tree of files that each channel wants, for release.py: core's files with the channel's manifest, written from
project.py. tests/platform/channels_test.py checks them."""
import json
import re
import subprocess
import textwrap

import arduino
from project import DESCRIPTION, PROJECT, ROOT, person, version

HOME, NAMESPACE = PROJECT["home"], PROJECT["namespace"]
DATE = "Thu, 01 Jan 2026 00:00:00 +0000"  # a time of writing would change the bytes
PLACED_BY_OTHERS = r"g\+\+|python3"  # of Debian's build-essential, or there with another package


def esp_idf(core):
    example = "examples/amoled/main/idf_component.yml"
    manifest = core["idf_component.yml"].decode() + "".join(
        f"{line}\n" for line in (f"url: {HOME}", f"repository: {HOME}.git", "maintainers:", f"  - {person()}"))
    return {**core, "idf_component.yml": manifest.encode(),
            example: core[example].replace(b"example/lumi:", f"{NAMESPACE}/lumi:".encode())}


def platformio(core):
    manifest = {**json.loads(core["library.json"]), "homepage": HOME,
                "repository": {"type": "git", "url": f"{HOME}.git"},
                "authors": [{"name": PROJECT["maintainer"], "email": PROJECT["email"], "maintainer": True}],
                "examples": [{"name": "live_data", "base": "examples/live_data", "files": ["main.cpp", "board.h"]}]}
    return {**core, "library.json": (json.dumps(manifest, indent=2) + "\n").encode()}


def zephyr(core):
    """`zephyr/module.yml` lies at the root of the tree; the snippet is for the west.yml of an application."""
    west = f"""manifest:
  projects:
    - name: lumi
      url: {HOME}
      revision: v{version()}
      path: modules/lib/lumi
"""
    return {**core, "zephyr/west-snippet.yml": west.encode()}


def pack_description(names):
    sources = "\n".join(f'        <file category="source" name="{n}"/>' for n in names
                        if n.startswith("src/") and n.endswith((".cpp", ".S")))
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<package schemaVersion="1.7.28" xmlns:xs="http://www.w3.org/2001/XMLSchema-instance"
         xs:noNamespaceSchemaLocation="PACK.xsd">
  <vendor>{NAMESPACE}</vendor>
  <name>lumi</name>
  <description>{DESCRIPTION}</description>
  <url>{HOME}/</url>
  <supportContact>{PROJECT["email"]}</supportContact>
  <license>LICENSE</license>
  <releases>
    <release version="{version()}">See CHANGELOG.md.</release>
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


def pack_index():
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<index schemaVersion="1.1.0" xmlns:xs="http://www.w3.org/2001/XMLSchema-instance"
       xs:noNamespaceSchemaLocation="PackIndex.xsd">
  <vendor>{NAMESPACE}</vendor>
  <url>{HOME}/</url>
  <timestamp>2026-01-01T00:00:00+00:00</timestamp>
  <pindex>
    <pdsc url="{HOME}/" vendor="{NAMESPACE}" name="lumi" version="{version()}"/>
  </pindex>
</index>
"""


def cmsis(core):
    return {**core, f"{NAMESPACE}.lumi.pdsc": pack_description(sorted(core)).encode()}


def debian_copyright(licence):
    holder = re.search(r"^Copyright (?:\(c\) )?(.*)$", licence, re.MULTILINE)[1]
    text = "".join(f" {line}\n" if line else " .\n" for line in licence.strip().split("\n"))
    return ("Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n"
            f"Upstream-Name: LumiPath for microcontrollers\nSource: {HOME}\n\n"
            f"Files: *\nCopyright: {holder}\nLicense: MIT\n\nLicense: MIT\n{text}")


def debian(files):
    """The whole project with a folder `debian`: a native source package of the `lumi` command."""
    needed = subprocess.run([ROOT / "tools/install_packages.sh", "build", "--print"], capture_output=True, text=True,
                            check=True).stdout.split()
    needed = ["debhelper-compat (= 13)", *(n for n in sorted(needed) if not re.fullmatch(PLACED_BY_OTHERS, n)), "python3"]
    told = re.search(r'_DESCRIPTION\n"(.*?)"\)', files["tools/packaging/debian.cmake"].decode(), re.DOTALL)[1]
    text = "\n".join(textwrap.wrap(" ".join(told.split()), 76, initial_indent=" ", subsequent_indent=" "))
    control = f"""Source: lumipath
Section: graphics
Priority: optional
Maintainer: {person()}
Build-Depends: {", ".join(needed)}
Standards-Version: 4.6.2
Homepage: {HOME}
Rules-Requires-Root: no

Package: lumipath
Architecture: any
Depends: ${{shlibs:Depends}}, ${{misc:Depends}}
Description: bake scenes for microcontrollers that draw them from any side
{text}
"""
    rules = """#!/usr/bin/make -f
%:
	dh $@ --buildsystem=cmake

override_dh_auto_configure:
	dh_auto_configure -- -DLUMI_BUILD_TESTS=OFF

override_dh_auto_install:
	DESTDIR=$(CURDIR)/debian/lumipath cmake --install obj-$(DEB_HOST_MULTIARCH) --component tool
	rm -r debian/lumipath/usr/share/doc

override_dh_auto_test:
"""
    changelog = f"lumipath ({version()}) unstable; urgency=medium\n\n  * See CHANGELOG.md.\n\n -- {person()}  {DATE}\n"
    own = {"control": control, "rules": rules, "changelog": changelog, "source/format": "3.0 (native)\n",
           "copyright": debian_copyright(files["LICENSE"].decode())}
    return {**files, **{f"debian/{name}": text.encode() for name, text in own.items()}}


def trees(core, all_files, added, fields):
    """{channel: {name: bytes}}. `core`: its files; `all_files`: the whole project's; `added`: those of arduino.ADDED;
    `fields`: what Arduino's sketches draw."""
    words = {"VERSION": version(), "HOME": HOME, "PERSON": person()}
    return {"arduino": arduino.library(core, added, words, fields), "esp-idf": esp_idf(core), "platformio": platformio(core),
            "zephyr": zephyr(core), "cmsis": cmsis(core), "debian": debian(all_files)}
