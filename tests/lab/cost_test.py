#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""cost_model.py --fit: costs that made-up counts have, and the costs of the header that it leaves alone."""
import pathlib
import re
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/lab"))
try:
    from proof import cost_fit, cost_model
except ImportError as error:  # numpy
    print(error)
    sys.exit(77)


def frames(costs):
    """Chord frames of two kinds of work, of every mode and texel format."""
    return [{"field": f"{k}", "core": core, "mode": mode, "texel": texel, "span": span, "setup": 5 * k * scale,
             "counted": (5 * k + costs["checked_row"] * (20 - k)) * scale,
             "counts": {"image_px": k * scale, "checked_row": (20 - k) * scale, **dict.fromkeys(
                 {*cost_fit.SETUP, *cost_fit.INNER_OF["nearest"], *cost_fit.HITS, *cost_fit.LATTICE} - {"image_px", "checked_row"}, 0)}}
            for core in cost_model.CORES for mode in cost_fit.CHORD_MODES for texel in cost_fit.TEXELS for span in (0, 8)
            for k in range(1, 20) for scale in (1, 3)]


class Fit(unittest.TestCase):
    def test_costs_of_work_are_found_again(self):
        rows = [row for row in frames({"checked_row": 7}) if row["core"] == "m4"]
        for mode in cost_fit.by_span_mode(rows):
            for costs in mode:
                self.assertAlmostEqual(costs["image_px"], 5)
                self.assertAlmostEqual(costs["checked_row"], 7)

    def test_the_costs_of_the_other_layout_stay_as_they_are(self):
        def array(text, name):
            return re.search(rf" {name}\[.*?;", text, re.DOTALL)[0]

        before = cost_model.COSTS.read_text()
        after = cost_fit.renewed(before, "chord", frames({"checked_row": 7}))
        self.assertEqual(array(before, "kSurfaceCosts"), array(after, "kSurfaceCosts"))
        for name in ("kExactCosts", "kSpanCosts"):
            self.assertNotEqual(array(before, name), array(after, name))
            self.assertEqual(array(before, name).count("{"), array(after, name).count("{"))
        self.assertEqual(cost_fit.renewed(after, "chord", frames({"checked_row": 7})), after)


if __name__ == "__main__":
    unittest.main()
