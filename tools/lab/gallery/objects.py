#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""objects.py OUT: writes the scenes of the gallery into a folder, but for the skull's CT. The same bytes on every run."""
import json
import pathlib
import shutil
import sys

import parts
import car
import potion
import watch
from mesh import Obj

SCENES = pathlib.Path(__file__).resolve().parents[3] / "baker/scenes"

# Bone is pale all over: a lamp from one side gives it its form. 226 is bone in the CT's units.
SKULL = {
    "objects": [{"volume": "skull.nii.gz", "iso": 226, "pieces": 0.2}], "up": "z",
    "environment": {"zenith": [0.55, 0.53, 0.5], "horizon": [0.26, 0.25, 0.24], "nadir": [0.12, 0.11, 0.1]},
    "lights": [{"type": "directional", "direction": [0.55, -0.6, -0.62], "irradiance": [2.2, 1.95, 1.6]}],
    "exposure": 0, "tone": "aces"}


def main(out):
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("product.obj", "product.mtl", "product_dial.png"):
        shutil.copy(SCENES / name, folder / name)
    (folder / "clock.json").write_text(parts.scene([{"obj": "product.obj"}]))
    (folder / "skull.json").write_text(json.dumps(SKULL, indent=1) + "\n")
    for model in (watch, car, potion):
        for name, value in model.files().items():
            data = value.text() if isinstance(value, Obj) else value
            (folder / name).write_bytes(data if isinstance(data, bytes) else data.encode("ascii"))


if __name__ == "__main__":
    main(sys.argv[1])
