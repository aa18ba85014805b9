#!/usr/bin/env bash
# Prints every figure of docs/reproduction.md and docs/results/reproduction.md, and the table of methods in
# docs/results/navigators.md.
#
# Rings and the tangent field are chosen on training layouts (seeds 1002018 and 1002019, those of the tuner). All
# other runs use seed 2015; 777, 31337 and 424242 show how much depends on the seed. For choices that differ from
# experiments/comparison/paper_plan.hpp or navigation/methods/fields/vector_field.hpp, change those files first.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1:-}" = "-h" ] || [ "${1:-}" = "--help" ]; then
  echo "Usage: scripts/reproduction.sh [FOLDER]   about twenty minutes on two cores; FOLDER: reproduction-figures"
  exit 0
fi
root=$PWD
program=$root/build/release/fulbito
out=${1:-reproduction-figures}
mkdir -p "$out"
cd "$out"

part() { printf '\n==== %s\n' "$*"; }

# Rows for the table of docs/reproduction.md: id, run, paper's value, measured value, difference, accepted band, whether it is inside.
rows() { awk -F' \\| ' '/^\| (distance|time|collisions)-/ { sub(/^\| /, "", $1); printf "| %s | %s | %s | %s | %s | %s | %s |\n", $1, $2, $3, $4, $5, $6, $7 }' "$1"; }

training=(--seed 1002018 --seeds 2 --headings goal)
rings=(--radii "0,0.02,0.04,0.06,0.08,0.10,0.12,0.14,0.16,0.18,0.20,0.22,0.24"
  --widths "0.01,0.02,0.03,0.05,0.10,0.15,0.20,0.25,0.30,0.35,0.40")

part "kTunedRing, kTunedCloseRing: rings under the classic law at 1.0 m/s (training layouts)"
for suite in corner close-range; do
  "$program" compare --map --suite "$suite" --laws classic --speeds 1.0 "${training[@]}" "${rings[@]}" --trials 100 --fresh 0 --out "train-$suite" |
    awk '/^\| (corner|close-range) / { print "safest: " $0 } /^- (corner|close-range): radius/ { print "least T/T* all: " $0 }'
done

part "VectorField::Params: one ring for both laws at 0.6, 1.0 and 2.6 m/s (training layouts)"
"$program" compare --map --suite corner --speeds 0.6,1.0,2.6 "${training[@]}" --radii 0,0.02,0.04,0.06,0.08,0.10 \
  --widths 0.05,0.10,0.15,0.18,0.20,0.22,0.25,0.30 --trials 50 --fresh 0 --out train-default | awk '/^- corner: radius/'

part "The tangent field that the tuner finds now"
"$program" compare --suite corner --tune tangent-field --speeds 1.0,2.6 --pictures 0 --navigators bezier tangent-field --out tuned 2>tuned.log |
  awk '/^###|^\| /'
grep tuned tuned.log

part "Tuned tangent fields"
"$program" compare --suite corner --trials 200 --speeds 2.6 --pictures 0 --out tangents --navigators bezier \
  tangent-field:offset=0.0784,range=5.56,hysteresis=0.239 tangent-field:offset=0.082,range=5.56 tangent-field:offset=0.085,range=1.16 |
  awk '/^###|^\| /'

part "The table of docs/reproduction.md"
"$program" compare --out paper >paper.md
rows paper.md
awk '/^### Figs 28 and 29/ { on = 1 } on' paper.md

part "Curves beyond the paper"
"$program" compare --suite corner --trials 200 --speeds 2.6 --pictures 0 --out curves --navigators bezier hermite bspline-time \
  bspline-time:acceleration-share=0.6,lateral-share=0.6 tangent-field:offset=0.0784,range=5.56,hysteresis=0.239 | awk '/^###|^\| /'

part "The figures over what their drawings leave open"
"$program" compare --suite sweeps --pictures 0 --out sweeps | awk '/^### (The paper|Fig)/ { on = 1 } on'

part "A robot without inertia that moves once per 1 ms"
presets=$root/engine/presets
sed -e 's/^name = .*/name = "no-inertia"/' -e 's/^\(wheel_acceleration\|wheel_braking\|lateral_grip\) = [0-9.]*/\1 = 900.0/' \
  -e 's/^longitudinal_grip = [0-9.]*/longitudinal_grip = 1000.0/' "$presets/robots/jung-lee-2015.toml" >no-inertia.toml
sed -e 's/^name = .*/name = "1ms"/' -e 's/^control_rate = .*/control_rate = 1000/' -e 's/^substeps = .*/substeps = 1/' \
  "$presets/physics/standard.toml" >1ms.toml
for models in "jung-lee-2015 standard" "jung-lee-2015 1ms.toml" "no-inertia.toml 1ms.toml"; do
  read -r robot physics <<<"$models"
  "$program" compare --robot "$robot" --physics "$physics" --speeds 1.0 --trials 60 --pictures 0 --out models --navigators bezier \
    bezier:follower=classic univector:goal=bearing,k0=0,d_min=0.09,delta=0.10 vector-field:offset=0.10,width=0.20,follower=classic >models.md
  echo "robot $robot, physics $physics"
  rows models.md
done

part "kRawCollisions: runs of the printed method that touch something, 20 seeds"
for seed in $(seq 5001 5020); do
  "$program" compare --suite corner --navigators bezier-raw --speeds 1.0 --seed "$seed" --pictures 0 --out raw >/dev/null
  awk -F, -v seed="$seed" 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    { n++; hit += $column["obstacle_contacts"] + $column["wall_contacts"] > 0 } END { print seed, n, 100 * hit / n " %" }' raw/trials.csv
done

for seed in 777 31337 424242; do
  part "The same on seed $seed"
  "$program" compare --seed $seed --pictures 0 --out "paper-$seed" >"paper-$seed.md"
  rows "paper-$seed.md"
done

part "The map"
"$program" compare --map --out map >map.md
cat map.md
part "The cells that match the paper on short runs, on fresh layouts"
for cell in "0.02 0.30 1.2 random" "0 0.35 1.0 goal"; do
  read -r radius width speed heading <<<"$cell"
  "$program" compare --map --suite close-range --laws classic --radii "$radius" --widths "$width" --speeds "$speed" --headings "$heading" \
    --trials 40 --out cell | awk '/on fresh layouts/ { on = 1 } /^### The safest/ { on = 0 } on && /^\| close/'
done
part "The map on a finer grid around the nearest cells"
"$program" compare --map --suite corner --laws classic --speeds 0.9,1.0,1.1,1.2 --radii 0.16,0.17,0.18,0.19,0.20,0.22,0.24 \
  --widths 0.005,0.01,0.015,0.02,0.03 --headings goal,random,away --trials 40 --out map-corner | awk '/^- |^  - /'
"$program" compare --map --suite close-range --laws classic --speeds 0.8,1.0,1.2 --radii 0,0.02,0.04,0.06,0.08,0.10,0.12,0.14 \
  --widths 0.10,0.15,0.20,0.25,0.30,0.35,0.40 --trials 40 --out map-close | awk '/^- |^  - /'

part "docs/results/navigators.md: the table of methods"
"$program" compare --suite corner --trials 200 --pictures 0 --out table-corner | awk '/^###|^\| /'
for suite in moving clutter u-trap; do
  "$program" compare --suite "$suite" --trials 40 --speeds 1.0 --pictures 0 --out "table-$suite" | awk '/^###|^\| /'
done
