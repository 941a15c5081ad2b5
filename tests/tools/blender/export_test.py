# SPDX-License-Identifier: MIT
"""blender --background --factory-startup --python-exit-code 1 --python export_test.py -- LUMI ADDON FOLDER

Exports a scene with a world of high range, an area lamp, a soft sun and a lamp with a radius by the add-on, and compares
what Cycles and `lumi reference` see through its camera, in linear light: the mean of each object.
"""
import importlib.util
import json
import math
import os
import subprocess
import sys

import bpy
import numpy

lumi, addon, folder = sys.argv[sys.argv.index("--") + 1:]
SIDE, SAMPLES = 128, 256
LIMIT = 0.03  # how far the materials of both programs lie apart (docs/blender.md)
EDGE = 0.999  # pixels that an object covers whole


def material(name, colour, roughness):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Specular"].default_value = 0  # Cycles' gloss sends back more than arrives: docs/log/models.md
    return made


def lamp(kind, name, energy, place, turn, **more):
    data = bpy.data.lights.new(name, kind)
    data.energy = energy
    for key, value in more.items():
        setattr(data, key, value)
    thing = bpy.data.objects.new(name, data)
    thing.location, thing.rotation_euler = place, turn
    bpy.context.collection.objects.link(thing)


def build():
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    scene, things = bpy.context.scene, []
    bpy.ops.mesh.primitive_plane_add(size=6)
    things.append(("ground", (0.6, 0.6, 0.55), 0.5))
    bpy.context.object.name = "ground"
    bpy.ops.mesh.primitive_cube_add(size=1.2, location=(-1, 0.4, 0.6), rotation=(0, 0, 0.5))
    things.append(("cube", (0.7, 0.15, 0.1), 0.5))
    bpy.context.object.name = "cube"
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=0.7, location=(1, -0.3, 0.7))
    bpy.ops.object.shade_smooth()
    things.append(("ball", (0.2, 0.35, 0.7), 0.5))
    bpy.context.object.name = "ball"
    for name, colour, roughness in things:
        bpy.data.objects[name].data.materials.append(material(name, colour, roughness))
    lamp("AREA", "panel", 150, (-2, -2, 3), (0.7, 0, -0.7), shape="RECTANGLE", size=1.5, size_y=0.5)
    lamp("SUN", "sun", 1.5, (0, 0, 5), (0.5, 0.4, 0), angle=math.radians(8), color=(1, 0.8, 0.6))
    lamp("POINT", "bulb", 60, (2, 2, 2), (0, 0, 0), shadow_soft_size=0.3)
    camera = bpy.data.objects.new("Eye", bpy.data.cameras.new("Eye"))
    camera.location, camera.rotation_euler = (0, -12, 6), (math.radians(64), 0, 0)
    camera.data.lens = 70
    bpy.context.collection.objects.link(camera)
    scene.camera = camera
    scene.render.resolution_x = scene.render.resolution_y = SIDE  # GLB's camera sees so much
    scene.render.resolution_percentage = 100
    nodes = scene.world.node_tree.nodes
    picture = nodes.new("ShaderNodeTexEnvironment")
    lights = bpy.utils.system_resource("DATAFILES", path="studiolights")
    picture.image = bpy.data.images.load(os.path.join(lights, "world", "interior.exr"))
    scene.world.node_tree.links.new(picture.outputs["Color"], nodes["Background"].inputs["Color"])
    scene.view_settings.view_transform, scene.view_settings.exposure = "Standard", 0.5
    return [name for name, *_ in things]


def pixels_of(path):
    image = bpy.data.images.load(path)
    pixels = numpy.empty(image.size[0] * image.size[1] * image.channels, numpy.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(-1, image.channels)


def rendered(name, samples):
    render = bpy.context.scene.render
    render.engine, render.film_transparent = "CYCLES", True
    render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
    render.image_settings.color_mode = "RGBA"
    cycles = bpy.context.scene.cycles
    cycles.samples, cycles.use_denoising, cycles.use_adaptive_sampling, cycles.seed = samples, False, False, 1
    cycles.sample_clamp_indirect = 0
    render.filepath = os.path.join(folder, name)
    bpy.ops.render.render(write_still=True)
    return pixels_of(render.filepath)


def main():
    os.makedirs(folder, exist_ok=True)
    names = build()
    spec = importlib.util.spec_from_file_location("export_lumi", addon)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.register()
    path = os.path.join(folder, "room.json")
    scenes = len(bpy.data.scenes)
    bpy.ops.export_scene.lumi(filepath=path)
    assert len(bpy.data.scenes) == scenes and bpy.context.scene.camera.name == "Eye", "the export changed the file"
    scene = json.load(open(path, encoding="utf-8"))
    assert scene["exposure"] == 0.5 and scene["tone"] == "srgb", scene
    assert sorted(light["type"] for light in scene["lights"]) == ["rectangle", "sphere"], scene["lights"]
    ours = os.path.join(folder, "ours.exr")
    subprocess.run([lumi, "reference", path, "-o", ours, "--view", "Eye", "--size", f"{SIDE}x{SIDE}", "--spp", str(SAMPLES)],
                   check=True)
    theirs, ours = rendered("theirs.exr", SAMPLES), pixels_of(ours)
    worst = 0
    for name in names:
        for other in names:
            bpy.data.objects[other].is_holdout = other != name
        whole = rendered(f"{name}.exr", 16)[:, 3] > EDGE
        for other in names:
            bpy.data.objects[other].is_holdout = False
        assert whole.sum() > 200, f"{name} covers {whole.sum()} pixels"
        a, b = (pixels[whole][:, :3].mean(0) for pixels in (ours, theirs))
        apart = a.mean() / b.mean() - 1
        print(f"{name}: lumi {a.round(4)}, Cycles {b.round(4)}, {100 * apart:+.2f} % in {whole.sum()} pixels")
        worst = max(worst, abs(apart))
    if worst > LIMIT:
        sys.exit(f"error: an object is {100 * worst:.1f} % brighter or darker than in Cycles")


main()
