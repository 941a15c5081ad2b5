#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/skull.sh [--paths P] [--spp S] [SIZE...]
# The skull of docs/log/skull.md: fetches a CT (tools/lab/scenes/fetch_skull.sh), bakes its bone as surface fields, and
# writes that page's figures (by lumi bake: bytes, dB, frames a second) and pictures. --paths: light paths a texel [100].
# --spp: light paths a pixel of the reference picture [128]. SIZE: of fields [250kB 500kB]; pictures show the last one.
# All else lands in build/skull; fields that are there are not made again. With LUMI in the environment that program is
# taken as it is, and nothing is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

sizes=(250kB 500kB)
pictured_view=oblique
declare -A views=([front]='90,5,2.6' [oblique]='45,15,2.6' [side]='0,10,2.6' [below]='120,-50,2.6')
paths=100
spp=128
work=$root/build/skull
scene=$work/skull.json

bake_fields() {
  local size
  for size in "${sizes[@]}"; do
    [[ -f $work/$size.lumi ]] ||
      "$lumi" bake "$scene" -o "$work/$size.lumi" --layout surface --paths "$paths" --fit "$size" | tee "$work/$size.txt"
  done
}

# From several sides; one of them also path-traced.
draw_pictures() {
  local view
  for view in "${!views[@]}"; do
    "$lumi" render "$work/$pictured.lumi" -o "$root/docs/img/skull-$view.png" --orbit "${views[$view]}" >/dev/null
  done
  "$lumi" reference "$scene" -o "$root/docs/img/skull-truth.png" --orbit "${views[$pictured_view]}" --spp "$spp" >/dev/null
}

# What bakes have printed, their progress left out.
write_page() {
  local size
  for size in "${sizes[@]}"; do
    grep --invert-match ' left$' "$work/$size.txt" | sed "s|$work/||" | python3 -c 'import json, sys
print(json.dumps({"size": sys.argv[1], "paths": int(sys.argv[2]), "lines": sys.stdin.read().splitlines()}, ensure_ascii=False))' \
      "$size" "$paths"
  done | put skull bakes
}

main() {
  local chosen=()
  while (($#)); do
    case $1 in
      --paths) paths=${2:?"--paths needs a number"} && shift ;;
      --spp) spp=${2:?"--spp needs a number"} && shift ;;
      --help) help "$0" && exit ;;
      [0-9]*B) chosen+=("$1") ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  if ((${#chosen[@]})); then sizes=("${chosen[@]}"); fi
  pictured=${sizes[-1]}
  mkdir -p "$work"
  [[ -n ${LUMI:-} ]] || run_step "Build" build_lumi
  [[ -f $work/skull.nii.gz ]] || run_step "Fetch the CT" "$root/tools/lab/scenes/fetch_skull.sh" "$work"
  run_step "Bake" bake_fields
  run_step "Draw" draw_pictures
  run_step "Write the page" write_page
  print_step_times
}

main "$@"
