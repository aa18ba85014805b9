#!/usr/bin/env bash
# Plays a tournament in shards with GNU parallel, on this machine or others, and merges them.
# The same command continues after failures: finished matches are not played again.
set -euo pipefail
plan=${1:?Usage: parallel.sh PLAN SHARDS FOLDER [OPTIONS OF parallel]    e.g. --sshloginfile hosts --workdir "$PWD"}
shards=${2:?Usage: parallel.sh PLAN SHARDS FOLDER}
folder=${3:?Usage: parallel.sh PLAN SHARDS FOLDER}
shift 3
mkdir -p "$folder"

# Exit code 7 means that a match does not repeat itself. A retry would only hide that, so nothing is retried.
parallel --will-cite --quote --halt now,fail=1 --joblog "$folder/jobs.log" "$@" \
  fulbito tournament run "$plan" --shard "{}/$shards" --out "$folder/shard-{}" --jobs 1 --verify 1% ::: $(seq "$shards")
exec fulbito tournament merge "$folder"/shard-* --out "$folder/merged" --html "$folder/report.html" \
  --csv "$folder/matches.csv" --markdown "$folder/report.md"
