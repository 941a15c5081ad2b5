#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/scenes/fetch_skull.sh OUT
# The CT of a skull from Debian's package invesalius-examples (unpacked, not installed) as OUT/skull.nii.gz, and its
# scene, OUT/skull.json. Needs apt-get, a network and python3.
set -euo pipefail
out=$(realpath --canonicalize-missing "${1:?"say where to"}")
deb=$(mktemp --directory)
trap 'rm -r "$deb"' EXIT
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
(cd "$deb" && apt-get download --quiet invesalius-examples && dpkg-deb --extract ./*.deb .)
python3 "$here/write_skull.py" "$deb/usr/share/doc/invesalius-examples/examples/Cranium.inv3" "$out"
