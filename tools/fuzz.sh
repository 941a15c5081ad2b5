#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/fuzz.sh [--minutes N | --hours N] [TARGET...]
# Fuzzes under AddressSanitizer and UndefinedBehaviorSanitizer, so long a target (a minute if not said), and says
# executions and coverage. A finding stops it; the input that shows it lies in build/fuzz/findings. What it learns stays
# in build/fuzz/corpus, so the next run goes on from there. Needs clang. Targets: field, picture, obj, scene, nifti,
# shard, weights; all if none is named.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

minutes=1
targets=()
work=$root/build/fuzz

parse_arguments() {
  while (($#)); do
    case $1 in
      --minutes) minutes=${2:?"--minutes needs a number"} && shift ;;
      --help) help "$0" && exit ;;
      --hours) minutes=$((60 * ${2:?"--hours needs a number"})) && shift ;;
      field | picture | obj | scene | nifti | shard | weights) targets+=("$1") ;;
      *) wrong_call "unknown argument '$1'" ;;
    esac
    shift
  done
  if ((${#targets[@]} == 0)); then targets=(field picture obj scene nifti shard weights); fi
}

build_targets() {
  cmake --preset fuzz
  local programs=("${targets[@]/#/lumi_}")
  cmake --build "$work" --parallel "$jobs" --target lumi_make_fuzz_corpus lumi_make_baker_corpus "${programs[@]/%/_fuzz}"
}

# fuzz TARGET: leaves the fuzzer's words in build/fuzz/TARGET.log, and its CPU seconds in TARGET.cpu.
fuzz() {
  local corpus=$work/corpus/$1 seeds=$work/seeds/$1 options=() TIMEFORMAT='%U'
  if [[ $1 == field ]]; then options=(-max_len=6144); fi  # small fields have every section and draw sixteen times as fast
  mkdir -p "$corpus" "$work/findings"
  {
    time "$work/tests/fuzz/lumi_$1_fuzz" "$corpus" "$seeds" "${options[@]}" -max_total_time=$((60 * minutes)) \
      -print_final_stats=1 -artifact_prefix="$work/findings/" -timeout=20 -rss_limit_mb=4096 2>&1 |
      tee "$work/$1.log" | grep --line-buffered -E 'ERROR|SUMMARY|pulse|DONE'
  } 2>"$work/$1.cpu" || die "a finding: see $work/$1.log and $work/findings"
}

# A line a target: executions, CPU seconds, and the edges of code that were reached.
sum_up() {
  local target
  printf '\n%-10s %14s %12s %8s\n' target executions 'CPU seconds' edges
  for target in "${targets[@]}"; do
    printf '%-10s %14s %12s %8s\n' "$target" \
      "$(sed --quiet 's/^stat::number_of_executed_units: *//p' "$work/$target.log")" "$(cat "$work/$target.cpu")" \
      "$(sed --quiet 's/.* cov: \([0-9]*\) .*/\1/p' "$work/$target.log" | tail -n 1)"
  done
}

main() {
  parse_arguments "$@"
  command -v clang++ >/dev/null || die "clang++ is missing: apt-get install clang"
  build_targets
  "$work/tests/fuzz/lumi_make_fuzz_corpus" "$work/seeds/field"
  "$work/tests/fuzz/lumi_make_baker_corpus" "$work/seeds"
  local target
  for target in "${targets[@]}"; do
    run_step "Fuzz $target, $minutes minutes" fuzz "$target"
  done
  print_step_times
  sum_up
}

main "$@"
