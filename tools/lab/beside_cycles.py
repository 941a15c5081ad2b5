#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws models that people have beside Cycles, with the same camera and the same light.

beside_cycles.py FOLDER [--count 89] [--lumi PROGRAM] [--json FILE]

All glTF files of FOLDER are ranked by the SHA-256 of their paths, so nobody chose those that are drawn: model_sheet.py
says where folders of them come from. Blender (Debian 12: 3.4.1, with python3-numpy) imports each, and Cycles and `lumi
reference` draw it in a sky of one colour. A row tells how far the two are apart: levels, mean over the pixels that one of
them covers by half, over black. build/beside-cycles/NAME.png has both pictures, Cycles' at the left. What is there already
is not made again. --json keeps the rows as data, which docs/log/models.md cites.
"""
import argparse
import json
import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SIDE_PX, SAMPLES, SKY = 120, 48, 0.7
AZIMUTH, ELEVATION, DISTANCE = 30, 20, 3  # of --orbit
FOV = 2 * math.asin(1 / DISTANCE)
NEAR, FAR = 8, 60  # levels


def import_model(bpy, path):
    import numpy
    numpy.bool = bool  # Debian's importer of glTF asks for it, and Debian's numpy has it no more
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(path))


def sphere_of(bpy):
    """Centre and radius of a sphere around all meshes, in Blender's axes."""
    import numpy
    graph = bpy.context.evaluated_depsgraph_get()
    parts = []
    for instance in graph.object_instances:
        if instance.object.type != "MESH":
            continue
        mesh, matrix = instance.object.data, numpy.array(instance.matrix_world)
        used = numpy.zeros(len(mesh.loops), numpy.int32)
        mesh.loops.foreach_get("vertex_index", used)
        points = numpy.zeros(3 * len(mesh.vertices))
        mesh.vertices.foreach_get("co", points)
        parts.append(points.reshape(-1, 3)[numpy.unique(used)] @ matrix[:3, :3].T + matrix[:3, 3])
    points = numpy.concatenate(parts)
    centre = (points.min(axis=0) + points.max(axis=0)) / 2
    return centre, 1.001 * float(numpy.sqrt(((points - centre) ** 2).sum(axis=1).max()))


def set_eye(bpy, centre, radius):
    """Azimuth 0 is Blender's front view."""
    import mathutils
    azimuth, elevation = math.radians(AZIMUTH), math.radians(ELEVATION)
    back = mathutils.Vector((math.cos(elevation) * math.sin(azimuth), -math.cos(elevation) * math.cos(azimuth), math.sin(elevation)))
    data = bpy.data.cameras.new("Eye")
    data.angle = FOV
    data.clip_start, data.clip_end = radius, 2 * DISTANCE * radius
    eye = bpy.data.objects.new("Eye", data)
    eye.location = mathutils.Vector(centre) + back * radius * DISTANCE
    eye.rotation_euler = back.to_track_quat("Z", "Y").to_euler()
    bpy.context.collection.objects.link(eye)
    bpy.context.scene.camera = eye


def render(bpy, path):
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (SKY, SKY, SKY, 1)
    scene.view_settings.view_transform = "Standard"
    scene.render.engine, scene.render.film_transparent = "CYCLES", True
    scene.render.resolution_x = scene.render.resolution_y = SIDE_PX
    scene.render.image_settings.color_mode = "RGBA"
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.use_adaptive_sampling = SAMPLES, False, False
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def pixels_of(bpy, path):
    import numpy
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    pixels = numpy.empty(SIDE_PX * SIDE_PX * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(SIDE_PX, SIDE_PX, 4)


def within_blender(model, lumi, folder, name):
    import bpy
    import numpy
    import_model(bpy, Path(model))
    centre, radius = sphere_of(bpy)
    set_eye(bpy, centre, radius)
    theirs, ours, scene = (Path(folder) / f"{name}{end}" for end in ("-cycles.png", "-ours.png", ".json"))
    render(bpy, theirs)
    x, y, z = map(float, centre)
    scene.write_text(json.dumps({"objects": [{"obj": model}], "environment": SKY, "exposure": 0,
                                 "sphere": {"centre": [x, z, -y], "radius": radius}}))
    done = subprocess.run([lumi, "reference", scene, "-o", ours, "--size", f"{SIDE_PX}x{SIDE_PX}", "--spp", str(SAMPLES),
                           "--orbit", f"{AZIMUTH},{ELEVATION},{DISTANCE}", "--fov", str(math.degrees(FOV)),
                           "--background", "none"], capture_output=True, text=True, check=False)
    said = [line.removeprefix("lumi: ").replace(str(Path(model).parent) + "/", "") for line in done.stderr.splitlines() if line.startswith("lumi: ")]
    row = {"model": name, "levels": None, "said": said}
    if done.returncode == 0:
        pair = [pixels_of(bpy, path) for path in (theirs, ours)]
        over_black = [255 * p[..., :3] * p[..., 3:] for p in pair]
        covered = numpy.maximum(pair[0][..., 3], pair[1][..., 3]) >= 0.5
        row["levels"] = round(float(numpy.abs(over_black[0] - over_black[1])[covered].mean()), 1) if covered.any() else 0.0
        both = bpy.data.images.new("both", 2 * SIDE_PX, SIDE_PX)
        side_by_side = numpy.ones((SIDE_PX, 2 * SIDE_PX, 4), numpy.float32)
        side_by_side[..., :3] = numpy.concatenate(over_black, axis=1) / 255
        both.pixels.foreach_set(side_by_side.ravel())
        both.filepath_raw, both.file_format = str(Path(folder) / f"{name}.png"), "PNG"
        both.save()
    (Path(folder) / f"{name}.row").write_text(json.dumps(row))


def row_of(name, model, lumi, folder):
    kept = folder / f"{name}.row"
    if not kept.exists():
        done = subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", __file__,
                               "--", str(model), lumi, str(folder), name], capture_output=True, text=True, check=False)
        if not kept.exists():
            why = [line for line in (done.stderr + done.stdout).splitlines() if line.startswith(("Error", "RuntimeError", "ValueError", "Exception"))]
            kept.write_text(json.dumps({"model": name, "levels": None, "said": ["Blender cannot read it: " + (why or ["?"])[-1]]}))
    return json.loads(kept.read_text())


def main():
    from model_sheet import people
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--count", type=int, default=89)
    parser.add_argument("--lumi", default=str(ROOT / "build/release/tools/lumi"))
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    folder = ROOT / "build/beside-cycles"
    folder.mkdir(parents=True, exist_ok=True)
    root, rows = options.folder.resolve(), []
    for name, path in [(n, p) for n, p in people(root).items() if p.suffix.lower() != ".obj"]:
        row = row_of(name, root / path, options.lumi, folder)
        print(f"{row['levels'] if row['levels'] is not None else '-':>6}  {name}  {'; '.join(row['said'])[:120]}", flush=True)
        rows += [row] if row["levels"] is not None else []
        if len(rows) == options.count:
            break
    rows.sort(key=lambda row: row["levels"])
    near, far = (sum(row["levels"] <= NEAR for row in rows), [row["model"] for row in rows if row["levels"] > FAR])
    print(f"{near} of {len(rows)} within {NEAR} levels; above {FAR}: {', '.join(far) or 'none'}")
    if options.json:
        data = {"about": "measured by hand: tools/lab/beside_cycles.py FOLDER --json", "models": len(rows), "near": near,
                "levels": {row["model"]: row["levels"] for row in rows}}
        options.json.write_text(json.dumps(data, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    if "bpy" in sys.modules or "--" in sys.argv:
        within_blender(*sys.argv[sys.argv.index("--") + 1:])
    else:
        sys.exit(main())
