#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws small inputs of the kinds that people report, and compares each picture and message with what is right.

cases.py FOLDER [--lumi PROGRAM]

FOLDER holds a folder for each case, with a.obj or a.json, or the cases themselves as models, and RIGHT.txt, which says
in words what a user calls right. RIGHT and RIGHT_MODELS below say it in pictures: the picture of another text, or of
another case, that surely means the same, or colours at places of the picture. A case that is right has a picture of at least
LEAST_PSNR dB, where a picture is stated, and says what is stated."""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/lab/devices"))
from picture import read_png  # noqa: E402

LEAST_PSNR = 30
VIEW = ["--size", "96x96", "--spp", "64", "--orbit", "30,20,3"]


class Like:
    """The picture of another case, or of this case with other texts, or with all positions moved."""

    def __init__(self, case=None, move=None, **files):
        self.case, self.move, self.files = case, move, {name.replace("_", "."): text for name, text in files.items()}

    def folder(self, cases, name, scratch):
        source = cases / (self.case or name)
        folder = scratch / "right"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(source, folder)
        for file, text in self.files.items():
            (folder / file).write_text(text)
        if self.move:
            path = folder / "a.obj"
            path.write_text("\n".join(map(self.moved, path.read_text().splitlines())) + "\n")
        return folder

    def moved(self, line):
        words = line.split()
        if not words or words[0] != "v":
            return line
        return "v " + " ".join(repr(float(c) - m) for c, m in zip(words[1:4], self.move))


def mtl(*lines, name="t"):
    return "\n".join([f"newmtl {name}", *lines]) + "\n"


class Shows:
    """Colours at places of the case's own picture: (x, y) in shares of its size, then the least and most of them."""

    def __init__(self, **places):
        self.places = list(places.values())

    def fault(self, picture):
        pixel = picture_of(picture)
        for (x, y), low, high in self.places:
            seen = pixel(x, y)
            if not all(a <= b <= c for a, b, c in zip(low, seen, high)):
                return f"shows {seen} at {x}, {y}"
        return ""


def picture_of(path):
    """Colour over black at a place of a PNG of 8-bit RGB or RGBA."""
    width, height, count, pixels = read_png(str(path))

    def pixel(x, y):
        first = (int(y * height) * width + int(x * width)) * count
        colour = pixels[first:first + count]
        return tuple(c * (colour[3] if count == 4 else 255) // 255 for c in colour[:3])
    return pixel


PLAIN = Like("plain")
RED = Like("mtllib_dotslash")
CHEQUERED = Like("map_spaces")
DOUBLED = Like("map_options")
WHITE = mtl("Kd 1 1 1")
MISSING = r"is missing|not defined"

# By kind: case, its picture or None, and what has to be said or None.
RIGHT = {
    "one odd line refuses a whole file": [
        ("face_two_vertices", PLAIN, "fewer than three"), ("face_one_vertex", PLAIN, "fewer than three"),
        ("face_empty", PLAIN, "fewer than three"), ("only_edges_and_faces", PLAIN, "fewer than three"),
        ("face_300_corners", None, "^$"), ("vt_later", CHEQUERED, None), ("forward_index", PLAIN, None),
        ("d_halo", Like(a_mtl=mtl("Kd 0.8 0.05 0.05", "d 0.9", name="m")), "-halo"), ("kd_xyz", PLAIN, "xyz"),
        ("kd_spectral", PLAIN, "spectral"), ("fo_face", PLAIN, None), ("upper_case", PLAIN, "capital"),
    ],
    "alpha only in map_Kd": [
        ("map_kd_alpha_only", Like("map_d_same"), None), ("map_d_same", None, "^$"),
        ("tex_pngga", None, "^$"), ("tex_pngpal_trns", None, "^$"),
    ],
    "options of pictures": [
        ("map_s_one_number", Like(a_mtl=mtl("Kd 1 1 1", "map_Kd -s 2 1 1 c.png")), None),
        ("map_s_two_numbers", DOUBLED, None),
        ("map_o_one_number", Like(a_mtl=mtl("Kd 1 1 1", "map_Kd -o 0.5 0 0 c.png")), None),
        ("map_bump_options_mm", CHEQUERED, None), ("map_options_texres", CHEQUERED, None),
        ("map_s_negative", None, "^$"), ("map_bm_name_digits", None, "^$"), ("map_empty", Like(a_mtl=WHITE), None),
    ],
    "`Kd` missing, or black beside a picture": [
        ("kd_missing", PLAIN, None), ("kd_empty_newmtl", PLAIN, None), ("kd_map_only_ke", PLAIN, None),
        ("kd_missing_pbr", Like(a_mtl=mtl("Kd 0.6 0.6 0.6", "Pr 0.5", "Pm 0", name="m")), None),
        ("kd_missing_with_map", CHEQUERED, None), ("kd_black_with_map", CHEQUERED, None),
        ("kd_one_number", None, "^$"),
        ("blender_map_missing_no_kd", None, "gone.png"), ("blender_map_tga_no_kd", None, "(?i)tga"),
    ],
    "silently dropped": [
        ("vertex_colours_255", Like(a_mtl=mtl("Kd 1 0 0")), None), ("map_lowercase_kw", CHEQUERED, "map_kd"),
        ("mtl_unknown_words", None, r"(?s)(?=.*kd)(?=.*roughness)"), ("mixed_lines", PLAIN, "not drawn"),
        ("lines_among", PLAIN, "2 line"), ("surf_bezier", PLAIN, "free-form"), ("vt_partial", None, "texture coord"),
        ("lines_only", None, "lines and points.*no surface"), ("points_only", None, "points.*no surface"),
        ("curve_only", None, "free-form"),
    ],
    "backslashes": [
        ("comment_backslash", Like(a_obj=None), None), ("mtl_name_backslash", RED, None),
        ("map_backslash_rel", CHEQUERED, None), ("crlf_continuation", None, None),
    ],
    "coordinates far from the origin, tiny or huge": [
        ("far_georef_sphere", "centred", None), ("far_georef_sphere_rd", "centred", None), ("far_1e6", PLAIN, None),
        ("far_1e7_fine", PLAIN, None), ("big_1e12", PLAIN, None), ("tiny_1e-7", PLAIN, None), ("millimetre", PLAIN, None),
        ("unused_far_vertex", PLAIN, None),
    ],
    "a scene that shows nothing": [
        ("big_ground", None, "(?i)tiny|share|fills"), ("stray_far_triangle", None, "(?i)tiny|share|fills"),
        ("black_scene", None, "no light"), ("black_env_no_lamp", None, "no light"),
        ("lamp_inside_box", None, "closed|no lamp"), ("d_zero", None, "transparent|invisible"),
        ("tr_one", None, "invisible|transparent"), ("empty", None, "no face"),
        ("dup_faces_two_colours", None, "coincid"), ("glass_open_pane", None, "(?i)closed|open"),
    ],
    "letter case, base name": [
        ("mtl_case", RED, "letter case"), ("map_case", CHEQUERED, "c.png"),
        ("mtllib_missing_but_same_name", RED, MISSING), ("mtllib_path", RED, None), ("mtl_missing", None, "gone.mtl"),
    ],
    "names": [
        ("mtl_bom", RED, None), ("mtl_latin1", None, "^$"), ("mtl_name_spaces", RED, None), ("mtl_name_utf8", RED, None),
        ("names_quoted_spaces", RED, None), ("map_quotes", CHEQUERED, None), ("map_spaces", None, "^$"),
        ("map_missing", None, MISSING), ("map_abs_win_missing", None, "wood.jpg"), ("map_url", None, MISSING),
        ("map_win_path", CHEQUERED, None), ("map_tga", None, "PNG"), ("mtllib_after_use", RED, None),
        ("mtllib_two", Like("mtllib_two_lines"), None), ("mtl_dup_names_same", RED, r"^[^\n]*$"),
        ("usemtl_persists_over_g", RED, None), ("usemtl_unknown", PLAIN, MISSING), ("obj_utf16", None, "UTF-16"),
        ("tex_webp_named_png", None, "(?i)webp"),
    ],
    "same as plain": [
        ("dup_faces", PLAIN, None), ("dup_faces_backside", PLAIN, None), ("neg_interleaved", PLAIN, None),
        ("tabs_spaces", PLAIN, None), ("vertex_w", PLAIN, None), ("vn_zero", PLAIN, None), ("vn_inverted", PLAIN, None),
        ("winding_inverted", PLAIN, None), ("ks_one_kd_one", None, "^$"), ("tr_and_d", RED, None),
        ("kd_above_1", None, "out of range"), ("kd_255", None, "out of range"),
    ],
    "refused with its line": [
        ("decimal_comma", None, ":[0-9]+: .*,"), ("index_beyond", None, ":[0-9]+: "), ("index_zero", None, ":[0-9]+: "),
        ("inf_vertex", None, ":[0-9]+: "), ("nan_vertex", None, ":[0-9]+: "), ("trailing_comma_vn", None, ":[0-9]+: "),
        ("uv_nan", None, ":[0-9]+: "), ("vn_index_beyond", None, ":[0-9]+: "), ("vt_index_beyond", None, ":[0-9]+: "),
    ],
}


# Cases that are models, not folders.
ANY, DARK = (255, 255, 255), (60, 60, 60)
RIGHT_MODELS = {
    "poses": [
        ("skin.gltf", Shows(low=((0.75, 0.58), (99, 99, 99), ANY), below=((0.4, 0.8), (0, 0, 0), (9, 9, 9))), "^$")],
    "glass": [
        ("t_plain.gltf", None, "^$"), ("t_mr1.gltf", Like("t_plain.gltf"), "^$"),
        ("t_mr.gltf", Like("t_plain.gltf"), "^$"),
        ("tt_col.gltf", Shows(red=((0.35, 0.4), (90, 0, 0), (255, 110, 110))), "^$"),
        ("pane_tint.gltf", Shows(box=((0.62, 0.43), (60, 40, 10), (150, 120, 90))), "^$"),
        ("pane_dark.gltf", Shows(pane=((0.4, 0.4), (5, 5, 5), DARK), box=((0.62, 0.43), (5, 5, 5), DARK)), "^$"),
    ],
    "soft alpha": [("shadow_narrow.gltf", None, "^$"), ("shadow_wide.gltf", None, "^$")],
    "old materials": [("sg_num.gltf", None, "^$"), ("sg_tex.gltf", Like("sg_num.gltf"), "^$")],
    "normal maps on metal": [
        ("nm_metal.gltf", Shows(ring=((0.36, 0.5), (90, 80, 40), ANY), low=((0.5, 0.72), (90, 80, 40), ANY)), "^$"),
        ("nm_metal_r5.gltf", Shows(ring=((0.36, 0.5), (90, 80, 40), ANY)), "^$"),
    ],
    "light that goes off": [
        ("glowplate_1.gltf",
         Shows(box=((0.45, 0.35), (120, 50, 20), ANY), plate=((0.5, 0.62), (250, 250, 250), ANY)), "^$")],
    "OBJ of other programs": [
        ("ml.obj", Shows(face=((0.5, 0.5), (60, 60, 60), ANY)), "opaque"), ("slash1.obj", None, "^$")],
    "a file that is missing": [("nobin.gltf", None, "put scene.bin beside it")],
}


def centre_of(path):
    points = [list(map(float, line.split()[1:4])) for line in path.read_text().splitlines() if line.startswith("v ")]
    return [(min(axis) + max(axis)) / 2 for axis in zip(*points)]


def resolved(picture, cases, name):
    """The rare pictures that need the case's own text."""
    text = cases / name / "a.obj"
    if picture == "centred":
        return Like(move=centre_of(text))
    if isinstance(picture, Like) and "a.obj" in picture.files and picture.files["a.obj"] is None:
        lines = text.read_text().splitlines()
        return Like(a_obj="\n".join(line for line in lines if not line.startswith("#")) + "\n")
    if name == "vertex_colours_255":
        lines = [" ".join(line.split()[:4]) if line.startswith("v ") else line for line in text.read_text().splitlines()]
        return Like(a_obj="mtllib a.mtl\nusemtl t\n" + "\n".join(lines) + "\n", a_mtl=mtl("Kd 1 0 0"))
    return picture


class Lumi:
    def __init__(self, program):
        self.program = program

    def draw(self, folder, picture):
        """Returns the messages without the folder's name; the picture is not there if it refuses."""
        picture.unlink(missing_ok=True)
        scene = folder if folder.is_file() else folder / ("a.json" if (folder / "a.json").exists() else "a.obj")
        run = subprocess.run([self.program, "reference", scene, "-o", picture, *VIEW], capture_output=True, text=True,
                             timeout=300, check=False)
        told = "lumi: warning: " if run.returncode == 0 else "lumi: "  # notes say what is chosen, not what is wrong
        lines = [line for line in run.stderr.splitlines() if line.startswith(told)]
        return "\n".join(lines).replace(str(folder if folder.is_dir() else folder.parent) + "/", "")

    def psnr(self, a, b):
        run = subprocess.run([self.program, "compare", a, b], capture_output=True, text=True, check=False)
        found = re.search(r"(inf|[0-9.]+) dB", run.stdout)
        return float(found.group(1)) if found else 0.0


def fault_of(lumi, cases, scratch, name, picture, said):
    """Says how the case is wrong, or returns nothing."""
    mine, right = scratch / "mine.png", scratch / "right.png"
    words = lumi.draw(cases / name, mine)
    if said and not re.search(said, words):
        return f"says '{words or 'nothing'}'"
    picture = resolved(picture, cases, name) if (cases / name).is_dir() else picture
    if not picture:
        return "" if words or mine.exists() else "no picture"
    if not mine.exists():
        return f"refused: {words}"
    if isinstance(picture, Shows):
        return picture.fault(mine)
    lumi.draw(cases / picture.case if (cases / name).is_file() else picture.folder(cases, name, scratch), right)
    psnr = lumi.psnr(mine, right)
    return "" if psnr >= LEAST_PSNR else f"{psnr:.1f} dB"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--lumi", default=str(ROOT / "build/release/tools/lumi"))
    options = parser.parse_args()
    counts, lumi = {}, Lumi(options.lumi)
    right = RIGHT if (options.folder / "plain").is_dir() else RIGHT_MODELS
    with tempfile.TemporaryDirectory() as scratch:
        for kind, cases in right.items():
            faults = {c[0]: fault_of(lumi, options.folder, Path(scratch), *c) for c in cases}
            counts[kind] = sum(not fault for fault in faults.values())
            print(f"{kind}: {counts[kind]} of {len(cases)}")
            for name, fault in faults.items():
                if fault:
                    print(f"  {name}: {fault}")
    print(f"{sum(counts.values())} of {sum(map(len, right.values()))} are right")
    return 0


if __name__ == "__main__":
    sys.exit(main())
