#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/failure_scenes.sh [--paths P] [--scene NAME]...
# Bakes scenes that are hard for surface fields (tools/lab/scenes/write_failures.py says which) as `lumi bake` does without
# options, draws turntables beside path-traced ones, and reports them, worst view and worst block included. Everything
# lands in build/failures: NAME-sheet.png, NAME-truth-sheet.png, NAME.html, NAME.json. --scene: that one alone (may be
# repeated). --paths: light paths a texel [100]. Look at the pictures: means hide what is ugly.
# With LUMI in the environment that program is taken as it is, and nothing is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scenes=(wires plant mirror glass mouth terrain curtain)
paths=100
truth=(--spp 32)
view=(--orbit 20,12,3 --size 240x240 --turntable 8)
work=$root/build/failures

show_scene() {
  local name=$1 scene=$work/scenes/$1.json
  "$lumi" bake "$scene" -o "$work/$name.lumi" --paths "$paths" >"$work/$name.txt"
  cat "$work/$name.txt"
  "$lumi" render "$work/$name.lumi" -o "$work/$name.png" "${view[@]}" >/dev/null
  [[ -f $work/$name-truth-sheet.png ]] ||
    "$lumi" reference "$scene" -o "$work/$name-truth.png" "${view[@]}" "${truth[@]}" >/dev/null
  "$lumi" report "$scene" "$work/$name.lumi" "${truth[@]}" --cache "$work/cache" -o "$work/$name.html" \
    --json >"$work/$name.json"
}

main() {
  local scene
  write_scenes write_failures.py "$@"
  for scene in "${scenes[@]}"; do
    run_step "$scene" show_scene "$scene"
  done
  print_step_times
}

main "$@"
