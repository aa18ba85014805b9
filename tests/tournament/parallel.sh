#!/usr/bin/env bash
# Checks that the recipe for GNU parallel gives the reports of a single run, also when it continues after a
# failed shard.
# Usage: tests/tournament/parallel.sh PROGRAM
set -euo pipefail
program=$(realpath "${1:?Usage: tests/tournament/parallel.sh PROGRAM}")
# shellcheck source=tests/tournament/compare.sh
. "$(dirname "$0")/compare.sh"
trap 'rm -rf "$work"' EXIT
play_undisturbed "$program"

# A folder in the place of the log of shard 2, so that this shard cannot write its results.
results="$work/my results"
mkdir -p "$results/shard-2/matches.jsonl"
if "$root/examples/tournaments/parallel.sh" "$plan" 3 "$results" --jobs 2 2>"$work/log"; then
  fail "a shard without a log is no failure"
fi
[ ! -e "$results/report.html" ] || fail "there is a report although a shard failed"
rmdir "$results/shard-2/matches.jsonl"
"$root/examples/tournaments/parallel.sh" "$plan" 3 "$results" --jobs 2 >/dev/null 2>"$work/log" ||
  { cat "$work/log" >&2; fail "the second try failed"; }
expect_same "$results"
echo "parallel.sh: three shards give the reports of one run, also after a failed shard"
