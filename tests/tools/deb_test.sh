#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# deb_test.sh BUILD VERSION FOLDER: makes the Debian package from a build tree, unpacks it into an empty folder, runs the
# command from there, and tries its pages and its completion. lintian, where it is installed, finds nothing.
set -euo pipefail
build=$1 version=$2 folder=$3

rm -rf "$folder"
mkdir -p "$folder"
(cd "$build" && cpack -G DEB -B "$folder/cpack" >"$folder/cpack.log") || { cat "$folder/cpack.log" && exit 1; }
package=$(echo "$folder"/cpack/lumipath_*.deb)
dpkg --info "$package" | tee "$folder/info"
grep --quiet "^ Version: $version\$" "$folder/info"
grep --quiet '^ Depends: .*libembree' "$folder/info"
dpkg --extract "$package" "$folder/root"
[[ $("$folder/root/usr/bin/lumi" --version) == "lumi $version"* ]]
"$folder/root/usr/bin/lumi" view "${BASH_SOURCE[0]%/*}/commands/chord-420e9fe.lumi" -o "$folder/view.html"
test -e "$folder"/root/usr/lib/*/lumi/modules/lumi_openvdb.so || test -e "$folder/root/usr/lib/lumi/modules/lumi_openvdb.so"
gunzip "$folder"/root/usr/share/man/man1/*.gz
"${BASH_SOURCE[0]%/*}/pages_test.sh" "$folder/root/usr/bin/lumi" "$folder/root/usr/share"
if command -v lintian >/dev/null; then
  lintian --allow-root --fail-on error,warning "$package"
else
  echo "lintian is not installed, so not run"
fi
