#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/first_picture.sh [--samples ZIP] [--docs] [FOLDER]
# Walks a newcomer's way by the clock: from `git clone` of what HEAD holds, by tools/demo.sh --quick, to a picture that turns
# in a browser; and with --samples, the archive that tools/packaging/release.py writes, from there without building.
# Nothing is taken from a cache of compilers. Prints rows of JSON; --docs writes docs/log/house.md of them.
# On a busy machine it says what other programs take, by the load before it. Needs chromium and puppeteer-core (tools/install_packages.sh all). FOLDER: new or empty; without it, one in /tmp.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

samples='' docs='' folder=''

parse_arguments() {
  while (($# > 0)); do
    case $1 in
      --samples) samples=$(realpath "${2:?"--samples takes an archive"}") && shift ;;
      --docs) docs=yes ;;
      --help) help "$0" && exit ;;
      -*) wrong_call "unknown argument '$1'" ;;
      *) folder=$1 ;;
    esac
    shift
  done
}

load() {
  cut -d' ' -f1 /proc/loadavg
}

# seconds_between A B: of two times of `date +%s.%N`.
seconds_between() {
  awk -v a="$1" -v b="$2" 'BEGIN { printf "%.1f", b - a }'
}

# row WAY STEP BEGIN END
row() {
  printf '{"way": "%s", "step": "%s", "seconds": %s}\n' "$1" "$2" "$(seconds_between "$3" "$4")" | tee -a "$folder/rows.json" >&2
}

turns() {
  node "$root/tools/lab/first_picture/turns.mjs" "$root/build/npm" "$(command -v chromium)" "$1" "$folder/first.png"
}

# The time at which the demo said so: its steps begin with a line "== TITLE".
time_of() {
  awk -v title="== $1" 'index($0, title) { print $1; found = 1; exit } END { exit !found }' "$folder/demo.log"
}

run_demo() {
  cd "$folder/lumi"
  env --unset=CMAKE_C_COMPILER_LAUNCHER --unset=CMAKE_CXX_COMPILER_LAUNCHER CCACHE_DISABLE=1 tools/demo.sh --quick 2>&1 |
    while IFS= read -r line; do
      printf '%s %s\n' "$(date +%s.%N)" "$line"
      [[ $line != "== Bake a chord field" ]] || break # the page is there: what follows compares
    done >"$folder/demo.log"
}

walk_from_clone() {
  local way begin cloned page turned built
  way="git clone; $jobs cores, load $(load) before"
  begin=$(date +%s.%N)
  git clone --quiet "$root" "$folder/lumi"
  cloned=$(date +%s.%N)
  (run_demo) || true # the demo's pipe ends early
  page=$(time_of "Bake a chord field") || die "the demo did not come so far; see $folder/demo.log"
  built=$(time_of "Bake product.obj")
  turns "$folder/lumi/out/product.html" || die "the page does not turn; see $folder/first.png"
  turned=$(date +%s.%N)
  row "$way" "clone" "$begin" "$cloned"
  row "$way" "packages (installed before), build" "$cloned" "$built"
  row "$way" "bake the desk clock, write the page" "$built" "$page"
  row "$way" "browser" "$page" "$turned"
  row "$way" "all" "$begin" "$turned"
}

walk_from_samples() {
  local way begin turned page
  way="archive of samples; load $(load) before"
  begin=$(date +%s.%N)
  unzip -q "$samples" -d "$folder/samples"
  page=$(find "$folder/samples" -name '*.html' | sort | head -n 1)
  [[ -n $page ]] || die "$samples holds no page"
  turns "$page" || die "$page does not turn; see $folder/first.png"
  turned=$(date +%s.%N)
  row "$way" "unpack, browser" "$begin" "$turned"
}

main() {
  parse_arguments "$@"
  [[ -n $folder ]] || folder=$(mktemp -d)
  mkdir -p "$folder"
  folder=$(realpath "$folder")
  [[ -z $(ls -A "$folder") ]] || wrong_call "$folder is not empty"
  walk_from_clone
  [[ -z $samples ]] || walk_from_samples
  cat "$folder/rows.json"
  if [[ -n $docs ]]; then
    "$root/tools/lab/pages.py" put house first_picture <"$folder/rows.json"
    "$root/tools/lab/pages.py"
  fi
}

main "$@"
