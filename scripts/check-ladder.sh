#!/usr/bin/env bash
# Plays the built-in teams against each other in short matches, and compares with the committed results. See --help.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/check-ladder.sh [--update] [--folder FOLDER] PROGRAM      e.g. scripts/check-ladder.sh build/release/fulbito

Plays FOLDER/plan.toml and compares with FOLDER/matches.csv, a line per match, and FOLDER/table.txt, the table. Both tell
what is played, not by which build: the identities of matches are left out.

  --update         write the files anew: a change of behaviour belongs into the same commit as its results
  --folder FOLDER  default: tests/tournament/ladder

Exit code: 0 as committed, or written; 1 something differs; 2 wrong use; others of the program.
USAGE
}

update=false folder='' program=''
while [ $# -gt 0 ]; do
  case $1 in
    --update) update=true ;;
    --folder) folder=$(realpath "${2:?check-ladder.sh: --folder needs a folder}") && shift ;;
    -h | --help) usage && exit 0 ;;
    -*) echo "check-ladder.sh: unknown option '$1' (see --help)" >&2; exit 2 ;;
    *) program=$1 ;;
  esac
  shift
done
[ -n "$program" ] || { echo "check-ladder.sh: PROGRAM is missing (see --help)" >&2; exit 2; }
[ -x "$program" ] || { echo "check-ladder.sh: no program '$program'" >&2; exit 2; }
program=$(realpath "$program")
cd "$(dirname "$0")/.."
folder=${folder:-$PWD/tests/tournament/ladder}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

play() {
  "$program" tournament run "$folder/plan.toml" --out "$work/results" --csv "$work/all.csv" >"$work/table.txt" 2>"$work/log" ||
    { local code=$?; cat "$work/log" >&2; exit "$code"; }
  # Leaves out the match ids, because they change with the sources even if play stays the same.
  awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "id") id = i }
    { line = ""; for (i = 1; i <= NF; ++i) if (i != id) line = line (line == "" ? "" : OFS) $i; print line }' \
    "$work/all.csv" >"$work/matches.csv"
}

# Prints the differences by pair of teams, with the first match of each.
explain() {
  awk -F, '
    FNR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    { key = $at["pair"] "." $at["leg"]; score = $at["goals_blue"] ":" $at["goals_yellow"] }
    NR == FNR { line[key] = $0; old[key] = score; next }
    {
      teams = $at["blue"] < $at["yellow"] ? $at["blue"] " and " $at["yellow"] : $at["yellow"] " and " $at["blue"]
      ++matches[teams]
      known = key in line
      if (known && line[key] == $0) { delete line[key]; next }
      if (!changed[teams]++) {
        order[++pairings] = teams
        first[teams] = $at["blue"] " against " $at["yellow"] " from " $at["start"] ": " \
          (known ? old[key] == score ? score ", by other moves" : old[key] " -> " score : "new, " score)
      }
      delete line[key]
    }
    END {
      for (i = 1; i <= pairings; ++i) {
        printf "  %s: %d of %d matches; first %s\n", order[i], changed[order[i]], matches[order[i]], first[order[i]]
      }
      for (key in line) ++gone
      if (gone) printf "  %d matches are gone\n", gone
    }' "$1" "$2" | tr -d '"'
}

play
if $update; then
  cp "$work/matches.csv" "$work/table.txt" "$folder"
  echo "check-ladder: wrote $folder/matches.csv and $folder/table.txt"
  exit 0
fi
for file in matches.csv table.txt; do
  [ -f "$folder/$file" ] || { echo "check-ladder: there is no $folder/$file: write it with --update" >&2; exit 1; }
done
if cmp -s "$work/matches.csv" "$folder/matches.csv" && cmp -s "$work/table.txt" "$folder/table.txt"; then
  echo "check-ladder: all $(($(wc -l <"$folder/matches.csv") - 1)) matches of the built-in teams are as committed"
  exit 0
fi
{
  if cmp -s "$work/matches.csv" "$folder/matches.csv"; then
    echo "check-ladder: all matches are as committed in $folder, but not the table:"
  else
    echo "check-ladder: the built-in teams do not play as committed in $folder:"
  fi
  explain "$folder/matches.csv" "$work/matches.csv"
  diff -u --label 'table as committed' --label 'table now' "$folder/table.txt" "$work/table.txt" | head -n 40 || true
  echo "Is the change meant? Then commit its results with it: scripts/check-ladder.sh --update ${program#"$PWD/"}"
} >&2
exit 1
