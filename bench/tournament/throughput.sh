#!/usr/bin/env bash
# Compares the speed of a tournament with that of one `fulbito match` per core, which play the same matches one after another.
# Usage: bench/tournament/throughput.sh PROGRAM [PAIRS] [ROUNDS]
set -euo pipefail
program=$(realpath "${1:?Usage: bench/tournament/throughput.sh PROGRAM [PAIRS] [ROUNDS]}")
pairs=${2:-24}
rounds=${3:-3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

seconds() {
  local begin
  begin=$(date +%s.%N)
  "$@" >/dev/null 2>&1
  awk "BEGIN { print $(date +%s.%N) - $begin }"
}

tournament() {
  "$program" tournament run libero classic --format match --pairs "$pairs" --half-seconds 150 --jobs "$(nproc)" --out "$1"
}

alone() { xargs -P "$(nproc)" -L 1 "$program" match --half-seconds 150 --json < matches.txt; }

tournament first >/dev/null 2>&1
# Extracts teams and seed of each match from the log.
sed -n 's/.*"teams":\["\([^"]*\)","\([^"]*\)"\].*"seed":\([0-9]*\).*/\1 \2 --seed \3/p' first/matches.jsonl > matches.txt
echo "matches $(wc -l < matches.txt), on $(nproc) cores"
for round in $(seq "$rounds"); do
  together=$(seconds tournament "round-$round")
  single=$(seconds alone)
  awk "BEGIN { printf \"tournament %.2f s, single matches %.2f s: ratio %.3f, %.0f matches per hour\n\", \
    $together, $single, $single / $together, 2 * $pairs * 3600 / $together }"
done
