# SPDX-License-Identifier: MIT
"""libraries.py PROGRAM

Prints the Debian packages of the shared objects that a program and its modules load on this machine, with their licences,
as rows of JSON: `tools/lab/pages.py put licences rows` takes them."""
import json
import pathlib
import re
import subprocess
import sys


def lines_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()


def loaded_by(program):
    """{object's name: file}: what the loader takes for `program`, what those libraries need included."""
    found = {}
    for line in lines_of("ldd", program):
        match = re.match(r"\s*(\S+) => (/\S+)|\s*(/\S+) \(", line)
        if match:
            name = match[1] or pathlib.Path(match[3]).name
            found[name] = pathlib.Path(match[2] or match[3]).resolve()
    return found


def package_of(file):
    """The Debian package of a file; dpkg knows the folders of a merged /usr by their old names, too."""
    for name in (file, pathlib.Path("/") / file.relative_to("/usr") if file.is_relative_to("/usr") else file):
        found = subprocess.run(["dpkg-query", "--search", name], capture_output=True, text=True).stdout
        if found:
            return found.split(":", 1)[0]
    raise FileNotFoundError(f"no Debian package holds {file}")


MODULES = ["lumi_openvdb.so"]  # beside a program, which loads them when they are needed


def packages_of(program, modules=MODULES):
    """{package: names of the objects of it that `program` and those of its modules that are there load}"""
    paths = [path for path in (pathlib.Path(program).parent / name for name in modules) if path.exists()]
    objects = {name: file for part in [program, *paths] for name, file in loaded_by(part).items()}
    packages = {}
    for name, file in sorted(objects.items()):
        packages.setdefault(package_of(file), []).append(name)
    return packages


def licences_of(package):
    """(licence of most files, licences of all files) by the short names of Debian's copyright file, whose parts also cover
    what only builds the library. An older file has no such names: then where it lies, and none."""
    path = pathlib.Path(f"/usr/share/doc/{package}/copyright")
    text = path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""
    if "copyright-format" not in text[:500]:
        return f"see {path}", []
    paragraphs = [dict(re.findall(r"^(Files|License): *(.*?) *$", p, re.MULTILINE)) for p in re.split(r"\n\s*\n", text)]
    of_files = [(p["Files"], p["License"]) for p in paragraphs if p.get("Files") is not None and p.get("License")]
    main = next((licence for files, licence in of_files if files.split()[:1] == ["*"]), f"see {path}")
    return main, sorted({licence for _, licence in of_files}, key=str.lower)


def rows(program):
    """Rows of the page of licences: each package, and which of the program's files load it."""
    parts = {path.name: loaded_by(path) for path in
             [pathlib.Path(program), *(pathlib.Path(program).parent / name for name in MODULES)]}
    return [{"package": name, "licence": licences_of(name)[0],
             "by": [part for part, loaded in parts.items() if set(objects) & set(loaded)]}
            for name, objects in sorted(packages_of(program).items())]


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    missing = [name for name in MODULES if not (pathlib.Path(sys.argv[1]).parent / name).exists()]
    if missing:
        sys.exit(f"libraries.py: {', '.join(missing)} is not beside {sys.argv[1]}: install libopenvdb-dev, and build anew")
    for row in rows(sys.argv[1]):
        print(json.dumps(row))
