#!/usr/bin/env bash
# Lets writes, syncs, renames and other calls of a tournament fail, one at a time. The exit code must be 5 with a message that
# names the folder, existing lines of the log must stay, and the same command must then complete the tournament.
# Usage: tests/tournament/faults.sh PROGRAM WATCHED_CALLS_LIBRARY
set -euo pipefail
usage="Usage: tests/tournament/faults.sh PROGRAM WATCHED_CALLS_LIBRARY"
program=$(realpath "${1:?$usage}")
library=$(realpath "${2:?$usage}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

run() { "$program" tournament run idle chaser --pairs 4 --half-seconds 2 --jobs 2 --out "$work/out" --csv "$1"; }
fail() { echo "faults.sh: $fault: $*" >&2; cat errors >&2; exit 1; }

run expected.csv >/dev/null 2>&1
cases=0
# ENOSPC 28, EIO 5, EDQUOT 122, EROFS 30, EACCES 13
for fault in "write "{1,2,3,6,10}" "{"28","28 half lasting","5","122 half"} "sync "{1,2,3,4,6,10}" "{5,28,"5 lasting"} \
  "rename 1 "{5,28,30} "open "{1,2}" "{13,28,5} "truncate 1 5" "lock 1 37"; do
  rm -rf out
  code=0
  FULBITO_FAULT_BELOW=$work/out FULBITO_FAULT=$fault LD_PRELOAD=$library run failed.csv >/dev/null 2>errors || code=$?
  [ "$code" -eq 5 ] || fail "exit code $code"
  grep -q "$work/out" errors || fail "the message does not name the folder"
  if [ -e out/matches.jsonl ]; then head -n "$(wc -l <out/matches.jsonl)" out/matches.jsonl >before; else : >before; fi
  run after.csv >/dev/null 2>errors || fail "the same command did not complete"
  head -c "$(wc -c <before)" out/matches.jsonl | cmp -s - before || fail "a match was lost"
  cmp -s after.csv expected.csv || fail "another report"
  cases=$((cases + 1))
done
echo "$cases failing calls: exit code 5, nothing lost, equal reports"
