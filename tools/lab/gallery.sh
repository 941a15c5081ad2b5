#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/gallery.sh [--object NAME]... [--paths P] [--fit SIZE]
# Makes docs/gallery: for each object a field, a turning picture, a page to turn it by hand, and what it takes; then the
# index. The scenes come from tools/lab/gallery/objects.py, the skull from a CT that Debian has (scenes/fetch_skull.sh).
# --object: that one alone (may be repeated): clock, watch, car, potion; skull, which takes more bytes. --paths: light paths a texel [100].
# --fit: bytes of a field [200kB; the car 280kB]. Fields that lie in build/gallery are not baked again: remove one to bake it anew.
# With LUMI in the environment that program is taken as it is, and nothing is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

objects=(clock watch car potion)
declare -A eyes=([clock]=30,20,3 [watch]=30,20,3 [car]=35,16,3 [potion]=30,16,3 [skull]=60,10,3)
declare -A titles=([clock]="A desk clock" [watch]="A wrist watch under a crystal" [car]="A small car with windows"
  [potion]="A potion of a game" [skull]="A skull from CT")
declare -A fits=([car]=280kB)  # where the size of all leaves rims ragged
paths=100
fit=200kB
parts=rp2040,rp2350,esp32s3,stm32f4,stm32h7
background=202428
work=$root/build/gallery
out=$root/docs/gallery

parse_arguments() {
  local chosen=()
  while (($#)); do
    case $1 in
      --object) chosen+=("${2:?"--object needs a name"}") && shift ;;
      --paths) paths=${2:?"--paths needs a number"} && shift ;;
      --fit) fit=${2:?"--fit needs a size"} fits=() && shift ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown option '$1'" ;;
    esac
    shift
  done
  if ((${#chosen[@]})); then objects=("${chosen[@]}"); fi
  for name in "${objects[@]}"; do [[ -v eyes[$name] ]] || wrong_call "there is no object '$name'"; done
}

write_scenes_of_objects() {
  python3 -B "$root/tools/lab/gallery/objects.py" "$work/scenes"
  if [[ " ${objects[*]} " == *" skull "* && ! -f $work/scenes/skull.nii.gz ]]; then
    "$root/tools/lab/scenes/fetch_skull.sh" "$work/ct" && mv "$work/ct/skull.nii.gz" "$work/scenes"
  fi
}

bake() {
  [[ -f $work/$1.lumi ]] ||
    "$lumi" bake "$work/scenes/$1.json" -o "$work/$1.lumi" --layout surface --fit "${fits[$1]:-$fit}" --paths "$paths" >"$work/$1.txt"
}

draw() {
  "$lumi" render "$work/$1.lumi" -o "$out/$1.webp" --turntable 36 --size 240x240 --orbit "${eyes[$1]}" \
    --background "$background" >/dev/null
  "$lumi" view "$work/$1.lumi" -o "$out/$1.html" --title "${titles[$1]}" --orbit "${eyes[$1]}" --background "$background"
}

# One line of JSON: what `lumi bake` measured against path-traced pictures, and what `lumi inspect` models.
row() {
  local db
  db=$(sed -n 's/^shows about \([0-9.]*\) dB in.*/\1/p' "$work/$1.txt")
  [[ -n $db ]] || die "$work/$1.txt says no dB; remove $work/$1.lumi and bake it again"
  "$lumi" inspect "$work/$1.lumi" --screen 240x240 --for "$parts" --json |
    python3 -B "$root/tools/lab/gallery/page.py" row "$1" "${titles[$1]}" "$db"
}

write_figures() {
  local name
  for name in "${objects[@]}"; do row "$name"; done | python3 -B "$root/tools/lab/gallery/page.py" put
}

main() {
  local name
  parse_arguments "$@"
  mkdir -p "$work/scenes" "$out"
  if [[ -z ${LUMI:-} ]]; then run_step "Build" build_lumi; fi
  run_step "Write the scenes" write_scenes_of_objects
  for name in "${objects[@]}"; do
    run_step "Bake $name" bake "$name"
    run_step "Draw $name" draw "$name"
  done
  run_step "Write the index" write_figures
  print_step_times
}

main "$@"
