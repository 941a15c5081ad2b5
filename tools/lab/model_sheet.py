#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Bakes models that people have, and draws them beside path-traced pictures.

model_sheet.py FOLDER [NAME...] [--paths 60] [--fit 250kB] [--lumi PROGRAM] [--docs]

FOLDER holds the models of MODELS below (Debian: python3-matplotlib):
    npm pack @webxr-input-profiles/assets@1.0.20 && tar xzf webxr*.tgz                     (as `package`)
    apt-get download sweethome3d-furniture && dpkg-deb -x sweethome3d-furniture*.deb .     (each .sh3f unpacked into `obj`)
NAMEs choose some of them. The sheet is build/model-sheet/sheet.png: path-traced, drawn from the field, and again from
the next side. What is there already is not made again: delete a model's folder there to bake it anew. --docs brings dB,
bytes and what `lumi bake` warns of into docs/log/data/model_sheet.json, beside what that holds of other models."""
import argparse
import re
import subprocess
import sys
from pathlib import Path

from figures.table import DATA, load, save

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / "build/model-sheet"
PROFILES = "package/dist/profiles"
MODELS = {
    "htc-vive": f"{PROFILES}/htc-vive/none.glb",
    "valve-index": f"{PROFILES}/valve-index/left.glb",
    "oculus-touch-v3": f"{PROFILES}/oculus-touch-v3/left.glb",
    "mixed-reality": f"{PROFILES}/microsoft-mixed-reality/left.glb",
    "magicleap-one": f"{PROFILES}/magicleap-one/none.glb",
    "generic-hand": f"{PROFILES}/generic-hand/left.glb",
    "pico-4": f"{PROFILES}/pico-4/left.glb",
    "gearvr": f"{PROFILES}/samsung-gearvr/none.glb",
    "daydream": f"{PROFILES}/google-daydream/none.glb",
    "mx-ink": f"{PROFILES}/logitech-mx-ink/none.glb",
    "camera": "obj/scopia/reflex_camera/reflex_camera.obj",
    "bicycle": "obj/scopia/bicycle/bicycle.obj",
    "car": "obj/scopia/smart-car/smart-car.obj",
    "bonsai": "obj/scopia/bonsai-tree/bonsai-tree.obj",
    "cake": "obj/scopia/birthday_cake/birthday_cake.obj",
    "sneakers": "obj/scopia/sneakers/sneakers.obj",
    "hydrant": "obj/katorlegaz/fire-hydrant/fire-hydrant.obj",
    "kettle": "obj/blendswap-cc-by/espressokettle/espressokettle.obj",
    "piano": "obj/blendswap-cc-by/piano/piano.obj",
    "man": "obj/reallusion/male01/male01.obj",
}
SIDES = ["30,20,3", "200,-10,3"]  # orbits
SIZE = "200x200"
SPP = "64"  # of references


class Model:
    """A model's pictures and what was said of it, each made once."""

    def __init__(self, name, options):
        self.name, self.options = name, options
        self.scene = options.folder / MODELS[name]
        self.folder = WORK / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.field = self.folder / "field.lumi"

    def run(self, *words):
        return subprocess.run([self.options.lumi, *map(str, words)], capture_output=True, text=True, check=False)

    def bake(self):
        """What lumi says; a refusal is what was said, without a field."""
        said = self.folder / "said.txt"
        if not said.exists():
            done = self.run("bake", self.scene, "-o", self.field, "--fit", self.options.fit, "--paths", self.options.paths)
            said.write_text(done.stdout + done.stderr)
        return said.read_text()

    def picture(self, kind, side):
        path = self.folder / f"{kind}-{side}.png"
        if path.exists():
            return path
        look = ["-o", path, "--orbit", SIDES[side], "--size", SIZE]
        if kind == "truth":
            self.run("reference", self.scene, *look, "--spp", SPP)
        elif self.field.exists():
            self.run("render", self.field, *look)
        return path

    def psnr(self, side):
        done = self.run("compare", self.picture("truth", side), self.picture("drawn", side))
        found = re.search(r"(inf|[0-9.]+) dB", done.stdout)
        return float(found[1]) if found else None

    def row(self):
        said = self.bake()
        warnings = re.findall(r"^lumi: warning: (.*)$", said, re.MULTILINE)
        told = [w.replace(f"{self.scene.parent}/", "") for w in warnings]
        return {"model": self.name, "bytes": self.field.stat().st_size if self.field.exists() else 0,
                "psnr_db": [self.psnr(side) for side in range(len(SIDES))], "said": told}


def draw_sheet(models, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    across = 2
    kinds = [(kind, side) for side in range(len(SIDES)) for kind in ("truth", "drawn")]
    down = -(-len(models) // across)
    figure, axes = pyplot.subplots(down, across * len(kinds), figsize=(across * len(kinds) * 2, down * 2.15), squeeze=False)
    for axis in axes.flat:
        axis.axis("off")
    for k, model in enumerate(models):
        for j, (kind, side) in enumerate(kinds):
            axis = axes[k // across][k % across * len(kinds) + j]
            picture = model.picture(kind, side)
            if picture.exists():
                axis.imshow(pyplot.imread(picture))
            psnr = model.psnr(side) if kind == "drawn" else None
            axis.set_title(model.name if kind == "truth" else "refused" if psnr is None else f"{psnr:.1f} dB", fontsize=9)
    figure.tight_layout(pad=0.2)
    figure.savefig(path, dpi=100)


def write_rows(rows):
    known = load("model_sheet")["models"] if (DATA / "model_sheet.json").exists() else []
    by_name = {row["model"]: row for row in [*known, *rows]}
    save("model_sheet", {"models": [by_name[name] for name in MODELS if name in by_name]})


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--paths", default="60")
    parser.add_argument("--fit", default="250kB")
    parser.add_argument("--lumi", default=str(ROOT / "build/release/tools/lumi"))
    parser.add_argument("--docs", action="store_true")
    options = parser.parse_args()
    unknown = sorted(set(options.names) - set(MODELS))
    if unknown:
        parser.error(f"there is no model {', '.join(unknown)}")
    models = [Model(name, options) for name in options.names or MODELS]
    rows = []
    for model in models:
        rows.append(model.row())
        print(rows[-1], flush=True)
    draw_sheet(models, WORK / "sheet.png")
    print(WORK / "sheet.png")
    if options.docs:
        write_rows(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
