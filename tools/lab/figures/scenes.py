# SPDX-License-Identifier: MIT
"""Pictures of the project's scenes, path-traced and drawn (tools/lab/pictures.sh)."""
from .table import Table, decimal, load


def pictures():
    def cells(row):
        return [f"`{row['scene']}`, {row['orbit']}", f"![traced](img/{row['picture']}.png)",
                f"![drawn](img/{row['picture']}-drawn.png)", f"{row['layout']}, {row['bytes'] / 1000:.0f} kB",
                f"{decimal(row['psnr_db'])} dB"]
    columns = ["scene, `--orbit`", "path-traced", "drawn from flash", "field", "likeness"]
    return Table.of(columns, load("scenes")["pictures"], cells)
