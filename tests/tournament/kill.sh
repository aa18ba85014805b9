#!/usr/bin/env bash
# Kills a tournament with kill -9 at random moments and starts it again, until it is complete; repeats this. No match in the log
# may be lost or doubled, and the reports must equal those of an undisturbed run.
# Usage: tests/tournament/kill.sh PROGRAM [KILLS]
set -euo pipefail
program=$(realpath "${1:?Usage: tests/tournament/kill.sh PROGRAM [KILLS]}")
kills=${2:-500}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Replaces the shell that calls it, so that the signal kills the program itself.
run() { exec "$program" tournament run idle random chaser --pairs 20 --half-seconds 2 --jobs 2 --out "$1" >/dev/null 2>&1; }
report() {
  "$program" tournament report "$1" --json >"$1.json"
  "$program" tournament report "$1" --csv "$1.csv" >"$1.txt"
}
# Prints the complete lines of the log.
whole_lines() { if [ -e "$1/matches.jsonl" ]; then head -n "$(wc -l <"$1/matches.jsonl")" "$1/matches.jsonl"; fi; }
fail() { echo "kill.sh: $*" >&2; exit 1; }

(run undisturbed)
report undisturbed
matches=$(($(wc -l <undisturbed/matches.jsonl) - 1))

done_kills=0 tournaments=0
while [ "$done_kills" -lt "$kills" ]; do
  rm -rf killed
  while true; do
    whole_lines killed >before
    run killed &
    process=$!
    sleep "0.$(printf '%03d' $((RANDOM % 400)))"
    kill -9 "$process" 2>/dev/null || true
    code=0
    wait "$process" 2>/dev/null || code=$?
    whole_lines killed >after
    head -c "$(wc -c <before)" after | cmp -s - before || fail "a match was lost after $done_kills kills"
    [ "$code" -ne 0 ] || break
    [ "$code" -eq 137 ] || fail "exit code $code instead of a kill"
    done_kills=$((done_kills + 1))
  done
  tournaments=$((tournaments + 1))
  [ "$(wc -l <killed/matches.jsonl)" -eq $((matches + 1)) ] || fail "not $matches matches"
  [ "$(tail -n +2 killed/matches.jsonl | cut -d'"' -f4 | sort -u | wc -l)" -eq "$matches" ] || fail "a match was doubled"
  report killed
  for kind in json csv txt; do cmp -s "killed.$kind" "undisturbed.$kind" || fail "another report: $kind"; done
done
echo "$done_kills kills, $tournaments tournaments of $matches matches completed: 0 matches lost, 0 doubled, equal reports"
