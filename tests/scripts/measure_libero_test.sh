#!/usr/bin/env bash
# Runs scripts/measure-libero.sh with short matches, and expects every table, and that it goes on where it stopped.
# Usage: measure_libero_test.sh PROJECT FULBITO
set -euo pipefail
project=$1 program=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

die() { echo "measure_libero_test.sh: $*" >&2; exit 1; }

# measure CODE TEXT OPTIONS...: the exit code and a piece of what it prints.
measure() {
  local status=0
  "$project/scripts/measure-libero.sh" --quick --program "$program" --out "$folder/out" "${@:3}" >"$folder/log" 2>&1 || status=$?
  [ $status = "$1" ] || die "exit code $status instead of $1: $(cat "$folder/log")"
  [[ $(<"$folder/log") == *"$2"* ]] || die "no '$2' in: $(cat "$folder/log")"
}

measure 0 'match libero chaser --robot vsss --physics standard --rules vsss-3v3 --half-seconds 5 -n 1 --seed 2029'
page=$folder/out/libero.md
# Backticks are those of Markdown.
# shellcheck disable=SC2016
for text in '| points against each team, both robots | ≥ 90 % |' '| vsss | `univector` | training | 1 |' '| firasim | `kicker` | validation | 1 |' \
  '| firasim | fast | 2 mm, 2 ticks | 5v5 | validation |' '| vsss | standard | exact | 3v3 |' '| 13 `jam` |' '| `race` | striker |' \
  '| without | roles | matches on `vsss`' '## Where it falls short'; do
  grep -qF -- "$text" "$page" || die "no '$text' in the page: $(cat "$page")"
done

cp "$page" "$folder/first.md"
rm -r "$folder/out/series/vsss-fast-camera-5v5/twins.json" "$folder/out/drills/vsss.json"
measure 0 'match libero twins'
[ "$(grep -c '^measure-libero.sh: ' "$folder/log")" = 2 ] || die "it does more than what is missing: $(cat "$folder/log")"
cmp "$page" "$folder/first.md" || die 'going on changes the page'

measure 2 'other options' --seed 7
measure 2 "unknown option '--sed'" --sed 7
echo '# no marks' >"$folder/page.md"
measure 1 "'<!-- measured: bars -->' and" --page "$folder/page.md"
