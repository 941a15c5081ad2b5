#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""channels_test.py [--all] ARCHIVES

Checks the trees that release.py wrote for each channel by rules of the channel, as far as they can refuse a package. No
registry of ours has the channels' own tools, so each check names the page that its rules come from. With --all,
dpkg-source and lintian check Debian's tree.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROJECT = json.loads((ROOT / "core/PROJECT.json").read_text())
VERSION = (ROOT / "core/VERSION").read_text().strip()
URL, PERSON = r"https://\S+", r"[^<>]+ <\S+@\S+>"


def require(channel, holds, what):
    if not holds:
        sys.exit(f"error: {channel}: {what}")


def check(channel, values, rules):
    """Each rule: the pattern that a value matches as a whole."""
    for name, pattern in rules.items():
        value = values.get(name)
        require(channel, isinstance(value, str) and re.fullmatch(pattern, value), f"{name} is {value!r}, not {pattern}")


def is_there(channel, tree, *names):
    for name in names:
        require(channel, (tree / name).exists(), f"{name} is missing")


def arduino(tree):
    """https://arduino.github.io/arduino-cli/latest/library-specification and arduino-lint's rules for a submission."""
    values = dict(line.split("=", 1) for line in (tree / "library.properties").read_text().splitlines())
    check("arduino", values, {
        "name": r"[A-Za-z0-9][A-Za-z0-9 _.-]{0,62}", "version": re.escape(VERSION), "author": PERSON, "maintainer": PERSON,
        "sentence": r"[^\n]+\.", "paragraph": r"[^\n]+", "url": URL, "architectures": r"[a-z0-9_*,]+", "includes": r"\S+\.h",
        "category": "Display|Communication|Signal Input/Output|Sensors|Device Control|Timing|Data Storage|Data Processing|Other"})
    is_there("arduino", tree, "src/" + values["includes"], "keywords.txt", "LICENSE", "examples", "extras/live_data/main.cpp")
    for folder in (tree / "examples").iterdir():
        is_there("arduino", folder, folder.name + ".ino")
    require("arduino", not list(tree.rglob("*.exe")) and not list(tree.rglob(".development")), "a file is forbidden")


def yaml_values(path):
    return dict(re.findall(r'^(\w+): *"?(.*?)"?$', path.read_text(), re.MULTILINE))


def esp_idf(tree):
    """https://docs.espressif.com/projects/idf-component-manager/en/latest/reference/manifest_file.html"""
    text = (tree / "idf_component.yml").read_text()
    values = yaml_values(tree / "idf_component.yml")
    values["maintainer"] = re.search(r"^maintainers:\n  - (.*)$", text, re.MULTILINE)[1]
    check("esp-idf", values, {"version": re.escape(VERSION), "description": r".{10,}", "url": URL, "license": "MIT",
                              "repository": URL + r"\.git", "maintainer": PERSON})
    known = {"version", "description", "url", "repository", "license", "maintainers", "tags", "dependencies"}
    require("esp-idf", set(re.findall(r"^(\w+):", text, re.MULTILINE)) <= known, "the manifest has an unknown key")
    is_there("esp-idf", tree, "CMakeLists.txt", "README.md", "LICENSE", "CHANGELOG.md", "examples/amoled/CMakeLists.txt")
    example = (tree / "examples/amoled/main/idf_component.yml").read_text()
    require("esp-idf", f"\n  {PROJECT['namespace']}/lumi:" in example, "the example depends on another's component")
    require("esp-idf", re.fullmatch(r"[a-z0-9][a-z0-9_-]*", PROJECT["namespace"]), "the namespace is none of the registry")


def platformio(tree):
    """https://github.com/platformio/platformio-core, platformio/assets/schema/library.json and package/manifest/schema.py"""
    for path in (tree / "library.json", ROOT / "library.json"):
        manifest = json.loads(path.read_text())
        check("platformio", manifest, {"name": r"[a-z0-9]+(-[a-z0-9]+)*", "version": re.escape(VERSION),
                                       "description": r".{1,255}", "keywords": r"[a-z0-9-]+(, [a-z0-9-]+)*", "license": "MIT"})
        build = manifest["build"]
        for header in manifest["headers"]:
            is_there("platformio", path.parent, f"{build.get('includeDir', 'include')}/{header}")
        is_there("platformio", path.parent, build.get("srcDir", "src"))
    manifest = json.loads((tree / "library.json").read_text())
    check("platformio", {"homepage": manifest["homepage"], **manifest["repository"], **manifest["authors"][0]},
          {"homepage": URL, "type": "git|hg|svn", "url": URL, "name": r".+", "email": r"\S+@\S+"})
    for example in manifest["examples"]:
        is_there("platformio", tree / example["base"], *example["files"])


def zephyr(tree):
    """https://docs.zephyrproject.org/latest/develop/modules.html, scripts/zephyr_module.py: METADATA_SCHEMA"""
    for root in (tree, ROOT):
        text = (root / "zephyr/module.yml").read_text()
        build = dict(re.findall(r"^  (\w+): *(\S+)$", text, re.MULTILINE))
        require("zephyr", set(re.findall(r"^(\w+):", text, re.MULTILINE)) == {"name", "build", "samples"}, "unknown keys")
        is_there("zephyr", root, build["cmake"] + "/CMakeLists.txt", build["kconfig"],
                 *re.findall(r"^  - (\S+)$", text, re.MULTILINE))
    snippet = dict(re.findall(r"^ +(?:- )?(\w+): (\S+)$", (tree / "zephyr/west-snippet.yml").read_text(), re.MULTILINE))
    check("zephyr", snippet, {"name": "lumi", "url": URL, "revision": re.escape("v" + VERSION), "path": r"modules/\S+"})


def cmsis(tree):
    """https://open-cmsis-pack.github.io/Open-CMSIS-Pack-Spec/main/html: pdsc_package_pg.html and packIndexFile.html"""
    vendor = PROJECT["namespace"]
    pack = xml.etree.ElementTree.parse(tree / f"{vendor}.lumi.pdsc").getroot()
    check("cmsis", {child.tag: child.text for child in pack},
          {"vendor": vendor, "name": "lumi", "description": r".{1,256}", "url": URL + "/", "license": "LICENSE"})
    check("cmsis", pack.find("releases/release").attrib, {"version": re.escape(VERSION)})
    order = [child.tag for child in pack]
    known = ["vendor", "name", "description", "url", "supportContact", "license", "releases", "conditions", "components"]
    require("cmsis", order == known, f"elements are {order}, not in the order of PACK.xsd")
    is_there("cmsis", tree, "LICENSE", *(f.get("name") for f in pack.iter("file")))
    index = xml.etree.ElementTree.parse(tree.parents[1] / f"{vendor}.pidx").getroot()
    check("cmsis", index.find("pindex/pdsc").attrib,
          {"url": URL + "/", "vendor": vendor, "name": "lumi", "version": re.escape(VERSION)})
    require("cmsis", index.find("vendor").text == vendor and index.find("timestamp") is not None, "the index is incomplete")


def npm(tree):
    """https://docs.npmjs.com/cli/v10/configuring-npm/package-json; `npm pack` itself runs in tests/tools/viewer."""
    manifest = json.loads((tree / "package.json").read_text())
    check("npm", {**manifest, **manifest["repository"]}, {
        "name": r"@[a-z0-9~-][a-z0-9._~-]*/[a-z0-9._~-]+", "version": re.escape(VERSION), "license": "MIT", "author": PERSON,
        "homepage": URL, "url": r"git\+https://\S+\.git", "main": r"\S+\.js", "types": r"\S+\.d\.ts"})
    is_there("npm", tree, manifest["main"], manifest["types"], "README.md", "LICENSE", *manifest["files"])


def debian(tree, has_tools):
    """https://www.debian.org/doc/debian-policy/ch-controlfields.html; lintian."""
    source, package = (tree / "debian/control").read_text().split("\n\n")
    values = dict(re.findall(r"^([\w-]+): *(.*)$", source, re.MULTILINE))
    check("debian", values, {"Source": r"[a-z0-9][a-z0-9+.-]+", "Maintainer": PERSON, "Homepage": URL, "Section": "graphics",
                             "Standards-Version": r"\d+\.\d+\.\d+", "Build-Depends": r"debhelper-compat \(= \d+\), .*cmake.*"})
    require("debian", "${shlibs:Depends}" in package, "the package does not depend on its libraries")
    is_there("debian", tree, "debian/copyright", "debian/rules", "debian/source/format", "CMakeLists.txt")
    require("debian", (tree / "debian/rules").stat().st_mode & 0o111, "rules cannot be run")
    if not has_tools:
        return
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / f"lumipath-{VERSION}"
        shutil.copytree(tree, copy, symlinks=True)
        for command in (["dpkg-source", "--build", copy], ["lintian", "--allow-root", "--fail-on", "error,warning",
                                                           f"lumipath_{VERSION}.dsc"]):
            ran = subprocess.run(command, cwd=folder, capture_output=True, text=True)
            require("debian", ran.returncode == 0, f"{command[0]} says\n{ran.stdout}{ran.stderr}")


def main(arguments):
    trees = pathlib.Path(arguments[-1]).resolve() / "trees"
    for test in (arduino, esp_idf, platformio, zephyr, cmsis):
        test(trees / test.__name__.replace("_", "-"))
    if (trees / "npm").exists():  # of a build without clang there is none
        npm(trees / "npm")
    debian(trees / "debian", "--all" in arguments)
    for channel in sorted(trees.iterdir()):
        print(f"{channel.name}: {sum(p.is_file() for p in channel.rglob('*'))} files")


if __name__ == "__main__":
    main(sys.argv[1:])
