# shellcheck shell=bash
# Shared by the tests of recipes: a temporary folder, the program as `fulbito`, and the reports of one undisturbed run of the
# example's plan to compare with. Sets $root, $work and $plan.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
# shellcheck disable=SC2034 # used by the scripts that source this file
plan=$root/examples/tournaments/plan.toml

fail() {
  echo "$(basename "$0"): $1" >&2
  exit 1
}

# play_undisturbed PROGRAM: puts the program on the PATH and plays the plan without shards.
play_undisturbed() {
  mkdir "$work/bin" "$work/whole"
  ln -s "$1" "$work/bin/fulbito"
  export PATH="$work/bin:$PATH"
  fulbito tournament run "$plan" --out "$work/whole/merged" --html "$work/whole/report.html" \
    --csv "$work/whole/matches.csv" --markdown "$work/whole/report.md" --json >"$work/whole.json" 2>"$work/whole.log" ||
    { cat "$work/whole.log" >&2; fail "the undisturbed run failed"; }
}

# expect_same FOLDER: checks that the folder has the reports of the undisturbed run, byte for byte.
expect_same() {
  local file
  for file in report.html matches.csv report.md; do
    cmp "$work/whole/$file" "$1/$file" || fail "$1/$file is not that of an undisturbed run"
  done
  fulbito tournament report "$1/merged" --json | cmp - "$work/whole.json" || fail "the JSON of $1 differs"
}
