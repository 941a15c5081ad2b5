#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/test.sh [--all]
# Builds the tool and the tests with warnings as errors and runs the tests: each file of them on the host under
# AddressSanitizer and UndefinedBehaviorSanitizer or, where it needs speed, without; and on emulated Cortex-M boards.
# Checks by clang-tidy the sources that changed most in the last commits. Installs missing packages when run as root.
# --all adds what tests/scope.cmake leaves out: every test without sanitizers, the laboratory, every policy and unit
# test on two boards, every frame on every board, every failure on purpose, clang-format, clang-tidy (which reads file by
# file and so shows missing includes), cppcheck, the branches that core's tests take, a minute of fuzzing a target and of
# random frames on boards, the commands of the examples' pages, and the page of `lumi view` in Chromium. There a missing
# tool is an error.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

packages=tests
all=OFF

parse_arguments() {
  while (($# > 0)); do
    case $1 in
      --all) packages=all all=ON ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown argument '$1'" ;;
    esac
    shift
  done
}

# One ctest run over both trees, so that one summary counts every test.
join_trees() {
  printf 'subdirs(release host-sanitize)\n' >"$root/build/CTestTestfile.cmake"
}

# check_with_clang_tidy [FILE...]: sources of our own that the host's build compiles, all of the product if none is named,
# checked by .clang-tidy; precompiled headers are GCC's.
check_with_clang_tidy() {
  local files="(core|baker|tools|platform)/.*\.cpp"
  if (($# > 0)); then files="($(IFS='|' && echo "$*"))"; fi
  command -v run-clang-tidy >/dev/null || die "clang-tidy is missing"
  (
    cd "$root" || exit
    cmake --preset tidy
    run-clang-tidy -quiet -p build/tidy -j "$jobs" "^$root/$files\$"
  )
}

# Checks the sources that changed most in the last commits (those of four hours before the newest) and in what is not
# committed. `--all` checks the others, too.
most_tidy_files=4
check_changes_with_clang_tidy() {
  local base files
  base=$(git -C "$root" rev-list -1 --before="$(($(git -C "$root" log -1 --format=%ct) - 4 * 3600))" HEAD)
  [[ -n $base ]] || return 0
  mapfile -t files < <(git -C "$root" diff --numstat --no-renames --diff-filter=d "$base" -- '*.cpp' |
    sort --reverse --numeric-sort | cut --fields=3)
  ((${#files[@]} <= most_tidy_files)) || printf '%d of %d changed sources\n' "$most_tidy_files" "${#files[@]}"
  ((${#files[@]} == 0)) || check_with_clang_tidy "${files[@]:0:most_tidy_files}"
}

check_format() {
  command -v clang-format >/dev/null || die "clang-format is missing"
  (cd "$root" && git ls-files '*.cpp' '*.h' '*.c' | xargs clang-format --dry-run -Werror)
}

# Left out: members that the next call sets; shifts of negative numbers, which GCC and Clang define; constants that a
# policy takes another value for; a sum of weights of which one is never 0; a pointer that is followed only while its
# object lives. This version also misreads nested conditionals and `size_t{n} * m`; GCC warns of what it looks for there.
check_with_cppcheck() {
  command -v cppcheck >/dev/null || die "cppcheck is missing"
  (
    cd "$root" || exit
    cppcheck --quiet --error-exitcode=1 --enable=warning,portability --std=c++17 --language=c++ -j "$jobs" \
      --suppress=missingIncludeSystem --suppress=uninitMemberVar --suppress=shiftTooManyBitsSigned \
      --suppress=duplInheritedMember --suppress=zerodiv:core/src/lattice/neighbours.cpp \
      --suppress=compareBoolExpressionWithInt \
      --suppress=constStatement --suppress=CastIntegerToAddressAtReturn --suppress=uselessAssignmentPtrArg \
      -Icore/include -Icore/src -Ibaker/include -Ibaker/src -Itools/src -Iplatform/host/include core/src baker/src tools/src
  )
}

# Exceptions are off, as core is built, and statics have no guards, in headers that tests include, too. Functions that are
# inlined always are not: gcov would count each place of theirs by itself. Threads lose counts of each other.
least_branches=93  # per cent; gcovr counts those of each instance of a template that has lines of its own
check_branches_of_core() {
  local build=$root/build/coverage
  local flags="--coverage -fno-exceptions -fno-threadsafe-statics -fprofile-filter-files=/core/[is][nr]c \
-DCATCH_CONFIG_DISABLE_EXCEPTIONS -Dalways_inline=unused"
  command -v gcovr >/dev/null || die "gcovr is missing"
  cmake -S "$root" -B "$build" -G Ninja -DLUMI_BUILD_HOST=OFF -DLUMI_BUILD_TESTS=ON -DCMAKE_BUILD_TYPE=Debug \
    "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -DNDEBUG" "-DCMAKE_CXX_FLAGS=$flags" -DCMAKE_EXE_LINKER_FLAGS=--coverage >/dev/null
  cmake --build "$build" --parallel "$jobs" --target lumi_core_tests lumi_c_tests
  find "$build" -name '*.gcda' -delete
  "$build/tests/core/lumi_core_tests" --filenames-as-tags '~[#halves_threads_test]'
  "$build/tests/core/lumi_c_tests"
  gcovr --root "$root" --filter 'core/(src|include)/' "$build" -j "$jobs" --branches --print-summary \
    --json "$build/lines.json" --fail-under-branch "$least_branches"
}

# Sums up what ctest says of each group of tests, a line a group: seconds of all processes together, number of tests.
sum_up_tests() {
  awk '/ Test +#[0-9]+: / {
      name = $0
      sub(/^.* Test +#[0-9]+: /, "", name)
      seconds = $(NF - 1)
      group = match(name, /^[a-z0-9-]+\.build/) ? substr(name, 1, RLENGTH) : \
        match(name, /^(sanitized\.)?[a-z0-9-]+/) ? substr(name, 1, RLENGTH) : "other"
      total[group] += seconds
      ++count[group]
    }
    END { for (group in total) printf "%7.0f s  %s (%d)\n", total[group], group, count[group] }' "$1" | sort --reverse --numeric-sort
}

print_table() {
  note_step "$1" "Tests, among them building for the boards; of that, two processes at a time:"
  print_step_times
  sum_up_tests "$2"
  printf '\n'
}

# Runs ctest and keeps its closing lines back until the table of steps is printed.
run_tests() {
  local begin=$SECONDS log=$root/build/tests.log status=0
  printf '\n== Tests (those of emulated boards build first)\n'
  ctest --test-dir "$root/build" --parallel "$jobs" --output-on-failure 2>&1 | tee "$log" |
    sed --unbuffered '/^[0-9]*% tests passed/,$d' || status=$?
  print_table $((SECONDS - begin)) "$log"
  sed --quiet '/^[0-9]*% tests passed/,$p' "$log"
  return "$status"
}

main() {
  parse_arguments "$@"
  run_step "Packages" "$root/tools/install_packages.sh" "$packages"
  run_step "Build for the host" build_preset host -DLUMI_TEST_ALL="$all" -DLUMI_TEST_SHORT=ON
  run_step "Build for the host, with sanitizers" build_preset host-sanitize
  if [[ $all == ON ]]; then
    run_step "clang-format" check_format
    run_step "cppcheck" check_with_cppcheck
    run_step "clang-tidy" check_with_clang_tidy
    run_step "Branches of core" check_branches_of_core
    run_step "Fuzz, a minute a target" "$root/tools/lab/fuzz.sh"
    run_step "Soak, a minute" "$root/tools/lab/soak.sh"
    run_step "The pages' commands in an empty folder" "$root/tools/lab/newcomer.sh"
  elif [[ -e $root/.git ]]; then
    run_step "clang-tidy of what changed last" check_changes_with_clang_tidy
  fi
  join_trees
  run_tests
}

main "$@"
