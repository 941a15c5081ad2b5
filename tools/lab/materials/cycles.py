# SPDX-License-Identifier: MIT
"""Measures materials with Cycles: what a ball of each sends back in each ring, as linear radiance, and the materials as
Blender exports them.

    blender --background --factory-startup --python tools/lab/materials/cycles.py

writes cycles.json and cycles.mtl beside itself. Run with Blender 3.4.1 of Debian 12, on its CPU.
"""
import json
import math
import os
import sys
import tempfile

import bpy

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)
import ball  # noqa: E402

SAMPLES = 196  # a pixel


def principled(base, roughness, **inputs):
    named = {key.replace("_", " "): value for key, value in inputs.items()}
    return {"Base Color": (base, base, base, 1), "Roughness": roughness, **named}


def make_material(name, inputs):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.distribution = inputs.pop("distribution", "GGX")
    for key, value in inputs.items():
        shader.inputs[key].default_value = value
    return made


def set_up_cycles(size_px):
    """So that a picture holds linear radiance."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 64
    scene.render.resolution_x = scene.render.resolution_y = size_px
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"


def add(name, data, location, rotation):
    made = bpy.data.objects.new(name, data)
    made.location = location
    made.rotation_euler = rotation
    bpy.context.collection.objects.link(made)
    return made


def materials():
    """Inputs of the Principled shader by name: a kind, base colour and roughness; `distribution` chooses its facets."""
    made = {}
    for base in (0.05, 0.5, 0.8, 1):
        for roughness in (0.2, 0.5, 1):
            made[f"plastic_{base}_{roughness}"] = principled(base, roughness)
    for base in (0.6, 1):
        for roughness in (0.2, 0.5, 1):
            made[f"matte_{base}_{roughness}"] = principled(base, roughness, Specular=0.0)
    for specular in (0.25, 1.0):
        made[f"specular_{specular}"] = principled(0.5, 0.2, Specular=specular)
    for roughness in (0.05, 0.2, 0.5, 1):
        made[f"metal_0.9_{roughness}"] = principled(0.9, roughness, Metallic=1.0)
    for roughness in (0.2, 0.5, 1):
        made[f"metal_1_{roughness}"] = principled(1, roughness, Metallic=1.0)
    for base in (0.05, 0.5, 0.8, 1):
        made[f"coat_{base}"] = principled(base, 0.5, Clearcoat=1.0)
        made[f"sheen_{base}"] = principled(base, 0.5, Sheen=1.0)
    made["coat_metal"] = principled(0.5, 0.3, Metallic=1.0, Clearcoat=1.0)
    made["glass_0"] = principled(1, 0.0, Transmission=1.0)
    made["glass_0.5"] = principled(1, 0.5, Transmission=1.0)
    made["emission_0"] = {**principled(0, 0.5, Specular=0.0), "Emission": (1, 1, 1, 1)}
    made["emission_0.8"] = {**principled(0.8, 0.5), "Emission": (1, 1, 1, 1)}
    for name in ("metal_0.9_0.5", "metal_0.9_1", "glass_0.5"):
        made[f"{name}_multi"] = {**made[name], "distribution": "MULTI_GGX"}
    return made


def set_up_scene():
    """Leaves a camera, a white sky and a ball, which it returns."""
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    camera = add("camera", bpy.data.cameras.new("camera"), (0, -ball.DISTANCE, 0), (math.pi / 2, 0, 0))
    camera.data.angle = ball.FOV_RADIANS
    bpy.context.scene.camera = camera
    world = bpy.context.scene.world
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    bpy.context.scene.cycles.samples = SAMPLES
    bpy.ops.mesh.primitive_uv_sphere_add(radius=1, segments=ball.SEGMENTS, ring_count=ball.HEIGHTS)
    bpy.ops.object.shade_smooth()
    return bpy.context.object


def draw(folder):
    path = os.path.join(folder, "ball.exr")
    bpy.context.scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    picture = bpy.data.images.load(path)
    red = list(picture.pixels)[0::4]
    bpy.data.images.remove(picture)
    means = ball.ring_means(lambda x, y: red[y * ball.SIZE_PX + x], ball.SIZE_PX)
    return [round(mean, 5) for mean in means]


def measure(body, made):
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for material in made:
            body.data.materials.clear()
            body.data.materials.append(material)
            rows.append({"name": material.name.replace("_", " "), "sky": draw(folder)})
    return rows


def export(body, made, mtl_file):
    body.data.materials.clear()
    for face, material in zip(body.data.polygons, made):
        body.data.materials.append(material)
        face.material_index = len(body.data.materials) - 1
    with tempfile.TemporaryDirectory() as folder:
        bpy.ops.wm.obj_export(filepath=os.path.join(folder, "ball.obj"), export_pbr_extensions=True)
        with open(os.path.join(folder, "ball.mtl")) as written, open(mtl_file, "w") as out:
            out.write("# SPDX-License-Identifier: MIT\n" + written.read())


def main():
    set_up_cycles(ball.SIZE_PX)
    body = set_up_scene()
    made = [make_material(*item) for item in materials().items()]
    rows = ",\n  ".join(map(json.dumps, measure(body, made)))
    with open(os.path.join(here, "cycles.json"), "w") as out:
        out.write(f'{{\n "program": "Cycles of Blender {bpy.app.version_string}",\n "materials": [\n  {rows}\n ]\n}}\n')
    export(body, made, os.path.join(here, "cycles.mtl"))


if __name__ == "__main__":
    main()
