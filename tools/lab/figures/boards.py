# SPDX-License-Identifier: MIT
"""Examples on emulated devices, memory of README's firmware, what the `lumi` command loads, and pictures of the project's
scenes (tools/lab/pictures.sh)."""
from .table import NONE, Table, decimal, load, or_none


def devices():
    def kilobytes(row, key):
        return f"{row[key] / 1e3:.1f} kB" if key in row else NONE
    return Table.of(
        ["`platform/`", "glue lines", "flash", "RAM", "stack", "frames a second", "with flash misses", "counted by",
         "same bits"], load("devices")["rows"],
        lambda row: [f"`{row['source']}`", row["glue_lines"], kilobytes(row, "flash_bytes"), kilobytes(row, "ram_bytes"),
                     f"{row['stack']} B" if "stack" in row else NONE, or_none(row.get("fps")),
                     or_none(row.get("fps_with_misses")), row["counted_by"], row["same_bits"]])


def memory():
    return Table.of(["core", "RAM: view and stripe", "stack of `open`", "stack of `look` and `draw`"],
                    load("devices")["memory"],
                    lambda row: [row[key] for key in ("cpu", "ram_bytes", "open_stack_bytes", "draw_stack_bytes")])


def licences():
    return Table.of(["package", "licence of most files", "loaded by"], load("licences")["rows"], lambda row: [
        row["package"], row["licence"], ", ".join(f"`{name}`" for name in row["by"])])


def pictures():
    def cells(row):
        return [f"`{row['scene']}`, {row['orbit']}", f"![traced](img/{row['picture']}.png)",
                f"![drawn](img/{row['picture']}-drawn.png)", f"{row['layout']}, {row['bytes'] / 1000:.0f} kB",
                f"{decimal(row['psnr_db'])} dB"]
    columns = ["scene, `--orbit`", "path-traced", "drawn from flash", "field", "likeness"]
    return Table.of(columns, load("scenes")["pictures"], cells)
