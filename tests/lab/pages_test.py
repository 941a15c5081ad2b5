#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tools/lab/pages.py and its tables, on made-up data and on the pages themselves."""
import os
import pathlib
import sys
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/lab"))
import pages  # noqa: E402
from figures import bench, table  # noqa: E402


class Tables(unittest.TestCase):
    def test_rows_and_columns_are_chosen_and_numbers_stand_at_the_right(self):
        made = table.Table(["what", "n", "why"], [["a", 1, "x"], ["b", 22, "y"]])
        self.assertEqual(made.selected("b ", ["what", "n"]).markdown(), "| what | n |\n|---|---:|\n| b | 22 |\n")
        self.assertEqual(made.markdown().split("\n")[1], "|---|---:|---|")

    def test_a_combination_that_was_not_measured_is_a_dash(self):
        row = {"layout": "chord", "core": "m4", "mode": "linear", "texel": "luma8", "span": 16, "view": "generic",
               "instructions_per_pixel": 123.46, "psnr_db": None, "worst_pixel": 0}
        made = bench.Tradeoff({"rows": [row], "parts": []})
        self.assertEqual(made.cost().rows, [["linear luma8", "–", "123"]])

    def test_rows_come_one_by_one_or_as_lists(self):
        self.assertEqual(table.rows_of('{"a": 1}\n[{"a": 2}, {"a": 3}] {"a": 4}\n'), [{"a": k} for k in range(1, 5)])

    def test_data_begin_with_the_commit_that_they_are_of(self):
        with mock.patch.dict(os.environ, LUMI_MEASURED="0123456789"), \
                mock.patch.object(pathlib.Path, "write_text") as write:
            table.save("made_up", {"commit": "another", "rows": []})
        self.assertIn('{\n "commit": "0123456789",\n', write.call_args.args[0])


class Pages(unittest.TestCase):
    def test_a_page_that_differs_from_its_data_is_named(self):
        data = table.load("devices")
        row, *others = data["memory"]
        changed = {**data, "memory": [{**row, "ram_bytes": row["ram_bytes"] + 1}, *others]}
        with mock.patch.dict(table.shown, devices=changed):
            said = "\n".join(pages.faults())
        self.assertIn("docs/firmware.md", said)
        self.assertNotIn("README.md", said)
        self.assertNotIn("two commits", said)

    def test_data_of_two_commits_are_named(self):
        with mock.patch.dict(table.shown, devices={**table.load("devices"), "commit": "another"}):
            self.assertIn("data of two commits", "\n".join(pages.faults()))

    def test_a_value_is_found_in_data_and_in_sources(self):
        self.assertEqual(pages.value("docs/log/data/devices.json", "memory.0.cpu"), table.load("devices")["memory"][0]["cpu"])
        self.assertRegex(pages.value("tests/platform/cross_tests.cmake", r"LUMI_SPAN_STACK_LIMIT (\d+)"), r"^\d,\d{3}$")

    def test_every_table_of_a_page_is_one_that_data_make(self):
        for page in pages.pages():
            for _, order, _ in pages.BLOCK.findall(page.read_text(encoding="utf-8")):
                self.assertIn(order.split(";")[0].strip(), pages.TABLES, page)


if __name__ == "__main__":
    unittest.main()
