# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# What the shell scripts of this folder share; sourced, after `set -euo pipefail`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

die() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  exit 1
}

# Ends the script with 2, as `lumi` does for a wrong call.
wrong_call() {
  printf '%s: %s; --help shows how\n' "$(basename "$0")" "$1" >&2
  exit 2
}

# help FILE: the comment at the head of a script, from its third line on.
help() {
  sed -n '3,/^[^#]/{s/^# \{0,1\}//p}' "$1"
}

# run_step TITLE COMMAND...: runs a command and notes how long it took. Where it fails the script ends, and says so.
run_step() {
  local begin=$SECONDS
  current_step=$1
  shift
  printf '\n== %s\n' "$current_step"
  "$@"
  step_times+=("$(printf '%5d s  %s' $((SECONDS - begin)) "$current_step")")
  current_step=
}
current_step=
step_times=()

report_failure() {
  if (($1 != 0)) && [[ -n $current_step ]]; then
    printf '%s: "%s" failed (%d); the messages above say why\n' "$(basename "$0")" "$current_step" "$1" >&2
  fi
}
trap 'report_failure $?' EXIT

print_step_times() {
  printf '\n== Time\n'
  printf '%s\n' "${step_times[@]}"
}

# build_preset PRESET: configures and builds one of CMakePresets.json.
build_preset() {
  (
    cd "$root" || exit
    cmake --preset "$1"
    cmake --build --preset "$1" --parallel "$jobs"
  )
}
