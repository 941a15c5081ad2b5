#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""lumi-lab bench: one run from source to rows, on fields that are baked at once; and what quality control takes of it."""
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

CHIPS = ("rp2040", "rp2350", "stm32f4", "stm32h7", "esp32s3", "nrf52840", "stm32u5", "esp32c3")
CHORD_KEYS = {"layout", "core", "mode", "texel", "span", "view", "instructions_per_pixel", "setup", "inner",
              "instructions_per_frame", "covered_pixels", "code_bytes", "stack_bytes", "psnr_db", "psnr_all_db",
              "worst_pixel"}
SURFACE_KEYS = CHORD_KEYS - {"texel", "span", "setup", "inner"} | {"pixel", "ram_bytes", "file", "file_bytes",
                                                                   "triangles", "sha256", *bench.PARTS, "tall", "halves"}


class Quality(unittest.TestCase):
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


def bake_small(scene, field):
    subprocess.run([os.environ["LUMI"], "bake", scene, "-o", field, "--layout", "surface", "--sky", "gradient", "--triangles", "200",
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
                self.assertEqual(set(row), CHORD_KEYS | {f"misses_{chip}" for chip in CHIPS})
                self.assertEqual(row["covered_pixels"], 42272)
                self.assertGreater(row["instructions_per_pixel"], row["setup"])
                self.assertGreater(row["misses_stm32f4"], 0)
                self.assertGreater(row["code_bytes"], 1000)
            self.assertGreater(rows[0]["psnr_db"], 60)  # the exact renderer, within rounding

            field = bake_small(ROOT / "baker/scenes/testcard.obj", pathlib.Path(folder) / "small.lumi")
            rows = self.rows(folder, "c.json", "--field", field, "--view", "generic", "--pixel", "rgb565")
            self.assertEqual([row["mode"] for row in rows], bench.SURFACE_MODES)
            for row in rows:
                self.assertEqual(set(row), SURFACE_KEYS)
                self.assertAlmostEqual(sum(row[part] for part in bench.PARTS), row["instructions_per_pixel"], delta=0.1)
                self.assertEqual(row["file_bytes"], field.stat().st_size)
                self.assertLess(row["halves"], row["palette"] + row["vertices"] + row["lists"] + row["lights"])


if __name__ == "__main__":
    unittest.main()
