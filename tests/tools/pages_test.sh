#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# pages_test.sh LUMI SHARE: what `tools/packaging/pages.py LUMI SHARE` wrote has a page for every subcommand with every option of its
# --help, is troff without a warning, and completes words.
set -euo pipefail
lumi=$1 share=$2

fail() {
  echo "pages_test.sh: $1" >&2
  exit 1
}

# expect "WORDS OF THE LINE" "WORDS OFFERED": the last word of the line, perhaps empty, is completed.
expect() {
  local offered
  read -ra COMP_WORDS <<<"$1"
  [[ $1 != *' ' ]] || COMP_WORDS+=('')
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _lumi || true  # compopt has no completion to change here
  offered=${COMPREPLY[*]}
  [[ $offered == "$2" ]] || fail "'$1' completes to '$offered', not to '$2'"
}

options_of() {
  "$lumi" "$1" --help | grep --only-matching --extended-regexp '^ +(-[A-Za-z],)?--[a-z0-9-]+' | sed 's/.*--/--/'
}

subcommands=$("$lumi" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\).*/\1/p')
[[ -n $subcommands ]] || fail "lumi --help names no subcommand"
# shellcheck source=/dev/null
source "$share/bash-completion/completions/lumi"
for subcommand in $subcommands; do
  page=$share/man/man1/lumi-$subcommand.1
  [[ -s $page ]] || fail "$page is missing"
  for option in $(options_of "$subcommand"); do
    grep --quiet --fixed-strings -e "${option//-/\\-}" "$page" || fail "$page lacks $option"
  done
  expect "lumi $subcommand --hel" "--help"
  expect "lumi $subcommand zzz" ""
done
if command -v groff >/dev/null; then
  for page in "$share"/man/man1/*.1; do
    warnings=$(groff -man -Tutf8 -wall "$page" 2>&1 >/dev/null)
    [[ -z $warnings ]] || fail "$page: $warnings"
  done
else
  echo "groff is not installed: the pages were not formatted"
fi
expect "lumi insp" "inspect"
expect "lumi --vers" "--version"
expect "lumi bake --texel pal" "palette8"
expect "lumi bake --texel = pal" "palette8"
expect "lumi render --span 1" "1 16"
expect "lumi render --fov " ""
expect "lumi filter tr" "train"
[[ -s $share/man/man1/lumi-filter-train.1 ]] || fail "lumi-filter-train.1 is missing"
echo "$(wc -w <<<"$subcommands") pages, every option; completion as expected"
