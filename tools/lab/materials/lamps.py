# SPDX-License-Identifier: MIT
"""Measures lamps with Cycles and with lumi: the light that a matte floor sends back below a lamp of each kind, as linear
radiance. lumi draws the glTF file that Blender exports, from the camera in it.

    blender --background --factory-startup --python tools/lab/materials/lamps.py -- LUMI

prints the table and writes docs/log/data/lamps.json; tools/lab/pages.py copies it to docs/blender.md. Run with Blender 3.4.1 of Debian 12, on its CPU; Blender's exporter
needs python3-numpy.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

import bpy

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.dirname(here)]
from blender_scene import add, make_material, principled, set_up_cycles  # noqa: E402
from figures import scripts  # noqa: E402
from figures.table import save, shown  # noqa: E402

SIZE_PX = 32
SAMPLES = 256
HEIGHT = 2  # of the lamp above the floor, in metres
ALBEDO = 0.8
TILT = math.radians(30)  # of the sun, which falls from no lamp's place
POINT = {"energy": 100, "shadow_soft_size": 0}
LAMPS = {  # by a name: Blender's type, and what is set
    "point": ("POINT", POINT),
    "point of radius 0.25": ("POINT", {**POINT, "shadow_soft_size": 0.25}),
    "spot": ("SPOT", {**POINT, "spot_size": math.radians(60), "spot_blend": 0.1}),
    "spot, half soft": ("SPOT", {**POINT, "spot_size": math.radians(90), "spot_blend": 0.5}),
    "sun": ("SUN", {"energy": 2, "angle": 0}),
}


def set_up_floor():
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    bpy.ops.mesh.primitive_plane_add(size=2)
    floor = make_material("floor", principled(ALBEDO, 1, Specular=0.0))
    bpy.context.object.data.materials.append(floor)
    camera = add("camera", bpy.data.cameras.new("camera"), (0, -4, 4), (math.radians(45), 0, 0))
    camera.data.angle = math.radians(3)
    bpy.context.scene.camera = camera
    bpy.context.scene.world.use_nodes = True
    bpy.context.scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)


def put_lamp(name):
    kind, settings = LAMPS[name]
    lamp = bpy.data.lights.new(name, kind)
    for key, value in settings.items():
        setattr(lamp, key, value)
    return add(name, lamp, (0, 0, HEIGHT), (TILT if kind == "SUN" else 0, 0, 0))


def mean_of(path):
    """Radiance of a picture's middle, a quarter of its area."""
    picture = bpy.data.images.load(path)
    picture.colorspace_settings.name = "Non-Color"
    pixels, (width, height) = list(picture.pixels), picture.size
    middle = [pixels[4 * (y * width + x)] for y in range(height // 4, height * 3 // 4)
              for x in range(width // 4, width * 3 // 4)]
    bpy.data.images.remove(picture)
    return sum(middle) / len(middle)


def by_cycles(folder):
    path = os.path.join(folder, "cycles.exr")
    bpy.context.scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    return mean_of(path)


def by_lumi(lumi, model, folder):
    path = os.path.join(folder, "lumi.exr")
    call = [lumi, "reference", model, "-o", path, "--view", "camera", "--size", f"{SIZE_PX}x{SIZE_PX}", "--spp", str(SAMPLES), "--exposure", "0"]
    result = subprocess.run(call, capture_output=True, text=True)
    if result.returncode:
        sys.exit(result.stderr)
    return mean_of(path)


def intensity_in(model):
    with open(model) as file:
        return json.load(file)["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"]


def row_of(lumi, name, folder):
    lamp = put_lamp(name)
    model = os.path.join(folder, "lamp.gltf")
    bpy.ops.export_scene.gltf(filepath=model, export_format="GLTF_EMBEDDED", export_lights=True, export_cameras=True)
    unit, file_unit = ("", "lux") if lamp.data.type == "SUN" else ("W", "cd")
    row = {"lamp": name, "strength": lamp.data.energy, "unit": unit, "in_the_file": intensity_in(model),
           "file_unit": file_unit, "cycles": by_cycles(folder), "lumi": by_lumi(lumi, model, folder)}
    bpy.data.objects.remove(lamp)
    return {key: float(f"{value:.4g}") if isinstance(value, float) else value for key, value in row.items()}


def main():
    lumi = os.path.abspath(sys.argv[sys.argv.index("--") + 1])
    set_up_cycles(SIZE_PX)
    set_up_floor()
    bpy.context.scene.cycles.samples = SAMPLES
    with tempfile.TemporaryDirectory() as folder:
        shown["lamps"] = {"blender": bpy.app.version_string, "lamps": [row_of(lumi, name, folder) for name in LAMPS]}
    print(scripts.lamps().markdown())
    save("lamps", shown["lamps"])


if __name__ == "__main__":
    main()
