#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/demo.sh [--quick] [SCENE]
# From a scene to pictures: builds `lumi`, bakes the scene (ours: a desk clock) into a surface field of at most 0.5 MB and
# into a chord field, the layout of the LumiPath paper, draws a turntable from each, and compares both with path-traced
# references. Everything lands in the folder out.
# --quick bakes an eighth of a megabyte. Installs missing packages when run as root.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scene=$root/baker/scenes/product.obj
surface=()                   # the default; minutes on two cores
chord=(--layout chord)       # 1024 × 2048 rays of a byte
reference_spp=256
orbit=30,20,3 size=320x320 background=202428
views=12 references=3
out=$root/out
lumi=$root/build/release/tools/lumi

parse_arguments() {
  while (($# > 0)); do
    case $1 in
      --quick) surface=(--fit 125kB --paths 70) chord=(--layout chord --fit 500kB) reference_spp=32 ;;
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

bake_surface() {
  "$lumi" bake "$scene" -o "$out/$name.lumi" "${surface[@]}"
}

bake_chord() {
  "$lumi" bake "$scene" -o "$out/$name-chord.lumi" "${chord[@]}"
}

draw_turntable() {
  "$lumi" render "$out/$1.lumi" -o "$out/$name-$2.png" --mode "$3" --turntable "$views" --orbit "$orbit" --size "$size" \
    --background "$background" >/dev/null
}

draw_turntables() {
  draw_turntable "$name" surface best
  draw_turntable "$name" one-sample one-sample
  draw_turntable "$name-chord" chord best
}

# Where lumi was built without clang and lld, it says so, and the demo goes on.
write_page() {
  rm -f "$out/$name.html"
  if "$lumi" view "$out/$name.lumi" -o "$out/$name.html" --orbit "$orbit" --background "$background"; then
    printf 'Open it in a browser to turn the field. What follows draws and compares.\n'
  fi
}

compare_fields() {
  "$lumi" report "$scene" "$out/$name.lumi" "$out/$name-chord.lumi" -o "$out/$name-report.html" --cache "$out/report" \
    --count "$references" --spp "$reference_spp" --size "${size%x*}"
}

print_where() {
  printf '\n== Pictures, in %s\n' "$out"
  [[ ! -e $out/$name.html ]] || printf '%-26s %s\n' "$name.html" "the field, to be turned in a browser"
  cat <<END
$name-surface-sheet.png    the turntable, as a microcontroller draws it from $(stat --format=%s "$out/$name.lumi") bytes
$name-surface-000.png ...  its views one by one; -one-sample- with one sample a pixel, the fastest
$name-chord-sheet.png      the same from a chord field, the layout of the LumiPath paper:
                           lumi bake $scene -o $name-chord.lumi ${chord[*]}
$name-report.html          both fields beside path-traced references, with errors and figures
$name.lumi                 the field
END
}

main() {
  parse_arguments "$@"
  name=$(basename "${scene%.*}")
  mkdir -p "$out"
  run_step "Packages" "$root/tools/install_packages.sh" build
  run_step "Build" build_lumi
  run_step "Bake $(basename "$scene")" bake_surface
  run_step "Write a page to turn it in a browser" write_page
  run_step "Bake a chord field" bake_chord
  run_step "Draw $views views of the surface field, of it with one sample a pixel, of the chord field" draw_turntables
  run_step "Compare with $references path-traced views, $reference_spp light paths a pixel" compare_fields
  print_step_times
  print_where
}

main "$@"
