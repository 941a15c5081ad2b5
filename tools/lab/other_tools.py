#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""other_tools.py LUMI GLTFPACK

Runs `lumi` beside tools that people know (cwebp and ffmpeg of Debian's packages webp and ffmpeg, gltfpack of npm's package
gltfpack) and writes what each does, a row of JSON for each question, to standard output:
`tools/lab/other_tools.py LUMI GLTFPACK | tools/lab/pages.py put other-tools rows`. Every cell is the outcome of calls that
this script makes, in a folder of its own.
"""
import json
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SMALL_BAKE = ["--layout", "surface", "--triangles", "20", "--longest-edge", "2", "--texel-density", "4", "--paths", "1"]
SQUARE = [(-1, 0, -1), (-1, 0, 1), (1, 0, 1), (1, 0, -1)]
TRIANGLES = [(0, 1, 2), (0, 2, 3)]
YES, NO = "yes", "no"


def run(words, folder, data=b""):
    """Exit code, standard output and error; 124 for what waits."""
    try:
        done = subprocess.run([str(word) for word in words], cwd=folder, input=data, capture_output=True, timeout=120)
    except subprocess.TimeoutExpired:
        return 124, b"", b""
    return done.returncode, done.stdout, done.stderr


class Tool:
    """How a tool is called to make an output of an input. `kind` is an input that it takes."""

    def __init__(self, name, program, kind, ending, options_before=(), options=()):
        self.name, self.program, self.kind, self.ending = name, program, kind, ending
        self.options_before, self.options = options_before, options

    def call(self, inputs, output):
        words = [self.program, *self.options_before]
        if self.name == "lumi":
            return [*words, "bake", *inputs, "-o", output, *self.options]
        if self.name == "cwebp":
            return [*words, *self.options, "-o", output, "--", *inputs]
        named = [output] if self.name == "ffmpeg" else ["-o", output]
        return [*words, *(word for one in inputs for word in ("-i", one)), *self.options, *named]

    def makes(self, inputs, folder, name="made", extra=()):
        """The exit code, and whether the output is there afterwards."""
        output = folder / f"{name}{self.ending}"
        output.unlink(missing_ok=True)
        words = self.call(inputs, output.name)
        code, _, _ = run([words[0], *extra, *words[1:]], folder)
        return code, output.exists() and output.stat().st_size > 0


def write_inputs(folder, lumi):
    """One input of each kind, by scripts or by the tools themselves; the same square everywhere."""
    points = "".join("v {} {} {}\n".format(*p) for p in SQUARE)
    faces = "".join("f {} {} {}\n".format(*(k + 1 for k in t)) for t in TRIANGLES)
    (folder / "in.obj").write_text(points + faces)
    (folder / "in.ply").write_text(
        f"ply\nformat ascii 1.0\nelement vertex {len(SQUARE)}\nproperty float x\nproperty float y\nproperty float z\n"
        f"element face {len(TRIANGLES)}\nproperty list uchar int vertex_indices\nend_header\n"
        + "".join("{} {} {}\n".format(*p) for p in SQUARE) + "".join("3 {} {} {}\n".format(*t) for t in TRIANGLES))
    stl = b"".join(struct.pack("<12fH", 0, 0, 0, *(c for k in t for c in SQUARE[k]), 0) for t in TRIANGLES)
    (folder / "in.stl").write_bytes(bytes(80) + struct.pack("<I", len(TRIANGLES)) + stl)
    positions = struct.pack("<12f", *(c for p in SQUARE for c in p)) + struct.pack("<6H", *(k for t in TRIANGLES for k in t))
    (folder / "in.bin").write_bytes(positions)
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "buffers": [{"uri": "in.bin", "byteLength": len(positions)}],
            "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, 0, -1],
                           "max": [1, 0, 1]},
                          {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]}
    (folder / "in.gltf").write_text(json.dumps(gltf))
    del gltf["buffers"][0]["uri"]
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(positions), b"BIN\0") + positions
    (folder / "in.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks)
    (folder / "in.json").write_text(json.dumps({"objects": [{"obj": "in.obj"}]}))
    made = run([lumi, "reference", "in.obj", "-o", "in.png", "--size", "64x64", "--spp", "1"], folder)
    if made[0] != 0:
        sys.exit(f"other_tools.py: {made[2].decode()}")
    for ending in ("jpg", "gif", "tiff", "webp", "bmp"):
        run(["ffmpeg", "-i", "in.png", f"in.{ending}"], folder)


KINDS = ["obj", "gltf", "glb", "stl", "ply", "json", "png", "jpg", "gif", "tiff", "webp", "bmp"]


def version(tool, folder):
    words = {"lumi": ["--version"], "cwebp": ["-version"], "gltfpack": ["-v"], "ffmpeg": ["-version"]}[tool.name]
    _, out, error = run([tool.program, *words], folder)
    found = re.search(rb"\d+\.\d+[.\d]*", out + error)
    return found[0].decode() if found else "?"


def executable(tool):
    """The program that the system loads: node, where the tool is a script of it."""
    path = pathlib.Path(shutil.which(tool.program) or tool.program).resolve()
    return pathlib.Path(shutil.which("node")).resolve() if path.read_bytes()[:2] == b"#!" else path


def libraries(tool, folder):
    _, out, _ = run(["ldd", executable(tool)], folder)
    return sorted(set(re.findall(r"=> (/\S+)", out.decode())))


def packages(tool, folder):
    """Those of Debian that hold the libraries; dpkg knows some by a path before /usr was merged."""
    found = set()
    for path in libraries(tool, folder):
        for name in (str(pathlib.Path(path).resolve()), path, path.removeprefix("/usr"), f"/usr{path}"):
            code, out, _ = run(["dpkg", "-S", name], folder)
            if code == 0:
                found.add(out.decode().split(":")[0])
                break
    return found


def needs(tool, folder):
    script = "" if executable(tool).name != "node" else ", and node"
    return f"{len(libraries(tool, folder))} libraries of {len(packages(tool, folder))} packages{script}"


def inputs(tool, folder):
    return ", ".join(kind for kind in KINDS if tool.makes([f"in.{kind}"], folder) == (0, True)) or NO


def batch(tool, folder):
    """Two inputs in one call: an output of each."""
    shutil.copy(folder / f"in.{tool.kind}", folder / f"two.{tool.kind}")
    first, second = f"in.{tool.kind}", f"two.{tool.kind}"
    if tool.name == "ffmpeg":
        words = [tool.program, *tool.options_before, "-i", first, "-i", second, "-map", "0", "one.webp", "-map", "1", "two.webp"]
        code, _, _ = run(words, folder)
        return YES if code == 0 and (folder / "two.webp").exists() else f"{NO} ({code})"
    code, _, _ = run(tool.call([first, second], f"one{tool.ending}"), folder)
    return f"one input a call; two end with {code}" if code else "two inputs, one output"


def pipe_in(tool, folder):
    data = (folder / f"in.{tool.kind}").read_bytes()
    for name in ("-", "/dev/stdin"):
        output = folder / f"piped{tool.ending}"
        output.unlink(missing_ok=True)
        code, _, _ = run(tool.call([name], output.name), folder, data)
        if code == 0 and output.exists():
            return f"`{name}`"
    return f"{NO} ({code})"


def pipe_out(tool, folder):
    for name in ("-", "/dev/stdout"):
        (folder / "-").unlink(missing_ok=True)
        words = tool.call([f"in.{tool.kind}"], name)
        if tool.name == "ffmpeg":
            words[-1:] = ["-f", "webp", name]
        code, out, _ = run(words, folder)
        if code == 0 and len(out) > 20 and not (folder / "-").exists():
            return f"`{name}`"
    return f"{NO} ({code})"


def picture_out(tool, folder):
    """Where the tool makes pictures of its files, too: lumi render."""
    if tool.name != "lumi":
        return "–"
    run(tool.call([f"in.{tool.kind}"], "made.lumi"), folder)
    code, out, _ = run([tool.program, "render", "made.lumi", "-o", "/dev/stdout", "--size", "32x32"], folder)
    return "`/dev/stdout`" if code == 0 and out[:4] == b"\x89PNG" else f"{NO} ({code})"


def man_page(tool, folder):
    name = pathlib.Path(tool.program).name
    words = ["man", "-w", name] if tool.name != "lumi" else ["man", "-M", folder / "share/man", "-w", "lumi"]
    return YES if run(words, folder)[0] == 0 else NO


def completion(tool, folder):
    """Whether bash-completion, or a file of ours, tells bash how to complete the tool's words."""
    name = pathlib.Path(tool.program).name
    own = folder / "share/bash-completion/completions/lumi"
    load = f"source {own}" if tool.name == "lumi" else f"_completion_loader {name}"
    library = pathlib.Path("/usr/share/bash-completion/bash_completion")
    if not library.exists():
        sys.exit(f"other_tools.py: {library} is missing (Debian: bash-completion)")
    shell = f"source {library}; {load}; complete -p {name}"
    code, out, _ = run(["bash", "-c", shell], folder)
    return YES if code == 0 and b" -F _minimal " not in out else NO


def codes(tool, folder):
    ending = tool.kind
    whole = (folder / f"in.{ending}").read_bytes()
    (folder / f"cut.{ending}").write_bytes(whole[: len(whole) // 2])
    missing, _ = tool.makes([f"none.{ending}"], folder)
    cut, _ = tool.makes([f"cut.{ending}"], folder)
    option, _ = tool.makes([f"in.{ending}"], folder, extra=["--no-such-option"])
    nowhere, _, _ = run(tool.call([f"in.{ending}"], f"none/out{tool.ending}"), folder)
    good, _ = tool.makes([f"in.{ending}"], folder)
    return f"{good} / {missing} / {cut} / {option} / {nowhere}"


def keeps(tool, folder):
    """Whether an earlier output stands after a call with a damaged input, which fails."""
    output = folder / f"old{tool.ending}"
    output.write_bytes(b"old")
    run(tool.call([f"cut.{tool.kind}"], output.name), folder)
    return YES if output.exists() and output.read_bytes() == b"old" else NO


def spares(tool, folder):
    """Whether an input that is also named as output stands afterwards."""
    name = f"own{'.png' if tool.name in ('cwebp', 'ffmpeg') else '.obj' if tool.name == 'lumi' else '.glb'}"
    kind = name.split(".")[1]
    shutil.copy(folder / f"in.{kind}", folder / name)
    code, _, _ = run(tool.call([name], name), folder)
    kept = (folder / name).read_bytes() == (folder / f"in.{kind}").read_bytes()
    return f"{YES} ({code})" if kept else NO


ROWS = [("version", version), ("shared libraries that it loads", needs), ("inputs that it takes, of 12", inputs),
        ("several inputs in a call", batch), ("input from a pipe", pipe_in), ("output to a pipe", pipe_out),
        ("a picture to a pipe", picture_out), ("man page", man_page), ("completion in bash", completion),
        ("exit codes: done / no input / cut input / unknown option / no folder for the output", codes),
        ("earlier output stays if the input is damaged", keeps), ("input stays if it is named as output", spares)]


def main(words):
    if len(words) != 2:
        sys.exit(__doc__)
    lumi, gltfpack = (str(pathlib.Path(word).absolute()) for word in words)
    tools = [Tool("lumi", lumi, "obj", ".lumi", options=SMALL_BAKE), Tool("cwebp", "cwebp", "png", ".webp"),
             Tool("gltfpack", gltfpack, "glb", ".glb"), Tool("ffmpeg", "ffmpeg", "png", ".webp", options_before=("-y",))]
    for tool in tools:
        if not shutil.which(tool.program):
            sys.exit(f"other_tools.py: {tool.program} is missing (Debian: webp, ffmpeg; npm: gltfpack)")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_inputs(folder, lumi)
        subprocess.run([sys.executable, "-B", ROOT / "tools/packaging/pages.py", lumi, folder / "share"], check=True)
        for question, answer in ROWS:
            print(json.dumps({"question": question, **{tool.name: answer(tool, folder) for tool in tools}},
                             ensure_ascii=False), flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
