#!/usr/bin/env bash
# Installs a build into a temporary prefix, looks at what got there, builds outside projects against it and runs them:
# one that needs no picture, recording or JSON, a paper's experiment, and the examples.
set -euo pipefail
build=$1 source=$2 compiler=$3 libraries=$4 port=$5
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

fail() {
  echo "install test: $1" >&2
  exit 1
}

# quietly COMMAND...: shows what it says only when it fails.
quietly() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log"; fail "failed: $*"; }
}

# configure PROJECT [OPTIONS...]
configure() {
  cmake -S "$1" -B "$work/$(basename "$1")" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$compiler" \
    -DCMAKE_BUILD_TYPE=Release "${@:2}"
}

quietly cmake --install "$build" --prefix "$prefix"
"$prefix/bin/fulbito" version

# The README builds target `fulbito` and nothing else: whatever is installed must come from it.
if [ -f "$build/build.ninja" ]; then
  ninja -C "$build" -t inputs fulbito >"$work/inputs"
  find "$prefix" -type f \( -name '*.a' -o -path '*/bin/*' -o -path '*/libexec/*' \) -printf '%f\n' |
    grep -vx fulbito >"$work/built"
  [ "$(wc -l <"$work/built")" -gt 5 ] || fail 'nearly nothing was installed'
  while read -r file; do
    grep -qE "(^|/)$file\$" "$work/inputs" || fail "target fulbito does not build $file, which is installed"
  done <"$work/built"
fi

# Each kind of team plays from the installed tree. Python finds the installed module.
"$prefix/bin/fulbito" new-team python "$work/rover" >/dev/null
rm "$work/rover/fulbito_team.py"
for team in chaser "$libraries/plain_c.so" "$libraries/ported_chaser.so" "cmd:python3 $work/rover/team.py" "cmd:$port"; do
  "$prefix/bin/fulbito" match "$team" idle --half-seconds 1 --time unlimited --json >"$work/match.json" ||
    fail "the installed program does not play with $team"
  [ "$(grep -c '"failures": 0' "$work/match.json")" -eq 2 ] || fail "$team fails when the installed program plays it"
done

# Headers: those of sdk/include and no others, each whole on its own.
diff -r "$source/sdk/include" "$prefix/include" || fail 'the installed headers are not those of sdk/include'
compiles() {
  "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I "$prefix/include" -include "$1" -x c++ /dev/null
}
export -f compiles
export compiler prefix
(cd "$prefix/include" && find . -name '*.hpp' | sed 's#^\./##') | xargs -P "$(nproc)" -I{} bash -c 'compiles {}' ||
  fail 'a header needs something that it does not include'

# Targets: no path of this machine, and none of what only the program has.
mapfile -t targets < <(find "$prefix" -name 'fulbitoTargets*.cmake')
((${#targets[@]} == 2)) || fail 'there are no exported targets'
! grep -nE '["; ]/(usr|lib|opt|home|work|build)' "${targets[@]}" || fail 'the exported targets name absolute paths'
! grep -nE 'fulbito::(view|verify|export)\b' "${targets[@]}" || fail 'a library without public headers is exported'

# What steps a world or plays a match needs none of these.
without=()
for package in SDL2 SDL2_ttf PNG ZLIB nlohmann_json libdeflate; do without+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"); done
quietly configure "$source/tests/install/consumer" "${without[@]}"
quietly cmake --build "$work/consumer"
"$work/consumer/consumer"
! ldd "$work/consumer/consumer" | grep -E 'SDL|png|deflate|libgif' || fail 'a player of matches needs libraries of pictures'

# A paper's experiment, built from copies of its sources and the installed headers alone, runs.
mkdir -p "$work/papers/experiments/papers"
cp -r "$source/experiments/papers/hybrid" "$source/experiments/papers/random" "$work/papers/experiments/papers"
quietly configure "$source/tests/install/paper" -DPAPERS="$work/papers"
quietly cmake --build "$work/paper"
"$work/paper/paper" >"$work/hybrid.json"
grep -q '"id": "gap-1.3-map"' "$work/hybrid.json" || fail 'an experiment built outside has no figures'

configure "$source/tests/install/wrong" >"$work/log" 2>&1 && fail 'a component that does not exist was found'
grep -q "no component 'pictures'" "$work/log" || { cat "$work/log"; fail 'a wrong component gets no clear message'; }

quietly configure "$source/examples"
quietly cmake --build "$work/examples"
for example in "$source"/examples/*.cpp; do
  [ "$(wc -l <"$example")" -le 40 ] || fail "$example has more than 40 lines"
done
cd "$work"
examples/step_world
examples/drive_navigator
examples/drive_navigator bezier:clearance=0.03
examples/play_match libero classic game.fbr
examples/own_team
examples/read_recording game.fbr
examples/write_picture game.fbr 20 moment.png
[ "$(head -c 4 moment.png | tail -c 3)" = PNG ] || fail 'moment.png is no picture'
