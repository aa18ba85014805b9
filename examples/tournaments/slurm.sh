#!/usr/bin/env bash
# Plays a tournament as a Slurm job array with one task per shard, and merges the shards in a job that waits for them.
# The same command continues after failed tasks: finished matches are not played again.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
plan=${1:?Usage: slurm.sh PLAN SHARDS FOLDER    FOLDER is on a disk that all nodes share}
shards=${2:?Usage: slurm.sh PLAN SHARDS FOLDER}
folder=${3:?Usage: slurm.sh PLAN SHARDS FOLDER}
mkdir -p "$folder"

# Options of your cluster go here: --partition, --account, --time, --cpus-per-task.
options=(--chdir="$folder" --output=%x-%A-%a.log)
plan=$(realpath "$plan")
array=$(sbatch --parsable "${options[@]}" --array="1-$shards" "$here/slurm-shard.sbatch" "$plan")
merge=$(sbatch --parsable "${options[@]}" --output=%x-%j.log --dependency="afterok:${array%%;*}" \
  --kill-on-invalid-dep=yes "$here/slurm-merge.sbatch")
echo "array ${array%%;*}, then merge ${merge%%;*}"
