#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/pictures.sh [readme] [looks] [states] [traced] [drawn] [NAME...]
# Makes pictures of the documents anew, from the scenes of the project; without arguments all of them. readme: those of
# README. looks: the skies of docs/scenes.md. states: one room and one clock in several lights. traced: its scenes with 512 light paths a pixel, a minute each. drawn: the
# same from fields that a bake without options makes, and how like the traced ones they are. NAME: of these alone, such
# as product-front.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

work=${LUMI_WORK:-$root/build/pictures}
scenes=$root/baker/scenes
readme_view=(--orbit 30,20,3 --size 224x224 --background 202428)

# A picture's name, its scene, and where the eye is.
pictures=("product-front product.obj 30,20,3" "product-back product.obj 205,15,3" "product-above product.obj 40,55,3"
  "cornell cornell.obj 180,0,3" "cornell-outside cornell.obj 215,20,3" "testcard testcard.obj 20,25,3"
  "gallery gallery.json 10,25,3" "finishes finishes.json 101,38,3")

# bake_once NAME ARGUMENT...: into build/pictures/NAME.lumi.
bake_once() {
  [[ -f $work/$1.lumi ]] || "$lumi" bake "${@:2}" -o "$work/$1.lumi"
}

trace() {
  "$lumi" reference "$scenes/$2" -o "$root/docs/img/$1.png" --orbit "$3" --size 320x320 --spp 512 >/dev/null
}

# Prints a row.
draw() {
  local truth=$root/docs/img/$1.png drawn=$root/docs/img/$1-drawn.png field=$work/${2%.*}.lumi
  bake_once "${2%.*}" "$scenes/$2" >&2
  "$lumi" render "$field" -o "$drawn" --orbit "$3" --size 320x320 --background black >/dev/null
  "$lumi" compare "$truth" "$drawn" --json >"$work/compared.json"
  "$lumi" inspect "$field" --json >"$work/inspected.json"
  python3 -c 'import json, sys
compared, inspected = (json.load(open(path)) for path in sys.argv[4:])
print(json.dumps({"picture": sys.argv[1], "scene": sys.argv[2], "orbit": sys.argv[3], "layout": inspected["layout"],
                  "bytes": inspected["bytes"], "psnr_db": compared["psnr_db"], "ssim": compared["ssim"]}))' \
    "$1" "$2" "$3" "$work/compared.json" "$work/inspected.json" | tee -a "$work/rows.json"
}

# The surface field that a bake without options makes, whose second hand runs, and the chord field.
draw_readme() {
  bake_once clock "$scenes/clock.json"
  bake_once chord "$scenes/product.obj" --layout chord
  "$lumi" render "$work/clock.lumi" -o "$root/docs/img/readme-surface.webp" --turntable 36 "${readme_view[@]}" \
    --part second_hand=0..720 --part minute_hand=57.6 --part hour_hand=304.8 >/dev/null
  "$lumi" render "$work/chord.lumi" -o "$root/docs/img/readme-chord.png" "${readme_view[@]}" >/dev/null
  "$lumi" reference "$scenes/product.obj" -o "$root/docs/img/readme-reference.png" --spp 256 "${readme_view[@]}" >/dev/null
}

draw_looks() {
  local sky
  for sky in studio gradient overcast evening; do
    "$lumi" reference "$scenes/product.obj" -o "$root/docs/img/look-$sky.png" --sky "$sky" --spp 512 "${readme_view[@]}" \
      >/dev/null
  done
}

# draw_state NAME FIELD ORBIT ARGUMENT...
draw_state() {
  "$lumi" render "$work/$2.lumi" -o "$root/docs/img/state-$1.png" --orbit "$3" --size 176x176 --background 202428 \
    "${@:4}" >/dev/null
}

draw_states() {
  bake_once room "$scenes/cornell.obj" --sky overcast --state lamp --state sky --fit 250kB --paths 100
  bake_once ring "$scenes/product.obj" --state glow --fit 250kB
  draw_state day room 180,2,2.5 --state lamp=0
  draw_state dusk room 180,2,2.5 --state sky=0.2,0.25,0.4
  draw_state night room 180,2,2.5 --state sky=0 --state lamp=0.6
  draw_state ring ring 30,20,3 --state base=0.08 --state glow=1,0.02,0.3
}

main() {
  if [[ ${1:-} == --help ]]; then help "$0" && exit; fi
  local wanted=" ${*:-readme looks states traced drawn} " picture name scene eye
  mkdir -p "$work"
  rm -f "$work/rows.json"
  run_step "Build" build_lumi
  if [[ $wanted == *" readme "* ]]; then run_step "readme" draw_readme; fi
  if [[ $wanted == *" looks "* ]]; then run_step "looks" draw_looks; fi
  if [[ $wanted == *" states "* ]]; then run_step "states" draw_states; fi
  for picture in "${pictures[@]}"; do
    read -r name scene eye <<<"$picture"
    if [[ $wanted == *" traced "* || $wanted == *" $name "* ]]; then run_step "$name" trace "$name" "$scene" "$eye"; fi
    if [[ $wanted == *" drawn "* || $wanted == *" $name "* ]]; then run_step "$name, drawn" draw "$name" "$scene" "$eye"; fi
  done
  if [[ $wanted == *" drawn "* ]]; then "$root/tools/lab/pages.py" put scenes pictures <"$work/rows.json" && "$root/tools/lab/pages.py"; fi
}

main "$@"
