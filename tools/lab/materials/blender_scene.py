# SPDX-License-Identifier: MIT
"""What the scenes that Blender measures are made of."""
import bpy


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
