#!/usr/bin/env bash
# Prints how many matches have late decisions while 250 teams in their own processes play at once.
# Usage: bench/tournament/crowd.sh PROGRAM [PAIRS]
set -euo pipefail
program=$(realpath "${1:?Usage: bench/tournament/crowd.sh PROGRAM [PAIRS]}")
pairs=${2:-1000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$program" new-team cpp team >/dev/null 2>&1
make -s -C team
"$program" tournament run ./team/team.so ./team/team.so:margin=0.05 --format match --pairs "$pairs" --half-seconds 10 \
  --jobs 125 --out results >/dev/null
late=$(grep -c '"late"' results/matches.jsonl || true)
echo "matches $((2 * pairs)), 125 at once, with late decisions: $late"
grep -o '"outcome":"[a-z]*"' results/matches.jsonl | sort | uniq -c
