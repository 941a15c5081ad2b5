#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/lab/attacks.sh [--docs]
# Repeats the attacks that were tried, each by the tests that try it, and tells what each found first, and whether it
# finds anything now. Ends with 1 if one does. Builds what is missing. --docs writes the table of docs/log/tests.md.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

rows=$root/build/attacks.json
failures=0

# Attack | what it found, at 420e9fe where nothing else is said | regular expression of the tests' names.
attacks() {
  cat <<'TABLE'
stripes left of the image and beyond column 32767|`render_spans` wrote outside|core\.(no renderer writes beside its stripe|stripes beside the image|pixels beside the stripe)
interlaced frames through a derived camera|wrong in 29 of 30 views; signed overflow|core\.(two interlaced halves|the outline of an interlaced half)
images one pixel wide, poses moved beyond all numbers|signed overflow|core\.(a pose moved further|hits agree with the quadratic equation|.*at every extreme)
outputs that name an input: itself, its MTL, a picture, a link|destroyed, exit code 0|tools\.(own files|a file guard|a symbolic link)
half turns of quaternions, and eyes at exactly one radius (at 2118bb6)|signed overflow; half of all turns refused|core\.(half turns about any axis|quaternions of the smallest|no rounding of a pose)
generated fields whose numbers are at their limits (at 2118bb6)|signed overflow|core\.(.* whose every number is at its end|a texture's steps of any size)
spans, axes, sides, shifts and counts one beyond their limits (at 989714f)|any number was taken as a span|core\.(a span that no|both_layouts\.of all numbers, only|every component of an axis|an image's sides|counts of surface)
every option: nan, inf, an empty word, 10^9, a line break (at 2118bb6)|`nan` passed every range; seeds were cut|tools\.no option takes
FIFOs, links to nowhere and to themselves (at 2118bb6)|Ctrl-C was swallowed; links were replaced|tools\.(an output follows a link|Ctrl-C ends a command that waits)
pose, weights and cache: a device without an end, a link to itself (at f3e3b91)|filled the memory; no remedy|tools\.(a pose from a device|weights from a device|a cache behind)
`ulimit -f` (at 2118bb6)|killed without a word|tools\.(a limit of the size|a bake over the limit)
field: every truncation, every single-byte change|nothing|core\.(every truncation and one|every single-byte change)
surface field whose sliver takes depths for an outline's mark (fuzzing)|read beside the stripe's samples|fuzz\.field
232,000 random frames on emulated boards (at 45b1679)|twice another pixel than in the whole frame|core\.(samples are hardly nearer|an opaque edge behind glass)
weights of a filter: every truncation, every byte|nothing|tools\.weights (that are cut short|with any byte)|fuzz\.weights
picture of 38 bytes (16-bit PNM); TGA of 18 bytes that claims 23,000²|read beyond the heap; 3.6 GB, 42 s|baker\.picture file: (other formats|sizes are checked)
PNG, JPEG, HDR, EXR: every truncation|`.hdr` never ended|baker\.(picture file: every truncation|sky picture: every truncation)
EXR of 430 bytes (fuzzing); sparse PNG of 6 GB|gigabytes; read whole|fuzz\.picture|baker\.picture file: a sparse file
EXR of 25 bytes whose header claims a part of 1.9 GB (at f3e3b91)|took the memory before it refused|baker\.sky picture: an EXR header
volume of a few bytes that claims 10^12 voxels; NIfTI cut short|nothing|baker\.(every truncation is refused, packed|a small file that claims)|fuzz\.nifti
OBJ, MTL, scene files, damaged at random and cut short|nothing|baker\.(mutation|obj: every truncation)|fuzz\.(obj|scene)
list of 10^63 numbers in the text of a PLY (fuzzing, at aad58aeb)|undefined conversion to an integer|fuzz\.ply|baker\.PLY: what claims
library named 2,000 times; 100,000 materials|4 minutes; 3 minutes|baker\.obj: (a library is read once|of many materials)
OBJ line of 100,000 pieces; 200,000 triangles at one edge (at f6b01a4)|23 s; above 1 minute|baker\.(text lines: a line of a million|Triangles share an edge)
shards and checkpoints: every truncation, damaged bytes|nothing|baker\.(merge: every truncation|checkpoint: every truncation|stage file)|fuzz\.shard
shard of 1.2 kB that says there are a million; of 176 bytes, a million rows (at 4d48ff1b)|message of 7.9 MB; 0.6 s of looking|baker\.merge: (of a million|rows beyond)
bakes killed before random writes, or each life before its fifth|a surface bake began again and again|tools\.(a bake that was killed ten|a surface bake of which each)
`ulimit -u`: the first thread or a later one is not given (at f3e3b91)|aborted|faults\.fail_on_purpose
an allocation, a read, write, sync or rename fails, one after the other|`terminate`; no mend; `embed` left one file of two|faults\.fail_on_purpose
full disk behind standard output|exit code 0, JSON cut|tools\.(a full disk behind|a failure keeps its own)
Ctrl-C while a scene loads; field cut short while it is used|nothing happened; SIGBUS|tools\.(Ctrl-C|a field's file may be cut)
UTF-16, numbers below 0, pipes; `int.lumi`|poor words; waited for ever; the symbol `int`|tools\.(numbers below 0|symbols are C|words of C)
wrong field, section, address, buffer, stripe on emulated boards|nothing|cortex-.*(bad_input|wild_read)
host of big-endian bytes|neither supported nor refused|machines\.s390x
TABLE
}

# try_attack WHAT FOUND TESTS
try_attack() {
  local log=$root/build/attack.log count
  if ctest --test-dir "$root/build/release" --parallel "$jobs" --tests-regex "^($3)" </dev/null >"$log" 2>&1; then
    count=$(sed --quiet 's/^100% tests passed, 0 tests failed out of //p' "$log")
    [[ -n $count ]] || die "no test is named ^($3): mend the list in tools/lab/attacks.sh"
    json_row attack "$1" first "$2" now nothing tests "$count" >>"$rows"
  else
    json_row attack "$1" first "$2" now '**a fault**' tests '""' >>"$rows"
    cat "$log"
    failures=$((failures + 1))
  fi
}

main() {
  local write_docs=false what found tests
  while (($#)); do
    case $1 in
      --docs) write_docs=true ;;
      --help) help "$0" && exit ;;
      *) wrong_call "unknown argument '$1'" ;;
    esac
    shift
  done
  run_step "Build for the host" build_preset host
  : >"$rows"
  while IFS='|' read -r what found tests; do
    try_attack "$what" "$found" "$tests"
  done < <(attacks)
  cat "$rows"
  if $write_docs; then put attacks attacks <"$rows"; fi
  ((failures == 0)) || die "$failures attacks found something; the messages above say what"
}

main "$@"
