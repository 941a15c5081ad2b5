#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tools/lab/pages.py and its tables, on made-up data and on the pages themselves."""
import pathlib
import sys
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/lab"))
import pages  # noqa: E402
from figures import scripts, table, tradeoff  # noqa: E402


class Tables(unittest.TestCase):
    def test_rows_and_columns_are_chosen_and_numbers_stand_at_the_right(self):
        made = table.Table(["what", "n", "why"], [["a", 1, "x"], ["b", 22, "y"]])
        self.assertEqual(made.selected("b ", ["what", "n"]).markdown(), "| what | n |\n|---|---:|\n| b | 22 |\n")
        self.assertEqual(made.markdown().split("\n")[1], "|---|---:|---|")

    def test_a_combination_that_was_not_measured_is_a_dash(self):
        row = {"layout": "chord", "core": "m4", "mode": "linear", "texel": "luma8", "span": 16, "view": "generic",
               "instructions_per_pixel": 123.46, "psnr_db": None, "worst_pixel": 0}
        made = tradeoff.Tradeoff({"rows": [row], "parts": []})
        self.assertEqual(made.cost().rows, [["linear luma8", "–", "–", "123", "–"]])

    def test_rows_come_one_by_one_or_as_lists(self):
        self.assertEqual(scripts.rows_of('{"a": 1}\n[{"a": 2}, {"a": 3}] {"a": 4}\n'), [{"a": k} for k in range(1, 5)])

    def test_fuzzing_adds_up_and_keeps_the_last_edges(self):
        saved = {}
        with mock.patch.dict(table.shown, tests={"fuzzing": [{"target": "obj", "executions": 5, "cpu_s": 60, "edges": 7}]}), \
                mock.patch.object(scripts, "save", saved.__setitem__):
            scripts.add_fuzzing('{"target": "obj", "executions": 6, "cpu_s": 30, "edges": 9}')
        self.assertEqual(saved["tests"]["fuzzing"], [{"target": "obj", "executions": 11, "cpu_s": 90, "edges": 9}])


class Pages(unittest.TestCase):
    def test_a_page_that_differs_from_its_data_is_named(self):
        data = table.load("tests")
        soak = [{**data["soak"][0], "frames": data["soak"][0]["frames"] + 1}]
        with mock.patch.dict(table.shown, tests={**data, "soak": soak}), self.assertRaises(SystemExit) as stopped:
            pages.write_pages(check=True)
        self.assertIn(": SECURITY.md;", str(stopped.exception))

    def test_a_value_is_found_in_data_and_in_sources(self):
        self.assertEqual(pages.value("docs/log/data/tests.json", "soak.0.cpu"), table.load("tests")["soak"][0]["cpu"])
        self.assertRegex(pages.value("tests/platform/cross_tests.cmake", r"LUMI_SPAN_STACK_LIMIT (\d+)"), r"^\d,\d{3}$")

    def test_every_table_of_a_page_is_one_that_data_make(self):
        for page in pages.pages():
            for _, order, _ in pages.BLOCK.findall(page.read_text(encoding="utf-8")):
                self.assertIn(order.split(";")[0].strip(), pages.TABLES, page)


if __name__ == "__main__":
    unittest.main()
