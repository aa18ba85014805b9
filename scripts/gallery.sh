#!/usr/bin/env bash
# Creates the pictures of README and docs in docs/images, with the commands that docs/pictures.md explains.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1:-}" = "-h" ] || [ "${1:-}" = "--help" ]; then
  echo "Usage: scripts/gallery.sh [PROGRAM]   remakes docs/images with PROGRAM (default: build/release/fulbito)"
  exit 0
fi
program=$(realpath "${1:-build/release/fulbito}")
root=$(pwd)
images=$(realpath docs/images)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$program" match libero classic --seed 7 --record game.fbr >/dev/null
export_game() { "$program" replay export game.fbr --force "$@"; }

# The first goal, as a still in both themes and with the paths that led to it.
goal=$("$program" replay events game.fbr --json | sed -n 's/.*"time_s":\([0-9.]*\),.*"event":"goal".*/\1/p' | head -n 1)
from=$(awk -v t="$goal" 'BEGIN { print (t > 4 ? t - 4 : 0) }')
to=$(awk -v t="$goal" 'BEGIN { print t + 1.5 }')
export_game --png "$images/match-goal.png" --around goals --from "$from" --to "$to"
export_game --png "$images/match-goal-light.png" --around goals --from "$from" --to "$to" --theme light
export_game --trails "$images/match-trails.png" --around goals --from "$from" --to "$to" --theme light --size 640
# The film, with exactly the commands of README.md.
"$program" match libero classic --seed 1 --record goals.fbr >/dev/null
"$program" replay export goals.fbr --force --gif "$images/match-goal.gif" --around goals:1
export_game --contact-sheet "$images/match-sheet.png" --size 1200
export_game --heatmap ball "$images/match-heatmap.png" --size 640
export_game --heatmap yellow "$images/match-heatmap-light.png" --size 640 --theme light

# Shortly before the goal, with the debug drawings of the teams.
"$program" match libero classic --seed 7 --record drawn.fbr --drawings >/dev/null
before=$(awk -v t="$goal" 'BEGIN { print (t > 1.2 ? t - 1.2 : 0) }')
"$program" replay export drawn.fbr --force --png "$images/match-drawings.png" --at "$before"

# The teams of docs/write-a-team.md, with its commands.
"$program" new-team python rovers >/dev/null
"$program" match "cmd:python3 rovers/team.py" classic --seed 3 --half-seconds 20 --record first.fbr --drawings >/dev/null
"$program" replay export first.fbr --force --contact-sheet "$images/team-first.png" --size 1200
cp -r "$root/examples" .
"$program" match "cmd:python3 examples/teams/rovers.py" classic --seed 3 --half-seconds 20 --record rovers.fbr --drawings >/dev/null
"$program" replay export rovers.fbr --force --png "$images/team-rovers.png" --at 2.2

"$program" run --navigator bspline-time --layout moving:3 --record trial.fbr >/dev/null
"$program" replay export trial.fbr --force --trails "$images/trial-trails.png" --size 640

# One layout for every method with a picture in docs/navigators.md, except the two that ignore obstacles.
while read -r navigator; do
  "$program" run --navigator "$navigator" --layout corner:17 --record way.fbr --force >/dev/null
  "$program" replay export way.fbr --force --trails "$images/navigator-$navigator.png" --size 480
done < <(sed -n 's|.*images/navigator-\([a-z-]*\)\.png.*|\1|p' "$root/docs/navigators.md" | grep -v curvature)

# The two methods that ignore obstacles, on a free field; the second with an arrival heading.
cat >single-curvature.toml <<'END'
[layout]
name = "free"
field = "vsss-3v3"
[start]
position = [-0.45, -0.25]
heading_deg = 75.0
[goal]
position = [0.40, 0.15]
END
{ cat single-curvature.toml && echo 'heading_deg = 75.0'; } >double-curvature.toml
for navigator in single-curvature double-curvature; do
  "$program" run --navigator "$navigator" --layout "$navigator.toml" --record way.fbr --force >/dev/null
  "$program" replay export way.fbr --force --trails "$images/navigator-$navigator.png" --size 480
done

# The pictures of docs/papers.md.
mkdir -p "$images/papers"
"$program" experiment hybrid --out papers >/dev/null
for picture in fig-8 gap lengths; do
  cp "papers/hybrid/$picture.png" "$images/papers/hybrid-$picture.png"
done

"$program" compare --suite jung-lee-2015 --trials 1 --out figures >/dev/null
cp figures/fig1-abrupt-turns-1.0.png figures/fig2a-ball-in-offset-1.0.png figures/fig5-corner-1.0.png "$images/"
"$program" compare --suite jung-lee-2015 --trials 10 --out bars >/dev/null
cp bars/fig28-time.png "$images/"
"$program" compare --map --suite close-range --laws classic --speeds 1.0,1.2 --radii 0,0.02,0.04,0.06,0.08,0.10,0.12,0.14 \
  --widths 0.10,0.15,0.20,0.25,0.30,0.35,0.40 --trials 40 --fresh 0 --out map >/dev/null
cp map/map-close-range-classic.png "$images/"

# The experiments of docs/papers.md.
mkdir -p "$images/papers"
"$program" experiment capture --out papers >/dev/null
cp papers/capture/fig-16.png papers/capture/fig-17-error.png papers/capture/fig-18.png "$images/papers/"
"$program" experiment localization --out papers >/dev/null
for picture in room deviation constant; do
  cp "papers/localization/$picture.png" "$images/papers/localization-$picture.png"
done
"$program" experiment transport --out papers >/dev/null
cp papers/transport/fig-9.png "$images/papers/transport-fig-9.png"
cp papers/transport/fig-10.png "$images/papers/transport-fig-10.png"
cp papers/transport/constraint-curve.png "$images/papers/transport-curve.png"
cp papers/transport/real-rod.gif "$images/papers/transport-real-rod.gif"

# Pictures in pages have to load quickly.
find "$images" \( -name 'match-*.png' -o -name 'team-*.png' -o -name 'trial-*.png' \) -size +150k -print | while IFS= read -r file; do
  echo "gallery.sh: $file is larger than 150 kB" >&2
done
