#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/plan_sweep.sh SCENE [BUDGET...]
# Compares what `lumi bake --fit` chooses with the best of a full sweep at each budget (250kB 500kB 1MB unless told
# otherwise). Every plan of the sweep has its parameters set by hand and is measured in the same way: same views, same
# light paths. Prints a Markdown table; ends with 1 if a choice is more than 0.3 dB below the best.
# LUMI: the program [build/release/tools/lumi]. WORK: a folder for references and plans, kept [build/plan-sweep]; what
# it holds is not measured again. ORIGINS, MEANS, TRIANGLES: the grid; every place is tried with and without occlusion.
# THREADS: of a bake [all]. The default grid takes about ten minutes of CPU time a budget.
set -euo pipefail

lumi=${LUMI:-build/release/tools/lumi}
work=${WORK:-build/plan-sweep}
read -ra origin_counts <<<"${ORIGINS:-64 96 128 192}"
read -ra mean_resolutions <<<"${MEANS:-48 80 112}"
read -ra triangle_counts <<<"${TRIANGLES:-2000 4000}"
threads=${THREADS:-0}
limit_db=0.3

# plan NAME OPTION...: measures into NAME.json, with the CPU time in NAME.cpu, unless it is there. Fails where nothing
# fits: then NAME.none is there.
plan() {
  local name=$1 TIMEFORMAT=%U
  shift
  [[ ! -e $name.none ]] || return 1
  [[ ! -s $name.json ]] || return 0
  { time "$lumi" bake "$scene" --plan-only --cache "$work/truths" --threads "$threads" --plan "$name.json" "$@" \
    >"$name.txt" 2>"$name.log"; } 2>"$name.cpu" && return 0
  grep -q 'nothing fits' "$name.log" || { cat "$name.log" >&2 && exit 1; }
  touch "$name.none"
  return 1
}

# sweep BUDGET: measures every plan of the grid, one trial each.
sweep() {
  local budget=$1 origins mean triangles occlusion
  local fixed=(--layout guided --texels 4 --mean-format palette8 --trials 1)
  for triangles in "${triangle_counts[@]}"; do
    for origins in "${origin_counts[@]}"; do
      for mean in "${mean_resolutions[@]}"; do
        for occlusion in '' --no-occlusion; do
          plan "$work/$budget-$origins-$mean-$triangles$occlusion" --fit "$budget" "${fixed[@]}" --origins "$origins" \
            --mean-resolution "$mean" --proxy-triangles "$triangles" ${occlusion:+"$occlusion"} || true
        done
      done
    done
  done
}

# compare BUDGET: its row of the table; fails where the planner's choice is too far below the best.
compare() {
  python3 - "$work" "$1" "$limit_db" <<'PYTHON'
import glob, json, re, sys

work, budget, limit_db = sys.argv[1], sys.argv[2], float(sys.argv[3])
read = lambda name: json.load(open(name))
plans = [read(name)["chosen"] for name in glob.glob(f"{work}/{budget}-*.json")]
best = max(plans, key=lambda plan: plan["psnr_db"])
planned = read(f"{work}/{budget}.json")
seconds = float(open(f"{work}/{budget}.cpu").read())
short = lambda plan: re.sub(r"guided, | palette8|4-bit texels, ", "", plan["plan"])
gap = planned["chosen"]["psnr_db"] - best["psnr_db"]
print(f"| {budget} | {short(planned['chosen'])} | {planned['chosen']['psnr_db']:.2f} | {len(planned['tried'])} | {seconds:.0f} s "
      f"| {short(best)} | {best['psnr_db']:.2f} | {len(plans)} | {gap:+.2f} |")
sys.exit(gap < -limit_db)
PYTHON
}

[[ $# -gt 0 ]] || { sed -n '3,10s/^# //p' "$0" >&2 && exit 2; }
scene=$1
shift
[[ $# -gt 0 ]] || set -- 250kB 500kB 1MB
mkdir -p "$work"
missed=0
printf '| budget | planner | dB | trials | CPU time | best of the sweep | dB | plans that fit | difference |\n'
printf '|---|---|---|---|---|---|---|---|---|\n'
for budget; do
  plan "$work/$budget" --fit "$budget"
  sweep "$budget"
  compare "$budget" || missed=1
done
exit "$missed"
