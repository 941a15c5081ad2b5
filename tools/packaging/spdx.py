# SPDX-License-Identifier: MIT
"""Bills of materials for tools/packaging/release.py: SPDX 2.3 as JSON. One lists core's files with checksums, the same bytes from the
same sources; one lists what the `lumi` command is built from and with and what it loads, as Debian packages of this machine."""
import hashlib
import json
import subprocess

import libraries

CREATED = "2020-01-01T00:00:00Z"  # a time of writing would change the bytes
COPYRIGHT = "The LumiPath for microcontrollers developers"


def reference(name):
    return "SPDXRef-" + "".join(c if c.isalnum() or c in ".-" else "-" for c in name)


def package(name, version, **more):
    return {"SPDXID": reference(name), "name": name, "versionInfo": version, "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False, "licenseConcluded": "NOASSERTION", "licenseDeclared": "NOASSERTION",
            "copyrightText": "NOASSERTION", **more}


def ours(name, version, url, **more):
    return package(name, version, homepage=url, licenseConcluded="MIT", licenseDeclared="MIT",
                   copyrightText=COPYRIGHT, **more)


def file_entry(name, content):
    sums = [{"algorithm": a, "checksumValue": hashlib.new(a, content).hexdigest()} for a in ("sha1", "sha256")]
    for entry in sums:
        entry["algorithm"] = entry["algorithm"].upper()
    return {"SPDXID": reference("File-" + name), "fileName": "./" + name, "checksums": sums,
            "licenseConcluded": "MIT", "licenseInfoInFiles": ["NOASSERTION"], "copyrightText": COPYRIGHT}


def relation(one, kind, other):
    return {"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}


def document(name, url, packages, files, relations):
    body = {"packages": packages, "files": files,
            "relationships": [relation("SPDXRef-DOCUMENT", "DESCRIBES", packages[0]["SPDXID"]), *relations]}
    name_of_these = hashlib.sha256(json.dumps(body, sort_keys=True).encode()).hexdigest()
    head = {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": name,
            "documentNamespace": f"{url}/spdx/{name}-{name_of_these}",
            "creationInfo": {"created": CREATED, "creators": ["Tool: tools/packaging/release.py"]}}
    return (json.dumps({**head, **body}, indent=1) + "\n").encode()


def of_core(files, version, url):
    entries = [file_entry(name, files[name]) for name in sorted(files)]
    code = hashlib.sha1("".join(sorted(e["checksums"][0]["checksumValue"] for e in entries)).encode()).hexdigest()
    core = ours("lumi-core", version, url)
    core.update(filesAnalyzed=True, packageVerificationCode={"packageVerificationCodeValue": code})
    return document(f"lumi-core-{version}", url, [core], entries,
                    [relation(core["SPDXID"], "CONTAINS", e["SPDXID"]) for e in entries])


def debian_package(name):
    """An entry for an installed package, or None."""
    query = ["dpkg-query", "--show", "--showformat=${db:Status-Status}\t${Version}\t${Architecture}\t${Homepage}", name]
    result = subprocess.run(query, capture_output=True, text=True)
    if result.returncode != 0 or not result.stdout.startswith("installed"):
        return None
    _, version, architecture, homepage = result.stdout.split("\t")
    locator = f"pkg:deb/debian/{name}@{version.replace('+', '%2B')}?arch={architecture}"
    main, parts = libraries.licences_of(name)
    licence = f"Most files: {main}." + (f" All files, those that only build it included: {', '.join(parts)}." if parts else "")
    entry = package(name, version, supplier="Organization: Debian", licenseComments=licence, externalRefs=[
        {"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": locator}])
    return {**entry, "homepage": homepage} if homepage else entry


def of_tool(names, program, version, url):
    """`names`: Debian packages that the build takes; those of libraries end with -dev. Missing ones are an error.
    `program`: the command that was built, whose shared objects are listed by the packages that hold them."""
    loaded = libraries.packages_of(program)
    found = {name: debian_package(name) for name in [*names, *(name for name in loaded if name not in names)]}
    missing = [name for name, entry in found.items() if entry is None]
    if missing:
        raise FileNotFoundError(f"these packages are not installed, so their versions are unknown: {' '.join(missing)}")
    tool = ours("lumi", version, url)
    relations = [relation(found[name]["SPDXID"], "BUILD_DEPENDENCY_OF" if is_library(name) else "BUILD_TOOL_OF",
                          tool["SPDXID"]) for name in names]
    for name, objects in loaded.items():
        found[name]["sourceInfo"] = "Loaded: " + ", ".join(objects)
        relations.append(relation(tool["SPDXID"], "DYNAMIC_LINK", found[name]["SPDXID"]))
    return document(f"lumi-{version}", url, [tool, *found.values()], [], relations)


def is_library(name):
    return name.endswith("-dev")
