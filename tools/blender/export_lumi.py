# SPDX-License-Identifier: MIT
"""Blender add-on: File > Export > LumiPath scene. It writes NAME.glb, NAME.json and NAME.hdr: the scene file has what GLB
loses, which are the world, soft suns, area lamps, radii of lamps, exposure and view transform. Install it in Preferences >
Add-ons, or call it without a window:

    blender --background room.blend --python export_lumi.py -- room.json
"""
import json
import math
import os
import sys

import bpy
import numpy
from bpy_extras.io_utils import ExportHelper

bl_info = {"name": "LumiPath scene", "author": "The LumiPath developers", "version": (0, 1, 0), "blender": (3, 4, 0),
           "location": "File > Export", "description": "Scenes for lumi bake, with lamps and world", "category": "Import-Export"}

WORLD_WIDTH, WORLD_SAMPLES = 2048, 16
# Tone curves of scene files by Blender's view transforms. Filmic has none; AgX, which came after it, is the nearest.
TONES = {"Standard": "srgb", "Raw": "srgb", "AgX": "agx", "Filmic": "agx"}
LEVEL = math.sin(math.radians(2))  # a rectangle's width lies level, or is said not to


def in_scene(v):
    """GLB has y up."""
    return [round(float(c), 6) for c in (v[0], v[2], -v[1])]


def watts(lamp, divisor):
    return [round(float(c * lamp.energy / divisor), 9) for c in lamp.color]


def rectangle(lamp, matrix, warn):
    place, size = matrix.translation, matrix.to_scale()
    across, up, back = (matrix.to_3x3().col[k].normalized() for k in range(3))
    width = lamp.size * size[0]
    height = (lamp.size_y if lamp.shape in ("RECTANGLE", "ELLIPSE") else lamp.size) * size[1]
    if lamp.shape in ("DISK", "ELLIPSE"):
        width, height = width * math.sqrt(math.pi) / 2, height * math.sqrt(math.pi) / 2
        warn("a round area lamp becomes a rectangle of its area")
    if abs(across.z) > abs(up.z):
        width, height, across = height, width, up
    if abs(across.z) > LEVEL and abs(width - height) > 0.01 * width:
        warn("an area lamp's sides are not level: lumi lays them so")
    if lamp.spread < math.radians(179):
        warn("an area lamp's spread is lost")
    return {"type": "rectangle", "position": in_scene(place), "target": in_scene(place - back), "size": [width, height],
            "radiance": watts(lamp, 4 * width * height)}


def light_of(thing, matrix, warn):
    """A light of the scene file; None for a soft sun, which the world's picture gets."""
    lamp, place = thing.data, matrix.translation
    forward = -matrix.to_3x3().col[2].normalized()
    if lamp.type == "AREA":
        return rectangle(lamp, matrix, warn)
    if lamp.type == "SUN":
        return None if lamp.angle > 0 else {"type": "directional", "direction": in_scene(forward), "irradiance": watts(lamp, 1)}
    if lamp.type == "SPOT":
        if lamp.shadow_soft_size > 0:
            warn("a spot's radius is lost")
        half = math.degrees(lamp.spot_size) / 2
        return {"type": "spot", "position": in_scene(place), "target": in_scene(place + forward), "angle": half,
                "inner_angle": half * (1 - max(lamp.spot_blend, 0.01)), "intensity": watts(lamp, 4 * math.pi)}
    if lamp.shadow_soft_size == 0:
        return {"type": "point", "position": in_scene(place), "intensity": watts(lamp, 4 * math.pi)}
    radius = lamp.shadow_soft_size
    return {"type": "sphere", "position": in_scene(place), "radius": radius, "radiance": watts(lamp, 4 * (math.pi * radius)**2)}


def render_world(world, path):
    """The world alone, all around: its middle column lies at Blender's -Y, which is azimuth 0."""
    scene = bpy.data.scenes.new("lumi world")
    camera = bpy.data.cameras.new("lumi world")
    eye = bpy.data.objects.new("lumi world", camera)
    try:
        scene.collection.objects.link(eye)
        scene.camera, scene.world, scene.render.engine = eye, world, "CYCLES"
        eye.rotation_euler = (math.pi / 2, 0, math.pi)
        camera.type = "PANO"
        (camera.cycles if bpy.app.version < (4, 0, 0) else camera).panorama_type = "EQUIRECTANGULAR"
        scene.cycles.samples, scene.cycles.use_denoising = WORLD_SAMPLES, False
        scene.cycles.sample_clamp_direct = scene.cycles.sample_clamp_indirect = 0
        render = scene.render
        render.resolution_x, render.resolution_y, render.resolution_percentage = WORLD_WIDTH, WORLD_WIDTH // 2, 100
        render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
        render.filepath = path
        bpy.ops.render.render(write_still=True, scene=scene.name)
    finally:
        bpy.data.scenes.remove(scene)
        bpy.data.objects.remove(eye)
        bpy.data.cameras.remove(camera)


def disc(towards, angle, width, height):
    """(how much of each pixel a disc of the sky covers, the disc's light on a face that looks at it per radiance)"""
    fine = 4
    rows, columns = numpy.mgrid[0:height * fine, 0:width * fine]
    polar = (rows + 0.5) / (height * fine) * math.pi
    azimuth = (0.5 - (columns + 0.5) / (width * fine)) * 2 * math.pi
    # Azimuth 0 is -Y, and grows towards +X.
    cosine = (numpy.sin(polar) * (numpy.sin(azimuth) * towards.x - numpy.cos(azimuth) * towards.y)
              + numpy.cos(polar) * towards.z)
    inside = cosine >= math.cos(max(angle / 2, 2 * math.pi / width))
    solid = numpy.sin(polar) * (math.pi / (height * fine)) * (2 * math.pi / (width * fine))
    covered = inside.reshape(height, fine, width, fine).mean((1, 3))
    return covered, float((inside * solid * cosine).sum())


def pixels_of(path):
    """Top row first."""
    image = bpy.data.images.load(path)
    width, height = image.size
    pixels = numpy.empty(width * height * image.channels, numpy.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, -1)[::-1, :, :3].copy()


def write_hdr(path, pixels):
    """Radiance's format without compression. Blender's own writer clips pictures that were changed."""
    exponent = numpy.frexp(pixels.max(2))[1]
    bytes_of = numpy.clip(numpy.rint(numpy.ldexp(pixels, (8 - exponent)[..., None])), 0, 255).astype(numpy.uint8)
    shared = numpy.where(pixels.max(2) > 1e-30, exponent + 128, 0).astype(numpy.uint8)
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % pixels.shape[:2])
        file.write(numpy.dstack([bytes_of, shared]).tobytes())


def write_sky(world, suns, path):
    rendered = path + ".exr"
    render_world(world, rendered)
    pixels = pixels_of(rendered)
    os.remove(rendered)
    for thing, matrix in suns:
        covered, light = disc(matrix.to_3x3().col[2].normalized(), thing.data.angle, pixels.shape[1], pixels.shape[0])
        pixels += covered[..., None] * numpy.array(watts(thing.data, light), numpy.float32)
    write_hdr(path, pixels)


def lamps_of(context):
    """(lamp, its matrix), instances included."""
    graph = context.evaluated_depsgraph_get()
    return [(i.object.original, i.matrix_world.copy()) for i in graph.object_instances
            if i.object.type == "LIGHT" and not i.object.original.hide_render]


def export(context, path, warn):
    stem, scene = os.path.splitext(path)[0], context.scene
    name = os.path.basename(stem)
    lamps = lamps_of(context)
    for thing, _ in lamps:
        if thing.data.use_nodes:
            warn(f"the nodes of the lamp {thing.name} are lost")
    lights = [(light_of(thing, matrix, warn), thing, matrix) for thing, matrix in lamps]
    suns = [(thing, matrix) for light, thing, matrix in lights if light is None]
    bpy.ops.export_scene.gltf(filepath=stem + ".glb", export_format="GLB", export_lights=False, export_cameras=True,
                              export_apply=True)
    transform = scene.view_settings.view_transform
    if transform not in TONES:
        warn(f"the view transform {transform} becomes sRGB")
    elif transform == "Filmic":
        warn("the view transform Filmic becomes AgX, the nearest tone curve")
    written = {"objects": [{"obj": name + ".glb"}], "environment": "black", "exposure": scene.view_settings.exposure,
               "tone": TONES.get(transform, "srgb"), "lights": [light for light, *_ in lights if light]}
    if scene.world or suns:
        write_sky(scene.world, suns, stem + ".hdr")
        written["environment"] = {"picture": name + ".hdr"}
    with open(stem + ".json", "w", encoding="utf-8") as file:
        json.dump(written, file, indent=2)
        file.write("\n")


class EXPORT_SCENE_OT_lumi(bpy.types.Operator, ExportHelper):
    """Write a scene for lumi bake: a model, its light and its camera"""
    bl_idname, bl_label = "export_scene.lumi", "Export LumiPath scene"
    filename_ext = ".json"

    def execute(self, context):
        export(context, self.filepath, lambda text: self.report({"WARNING"}, text))
        return {"FINISHED"}


def menu(self, _):
    self.layout.operator(EXPORT_SCENE_OT_lumi.bl_idname, text="LumiPath scene (.json)")


def register():
    bpy.utils.register_class(EXPORT_SCENE_OT_lumi)
    bpy.types.TOPBAR_MT_file_export.append(menu)


def unregister():
    bpy.types.TOPBAR_MT_file_export.remove(menu)
    bpy.utils.unregister_class(EXPORT_SCENE_OT_lumi)


if __name__ == "__main__":
    register()
    if "--" in sys.argv:
        bpy.ops.export_scene.lumi(filepath=os.path.abspath(sys.argv[sys.argv.index("--") + 1]))
