#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""dim_light.py [--docs] [--spp N] [--work FOLDER]

Whether light that few paths find is lost in a bake: a lamp seen through a small hole, first light and second light, and a
caustic under a ball of glass. Each scene is baked with few paths. Pictures of the field are compared with
path-traced ones of N light paths a pixel [4096] where that light makes the picture brighter, by the mean of both in levels:
there alone, and with a border, over which texels spread the edge of what is lit.
--docs writes docs/log/data/dim_light.json, of which pages.py makes the table of docs/log/view-tables.md. Scenes, fields and
pictures stay in FOLDER [build/dim-light]. LUMI names the program. Needs numpy and Pillow (Debian: python3-pil).
"""
import argparse
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import bench  # noqa: E402
from figures.table import save  # noqa: E402
from scenes.write_failures import Obj  # noqa: E402

PATHS = [60]
BYTES = "250kB"
VIEWS = ["20,12,3", "200,24,3"]
SIZE = "128x128"
LIT = 2  # levels that the light must add to a pixel
BORDER = 3  # pixels
BLACK = 8  # levels; what throws the caustic is darker than this once it is painted black


def plate(obj, height, half, hole):
    """A square plate in four parts around a square hole."""
    for low, high in (([-half, -half], [half, -hole]), ([-half, hole], [half, half]),
                      ([-half, -hole], [-hole, hole]), ([hole, -hole], [half, hole])):
        obj.box([low[0], height, low[1]], [high[0], height + 0.02, high[1]])


def hole(obj, has_light):
    obj.material("grey")
    obj.box([-1, -0.5, -1], [1, -0.45, 1])
    plate(obj, 0.5, 1, 0.04 if has_light else 0)


def room(obj, has_light):
    """The same with three walls: most of what is seen there is lit by the spot alone."""
    hole(obj, has_light)
    obj.material("wall")
    for low, high in (([-1, -0.45, -1], [-0.96, 0.5, 1]), ([0.96, -0.45, -1], [1, 0.5, 1]), ([-1, -0.45, -1], [1, 0.5, -0.96])):
        obj.box(low, high)


def caustic(obj, has_light, ball="glass"):
    obj.material("grey")
    obj.box([-1, -0.5, -1], [1, -0.45, 1])
    if has_light:
        obj.material(ball, True)
        obj.ball([0, 0, 0], 0.3)


MATERIALS = ("newmtl grey\nKd 0.6 0.6 0.6\nnewmtl wall\nKd 0.7 0.5 0.4\nnewmtl black\nKd 0 0 0\n"
             "newmtl glass\nKd 0 0 0\nKs 1 1 1\nNi 1.5\nillum 7\n")
LAMP = {"type": "sphere", "position": [0.1, 1.6, 0.1], "radius": 0.15, "radiance": 60}
SCENES = {"a lamp through a hole": hole, "a room that such a spot lights": room, "a caustic": caustic}


def write_scene(work, stem, make, *how):
    obj = Obj(stem)
    make(obj, *how)
    (work / f"{stem}.obj").write_text("\n".join(obj.lines) + "\n")
    (work / f"{stem}.mtl").write_text(MATERIALS)
    (work / f"{stem}.json").write_text(json.dumps({"objects": [{"obj": f"{stem}.obj"}], "environment": 0.05, "lights": [LAMP],
                                                   "exposure": 0, "sphere": {"centre": [0, 0, 0], "radius": 1.6}}))
    return work / f"{stem}.json"


def rendered(kind, source, work, stem, view, *words):
    """The picture as rows of R, G, B in levels."""
    from PIL import Image
    import numpy
    picture = work / f"{stem}-{view.replace(',', '_')}.png"
    if not picture.exists():
        bench.lumi(kind, source, "-o", picture, "--orbit", view, "--size", SIZE, *words)
    return numpy.asarray(Image.open(picture).convert("RGB"), dtype=float)


def grown(mask):
    import numpy
    for _ in range(BORDER):
        mask = mask | numpy.roll(mask, 1, 0) | numpy.roll(mask, -1, 0) | numpy.roll(mask, 1, 1) | numpy.roll(mask, -1, 1)
    return mask


def rows_of(name, work, spp):
    """A row for each number of paths: means of truth and picture where the light is seen, and nothing that throws it."""
    import numpy
    make = SCENES[name]
    stem = make.__name__
    lit, without = write_scene(work, stem, make, True), write_scene(work, f"{stem}-without", make, False)
    black = write_scene(work, f"{stem}-black", make, True, "black") if make is caustic else lit
    truths, masks = [], []
    for view in VIEWS:
        truth = rendered("reference", lit, work, f"{stem}-truth{spp}", view, "--spp", spp)
        unlit = rendered("reference", without, work, f"{stem}-without", view, "--spp", 256)
        painted = rendered("reference", black, work, f"{stem}-black", view, "--spp", 64)
        truths.append(truth)
        masks.append(((truth - unlit).mean(axis=2) >= LIT) & (painted.mean(axis=2) >= BLACK))
    truth = numpy.array(truths)
    places = {"lit": numpy.array(masks), "border": numpy.array([grown(mask) for mask in masks])}
    rows = []
    for paths in PATHS:
        field = work / f"{stem}-{paths}.lumi"
        if not field.exists():
            bench.lumi("bake", lit, "-o", field, "--layout", "surface", "--fit", BYTES, "--paths", paths)
        drawn = numpy.array([rendered("render", field, work, f"{stem}-{paths}", view) for view in VIEWS])
        means = {place: {"pixels": int(mask.sum()), "truth": round(truth[mask].mean(), 2), "drawn": round(drawn[mask].mean(), 2)}
                 for place, mask in places.items()}
        rows.append({"scene": name, "paths": paths, **means})
        bench.announce(json.dumps(rows[-1]))
    return rows


def main(arguments):
    parser = argparse.ArgumentParser(prog="dim_light.py", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--docs", action="store_true", help="write docs/log/data/dim_light.json")
    parser.add_argument("--spp", type=int, default=4096, help="light paths a pixel of the reference [%(default)s]")
    parser.add_argument("--scene", choices=[make.__name__ for make in SCENES.values()], help="this one alone, not with --docs")
    parser.add_argument("--work", type=pathlib.Path, default=bench.ROOT / "build/dim-light", help="[build/dim-light]")
    options = parser.parse_args(arguments)
    work = options.work.absolute()
    work.mkdir(parents=True, exist_ok=True)
    try:
        rows = [row for name, make in SCENES.items() if options.scene in (None, make.__name__)
                for row in rows_of(name, work, options.spp)]
    except bench.BenchError as error:
        sys.exit(f"dim_light.py: {error}")
    if options.docs:
        save("dim_light", {"rows": rows, "reference_samples": options.spp})


if __name__ == "__main__":
    main(sys.argv[1:])
