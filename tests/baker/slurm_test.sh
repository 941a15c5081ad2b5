#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# slurm_test.sh LUMI BAKE_ARRAY SCENE
# Starts munge and Slurm on this machine, loopback only, without systemd; bakes a field as a job array while one task's
# process is killed and another task is requeued; compares the merged bytes with a bake on one machine.
set -euo pipefail

lumi=$1
bake_array=$2
scene=$3
export PATH=$PATH:/usr/sbin:/sbin
readonly shards=4
# Some seconds for each shard on one processor.
readonly options=(--origins 96 --directions 200 --spp 384 --seed 3)

work=$(mktemp -d "${TMPDIR:-/tmp}/lumi-slurm.XXXXXX")
chmod 755 "$work" # munge wants its socket where everybody may pass
started=()

say() { printf '%s\n' "$*"; }

fail() {
  say "FAILED: $*"
  tail -n 20 "$work"/*.log "$work"/field/*.log 2>/dev/null || true
  squeue 2>/dev/null || true
  exit 1
}

cleanup() {
  local pid
  if [[ -n ${SLURM_CONF:-} ]]; then
    scancel --user="$(id -un)" --signal=KILL 2>/dev/null || true
  fi
  for pid in "${started[@]}"; do kill "$pid" 2>/dev/null || true; done
  for pid in "${started[@]}"; do wait "$pid" 2>/dev/null || true; done
  rm -rf "$work"
}
trap cleanup EXIT

# wait_for SECONDS COMMAND...: until the command succeeds.
wait_for() {
  local end=$((SECONDS + $1))
  shift
  until "$@" >/dev/null 2>&1; do
    ((SECONDS < end)) || return 1
    sleep 0.1
  done
}

free_port() {
  local port
  while port=$((RANDOM % 20000 + 20000)); do
    (: <"/dev/tcp/127.0.0.1/$port") 2>/dev/null || break
  done
  printf '%s' "$port"
}

# start NAME COMMAND...: a daemon in the foreground of a shell of ours.
start() {
  local log=$work/$1.log
  shift
  "$@" >"$log" 2>&1 &
  started+=("$!")
}

start_munge() {
  dd if=/dev/urandom of="$work/munge.key" bs=1024 count=1 status=none
  chmod 400 "$work/munge.key"
  start munged munged --foreground --force --key-file="$work/munge.key" --socket="$work/munge.socket" \
    --pid-file="$work/munge.pid" --seed-file="$work/munge.seed" --log-file="$work/munged-own.log" --num-threads=1
  wait_for 10 munge --no-input --socket="$work/munge.socket" || fail "munged does not answer"
}

write_config() {
  local user host
  user=$(id -un)
  host=$(hostname -s)
  mkdir -p "$work/state" "$work/spool" "$work/field"
  cat >"$work/slurm.conf" <<EOF
ClusterName=lumi
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
# Requeued jobs wait until their credential has run out.
AuthInfo=socket=$work/munge.socket,cred_expire=5
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
KillWait=2
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP
EOF
  export SLURM_CONF=$work/slurm.conf
}

is_idle() { [[ $(sinfo --noheader --format=%t) == idle ]]; }

start_slurm() {
  write_config
  start slurmctld slurmctld -D -i
  wait_for 20 scontrol ping || fail "slurmctld does not answer"
  start slurmd slurmd -D -N "$(hostname -s)"
  wait_for 30 is_idle || fail "slurmd does not become idle"
}

# The process of a shard's bake. Its arguments end with --shard K/COUNT.
pid_of_shard() { pgrep -f -- "^$lumi bake .*$work/field/.*--shard $1/$shards\$"; }

has_rows() { [[ -s $work/field/out.lumi.$1-of-$shards.shard.part ]] && pid_of_shard "$1"; }

restarts() { scontrol show job "$1" | sed -n 's/.*Restarts=\([0-9]*\).*/\1/p' | head -n 1; }

was_requeued() { (($(restarts "$1") >= 1)); }

is_finished() { [[ $(scontrol show job "$1" | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p') == COMPLETED ]]; }

main() {
  local ids array merge
  "$lumi" bake "$scene" -o "$work/one.lumi" --threads 2 "${options[@]}"
  start_munge
  start_slurm
  ids=$(cd "$work" && LUMI=$lumi "$bake_array" "$shards" "$work/field/out.lumi" "$scene" "${options[@]}")
  array=${ids% *}
  merge=${ids#* }
  say "array $array, merge $merge"

  wait_for 60 has_rows 1 || fail "shard 1 does not start"
  kill -KILL "$(pid_of_shard 1)" || fail "shard 1 was too fast to be killed"
  wait_for 60 was_requeued "${array}_1" || fail "the killed task was not requeued"
  say "killed and requeued: shard 1"

  wait_for 60 has_rows 3 || fail "shard 3 does not start"
  scontrol requeue "${array}_3" || fail "shard 3 was too fast to be requeued"
  wait_for 60 was_requeued "${array}_3" || fail "shard 3 was not requeued"
  say "requeued: shard 3"

  wait_for 180 is_finished "$merge" || fail "the merge does not end"
  cmp "$work/one.lumi" "$work/field/out.lumi" || fail "the merged field differs from the one-machine bake"
  say "the merged field has the bytes of the one-machine bake"
}

main
