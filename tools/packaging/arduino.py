# SPDX-License-Identifier: MIT
"""The Arduino library, for release.py: core's sources and headers, what platform/arduino adds, and the fields that its
sketches draw, as arrays in C."""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADDED = ROOT / "platform/arduino"
# A board with 256 kB of flash has room for it. Its view of 240 x 240 pixels by 8 rows takes 28 kB of RAM.
BAKE = ["--fit", "60kB"]
SCENES = {"desk_clock": ROOT / "baker/scenes/product.obj", "running_clock": ROOT / "baker/scenes/clock.json"}
FIELDS = "src/lumi_fields/"


def run(command):
    result = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(map(str, command))}\n{result.stderr}")


def field_files(lumi, field):
    """The arrays and headers of the fields: `field` by each name, or if that is None the clocks, baked."""
    if not lumi.is_file():
        sys.exit(f"error: {lumi}: the lumi command embeds the field of Arduino's sketches; build it (cmake --preset "
                 "release && cmake --build --preset release) or name it by --lumi")
    files = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, scene in SCENES.items():
            baked = pathlib.Path(folder) / f"{name}.lumi"  # whose name the header holds
            if field is None:
                run([lumi, "bake", scene, "-o", baked, *BAKE])
            else:
                baked.write_bytes(field.read_bytes())
            run([lumi, "embed", baked, "-o", baked.with_suffix(".c")])
            files |= {f"{FIELDS}{name}{end}": baked.with_suffix(end).read_bytes() for end in (".c", ".h")}
    return files


def library(core, added, words, fields):
    """Files of the library. Arduino compiles all of src and has src alone in its include path, so headers and sources lie
    there together; extras it leaves alone. `core`: its files; `added`: those of ADDED; `words`: what stands for @NAME@ in
    library.properties."""
    files = dict(fields, LICENSE=core["LICENSE"], **added)
    properties = files["library.properties"].decode()
    for name, value in words.items():
        properties = properties.replace(f"@{name}@", value)
    files["library.properties"] = properties.encode()
    files["CHANGELOG.md"] = core["CHANGELOG.md"]
    for name, content in core.items():
        if name.startswith("examples/live_data/"):
            files["extras/live_data/" + name.rsplit("/", 1)[1]] = content
        if name.startswith("lvgl/"):
            files["extras/" + name] = content.replace(b'"../src/', b'"')
        for folder in ("include/", "src/"):
            if name.startswith(folder):
                files["src/" + name[len(folder):]] = content
    return files
