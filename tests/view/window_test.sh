#!/usr/bin/env bash
# Opens the window of `fulbito view` and `fulbito match --view` on an X server in memory, sends it keys and mouse, and checks how it stood when
# it was closed. With a folder as second argument the pictures are left there, to be looked at. Exits with 77 where Xvfb or xdotool is missing.
set -euo pipefail
program=$(realpath "${1:?Usage: tests/view/window_test.sh PROGRAM [FOLDER]}")
keep=${2:+$(realpath -m "$2")}
for tool in Xvfb xdotool; do
  command -v "$tool" >/dev/null || { echo "window_test.sh: $tool is not installed: skipped" >&2; exit 77; }
done

work=$(mktemp -d)
server=
child=
finish() {
  status=$?
  [ -z "$child" ] || kill "$child" 2>/dev/null || true
  [ -z "$server" ] || kill "$server" 2>/dev/null || true
  if [ -n "$keep" ]; then
    mkdir -p "$keep"
    cp "$work"/*.png "$keep"/ || true
  fi
  rm -rf "$work"
  exit "$status"
}
trap finish EXIT
cd "$work"
export HOME=$work XDG_RUNTIME_DIR=$work
unset SDL_VIDEODRIVER WAYLAND_DISPLAY

fail() { echo "window_test.sh: $*" >&2; exit 1; }

# Retries a command for ten seconds.
soon() {
  for _ in $(seq 100); do
    if "$@"; then return 0; fi
    sleep 0.1
  done
  return 1
}

# Without -noreset the server starts anew whenever its last client leaves, and refuses whoever comes meanwhile.
Xvfb -displayfd 3 -noreset -screen 0 1280x1000x24 -nolisten tcp 3>display 2>xvfb.log >/dev/null &
server=$!
soon test -s display || fail "Xvfb did not start: $(cat xvfb.log)"
DISPLAY=:$(head -n 1 display)
export DISPLAY

# open PATTERN ARGUMENT...: starts the program and finds its window by its title.
open() {
  local pattern=$1
  shift
  "$program" "$@" >out.json 2>err.txt &
  child=$!
  found() { window=$(xdotool search --name "$pattern" 2>/dev/null | head -n 1) && [ -n "$window" ]; }
  soon found || fail "no window '$pattern': $(cat err.txt)"
  xdotool windowfocus --sync "$window"
}
titled() { xdotool getwindowname "$window" | grep -q -- "$1"; }
closes() {
  local code=0
  wait "$child" || code=$?
  child=
  [ "$code" = "$1" ] || fail "exit code $code instead of $1: $(cat err.txt)"
}
# expect KEY VALUE: in the printed object.
expect() {
  grep -q "^  \"$1\": $2,\{0,1\}\$" out.json || fail "not \"$1\": $2 in $(cat out.json)"
}
# sized FILE WIDTH HEIGHT: a PNG of that size.
sized() {
  local size
  size=$(od -A n -t u1 -j 16 -N 8 "$1" | awk '{ print ($3 * 256 + $4) "x" ($7 * 256 + $8) }')
  [ "$size" = "$2x$3" ] || fail "$1 is $size"
}

"$program" match chaser classic --half-seconds 6 --seed 3 --record game.fbr >/dev/null 2>&1

echo "1: keys"
open ' - game.fbr' view game.fbr --paused --json --screenshot keys.png
xdotool key Right Right Right Left period comma period t o f d plus plus minus h
xdotool key s
soon test -s game-2.0s.png || fail "no picture was saved: $(ls)"
xdotool key Escape q
closes 0
expect paused true
expect position_s '2.01[0-9]*'
expect speed 2.0
expect theme '"light"'
expect trails false
expect drawings true
expect flipped true
expect help false
sized keys.png 900 804

echo "2: bar of time, events, full screen, size"
open ' - game.fbr' view game.fbr --paused --json --screenshot bar.png --size 800x700
xdotool mousemove --window "$window" 400 692 click 1 key s
soon sh -c 'ls game-[3-9].*s.png' || fail "no picture after a click in the middle of the bar: $(ls)"
xdotool key --repeat 3 n key End key p key Home key n
xdotool windowsize --sync "$window" 640 600
xdotool key shift+Right key shift+slash
resized() { xdotool key s && for file in game-1*.png; do [ -s "$file" ] && sized "$file" 640 600 && return; done; }
soon resized 2>/dev/null || fail "the picture did not follow the window"
xdotool key q key q
closes 0
expect paused true
expect full_screen false
sized bar.png 640 600

echo "3: a recording plays by itself, in real time"
open ' - game.fbr' view game.fbr --json --speed 4
sleep 1
xdotool key q
closes 0
grep -q '"position_s": [2-9]\.' out.json || fail "it did not play: $(cat out.json)"

echo "4: a live match is stepped, edited and recorded"
open ' - live' match idle chaser --half-seconds 20 --seed 3 --view --paused --record live.fbr --json --screenshot live.png
xdotool key period period period
# The ball, in the middle of the field, to the upper right; a robot of blue turned by wheel and by the right button.
xdotool mousemove --window "$window" 450 444 mousedown 1 mousemove --window "$window" 500 400 \
  mousemove --window "$window" 550 300 mouseup 1
soon titled ' - edited' || fail "the title does not say that it was edited: $(xdotool getwindowname "$window")"
xdotool mousemove --window "$window" 349 444 click 4 click 4 mousedown 3 mousemove --window "$window" 349 300 mouseup 3
xdotool key space
sleep 0.5
xdotool key space key s
saved() { compgen -G 'live-*.png' >/dev/null; }
soon saved || fail "no picture of the live match: $(ls)"
xdotool key q
closes 0
expect edited true
expect edits 1
sized live.png 900 804
"$program" replay verify live.fbr >/dev/null || fail "an edited recording does not verify"
"$program" replay info live.fbr --json | grep -q '"edits": 1' || fail "the recording does not say that it was edited"
"$program" replay events live.fbr | grep -q -- '- given' || fail "the edit is no play of its own"
open ' - edited' view live.fbr --json
xdotool key q
closes 0
expect edited true

echo "5: interrupted"
open ' - live' match idle idle --view --record stopped.fbr
kill -INT "$child"
closes 130
"$program" replay verify stopped.fbr >/dev/null || fail "an interrupted recording does not verify"
echo "all of the window works"
