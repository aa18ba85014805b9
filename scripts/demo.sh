#!/usr/bin/env bash
# Goes from a fresh clone to the comparison's table and pictures and a match: installs missing packages, builds, runs the commands.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1:-}" = "-h" ] || [ "${1:-}" = "--help" ]; then
  cat <<'USAGE'
Usage: scripts/demo.sh [OUT] [OPTIONS OF THE COMPARISON...]
Installs, builds, runs the comparison of Jung & Lee (2015) and a match into OUT (default: fulbito-out).
FULBITO_PRESET in the environment names the build, default: release. For a quick look: scripts/demo.sh fulbito-out --trials 20
USAGE
  exit 0
fi
out=${1:-fulbito-out}
shift || true
preset=${FULBITO_PRESET:-release}

scripts/install-deps.sh
# A build that is already configured keeps its tests.
[ -f "build/$preset/CMakeCache.txt" ] || cmake --preset "$preset" -DFULBITO_BUILD_TESTS=OFF >/dev/null
cmake --build --preset "$preset" --target fulbito
fulbito=build/$preset/fulbito
echo
echo "A first look: all methods on 20 layouts, corner to corner at 2.6 m/s"
"$fulbito" compare --suite corner --speeds 2.6 --trials 20 --pictures 4 --out "$out/first-look" --html "$out/races.html" --force
echo
echo "The comparison: 400 layouts unless told otherwise, three speeds, and the paper's own runs"
"$fulbito" compare --out "$out" "$@"
echo
echo "A first version of a team of your own, in C, as a shared library"
[ -e "$out/my-team" ] || "$fulbito" new-team c "$out/my-team" >/dev/null
make -s -C "$out/my-team"
"$fulbito" match "$out/my-team/team.so" idle --half-seconds 10
echo
echo "A match: two halves of five minutes, recorded"
"$fulbito" match libero classic --seed 7 --record "$out/match.fbr" --force
"$fulbito" replay export "$out/match.fbr" --force --png "$out/match.png" --at 60 \
  --gif "$out/match.gif" --from 40 --to 60 --speed 2
# Of the whole match: --at would choose the sheet's moments, too.
"$fulbito" replay export "$out/match.fbr" --force --contact-sheet "$out/match-sheet.png" --html "$out/match.html"
echo
echo "The match as pictures: $out/match.png, $out/match-sheet.png, $out/match.gif"
echo "Pictures: $out/*.png (time.png and distance.png sum up; corner-0-1.0.png shows the paper's methods and the best)"
echo "To look at in a browser: $out/match.html (the match) and $out/races.html (all methods on the first layouts)"
