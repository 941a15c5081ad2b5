#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""npm.py MODULE.wasm.gz FOLDER

Writes the npm package of the web component <lumi-view>: one ES module, made of what pages of `lumi view` are made of, with
the module element_viewer.wasm.gz of the build (platform/wasm) in it.
"""
import base64
import gzip
import json
import pathlib
import re
import sys

from project import CORE, PROJECT, ROOT, person, version

VIEWER = ROOT / "tools/src/viewer"


def files(module):
    """{name: bytes}. `module`: the path of element_viewer.wasm.gz."""
    own = {name: (VIEWER / "npm" / name).read_bytes() for name in ("lumi-view.d.ts", "README.md")}
    text = "".join((VIEWER / name).read_text() for name in ("page/turner.js", "npm/lumi-view.js"))
    licence, *lines = text.splitlines()
    short = [re.sub(r"(^|  +)// .*", "", line.strip()) for line in lines]  # without comments
    script = "\n".join([licence, *filter(None, short), ""]).encode()
    packed = gzip.compress(gzip.decompress(module.read_bytes()), mtime=0)  # zlib's is smaller than that of the tool gzip
    manifest = {
        "name": f"@{PROJECT['namespace']}/lumi-view", "version": version(),
        "description": "Path-traced objects that people turn, as a web component",
        "keywords": ["web-component", "webassembly", "3d", "path-tracing"], "homepage": PROJECT["home"],
        "repository": {"type": "git", "url": f"git+{PROJECT['home']}.git"}, "license": "MIT", "author": person(),
        "type": "module", "main": "lumi-view.js", "types": "lumi-view.d.ts", "sideEffects": ["lumi-view.js"],
        "exports": {".": {"types": "./lumi-view.d.ts", "default": "./lumi-view.js"}},
        "files": ["lumi-view.js", "lumi-view.d.ts"]}
    return {**own, "LICENSE": (CORE / "LICENSE").read_bytes(), "package.json": (json.dumps(manifest, indent=2) + "\n").encode(),
            "lumi-view.js": script.replace(b"{{module}}", base64.b64encode(packed))}


def main(module, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in files(pathlib.Path(module)).items():
        (folder / name).write_bytes(content)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
