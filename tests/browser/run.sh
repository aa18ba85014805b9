#!/usr/bin/env bash
# Tests the HTML viewer in headless Chromium: tests/browser/run.sh BUILD [FOLDER FOR SCREENSHOTS]
set -euo pipefail
build=$(realpath "${1:?Usage: tests/browser/run.sh BUILD [SCREENSHOTS]}")
cd "$(dirname "$0")"
cmake --build "$build" --target fulbito browser_pages
FULBITO_PAGES=$(mktemp -d)
trap 'rm -rf "$FULBITO_PAGES"' EXIT
export FULBITO_PAGES
export FULBITO_SHOTS=${2:-$FULBITO_PAGES/shots}
export FULBITO_CHROMIUM=${FULBITO_CHROMIUM:-$(command -v chromium-headless-shell)}
mkdir -p "$FULBITO_SHOTS"

fulbito=$build/fulbito pages=$build/tests/browser/browser_pages
cd "$FULBITO_PAGES"
"$fulbito" match libero classic --seed 7 --record long.fbr --json >long.json
"$fulbito" match libero classic --seed 7 --half-seconds 30 --record short.fbr >/dev/null
"$fulbito" match libero classic --seed 8 --half-seconds 30 --record other.fbr >/dev/null
"$fulbito" run --layout moving:0 --navigator bezier --record trial.fbr >/dev/null
"$fulbito" replay export trial.fbr --html trial.html
"$fulbito" replay export long.fbr --html long.html
"$fulbito" replay export short.fbr --html short.html
"$fulbito" replay export short.fbr --html ghost.html --ghost other.fbr
"$fulbito" replay export short.fbr --html same.html --ghost short.fbr
"$fulbito" compare --suite moving --speeds 1.0,2.6 --trials 2 --out compare --html races.html >/dev/null
"$pages" hostile >hostile.html
"$pages" drawings >drawings.html
"$pages" round >round.html
"$pages" calls >calls.html
"$pages" banners >calls.banners
for file in long short trial; do "$pages" positions "$file.fbr" >"$file.positions"; done
cd - >/dev/null

# npm leaves its lock file beside what it has installed: newer than ours, it is what ours asks for.
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --no-audit --no-fund
node --test --test-concurrency=1 --test-reporter=spec ./*.test.mjs
