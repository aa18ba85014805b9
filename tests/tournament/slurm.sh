#!/usr/bin/env bash
# Starts a Slurm of one node in its own folder, as any user and without systemd or cgroups. Runs the recipe of
# examples/tournaments there: once with a shard that fails, then again to the end. Stops everything afterwards.
# Usage: tests/tournament/slurm.sh PROGRAM
set -euo pipefail
program=$(realpath "${1:?Usage: tests/tournament/slurm.sh PROGRAM}")
# shellcheck source=tests/tournament/compare.sh
. "$(dirname "$0")/compare.sh"
export PATH="$PATH:/usr/sbin:/sbin"
export SLURM_CONF=$work/slurm.conf
readonly patience=120  # [s] limit for the end of a job
daemons=()

take_down() {
  local status=$? daemon
  # Jobs first, because their processes do not belong to a daemon.
  if [ "${#daemons[@]}" -gt 0 ]; then timeout 10 scancel --full --signal=KILL --state=RUNNING --user="$(id -un)" || true; fi
  for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
  for daemon in "${daemons[@]}"; do wait "$daemon" 2>/dev/null || true; done
  if [ "$status" -ne 0 ]; then tail -n 20 "$work"/*.log "$work"/results/*.log 2>/dev/null || true; fi
  rm -rf "$work"
}
trap take_down EXIT

free_ports() {
  python3 -c 'import socket
open_ports = [socket.create_server(("127.0.0.1", 0)) for _ in range(2)]
print(*(port.getsockname()[1] for port in open_ports))'
}

write_configuration() {
  local host user controller node
  host=$(hostname -s) user=$(id -un)
  read -r controller node < <(free_ports)
  mkdir -p "$work/state" "$work/spool"
  cat >"$SLURM_CONF" <<CONFIGURATION
ClusterName=recipe
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$controller
SlurmdPort=$node
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$work/munge.sock
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,bf_interval=1
MailProg=/bin/true
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=10 State=UP
CONFIGURATION
}

# start NAME PROGRAM ARGUMENTS...: starts a daemon in the foreground and keeps its process id.
start() {
  local name=$1
  shift
  "$@" >"$work/$name.log" 2>&1 &
  daemons=("$!" "${daemons[@]}")
}

start_slurm() {
  (umask 077 && head -c 1024 /dev/urandom >"$work/munge.key")
  # --force, because everyone may write to /tmp, the parent of the folder.
  start munged munged --foreground --force --key-file="$work/munge.key" --socket="$work/munge.sock" \
    --pid-file="$work/munged.pid" --seed-file="$work/munge.seed" --log-file="$work/munge.log"
  wait_until 20 "munge does not answer" munge --socket="$work/munge.sock" --no-input
  start slurmctld slurmctld -D -f "$SLURM_CONF"
  start slurmd slurmd -D -f "$SLURM_CONF"
  wait_until 30 "the node is not idle" node_is_idle
}

node_is_idle() { [ "$(sinfo --noheader --format=%T)" = idle ]; }

# wait_until SECONDS COMPLAINT COMMAND...
wait_until() {
  local deadline=$((SECONDS + $1)) complaint=$2
  shift 2
  until "$@" >/dev/null 2>&1; do
    [ "$SECONDS" -lt "$deadline" ] || fail "$complaint"
    sleep 0.2
  done
}

no_job_left() { [ -z "$(squeue --noheader)" ]; }

# job_state JOB
job_state() { scontrol show job "$1" | sed -n 's/^ *JobState=\([A-Z]*\).*/\1/p' | sort | uniq | paste -sd,; }

# submit: runs the recipe and sets $array and $merge.
submit() {
  read -r array merge < <("$root/examples/tournaments/slurm.sh" "$plan" 3 "$work/results" | tr -dc '0-9 \n')
  wait_until "$patience" "jobs are left after $patience s" no_job_left
}

play_undisturbed "$program"
write_configuration
start_slurm

# Shard 2 exits with the code of a match that does not repeat itself, so the results must not be merged.
rm "$work/bin/fulbito"
cat >"$work/bin/fulbito" <<WRAPPER
#!/bin/sh
[ "\${SLURM_ARRAY_TASK_ID:-}" = 2 ] && exit 7
exec "$program" "\$@"
WRAPPER
chmod +x "$work/bin/fulbito"
mkdir "$work/results"
submit
[ "$(job_state "$array")" = COMPLETED,FAILED ] || fail "the array is $(job_state "$array")"
[ "$(job_state "$merge")" = CANCELLED ] || fail "the merge is $(job_state "$merge") although a shard failed"
[ ! -e "$work/results/report.html" ] || fail "there is a report although a shard failed"

ln -sf "$program" "$work/bin/fulbito"
submit
[ "$(job_state "$merge")" = COMPLETED ] || fail "the merge is $(job_state "$merge")"
expect_same "$work/results"
grep -q '^0 matches played' "$work/results/fulbito-shard-$array-1.log" || fail "shard 1 was played again"
echo "slurm.sh: $(sinfo --version): an array of 3 gives the reports of one run, also after a failed shard"
