#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Bakes models that people have, and draws them beside path-traced pictures.

model_sheet.py FOLDER [NAME...] [--people [1-60]] [--paths 60] [--fit 250kB] [--lumi PROGRAM]

FOLDER holds the models of MODELS below (Debian: python3-matplotlib):
    npm pack @webxr-input-profiles/assets@1.0.20 && tar xzf webxr*.tgz                     (as `package`)
    apt-get download sweethome3d-furniture && dpkg-deb -x sweethome3d-furniture*.deb .     (each .sh3f unpacked into `obj`)
With --people FOLDER holds, in place of these, what Debian's packages minetest-mod-homedecor, assimp-testmodels and
sweethome3d-furniture unpack (dpkg-deb -x), each .sh3f in place of itself, as a folder of that name. All OBJ and glTF files
there are ranked by the SHA-256 of their paths, and the sheet has those of the ranks that are said, from six sides: nobody
chose them. NAMEs choose some of them. The sheet is build/model-sheet/sheet.png: path-traced, drawn from the field, and again from
the next side. What is there already is not made again: delete a model's folder there to bake it anew."""
import argparse
import hashlib
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
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
PEOPLE_SIDES = ["30,20,3", "90,5,3", "150,40,3", "210,-10,3", "270,20,3", "330,-40,3"]
SIZE = "200x200"
SPP = "64"  # references take so many
FAR_DB, FAR_SPP = 34, "512"  # a view that is farther off is measured again: its reference may be the noisy one


class Set:
    """Which models, from which sides, and where it goes."""

    def __init__(self, work, models, sides):
        self.work, self.models, self.sides = ROOT / "build" / work, models, sides


def people(folder):
    """Names and paths of all models, in the order of their paths' SHA-256."""
    paths = [p.relative_to(folder) for p in folder.rglob("*") if p.suffix.lower() in (".obj", ".gltf", ".glb") and p.is_file()]
    chosen = sorted(paths, key=lambda p: hashlib.sha256(p.as_posix().encode()).digest())
    return {f"{k + 1:02}-{path.stem}": path for k, path in enumerate(chosen)}


def ranks(text):
    first, last = map(int, text.split("-"))
    return first, last


class Model:
    """A model's pictures and what was said of it, each made once."""

    def __init__(self, name, chosen, options):
        self.name, self.sides, self.options = name, chosen.sides, options
        self.scene = options.folder / chosen.models[name]
        self.folder = chosen.work / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.field = self.folder / "field.lumi"

    def run(self, *words):
        return subprocess.run([self.options.lumi, *map(str, words)], capture_output=True, text=True, check=False)

    def bake(self):
        """Keeps what lumi says; after a refusal there is no field."""
        said = self.folder / "said.txt"
        if not said.exists():
            done = self.run("bake", self.scene, "-o", self.field, "--fit", self.options.fit, "--paths", self.options.paths)
            said.write_text(done.stdout + done.stderr)
        return said.read_text()

    def picture(self, kind, side, spp=SPP):
        path = self.folder / f"{kind}-{side}.png"
        if path.exists():
            return path
        look = ["-o", path, "--orbit", self.sides[side], "--size", SIZE]
        if kind != "drawn":
            self.run("reference", self.scene, *look, "--spp", spp)
        elif self.field.exists():
            self.run("render", self.field, *look, "--background", "black")
        return path

    def psnr_to(self, truth, side):
        done = self.run("compare", truth, self.picture("drawn", side))
        found = re.search(r"(inf|[0-9.]+) dB", done.stdout)
        return float(found[1]) if found else None

    def psnr(self, side):
        psnr = self.psnr_to(self.picture("truth", side), side)
        return self.psnr_to(self.picture("fine-truth", side, FAR_SPP), side) if psnr and psnr < FAR_DB else psnr

    def row(self):
        said = self.bake()
        warnings = re.findall(r"^lumi: warning: (.*)$", said, re.MULTILINE)
        if not self.field.exists():
            warnings = [f"refused: {line}" for line in re.findall(r"^lumi: (.*)$", said, re.MULTILINE)]
        told = [w.replace(f"{self.scene.parent}/", "") for w in warnings]
        return {"model": self.name, "bytes": self.field.stat().st_size if self.field.exists() else 0,
                "psnr_db": [self.psnr(side) for side in range(len(self.sides))],
                "layout": None if not self.field.exists() else "chord" if "lumi: layout chord: " in said else "surface", "said": told}


def draw_sheet(models, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    sides = models[0].sides
    across = max(1, 4 // len(sides))
    kinds = [(kind, side) for side in range(len(sides)) for kind in ("truth", "drawn")]
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


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--people", type=ranks, nargs="?", const=(1, 60), metavar="FIRST-LAST")
    parser.add_argument("--paths", default="60")
    parser.add_argument("--fit", default="250kB")
    parser.add_argument("--lumi", default=str(ROOT / "build/release/tools/lumi"))
    options = parser.parse_args()
    if options.people:
        chosen = Set("people-sheet", people(options.folder), PEOPLE_SIDES)
    else:
        chosen = Set("model-sheet", MODELS, SIDES)
    unknown = sorted(set(options.names) - set(chosen.models))
    if unknown:
        parser.error(f"there is no model {', '.join(unknown)}")
    first, last = options.people or (1, len(chosen.models))
    models = [Model(name, chosen, options) for name in options.names or list(chosen.models)[first - 1:last]]
    for model in models:
        print(model.row(), flush=True)
    draw_sheet(models, chosen.work / "sheet.png")
    print(chosen.work / "sheet.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
