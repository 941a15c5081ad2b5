# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# The shell scripts of this folder share this; they source it, after `set -euo pipefail`.

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
  note_step $((SECONDS - begin)) "$current_step"
  current_step=
}
current_step=
step_times=()

# note_step SECONDS TITLE: adds a line to the table of steps. With LUMI_STEPS in the environment, the name of a file,
# scripts that run one after the other share one table.
note_step() {
  step_times+=("$(printf '%5d s  %s' "$1" "$2")")
  if [[ -n ${LUMI_STEPS:-} ]]; then
    printf '%s\n' "${step_times[-1]}" >>"$LUMI_STEPS"
  fi
}

report_failure() {
  if (($1 != 0)) && [[ -n $current_step ]]; then
    printf '%s: "%s" failed (%d); the messages above say why\n' "$(basename "$0")" "$current_step" "$1" >&2
  fi
}
trap 'report_failure $?' EXIT

print_step_times() {
  printf '\n== Time\n'
  if [[ -n ${LUMI_STEPS:-} ]]; then
    cat "$LUMI_STEPS"
  else
    printf '%s\n' "${step_times[@]}"
  fi
}

# The `lumi` command, in the tree that the tests use too (see tools/test.sh).
build_lumi() {
  (
    cd "$root" || exit
    [[ -f build/release/build.ninja ]] || cmake --preset release
    cmake --build --preset release --parallel "$jobs" --target lumi
  )
}

# build_preset PRESET [OPTION...]: configures one of CMakePresets.json, with further options of cmake, and builds it.
build_preset() {
  (
    cd "$root" || exit
    cmake --preset "$@"
    cmake --build --preset "$1" --parallel "$jobs"
  )
}
