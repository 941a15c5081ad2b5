# SPDX-License-Identifier: MIT
"""The archive of sample fields, for release.py: each with what embeds it in a program, a page that turns the largest of
each object, and a table of what they take. Who has it needs no `lumi` for a first picture."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

PARTS = {"rp2040": "RP2040", "rp2350": "RP2350", "esp32s3": "ESP32-S3"}
WORDS = """# Sample fields of LumiPath {version}

Open a page of this folder, such as `{page}`, in a browser to turn an object; the page needs no network and runs the code
that firmware links. A program takes a field with two files: compile `NAME.S`, which includes `NAME.lumi` from beside it, and
include `NAME.h`, which holds the view that draws exactly this field. `lumi::core` of the same release draws it
(README.md of its archive).

RAM is a view of 240×240 pixels and a stripe of 16 rows, outlines antialiased. The last columns are frames a second of one
core, modelled from counted instructions; * is estimated, and – stands where the part has too little RAM.

"""


def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"error: {' '.join(map(str, command))}\n{result.stderr}")
    return result.stdout


def object_of(name):
    """Splits "clock250" into ("clock", 250)."""
    found = re.fullmatch(r"(\D+)(\d+)", name)
    if not found:
        sys.exit(f"error: {name}.lumi: sample fields are named by object and kilobytes, such as clock250.lumi")
    return found[1], int(found[2])


def row(lumi, field):
    data = json.loads(run(lumi, "inspect", field, "--verify", "--json", "--screen", "240x240", "--for", ",".join(PARTS)))
    ram = sum(data["ram_bytes"]["antialiased"].values())
    rates = data["frames_per_second"]["antialiased"]
    return [field.stem, f"{data['bytes']:,}", str(data["triangles"]), f"{ram:,}",
            *("–" if rates[part] is None else f"{rates[part]:.0f}" for part in PARTS)]


def table(rows):
    head = ["field", "bytes", "triangles", "RAM", *(title + ("*" if key.startswith("esp") else "") for key, title in PARTS.items())]
    lines = [head, ["---"] + ["---:"] * (len(head) - 1), *rows]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def files(lumi, folder, version):
    """{name: bytes} of the archive."""
    fields = sorted(folder.glob("*.lumi"), key=lambda path: object_of(path.stem))
    if not fields:
        sys.exit(f"error: {folder}: it holds no field")
    largest = {object_of(path.stem)[0]: path for path in fields}  # the last of each
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(name)
        for field in fields:
            (out / field.name).write_bytes(field.read_bytes())
            run(lumi, "embed", out / field.name, "-o", out / f"{field.stem}.S")
        for field in largest.values():
            run(lumi, "view", out / field.name, "-o", out / f"{field.stem}.html", "--title", field.stem, "--background", "202428")
        words = WORDS.format(version=version, page=f"{fields[-1].stem}.html")
        (out / "README.md").write_text(words + table([row(lumi, field) for field in fields]))
        return {path.name: path.read_bytes() for path in out.iterdir()}
