# SPDX-License-Identifier: MIT
"""Where the project lives and who keeps it: core/PROJECT.json, from which every manifest of a release is written."""
import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORE = ROOT / "core"
PROJECT = json.loads((CORE / "PROJECT.json").read_text())
DESCRIPTION = "Path-traced objects, drawn from flash by integers"


def version():
    return (CORE / "VERSION").read_text().strip()


def placeholders():
    """Names of what the owner has not filled in yet."""
    return [name for name, value in PROJECT.items() if "example" in value.lower()]


def person():
    return f"{PROJECT['maintainer']} <{PROJECT['email']}>"
