#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lumi-lab bench: what it reads, and one run from source to rows, on fields that are baked at once."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/lab"))
import bench  # noqa: E402
from figures.table import load  # noqa: E402

LINE = "view pole span 8 covered 1000 instructions 123456 setup 23456 stack 640 crc 0badcafe\n"
SURFACE_LINE = ("view generic mode 2x2 covered 1000 instructions 100000 palette 100 vertices 9900 lists 10000 lights 20000 "
                "edges 30000 samples 20000 outlines 4000 resolve 6000 order 0 blends 0 tall 95000 stack 640 ram 48000 halves 25000 crc 0badcafe\n")
CHIPS = ("rp2040", "rp2350", "stm32f4", "stm32h7", "esp32s3", "nrf52840", "stm32u5", "esp32c3")
CHORD_KEYS = {"layout", "core", "mode", "texel", "span", "view", "instructions_per_pixel", "setup", "inner",
              "instructions_per_frame", "covered_pixels", "code_bytes", "stack_bytes", "psnr_db", "psnr_all_db",
              "worst_pixel", *(f"{what}_{chip}" for what in ("lines", "misses") for chip in CHIPS),
              "fps_rp2350", "fps_stm32f4", "fps_esp32s3", "fps_nrf52840", "fps_stm32u5", "fps_esp32c3"}
SURFACE_KEYS = CHORD_KEYS - {"texel", "span", "setup", "inner"} | {"pixel", "ram_bytes", "file", "file_bytes",
                                                                   "triangles", "sha256", *bench.PARTS, "tall", "halves",
                                                                   "fps2_rp2350", "fps2_esp32s3"}


class Lines(unittest.TestCase):
    def test_counts_are_what_the_firmware_writes_and_nothing_else(self):
        counts = bench.parse_counts(LINE + LINE, bench.CHORD_COUNTS)
        self.assertEqual(len(counts), 2)
        self.assertEqual((counts[1]["view"], counts[1]["span"], counts[1]["instructions"], counts[1]["crc"]),
                         ("pole", 8, 123456, 0x0badcafe))
        for wrong in ("error: truncated\n", LINE[:40], LINE.replace("123456", "0"), LINE.replace("1000", "0"), SURFACE_LINE):
            with self.assertRaises(bench.BenchError):
                bench.parse_counts(wrong, bench.CHORD_COUNTS)

    def test_parts_of_surface_frames_add_up(self):
        count = bench.parse_counts(SURFACE_LINE, bench.SURFACE_COUNTS)[0]
        self.assertEqual(sum(count[part] for part in bench.PARTS + bench.SEE_THROUGH_PARTS), count["instructions"])
        self.assertEqual(count["ram"], 48000)
        with self.assertRaises(bench.BenchError):
            bench.parse_counts(LINE, bench.SURFACE_COUNTS)

    def test_a_board_that_draws_other_bits_stops_the_bench(self):
        row = {"core": "m4", "mode": "linear", "texel": "luma8", "span": 8, "view": "pole"}
        frame = {"mode": "linear", "texel": "luma8", "span": 8, "view": "pole", "crc": 7, "psnr_db": 40.0}
        self.assertEqual(bench.with_facts(dict(row), {"crc": 7}, [frame])["psnr_db"], 40.0)
        with self.assertRaises(bench.BenchError):
            bench.with_facts(dict(row), {"crc": 8}, [frame])


    def test_quality_control_expects_no_less_than_what_modes_were_counted_to_cost(self):
        header = (ROOT / "core/include/lumi/quality.h").read_text()
        growth = [int(k) / 16 for k in re.search(r"kGrowth_q4\[\] = {(.*)}", header).group(1).split(",")]
        cost = {(r["core"], r["pixel"], r["view"], r["mode"]): r["instructions_per_pixel"]
                for r in load("tradeoff")["rows"] if r["layout"] == "surface"}
        modes = ("one-sample", "antialiased", "2x2")
        for (core, pixel, view, mode), own in cost.items():
            step = modes.index(mode)
            if step > 0:
                self.assertLessEqual(own / cost[core, pixel, view, modes[step - 1]], growth[step], (core, pixel, view, mode))


# A red square, and a pane over it.
MATERIALS = "newmtl red\nKd 0.8 0.1 0.1\nnewmtl pane\nKd 0.2 0.3 0.3\nd 0.4\n"
PANE = """mtllib pane.mtl
v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0
v -0.5 -0.5 1\nv 0.5 -0.5 1\nv 0.5 0.5 1\nv -0.5 0.5 1
usemtl red\nf 1 2 3 4
usemtl pane\nf 5 6 7 8
"""


def bake_small(scene, field):
    subprocess.run([os.environ["LUMI"], "bake", scene, "-o", field, "--layout", "surface", "--triangles", "200",
                    "--longest-edge", "1", "--texel-density", "8", "--paths", "1"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return field


class WholeRun(unittest.TestCase):
    def rows(self, folder, name, *words):
        path = pathlib.Path(folder) / name
        subprocess.run([os.environ["LUMI_LAB"], "bench", "--core", "m4", "--work", f"{folder}/work", "--json", path, *words],
                       check=True, stdout=subprocess.DEVNULL)
        return json.loads(path.read_text())

    def test_it_builds_runs_and_judges_and_counts_the_same_twice(self):
        words = ["--mode", "linear", "--texel", "luma8", "--span", "0,8", "--view", "generic,pole", "--origins", "100",
                 "--directions", "130", "--spp", "1"]
        with tempfile.TemporaryDirectory() as folder:
            rows = self.rows(folder, "a.json", *words)
            self.assertEqual(rows, self.rows(folder, "b.json", *words))
            self.assertEqual(len(rows), 4)  # two spans of two views
            for row in rows:
                self.assertEqual(set(row), CHORD_KEYS)
                self.assertEqual(row["covered_pixels"], 42272)
                self.assertGreater(row["instructions_per_pixel"], row["setup"])
                self.assertGreaterEqual(row["misses_rp2040"], row["lines_rp2040"])
                self.assertGreater(row["code_bytes"], 1000)
            self.assertGreater(rows[0]["psnr_db"], 60)  # the exact renderer, within rounding

            field = bake_small(ROOT / "baker/scenes/testcard.obj", pathlib.Path(folder) / "small.lumi")
            rows = self.rows(folder, "c.json", "--field", field, "--view", "generic", "--pixel", "rgb565")
            self.assertEqual([row["mode"] for row in rows], bench.SURFACE_MODES)
            for row in rows:
                self.assertEqual(set(row), SURFACE_KEYS)
                self.assertAlmostEqual(sum(row[part] for part in bench.PARTS), row["instructions_per_pixel"], delta=0.1)
                self.assertEqual(row["file_bytes"], field.stat().st_size)
                self.assertGreater(row["fps2_rp2350"], row["fps_rp2350"])
                self.assertLess(row["halves"], row["palette"] + row["vertices"] + row["lists"] + row["lights"])

    def test_it_tells_what_see_through_triangles_take(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "pane.obj"
            scene.write_text(PANE)
            scene.with_suffix(".mtl").write_text(MATERIALS)
            field = bake_small(scene, pathlib.Path(folder) / "pane.lumi")
            rows = self.rows(folder, "a.json", "--field", field, "--view", "generic", "--pixel", "rgb565")
            self.assertEqual([row["mode"] for row in rows], bench.SURFACE_MODES)
            for row in rows:
                parts = sum(row[part] for part in bench.PARTS + bench.SEE_THROUGH_PARTS)
                self.assertAlmostEqual(parts, row["instructions_per_pixel"], delta=0.1)
                self.assertGreater(row["order"], 0)
                self.assertGreater(row["blends"], row["samples"] / 8)  # the pane is a quarter as large, and nearer
                self.assertGreater(row["see_through_patches"], 0)
                self.assertNotIn("fps_rp2350", row)


if __name__ == "__main__":
    unittest.main()
