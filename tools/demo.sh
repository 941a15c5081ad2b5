#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/demo.sh [--quick] [SCENE.obj]
# From a scene to pictures: builds `lumi`, bakes the scene (ours: a desk clock) into a field of 67 MB, draws a turntable
# from it, path-traces three of the views as references and compares them. Everything lands in the folder out.
# --quick bakes a field of 1 MB, in seconds. Installs missing packages when run as root.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scene=$root/baker/scenes/product.obj
origins=5792 directions=5792 bake_spp=10  # about two minutes on two cores
reference_spp=256
orbit=30,20,3 size=320x320 background=202428
views=12 references=3  # a reference is compared with every (views / references)-th view
modes=(nearest linear paper)
out=$root/out
lumi=$root/build/release/tools/lumi

parse_arguments() {
  while (($# > 0)); do
    case $1 in
      --quick) origins=724 directions=724 bake_spp=8 reference_spp=32 ;;
      --help) help "$0" && exit ;;
      -*) wrong_call "unknown option '$1'" ;;
      *)
        [[ -f $1 ]] || die "$1: no such file; give an OBJ file, or nothing for the desk clock"
        scene=$(realpath "$1")
        ;;
    esac
    shift
  done
}

bake() {
  "$lumi" bake "$scene" -o "$field" --origins "$origins" --directions "$directions" --spp "$bake_spp"
}

view_options() {
  printf '%s\n' --orbit "$orbit" --size "$size" --background "$background"
}

draw_turntables() {
  local mode options
  mapfile -t options < <(view_options)
  for mode in "${modes[@]}"; do
    "$lumi" render "$field" -o "$out/$name-$mode.png" --mode "$mode" --turntable "$views" "${options[@]}" >/dev/null
  done
}

trace_references() {
  local options
  mapfile -t options < <(view_options)
  "$lumi" reference "$scene" -o "$out/$name-reference.png" --spp "$reference_spp" --turntable "$references" \
    "${options[@]}" >/dev/null
}

# The row of one view: PSNR and SSIM of every mode.
compare_view() {
  local mode figures row
  row=$(printf '%-8s' "$(printf '%03d' "$2")")
  for mode in "${modes[@]}"; do
    figures=$("$lumi" compare "$out/$name-$mode-$(printf '%03d' "$2").png" \
      "$out/$name-reference-$(printf '%03d' "$1").png")
    row+=$(awk '/^PSNR/ { psnr = $2 } /^SSIM/ { ssim = $2 } END { printf "  %5s dB  %.3f", psnr, ssim }' <<<"$figures")
  done
  printf '%s\n' "$row"
}

compare_views() {
  local k
  printf 'PSNR and SSIM against path-traced references\n%-8s' view
  printf '  %-15s' "${modes[@]}"
  printf '\n'
  for ((k = 0; k < references; ++k)); do
    compare_view "$k" $((k * views / references))
  done
}

print_where() {
  cat <<END

== Pictures, in $out
$name-linear-sheet.png     the turntable, as a microcontroller draws it (also -nearest-, -paper-)
$name-linear-000.png ...   its views one by one
$name-reference-sheet.png  the path-traced references
$name.lumi                 the field
END
}

main() {
  parse_arguments "$@"
  name=$(basename "$scene" .obj)
  field=$out/$name.lumi
  mkdir -p "$out"
  run_step "Packages" "$root/tools/install_packages.sh" build
  run_step "Build" build_preset release
  run_step "Bake $name.obj" bake
  run_step "Draw $views views with each of: ${modes[*]}" draw_turntables
  run_step "Path-trace $references of the views, $reference_spp samples a pixel" trace_references
  run_step "Compare" compare_views
  print_step_times
  print_where
}

main "$@"
