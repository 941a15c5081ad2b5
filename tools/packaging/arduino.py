# SPDX-License-Identifier: MIT
"""The Arduino library, for release.py: core's sources and headers, what platform/arduino adds, and the field that its
sketches draw, as an array in C."""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADDED = ROOT / "platform/arduino"
SCENE = ROOT / "baker/scenes/product.obj"
# A board with 256 kB of flash has room for it. Its view of 240 x 240 pixels by 8 rows takes 25 kB of RAM.
BAKE = ["--fit", "60kB"]
FIELD = "desk_clock"
FIELDS = "src/lumi_fields/"


def run(command):
    result = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(map(str, command))}\n{result.stderr}")


def field_files(lumi, field):
    """The array and the header of the field: `field`, or if that is None the desk clock, baked."""
    if not lumi.is_file():
        sys.exit(f"error: {lumi}: the lumi command embeds the field of Arduino's sketches; build it (cmake --preset "
                 "release && cmake --build --preset release) or name it by --lumi")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        baked = folder / f"{FIELD}.lumi"  # whose name the header holds
        if field is None:
            run([lumi, "bake", SCENE, "-o", baked, *BAKE])
        else:
            baked.write_bytes(field.read_bytes())
        run([lumi, "embed", baked, "-o", folder / f"{FIELD}.c"])
        return {FIELDS + name: (folder / name).read_bytes() for name in (f"{FIELD}.c", f"{FIELD}.h")}


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
        if name.startswith("lvgl/"):
            files["extras/" + name] = content.replace(b'"../src/', b'"')
        for folder in ("include/", "src/"):
            if name.startswith(folder):
                files["src/" + name[len(folder):]] = content
    return files
