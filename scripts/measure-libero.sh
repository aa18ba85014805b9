#!/usr/bin/env bash
# Measures libero and writes the tables of docs/results/libero.md anew. See --help.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/measure-libero.sh [OPTIONS]      e.g. scripts/measure-libero.sh --pairs 100 --out build/libero

Plays libero against every sparring team and against itself, on both robots, both profiles of physics, with exact and with
late and noisy sight, 3v3 and 5v5. Runs all drills. Measures what each skill is worth, in drills and in matches of 180 s against
the training teams. Then it writes the tables between the marks of docs/results/libero.md; all other text of the page stays.

  --pairs N       pairs against each team with standard physics, exact sight, 3v3, and against itself (default: 100)
  --grid-pairs N  pairs against each team in the rest of the grid, and of the short ones without a skill (default: a fifth of N)
  --seed S        seed of all matches and drills (default: 2029)
  --out FOLDER    keeps what is measured; the same command goes on where it stopped (default: build/libero)
  --program FILE  default: build/release/fulbito
  --page FILE     default: docs/results/libero.md
  --quick         short matches and few trials, to try the script; without --page the page is written to OUT/libero.md

With 100 pairs it takes about three hours on two cores. Teams and what they are for come from `fulbito list teams --json`.
Exit code: 0 the page is written; 2 wrong use; others of the program.
USAGE
}

fail() { echo "measure-libero.sh: $*" >&2; exit 2; }

root=$(realpath "$(dirname "$0")/..")
pairs=100 grid_pairs='' seed=2029 out=$root/build/libero program=$root/build/release/fulbito page='' quick=false
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage && exit 0 ;;
    --quick) quick=true && shift && continue ;;
    --pairs | --grid-pairs | --seed | --out | --program | --page) [ $# -gt 1 ] || fail "$1 needs a value" ;;
    *) fail "unknown option '$1' (see --help)" ;;
  esac
  case $1 in
    --pairs) pairs=$2 ;;
    --grid-pairs) grid_pairs=$2 ;;
    --seed) seed=$2 ;;
    --out) out=$(realpath -m "$2") ;;
    --program) program=$(realpath -m "$2") ;;
    --page) page=$(realpath -m "$2") ;;
  esac
  shift 2
done
[[ $pairs =~ ^[1-9][0-9]*$ ]] || fail "--pairs must be a number from 1"
grid_pairs=${grid_pairs:-$(((pairs + 4) / 5))}
[[ $grid_pairs =~ ^[1-9][0-9]*$ ]] || fail "--grid-pairs must be a number from 1"
[ -x "$program" ] || fail "no program '$program'"
cd "$root"
match=() short=(--half-seconds 90) trials=() drills=() worth=(--drill "3,6,7,8,9,10,11,12,13,14,15,16,17" --trials 200)
if $quick; then
  pairs=1 grid_pairs=1
  match=(--half-seconds 5) short=(--half-seconds 2) trials=(--trials 2) drills=(--drill "3,13") worth=(--drill "3,13" --trials 4)
fi
mkdir -p "$out"
if [ -z "$page" ]; then
  page=docs/results/libero.md
  ! $quick || { cp "$page" "$out/libero.md" && page=$out/libero.md; }
fi

# Results of another program or of other options must not mix with these.
asked="$(sha256sum <"$program") pairs=$pairs grid-pairs=$grid_pairs seed=$seed quick=$quick"
[ ! -e "$out/asked" ] || [ "$(cat "$out/asked")" = "$asked" ] ||
  fail "'$out' holds results of another program or of other options: name another --out"
printf '%s\n' "$asked" >"$out/asked"

# run FILE COMMAND...: the JSON of a command of the program, unless FILE has it. It is whole or absent.
run() {
  local file=$out/$1.json
  shift
  [ ! -e "$file" ] || return 0
  mkdir -p "$(dirname "$file")"
  echo "measure-libero.sh: $*" >&2
  "$program" "$@" --json >"$file.part"
  mv "$file.part" "$file"
}

# series FILE PAIRS TEAM TEAM OPTIONS...: a series, which goes on where it stopped.
series() {
  local file=$1 count=$2
  shift 2
  [ ! -e "$out/$file.json" ] || return 0
  run "$file" match "$@" -n "$count" --seed "$seed" --out "$out/$file"
  rm -r "${out:?}/$file"
}

run teams list teams
opponents=$(python3 scripts/libero-tables.py --opponents "$out") training=$(python3 scripts/libero-tables.py --training "$out")

for robot in vsss firasim; do
  for physics in standard fast; do
    for sight in exact camera; do
      for size in 3v3 5v5; do
        count=$grid_pairs see=()
        [ "$physics-$sight-$size" != standard-exact-3v3 ] || count=$pairs
        [ $sight = exact ] || see=(--noise 0.002 --latency 2)
        for opponent in $opponents libero; do
          series "series/$robot-$physics-$sight-$size/$opponent" "$count" libero "$opponent" --robot $robot --physics $physics \
            --rules "vsss-$size" "${see[@]}" "${match[@]}"
        done
      done
    done
  done
  run "drills/$robot" drill libero --robot $robot --seed "$seed" "${drills[@]}" "${trials[@]}"
  run "worth/$robot" drill libero --without all --robot $robot --seed "$seed" "${worth[@]}"
done
for skill in nothing $(python3 scripts/libero-tables.py --skills "$out"); do
  team=libero
  [ "$skill" = nothing ] || team="libero:without=$skill"
  for robot in vsss firasim; do
    for opponent in $training; do
      series "without/$robot/$skill/$opponent" "$grid_pairs" "$team" "$opponent" --robot $robot "${short[@]}"
    done
  done
done
for team in libero classic; do
  run "time/$team" match $team $team --seed "$seed" --profile "${match[@]}"
done
python3 scripts/libero-tables.py "$out" "$page"
