# SPDX-License-Identifier: MIT
"""Makes a cup with saucer in Blender and exports it: blender --background --factory-startup --python mug.py"""
import math

import bmesh
import bpy

SEGMENTS = 96


def material(name, colour, roughness, metallic=0.0, picture=None):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metallic
    if picture:
        texture = made.node_tree.nodes.new("ShaderNodeTexImage")
        texture.image = picture
        made.node_tree.links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    return made


def waves(width=512, height=128):
    """A glaze of three colours as a picture beside the OBJ."""
    picture = bpy.data.images.new("glaze", width, height)
    pixels = []
    for y in range(height):
        for x in range(width):
            edge = 0.5 + 0.12 * math.sin(2 * math.pi * 6 * x / width)
            band = y / height - edge
            colour = (0.85, 0.82, 0.74) if band > 0.04 else (0.9, 0.5, 0.12) if band > -0.04 else (0.05, 0.22, 0.35)
            pixels += [*colour, 1]
    picture.pixels = pixels
    picture.filepath_raw = "glaze.png"
    picture.file_format = "PNG"
    picture.save()
    return picture


def lathe(name, profile, *materials, rim=None):
    """Turns (radius, height) pairs about z; `rim` names the profile steps of the second material."""
    rings = [[(r * math.cos(a), r * math.sin(a), z) for r, z in profile]
             for a in (2 * math.pi * k / SEGMENTS for k in range(SEGMENTS))]
    count = len(profile)
    faces, uvs, second = [], [], []
    for k in range(SEGMENTS):
        for p in range(count - 1):
            a, b = k * count + p, (k + 1) % SEGMENTS * count + p
            faces.append((a, b, b + 1, a + 1))
            u, w = k / SEGMENTS, (k + 1) / SEGMENTS
            v, t = profile[p][1], profile[p + 1][1]
            uvs += [(u, v), (w, v), (w, t), (u, t)]
            second.append(rim is not None and p in rim)
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([v for ring in rings for v in ring], [], faces)
    layer = mesh.uv_layers.new()
    for loop, uv in zip(layer.data, uvs):
        loop.uv = uv
    for slot in materials:
        mesh.materials.append(slot)
    for polygon, gilded in zip(mesh.polygons, second):
        polygon.use_smooth = True
        polygon.material_index = int(gilded)
    merge_doubles(mesh)
    bpy.context.collection.objects.link(bpy.data.objects.new(name, mesh))


def merge_doubles(mesh):
    """A ring of radius 0 is one point; its faces become triangles."""
    edit = bmesh.new()
    edit.from_mesh(mesh)
    bmesh.ops.remove_doubles(edit, verts=edit.verts, dist=1e-6)
    edit.to_mesh(mesh)
    edit.free()


def handle(glaze):
    curve = bpy.data.curves.new("handle", "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = 0.055
    curve.bevel_resolution = 6
    curve.resolution_u = 24
    spline = curve.splines.new("BEZIER")
    spline.bezier_points.add(2)
    for point, place in zip(spline.bezier_points, [(0.43, 0, 0.25), (0.85, 0, 0.55), (0.47, 0, 0.82)]):
        point.co = place
        point.handle_left_type = point.handle_right_type = "AUTO"
    curve.materials.append(glaze)
    bpy.context.collection.objects.link(bpy.data.objects.new("handle", curve))


bpy.ops.object.select_all(action="SELECT")
bpy.ops.object.delete()
glaze = material("glaze", (1, 1, 1), 0.25, picture=waves())
plain = material("plain", (0.05, 0.22, 0.35), 0.25)
gold = material("gold", (1.0, 0.77, 0.34), 0.2, metallic=1)
coffee = material("coffee", (0.06, 0.025, 0.01), 0.05)
lathe("cup", [(0, 0.02), (0.3, 0.02), (0.32, 0.06), (0.36, 0.1), (0.45, 0.3), (0.5, 0.6), (0.52, 1), (0.505, 1.015),
              (0.49, 1), (0.47, 0.6), (0.42, 0.3), (0.3, 0.12), (0, 0.1)], glaze, gold, rim={6, 7})
lathe("coffee", [(0.485, 0.9), (0, 0.9)], coffee)
lathe("saucer", [(0, -0.02), (0.4, -0.02), (0.5, 0), (0.95, 0.12), (0.965, 0.135), (0.95, 0.15), (0.5, 0.03), (0.35, 0.02),
                 (0, 0.02)], plain, gold, rim={3, 4})
handle(plain)
bpy.ops.wm.obj_export(filepath="mug.obj", export_pbr_extensions=True, export_triangulated_mesh=True, path_mode="RELATIVE")
