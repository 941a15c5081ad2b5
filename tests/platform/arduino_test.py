#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""arduino_test.py LUMI FIELD ARCHIVES FOLDER

Installs the Arduino library of ARCHIVES as a user does, into a folder of libraries, and lets arduino-builder make programs
of its sketches: it finds the library by the sketch's includes, as the Arduino IDE does, and alone tells the compiler where
headers lie. The board is arduino/hardware; QEMU runs the programs, behind stand-ins for two libraries of displays
(arduino/libraries). What reaches the display is what `lumi render` draws of FIELD, which packages_test.py put into
the archive. Ends with 77 where arduino-builder is missing.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
DEBIAN_HARDWARE = "/usr/share/arduino-builder"  # says how the builder calls ctags
SIDE, FRAMES = 240, 2
FRAME_BYTES = SIDE * SIDE * 2
CPP17 = "Lumi needs C++17"


class Workshop:
    def __init__(self, lumi, field, archives, folder):
        self.lumi, self.field, self.folder = lumi, field, folder
        shutil.rmtree(folder, ignore_errors=True)
        self.libraries = folder / "libraries"
        shutil.copytree(HERE / "arduino/libraries", self.libraries)
        for source in ("slow_dma.h", "slow_dma.c"):
            shutil.copy(HERE / "snippets" / source, self.libraries / "LovyanGFX/src")
        zipfile.ZipFile(next(archives.glob("lumi-arduino-*.zip"))).extractall(self.libraries)
        self.library = self.libraries / "Lumi"
        # One sketch after the other in one folder, so that the library is compiled once.
        self.sketch = folder / "Sketch/Sketch.ino"
        self.sketch.parent.mkdir(parents=True)

    def build(self, text, board="emulated"):
        """Arduino's verdict on a sketch."""
        self.sketch.write_text(text)
        made = self.folder / f"made-{board}"
        made.mkdir(exist_ok=True)
        return subprocess.run(
            ["arduino-builder", "-compile", "-hardware", DEBIAN_HARDWARE, "-hardware", HERE / "arduino/hardware",
             "-tools", "/usr/bin", "-libraries", self.libraries, "-fqbn", f"lumi:rp2040:{board}", "-build-path", made,
             "-warnings", "all", self.sketch], capture_output=True, text=True)

    def run(self, name, text):
        """(pixels that went to the display, text on the serial port)"""
        built = self.build(text)
        if built.returncode != 0 or "warning:" in built.stderr:
            sys.exit(f"error: {name}: arduino-builder does not make a program of it without a warning\n{built.stderr}")
        program = self.folder / "made-emulated/Sketch.ino.elf"
        ran = subprocess.run(["qemu-system-arm", "-M", "mps2-an385", "-display", "none", "-serial", "none", "-monitor",
                              "none", "-semihosting-config", "enable=on,target=native", "-kernel", program],
                             capture_output=True, timeout=120)
        if ran.returncode != 0:
            sys.exit(f"error: {name}: ended with {ran.returncode}\n{ran.stderr.decode()}")
        return ran.stdout, ran.stderr.decode()

    def example(self, name):
        return (self.library / f"examples/{name}/{name}.ino").read_text()


def check_manifest(library):
    properties = dict(line.split("=", 1) for line in (library / "library.properties").read_text().splitlines())
    if properties["version"] != (ROOT / "core/VERSION").read_text().strip() or "@" in properties["url"]:
        sys.exit("error: library.properties: its version is not that of core/VERSION, or a name was left in it")
    header = library / "src" / properties["includes"]
    if not header.is_file():
        sys.exit(f"error: library.properties: src has no {properties['includes']}")
    words = [line.split("\t") for line in (library / "keywords.txt").read_text().splitlines() if line[0] != "#"]
    known = "".join(p.read_text() for p in (library / "src").rglob("*.h"))
    for word, kind in words:
        if kind not in ("KEYWORD1", "KEYWORD2") or not re.search(rf"\b{word}\b", known + properties["name"]):
            sys.exit(f"error: keywords.txt: {word} is no name of the library")


def check_picture(shop, name, pixels, field=None, orbit="30,20,3", parts=()):
    if len(pixels) != FRAMES * FRAME_BYTES:
        sys.exit(f"error: {name}: {len(pixels)} bytes reached the display, not {FRAMES} frames")
    frame, expected = shop.folder / f"{name}.raw", shop.folder / "expected.png"
    frame.write_bytes(pixels[:FRAME_BYTES])
    size = f"{SIDE}x{SIDE}"
    for command in ([shop.lumi, "render", field or shop.field, "-o", expected, "--size", size, "--orbit", orbit, "--mode",
                     "antialiased", "--pixel", "rgb565", "--background", "black", *parts],
                    [sys.executable, "-B", ROOT / "tools/lab/devices/picture.py", "rgb565-swapped", size, frame,
                     "--same-as", expected, "png"]):
        result = subprocess.run([str(c) for c in command], capture_output=True, text=True)
        if result.returncode != 0:
            sys.exit(f"error: {name}: {result.stdout}{result.stderr}")
    print(f"{name}: {FRAMES} frames reached the display, the first is that of lumi render")


def displays(shop):
    frames = []
    for name in ("DeskClockTFT_eSPI", "DeskClockLovyanGFX"):
        pixels, said = shop.run(name, shop.example(name))
        if said != "no error\n":
            sys.exit(f"error: {name}: the serial port says\n{said}")
        check_picture(shop, name, pixels)
        frames.append(pixels)
    if frames[0] != frames[1] or frames[0][:FRAME_BYTES] == frames[0][FRAME_BYTES:]:
        sys.exit("error: the sketches draw different frames, or the object does not turn")


def embed(shop, field):
    command = [shop.lumi, "embed", field, "-o", shop.sketch.parent / "product.c"]
    subprocess.run([str(c) for c in command], check=True, stdout=subprocess.DEVNULL)


def running_clock(shop):
    """The sketch with another field's parts: what is on the display after a tick is a whole picture of the new pose."""
    name, second = "RunningClockTFT_eSPI", (10 * 60 + 8) * 60 + 1
    moving = shop.field.parent / "moving.lumi"
    embed(shop, moving)
    text = shop.example(name).replace("<lumi_fields/running_clock.h>", '"product.h"').replace("running_clock", "product")
    for hand, part in (("second_hand", "moon"), ("minute_hand", "knob"), ("hour_hand", "knob")):
        text = text.replace(hand, part)
    pixels, said = shop.run(name, text)
    if said != "no error\n":
        sys.exit(f"error: {name}: the serial port says\n{said}")
    check_picture(shop, name, pixels[FRAME_BYTES:] + pixels[:FRAME_BYTES], moving, "15,10,3",
                  ["--part", f"moon={second % 60 * 6}", "--part", f"knob={second // 60 / 2}"])


def serial(shop):
    name = "DeskClockSerial"
    _, said = shop.run(name, shop.example(name))
    if len(re.findall(r"^\d+ microseconds a frame: no error$", said, re.MULTILINE)) != FRAMES:
        sys.exit(f"error: {name}: the serial port says\n{said}")
    print(f"{name}: says how long frames take")


def measures(shop):
    """The lines of JSON that MeasureBoard prints: a mode each, and figures that fit each other."""
    name = "MeasureBoard"
    _, said = shop.run(name, shop.example(name).replace("clock_mhz = 0;", "clock_mhz = 25;"))
    rows = [json.loads(line) for line in said.splitlines()]
    if [row.get("mode") for row in rows] != ["one-sample", "antialiased"] * FRAMES:
        sys.exit(f"error: {name}: the serial port says\n{said}")
    for row in rows:
        pixels_a_second = row["frames_a_second"] * row["width"] * row["height"]
        cycles = row["clock_mhz"] * 1e6 / pixels_a_second
        if abs(cycles / row["cycles_a_pixel"] - 1) > 0.02 or row["worst_us"] * row["frames_a_second"] < 0.99e6:
            sys.exit(f"error: {name}: its figures do not fit each other: {row}")
    print(f"{name}: {len(rows)} lines of JSON, whose figures fit each other")


def own_field(shop):
    """A field of the user's beside the sketch, as the library's README has it."""
    embed(shop, shop.field)
    text = shop.example("DeskClockSerial").replace("<lumi_fields/desk_clock.h>", '"product.h"')
    _, said = shop.run("own field", text.replace("desk_clock", "product"))
    if said.count("no error") != FRAMES + 1:
        sys.exit(f"error: own field: the serial port says\n{said}")
    for file in shop.sketch.parent.glob("product.*"):
        file.unlink()
    print("own field: draws from product.c beside the sketch")


def old_cpp(shop):
    """Below C++17 the first error says what to do, and the second ends the compiler."""
    built = shop.build(shop.example("DeskClockSerial"), "old")
    errors = re.findall(r"error:.*", built.stderr)
    if built.returncode == 0 or len(errors) != 2 or CPP17 not in errors[0] or "platform.local.txt" not in errors[0]:
        sys.exit(f"error: gnu++11: not one error that names the mend\n{built.stderr}")
    print("gnu++11: refused, with the mend")


def main(arguments):
    lumi, field, archives, folder = (pathlib.Path(a).resolve() for a in arguments)
    for program in ("arduino-builder", "qemu-system-arm"):
        if shutil.which(program) is None:
            print(f"SKIPPED: {program} is missing; tools/install_packages.sh tests installs it", file=sys.stderr)
            sys.exit(77)
    shop = Workshop(lumi, field, archives, folder)
    check_manifest(shop.library)
    old_cpp(shop)
    displays(shop)
    running_clock(shop)
    serial(shop)
    measures(shop)
    own_field(shop)


if __name__ == "__main__":
    main(sys.argv[1:])
