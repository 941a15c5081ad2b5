#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# tools/slurm/bake_array.sh COUNT FIELD.lumi SCENE [OPTIONS of lumi bake]
# Submits a Slurm job array of COUNT tasks that each bake one shard of the field, and a job that merges the shards when
# all are done. Prints the ids of both jobs: array, merge. Paths must lead to the same files on every node.
#
# A task that is requeued, preempted or killed goes on from its checkpoint; one that dies of a signal requeues itself,
# up to 3 times. After failures call the script again as before: finished shards are not baked again.
#
# LUMI             the lumi program [lumi]
# LUMI_CPUS        processors for each task [1]
# LUMI_ARRAY_LIMIT tasks that run at once [all]
# SBATCH_...       partition, account, time limit and so on: Slurm's own variables, see sbatch(1)
set -euo pipefail

die() {
  printf 'bake_array.sh: %s\n' "$1" >&2
  exit 2
}

# The commands of one task; all arguments are quoted for the shell that runs them.
task_script() {
  local field=$1 scene=$2
  shift 2
  cat <<EOF
#!/usr/bin/env bash
$(printf '%q ' "$lumi" bake "$scene" -o "$field" --threads "$cpus" --progress json "$@") \\
  --shard "\$SLURM_ARRAY_TASK_ID/$count"
code=\$?
# Above 128: a signal ended it, most likely for want of memory. But not 130: Slurm asked it to stop, and knows why.
if ((code > 128 && code != 130 && \${SLURM_RESTART_COUNT:-0} < 3)); then
  scontrol requeue "\${SLURM_ARRAY_JOB_ID}_\$SLURM_ARRAY_TASK_ID"
fi
exit \$code
EOF
}

merge_script() {
  local field=$1 k shards=()
  for ((k = 1; k <= count; k++)); do
    shards+=("$field.$k-of-$count.shard")
  done
  printf '#!/usr/bin/env bash\nexec %s\n' "$(printf '%q ' "$lumi" merge -o "$field" "${shards[@]}")"
}

main() {
  if [[ ${1:-} == --help ]]; then
    sed -n '3,/^[^#]/{s/^# \{0,1\}//p}' "$0"
    return
  fi
  (($# >= 3)) || die 'say COUNT FIELD.lumi SCENE; --help shows how'
  count=$1
  local field=$2 array merge
  [[ $count =~ ^[1-9][0-9]*$ ]] || die "COUNT is a number of shards, not \"$count\""
  lumi=${LUMI:-lumi}
  cpus=${LUMI_CPUS:-1}
  shift
  array=$(task_script "$@" | sbatch --parsable --job-name=lumi-bake --requeue --open-mode=append \
    --array="1-$count${LUMI_ARRAY_LIMIT:+%$LUMI_ARRAY_LIMIT}" --ntasks=1 --cpus-per-task="$cpus" \
    --output="$field.%a-of-$count.log")
  merge=$(merge_script "$field" | sbatch --parsable --job-name=lumi-merge --dependency="afterok:${array%%;*}" \
    --kill-on-invalid-dep=yes --ntasks=1 --output="$field.merge.log")
  printf '%s %s\n' "${array%%;*}" "${merge%%;*}"
}

main "$@"
