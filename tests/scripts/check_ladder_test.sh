#!/usr/bin/env bash
# Changes committed results of a small tournament, and expects scripts/check-ladder.sh to name what differs.
# Usage: check_ladder_test.sh PROJECT FULBITO
set -euo pipefail
project=$1 program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/plan.toml" <<'PLAN'
[tournament]
format = "match"
pairs = 2
[match]
half_seconds = 5
[[team]]
team = "chaser"
[[team]]
team = "idle"
PLAN

# expect CODE TEXT NAME [OPTIONS]: the exit code and a piece of the output.
expect() {
  local output status=0
  output=$("$project"/scripts/check-ladder.sh --folder "$folder" "${@:4}" "$program" 2>&1) || status=$?
  if ((status != $1)) || [[ $output != *"$2"* ]]; then
    echo "check_ladder_test.sh: $3: exit code $status instead of $1, or no '$2' in: $output" >&2
    exit 1
  fi
}

expect 1 'write it with --update' 'nothing committed'
expect 0 'wrote' 'first results' --update
expect 0 'all 4 matches' 'as committed'
if grep -qE '[0-9a-f]{32}' "$folder/matches.csv"; then
  echo "check_ladder_test.sh: identities are compared, which depend on the sources" >&2
  exit 1
fi

# The last character of a line is of the final hash.
sed -i '2s/.$/x/' "$folder/matches.csv"
expect 1 'chaser and idle: 1 of 4 matches; first chaser against idle from kick-off:0: ' 'another match'
expect 1 'do not play as committed' 'another match'
expect 1 'by other moves' 'the same score'
expect 1 '--update' 'what to do'
expect 0 'wrote' 'meant' --update
sed -i '1s/^/once /' "$folder/table.txt"
expect 1 '-once ' 'another table'
expect 1 'all matches are as committed' 'another table of the same matches'
expect 0 'wrote' 'meant' --update
sed -i 's/pairs = 2/pairs = 1/' "$folder/plan.toml"
expect 1 '2 matches are gone' 'a shorter plan'
sed -i 's/pairs = 1/pairs = 3/' "$folder/plan.toml"
expect 1 'new, ' 'a longer plan'
sed -i 's/"idle"/"nobody"/' "$folder/plan.toml"
expect 2 'nobody' 'a wrong plan'
