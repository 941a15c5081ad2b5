#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/pictures.sh [NAME...]
# Makes the pictures of README and of docs/scenes.md anew, from the scenes of the project. NAME: of them alone, such as
# product-front. The pictures of the scenes are path-traced with 512 light paths a pixel, which takes a minute each.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

work=$root/build/pictures
scenes=$root/baker/scenes
readme_view=(--orbit 30,20,3 --size 224x224 --background 202428)

# A picture's name, its scene, and where the eye is.
traced=("product-front product.obj 30,20,3" "product-back product.obj 205,15,3" "product-above product.obj 40,55,3"
  "cornell cornell.obj 180,0,3" "cornell-outside cornell.obj 215,20,3" "testcard testcard.obj 20,25,3"
  "gallery gallery.json 10,25,3" "finishes finishes.json 101,38,3")

trace() {
  "$lumi" reference "$scenes/$2" -o "$root/docs/img/$1.png" --orbit "$3" --size 320x320 --spp 512 >/dev/null
}

# The surface field that a bake without options makes, and the chord field.
draw_readme() {
  "$lumi" bake "$scenes/product.obj" -o "$work/surface.lumi"
  "$lumi" bake "$scenes/product.obj" -o "$work/chord.lumi" --layout chord
  "$lumi" render "$work/surface.lumi" -o "$root/docs/img/readme-surface.webp" --turntable 36 "${readme_view[@]}" >/dev/null
  "$lumi" render "$work/chord.lumi" -o "$root/docs/img/readme-chord.png" "${readme_view[@]}" >/dev/null
  "$lumi" reference "$scenes/product.obj" -o "$root/docs/img/readme-reference.png" --spp 256 "${readme_view[@]}" >/dev/null
}

main() {
  if [[ ${1:-} == --help ]]; then help "$0" && exit; fi
  local wanted=" $* " picture name scene eye
  mkdir -p "$work"
  run_step "Build" build_lumi
  if [[ $# == 0 || $wanted == *" readme "* ]]; then run_step "readme" draw_readme; fi
  for picture in "${traced[@]}"; do
    read -r name scene eye <<<"$picture"
    if [[ $# == 0 || $wanted == *" $name "* ]]; then run_step "$name" trace "$name" "$scene" "$eye"; fi
  done
}

main "$@"
