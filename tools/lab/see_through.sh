#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/see_through.sh [--scene NAME]... [--paths P] [--fit SIZE]
# Bakes scenes that one sees through (tools/lab/scenes/write_see_through.py says which) as surface fields, each also without
# its glass, and reports both: reference, picture, error and dB of 12 views, in build/see-through/NAME.html. Ends with a
# table. --scene: that one alone (may be repeated). --paths: light paths a texel [60]. --fit: bytes of a field [150kB].
# With LUMI in the environment that program is taken as it is, and nothing is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=(faint pane bottle car watch)
paths=60
fit=150kB
work=$root/build/see-through

measure() {
  local name=$1 scene=$work/scenes/$1.json
  "$lumi" bake "$scene" -o "$work/$name.lumi" --layout surface --fit "$fit" --paths "$paths" >"$work/$name.txt"
  "$lumi" report "$scene" "$work/$name.lumi" --cache "$work/cache" -o "$work/$name.html" --json \
    >"$work/$name.json"
}

mean_db() {
  python3 -c 'import json, sys
for field in json.load(open(sys.argv[1]))["fields"]: print("%.2f" % field["psnr_db"])' "$1"
}

main() {
  local scene bare
  write_scenes write_see_through.py "$@"
  for scene in "${scenes[@]}"; do
    run_step "$scene" measure "$scene"
    if [[ $scene != faint ]]; then run_step "$scene without glass" measure "$scene-bare"; fi
  done
  printf '%-8s %8s %14s\n' scene dB "without glass"
  for scene in "${scenes[@]}"; do
    bare=-
    if [[ $scene != faint ]]; then bare=$(mean_db "$work/$scene-bare.json"); fi
    printf '%-8s %8s %14s\n' "$scene" "$(mean_db "$work/$scene.json")" "$bare"
  done
}

main "$@"
