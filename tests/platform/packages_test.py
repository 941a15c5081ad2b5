#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""packages_test.py [--all] LUMI FIELD FOLDER

Unpacks core's archives into empty folders and compiles them as each ecosystem would: its file globs, include paths and
flags. The ecosystems' own tools (idf.py, west, pio, the Pico SDK, packchk) are not used: their part is played by the
functions that they call and by their flags. LUMI embeds FIELD, a surface field, into Arduino's library, which
arduino_test.py then builds; the archives stay in FOLDER/archives.
Without --all sources are checked, but no code is made.
"""
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import xml.etree.ElementTree
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CROSS = "arm-none-eabi-"
M0 = ["-mcpu=cortex-m0plus", "-mthumb"]
ESP32_C3 = ["-march=rv32imc", "-mabi=ilp32", "-ffreestanding"]  # by Debian's compiler, which has no C library
COMMON = ["-ffunction-sections", "-fdata-sections", "-fno-exceptions", "-fno-rtti"]
# This stands for the functions of an SDK, as a project that includes core's files and builds what they ask for.
ESP_IDF = """
set(ESP_PLATFORM ON)
macro(idf_component_register)
  cmake_parse_arguments(arg "" "" "SRCS;INCLUDE_DIRS;PRIV_INCLUDE_DIRS" ${ARGN})
  if(PROJECT_NAME STREQUAL "lumi")
    message(FATAL_ERROR "registered after project()")
  endif()
  list(TRANSFORM arg_SRCS PREPEND ${core}/)
  set(sources ${arg_SRCS})
  set(includes ${arg_INCLUDE_DIRS} ${arg_PRIV_INCLUDE_DIRS})
  list(TRANSFORM includes PREPEND ${core}/)
endmacro()
macro(idf_component_optional_requires)
endmacro()
macro(run)
  include(${core}/CMakeLists.txt)
endmacro()
"""
ZEPHYR = """
set(CONFIG_LUMI y)
set(CONFIG_LUMI_C y)
macro(zephyr_include_directories)
  list(APPEND includes ${ARGN})
endmacro()
macro(zephyr_library_include_directories)
  list(APPEND includes ${ARGN})
endmacro()
macro(zephyr_library_named name)
endmacro()
macro(zephyr_library_sources)
  list(APPEND sources ${ARGN})
endmacro()
macro(zephyr_library_sources_ifdef name)
  if(${name})
    list(APPEND sources ${ARGN})
  endif()
endmacro()
macro(run)
  include(${core}/zephyr/CMakeLists.txt)
endmacro()
"""
PICO = """
macro(run)
  include(${core}/pico_lumi.cmake)
  get_target_property(sources pico_lumi INTERFACE_SOURCES)
  get_target_property(includes pico_lumi INTERFACE_INCLUDE_DIRECTORIES)
  get_target_property(definitions pico_lumi INTERFACE_COMPILE_DEFINITIONS)
endmacro()
"""
PROJECT = """
cmake_minimum_required(VERSION 3.16)
project(firmware LANGUAGES NONE)
function(find)
  {stub}
  run()
  foreach(line IN LISTS sources)
    message("source ${{line}}")
  endforeach()
  foreach(line IN LISTS includes)
    message("include ${{line}}")
  endforeach()
  foreach(line IN LISTS definitions)
    message("define ${{line}}")
  endforeach()
endfunction()
set(core {core})
find()
"""


class Build:
    def __init__(self, folder, makes_code, lumi, field):
        self.folder, self.makes_code, self.lumi, self.field = folder, makes_code, lumi, field

    def fresh(self, name):
        path = self.folder / name
        shutil.rmtree(path, ignore_errors=True)
        path.mkdir(parents=True)
        return path

    def compile(self, name, sources, flags, cxx_flags, prefix=CROSS):
        if not sources:
            sys.exit(f"error: {name}: no source was found")
        done = []
        cxx = [s for s in sources if s.suffix == ".cpp"]
        for source in cxx if self.makes_code else []:
            self.run(name, [prefix + "g++", *flags, *cxx_flags, "-c", source, "-o", self.folder / "object.o"])
        if not self.makes_code:
            self.run(name, [prefix + "g++", *flags, *cxx_flags, "-fsyntax-only", *cxx])
        for source in (s for s in sources if s.suffix in (".S", ".c")):
            self.run(name, [prefix + "gcc", *flags, "-c", source, "-o", self.folder / "object.o"])
        print(f"{name}: {len(sources)} sources")
        return done

    @staticmethod
    def run(name, command):
        result = subprocess.run([str(c) for c in command], capture_output=True, text=True)
        if result.returncode != 0:
            sys.exit(f"error: {name}: {' '.join(map(str, command))}\n{result.stdout}{result.stderr}")
        return result.stderr


def listed(build, name, core, stub):
    """What a build system written in CMake would compile: (sources, flags)."""
    folder = build.fresh(name + "-project")
    (folder / "CMakeLists.txt").write_text(PROJECT.format(stub=stub, core=core))
    lines = build.run(name, ["cmake", "-S", folder, "-B", folder / "build"])
    found = {kind: re.findall(rf"^{kind} (.*)$", lines, re.MULTILINE) for kind in ("source", "include", "define")}
    flags = [f"-I{i}" for i in found["include"]] + [f"-D{d}" for d in found["define"]]
    return [pathlib.Path(s) for s in found["source"]], flags


def manifests(core):
    """What west reads before CMake."""
    module = dict(re.findall(r"^ +(cmake|kconfig): *(.*)$", (core / "zephyr/module.yml").read_text(), re.MULTILINE))
    options = set(re.findall(r"^config (\w+)$", (core / module["kconfig"]).read_text(), re.MULTILINE))
    samples = re.findall(r"^  - (\S+)$", (core / "zephyr/module.yml").read_text(), re.MULTILINE)
    if not samples or not all(list((core / name).glob("*/sample.yaml")) for name in samples):
        sys.exit(f"error: zephyr: module.yml names {samples}, where no sample is")
    used = set(re.findall(r"CONFIG_(\w+)", (core / module["cmake"] / "CMakeLists.txt").read_text()))
    if used != options:
        sys.exit(f"error: zephyr: CMakeLists.txt uses {used}, Kconfig has {options}")


def bills(archives):
    """The bills of materials: every file of core's archive with its checksum, every relation between known elements."""
    with tarfile.open(next(archives.glob("lumi-core-*.tar.xz"))) as archive:
        held = {"./" + m.name.split("/", 1)[1]: hashlib.sha256(archive.extractfile(m).read()).hexdigest()
                for m in archive.getmembers()}
    for path in sorted(archives.glob("*.spdx.json")):
        bill = json.loads(path.read_text())
        listed = {f["fileName"]: f["checksums"][1]["checksumValue"] for f in bill["files"]}
        elements = [e["SPDXID"] for e in [bill, *bill["packages"], *bill["files"]]]
        ends = {r[k] for r in bill["relationships"] for k in ("spdxElementId", "relatedSpdxElement")}
        if bill["spdxVersion"] != "SPDX-2.3" or len(set(elements)) != len(elements) or ends != set(elements):
            sys.exit(f"error: {path.name}: identifiers do not fit")
        if not all(p["versionInfo"] for p in bill["packages"]) or (listed and listed != held):
            sys.exit(f"error: {path.name}: a version is missing, or files are not those of the archive")
        print(f"{path.name}: {len(bill['packages'])} packages, {len(listed)} files")


def licences(archives):
    """The page of licences names what the command loads, which its bill of materials says."""
    bill = json.loads(next(archives.glob("lumi-[0-9]*.spdx.json")).read_text())
    names = {p["SPDXID"]: p["name"] for p in bill["packages"]}
    loaded = sorted(names[r["relatedSpdxElement"]] for r in bill["relationships"] if r["relationshipType"] == "DYNAMIC_LINK")
    told = [row["package"] for row in json.loads((ROOT / "docs/log/data/licences.json").read_text())["rows"]]
    if loaded != sorted(told):
        sys.exit(f"error: docs/licences.md is old: {set(loaded) ^ set(told)}; `python3 tools/packaging/libraries.py LUMI | "
                 "tools/lab/pages.py put licences rows` makes it anew")


def tagging(build):
    """A release tags the commit that it packs, once, and refuses a tree with changes. In a repository of its own."""
    if shutil.which("git") is None:
        print("git is not installed, so tags were not tried")
        return
    folder = build.fresh("repository")
    for name in ["core", "tools", "platform/arduino", "platform/lvgl", "platform/overlay", "platform/bare", "LICENSE",
                 "CHANGELOG.md", "CITATION.cff", "library.json"]:
        (shutil.copytree if (ROOT / name).is_dir() else shutil.copy)(ROOT / name, folder / name)
    release = [sys.executable, "-B", folder / "tools/packaging/release.py", "--tag", "--lumi", build.lumi,
               "--field", build.field, build.folder / "tagged"]
    project = folder / "core/PROJECT.json"
    if b"are placeholders" not in subprocess.run(release, capture_output=True).stderr:
        sys.exit("error: release: placeholders were released")
    project.write_text(re.sub("[Ee]xample", "real", project.read_text()))
    git = ["git", "-C", folder, "-c", "user.name=test", "-c", "user.email=test@example.invalid"]
    for command in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "all"]):
        build.run("release", [*git, *command])
    for name in ("user.name", "user.email"):
        build.run("release", [*git, "config", name, "test"])
    build.run("release", release)
    if subprocess.run(release, capture_output=True).returncode == 0:
        sys.exit("error: release: a version was tagged twice")
    build.run("release", [*git, "tag", "--delete", "v" + (ROOT / "core/VERSION").read_text().strip()])
    (folder / "core/new.cpp").write_text("int changed;\n")
    if b"not committed" not in subprocess.run(release, capture_output=True).stderr:
        sys.exit("error: release: what was not committed was tagged")
    for name in ("core/new.cpp", "core/LICENSE", "platform/arduino"):
        kept = folder / (name + ".kept")
        (folder / name).rename(kept)
        (folder / name).symlink_to(kept)
        build.run("release", [*git, "add", "--all"])
        outcome = subprocess.run([word for word in release if word != "--tag"], capture_output=True)
        if outcome.returncode == 0 or b"a link is not packed" not in outcome.stderr:
            sys.exit(f"error: release: {name}, a link, was packed")
        (folder / name).unlink()
        kept.rename(folder / name)
        build.run("release", [*git, "add", "--all"])
    print("release: tags what is committed, once, and packs no link")


def old_standard(build, core):
    """To a compiler of an older C++ each header says what to do, before anything else."""
    headers = [h for h in sorted((core / "include").rglob("*.h")) if "detail" not in h.parts and h.name != "lumi.h"]
    for header in headers:
        command = ["c++", "-std=c++14", "-x", "c++", "-fsyntax-only", f"-I{core / 'include'}", header]
        errors = re.findall(r"error: .*", subprocess.run(command, capture_output=True, text=True).stderr)
        if len(errors) != 2 or "C++17: compile with" not in errors[0]:
            sys.exit(f"error: {header.name} under C++14: {errors[:3]}")
    print(f"C++14: {len(headers)} headers say what to do")


def platformio(build, core):
    """library.json has no srcFilter and no includeDir: all of src, with include and src as include paths."""
    manifest = json.loads((core / "library.json").read_text())
    sources = [p for p in sorted((core / "src").rglob("*")) if p.suffix in (".c", ".cpp", ".S")]
    build.compile("platformio", sources, [*M0, "-Os", f"-I{core / 'include'}", f"-I{core / 'src'}", "-ffunction-sections"],
                  [*manifest["build"]["flags"], "-fno-exceptions"])


def cmsis_pack(build, archives):
    folder = build.fresh("cmsis")
    zipfile.ZipFile(next(archives.glob("*.pack"))).extractall(folder)
    description = xml.etree.ElementTree.parse(next(folder.glob("*.pdsc"))).getroot()
    named = [(f.get("category"), f.get("name")) for f in description.iter("file")]
    sources = [folder / n for c, n in named if c == "source"]
    includes = [f"-I{folder / n}" for c, n in named if c == "include"]
    build.compile("cmsis-pack", sources, [*M0, "-O2", *includes, "-ffunction-sections"],
                  ["-std=c++17", "-fno-exceptions", "-fno-rtti"])


def esp_idf_lvgl(build, archives, cxx):
    """The component is called lumi, as its folder, and has LVGL's part where the project asks for it. The widget needs
    more of LVGL than its stand-in has; everything else is compiled."""
    folder = build.fresh("components")
    zipfile.ZipFile(next(archives.glob("lumi-esp-idf-*.zip"))).extractall(folder)
    if [path.name for path in folder.iterdir()] != ["lumi"]:
        sys.exit(f"error: esp-idf: the archive holds {sorted(folder.iterdir())}")
    core = folder / "lumi"
    if set(re.findall(r"config (\w+)", (core / "Kconfig").read_text())) != {"LUMI_LVGL"}:
        sys.exit("error: esp-idf: Kconfig has other options than CMakeLists.txt")
    sources, flags = listed(build, "esp-idf-lvgl", core, "set(CONFIG_LUMI_LVGL y)" + ESP_IDF)
    lvgl = [path for path in sources if path.parent.name == "lvgl"]
    if len(lvgl) != 3 or any(path.parts[-2:] == ("c", "lumi.cpp") for path in sources):
        sys.exit(f"error: esp-idf: with LVGL these are compiled: {sources}")
    stand_in = [f"-I{ROOT / 'tests/platform/lvgl_double'}", "-DLV_COLOR_DEPTH=16"]
    build.compile("esp-idf, LVGL", [path for path in lvgl if path.name != "lv_lumi.cpp"],
                  [*ESP32_C3, "-Os", *flags, *stand_in], cxx, "riscv64-unknown-elf-")


def samples(build, core, cxx):
    """Zephyr's sample and ESP-IDF's example, against declarations of the functions that they call."""
    folder = build.fresh("sample")
    build.run("samples", [build.lumi, "embed", build.field, "-o", folder / "product.c"])
    flags = ["-Os", f"-I{folder}", f"-I{core / 'include'}"]
    build.compile("zephyr's sample", sorted((core / "zephyr/samples").glob("*/src/*.cpp")),
                  [*M0, *flags, f"-I{ROOT / 'tests/platform/zephyr_double'}"],
                  ["-std=c++17", *COMMON[2:], "-Wall", "-Wextra", "-Werror"])
    esp_idf = [*ESP32_C3, *flags, f"-I{ROOT / 'tests/platform/esp_idf_double'}", f"-I{ROOT / 'platform/arduino/src'}"]
    build.compile("esp-idf's example", sorted((core / "examples").glob("*/main/*.cpp")), esp_idf,
                  [*cxx, "-Wextra", "-Werror"], "riscv64-unknown-elf-")
    build.run("measure", [build.lumi, "embed", build.field, "-o", folder / "desk_clock.c"])
    build.compile("live data", sorted((core / "examples/live_data").glob("*.cpp")), [*M0, *flags],
                  ["-std=c++17", *COMMON[2:], "-Wall", "-Wextra", "-Werror"])
    build.compile("esp-idf's measuring program", [ROOT / "platform/measure/esp_idf/main/main.cpp"], esp_idf,
                  [*cxx, "-Wextra", "-Werror"], "riscv64-unknown-elf-")


def sample_fields(build, archives, core):
    """Who has the archive of samples needs no lumi: pages turn, and what embeds a field compiles where it was unpacked."""
    folder = build.fresh("sample-fields")
    zipfile.ZipFile(next(archives.glob("lumi-samples-*.zip"))).extractall(folder)
    folder = next(folder.iterdir())
    held = sorted(path.name for path in folder.iterdir())
    wanted = {"LICENSE", "README.md", "toy30.html", *(f"toy{kb}.{kind}" for kb in (7, 30) for kind in ("S", "h", "lumi"))}
    if set(held) != wanted:
        sys.exit(f"error: samples: the archive holds {held}")
    text = (folder / "README.md").read_text()
    if "`toy30.html`" not in text or f"| toy7 | {build.field.stat().st_size:,} |" not in text:
        sys.exit(f"error: samples: the page does not tell what the archive holds:\n{text}")
    main = folder / "main.cpp"
    main.write_text('#include "toy30.h"\nusing namespace lumi;\nstatic toy30_view<Screen<240, 240, 16>> view;\n'
                    "bool start() { return view.open(toy30, toy30_size()) == ViewError::none; }\n")
    build.compile("sample fields", [main, folder / "toy30.S"], [*M0, "-Os", f"-I{folder}", f"-I{core / 'include'}"],
                  ["-std=c++17", *COMMON[2:], "-Wall", "-Werror"])


def main(arguments):
    makes_code = "--all" in arguments
    lumi, field, folder = (pathlib.Path(a).resolve() for a in arguments[-3:])
    build = Build(folder, makes_code, lumi, field)
    archives = build.fresh("archives")
    toys = build.fresh("toys")
    for size in (7, 30):  # kilobytes, by their names
        shutil.copy(field, toys / f"toy{size}.lumi")
    build.run("release", [sys.executable, "-B", ROOT / "tools/packaging/release.py", "--dry-run", "--lumi", lumi,
                          "--field", field, "--samples", toys, archives])
    unpacked = build.fresh("core")
    tarfile.open(next(archives.glob("lumi-core-*.tar.xz"))).extractall(unpacked)
    core = next(unpacked.iterdir())
    manifests(core)
    bills(archives)
    licences(archives)
    tagging(build)
    old_standard(build, core)
    platformio(build, core)
    cmsis_pack(build, archives)
    cxx = ["-std=gnu++2b", "-fno-exceptions", "-fno-rtti", "-Wall", "-Werror=all", "-Wno-error=unused-function"]
    esp_idf_lvgl(build, archives, cxx)
    samples(build, core, cxx)
    sample_fields(build, archives, core)
    for name, stub, prefix, cpu, std in (
            ("esp-idf", ESP_IDF, "riscv64-unknown-elf-", ESP32_C3, cxx),
            ("zephyr", ZEPHYR, CROSS, M0, ["-std=c++17", *COMMON[2:], "-Wall", "-Werror"]),
            ("pico", PICO, CROSS, M0, ["-std=gnu++17", *COMMON[2:], "-Wall"])):
        sources, flags = listed(build, name, core, stub)
        if name == "pico" and not {"-DPICO_STACK_SIZE=0x1000", "-DPICO_CORE1_STACK_SIZE=0x1000"} <= set(flags):
            sys.exit(f"error: pico: the stacks are not of 4 kB: {flags}")
        build.compile(name, sources, [*cpu, "-Os", *COMMON[:2], *flags], std, prefix)
    _, flags = listed(build, "pico", core, "set(LUMI_PICO_STACK_SIZE 0)" + PICO)
    if any("STACK" in flag for flag in flags):
        sys.exit(f"error: pico: a firmware cannot set its own stacks: {flags}")
    print("not installed, so not run: idf.py, west, pio, the Pico SDK, packchk")


if __name__ == "__main__":
    main(sys.argv[1:])
