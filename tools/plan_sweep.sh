#!/bin/sh
# SPDX-License-Identifier: MIT
# tools/plan_sweep.sh SCENE [BUDGET...]
# Compares what `lumi bake --fit` chooses with the best of a full sweep at each budget (250kB 1MB 4MB unless told
# otherwise). Every plan of the sweep has its parameters set by hand and is measured in the same way: same views, same
# light paths. Prints a table; ends with 1 if a choice is more than 0.3 dB below the best.
# LUMI: the program [build/tools/lumi]. WORK: a folder for references and plans, kept [plan-sweep].
# ORIGINS, MEANS, TRIANGLES: the grid. It takes hours for large budgets.
set -eu
lumi=${LUMI:-build/tools/lumi}
work=${WORK:-plan-sweep}
limit_db=0.3
scene=$1
shift
[ $# -gt 0 ] || set -- 250kB 1MB 4MB
mkdir -p "$work"

# plan NAME OPTION...: measures into NAME.json unless it is there.
plan() {
  name=$1
  shift
  [ -s "$name.json" ] || "$lumi" bake "$scene" --plan-only --cache "$work/truths" --plan "$name.json" "$@" > "$name.txt"
}

chosen_db() {
  python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["chosen"]["psnr_db"])' "$1"
}

missed=0
printf '%-10s %10s %12s  %s\n' budget planner sweep 'best of the sweep'
for budget; do
  plan "$work/$budget" --fit "$budget"
  best=0
  best_name=none
  for origins in ${ORIGINS:-64 128 256 512}; do
    for mean in ${MEANS:-48 80 128}; do
      for triangles in ${TRIANGLES:-2000 4000 8000}; do
        name="$work/$budget-$origins-$mean-$triangles"
        # A plan that does not fit ends with 1 and leaves no file.
        plan "$name" --fit "$budget" --layout guided --origins "$origins" --mean-resolution "$mean" \
          --proxy-triangles "$triangles" 2> "$name.log" || continue
        db=$(chosen_db "$name.json")
        if awk "BEGIN { exit !($db > $best) }"; then
          best=$db
          best_name="$origins origins, mean $mean, $triangles triangles"
        fi
      done
    done
  done
  planned=$(chosen_db "$work/$budget.json")
  printf '%-10s %7.2f dB %9.2f dB  %s\n' "$budget" "$planned" "$best" "$best_name"
  awk "BEGIN { exit !($planned < $best - $limit_db) }" && missed=1
done
exit "$missed"
