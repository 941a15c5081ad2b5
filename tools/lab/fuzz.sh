#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/fuzz.sh [--minutes N | --hours N | --runs N] [TARGET...]
# Fuzzes under AddressSanitizer and UndefinedBehaviorSanitizer, so long a target (a minute if not said) or so many
# executions, as many targets at once as there are cores, and says executions and coverage. A finding ends its
# target; the input that shows it lies in build/fuzz/findings. What is learnt stays in build/fuzz/corpus, so the next run
# goes on from there. Needs clang.
# Targets: field, extreme, picture, obj, gltf, stl, ply, scene, nifti, shard, weights; all if none is named.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

limit=(-max_total_time=60)
limit_text="a minute"
targets=()
work=$root/build/fuzz
memory=$([[ -w /dev/shm ]] && echo /dev/shm || echo "${TMPDIR:-/tmp}")

set_minutes() {
  limit=(-max_total_time=$((60 * $1)))
  limit_text="$1 minutes"
}

parse_arguments() {
  while (($#)); do
    case $1 in
      --minutes) set_minutes "${2:?"--minutes needs a number"}" && shift ;;
      --help) help "$0" && exit ;;
      --hours) set_minutes $((60 * ${2:?"--hours needs a number"})) && shift ;;
      --runs) limit=(-runs="${2:?"--runs needs a number"}") && limit_text="$2 executions" && shift ;;
      field | extreme | picture | obj | gltf | stl | ply | scene | nifti | shard | weights) targets+=("$1") ;;
      *) wrong_call "unknown argument '$1'" ;;
    esac
    shift
  done
  if ((${#targets[@]} == 0)); then targets=(field extreme picture obj gltf stl ply scene nifti shard weights); fi
}

build_targets() {
  cmake --preset fuzz
  local programs=("${targets[@]/#/lumi_}")
  cmake --build "$work" --parallel "$jobs" --target lumi_make_fuzz_corpus lumi_make_baker_corpus "${programs[@]/%/_fuzz}"
}

# fuzz TARGET: leaves the fuzzer's words in build/fuzz/TARGET.log, and its seconds of CPU, user's and system's, in
# TARGET.cpu.
fuzz() {
  local corpus=$work/corpus/$1 seeds=$work/seeds/$1 options=() TIMEFORMAT='%U %S'
  # Small files have all that a reader knows: fields of this size draw sixteen times as fast.
  case $1 in
    field) options=(-max_len=8192) ;;
    shard) options=(-max_len=10240) ;;
    extreme) options=(-max_len=4096) ;;
    gltf | scene) options=(-max_len=2048) ;;
    obj | stl | ply) options=(-max_len=1024) ;;
  esac
  # Files in memory, no callers of allocations, no count of rare features: each took a tenth of the time or more.
  local -x TMPDIR=$memory ASAN_OPTIONS=malloc_context_size=0
  mkdir -p "$corpus" "$work/findings"
  {
    time "$work/tests/fuzz/lumi_$1_fuzz" "$corpus" "$seeds" "${options[@]}" -entropic=0 "${limit[@]}" \
      -print_final_stats=1 -artifact_prefix="$work/findings/" -timeout=60 -rss_limit_mb=4096 2>&1 |
      tee "$work/$1.log" | grep --line-buffered -E 'ERROR|SUMMARY|pulse|DONE'
  } 2>"$work/$1.cpu" || die "a finding: see $work/$1.log and $work/findings"
}

# figures_of TARGET: a row.
figures_of() {
  local log=$work/$1.log
  json_row target "$1" executions "$(sed --quiet 's/^stat::number_of_executed_units: *//p' "$log")" \
    cpu_s "$(awk '{ print int($1 + $2) }' "$work/$1.cpu")" edges \
    "$(sed --quiet 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)"
}

fuzz_and_tell() {
  fuzz "$1"
  figures_of "$1"
}

fuzz_all() {
  local target pids=() pid status=0
  for target in "${targets[@]}"; do
    while (($(jobs -rp | wc -l) >= jobs)); do sleep 1; done
    fuzz_and_tell "$target" & pids+=($!)
  done
  for pid in "${pids[@]}"; do wait "$pid" || status=1; done
  return "$status"
}

main() {
  parse_arguments "$@"
  command -v clang++ >/dev/null || die "clang++ is missing: apt-get install clang"
  build_targets
  "$work/tests/fuzz/lumi_make_fuzz_corpus" "$work/seeds"
  "$work/tests/fuzz/lumi_make_baker_corpus" "$work/seeds"
  run_step "Fuzz ${targets[*]}, $limit_text each" fuzz_all
}

main "$@"
