#!/usr/bin/env bash
# Builds hashes of sources in two places and expects cmake/FulbitoSources.cmake to give equal ones, which
# sha256sum confirms; a build without a change does nothing, and a change touches its group only.
# Usage: source_hashes_test.sh PROJECT
set -euo pipefail
project=$1
# shellcheck source=tests/scripts/small_repository.sh
. "$project"/tests/scripts/small_repository.sh

list='# a note
engine engine
team engine/teams/one
none engine/unused
none engine/extra.hpp
engine lone.txt'

# project FOLDER FILES...: a small project whose files are made in that order
project() {
  local folder=$1 file
  mkdir -p "$folder"
  echo "$list" >"$folder/sources.txt"
  for file in "${@:2}"; do
    mkdir -p "$folder/$(dirname "$file")"
    echo "text of $file" >"$folder/$file"
  done
  cat >"$folder/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.22)
project(small LANGUAGES NONE)
include("$project/cmake/FulbitoSources.cmake")
fulbito_source_hashes(\${CMAKE_CURRENT_SOURCE_DIR}/sources.txt \${CMAKE_CURRENT_BINARY_DIR}/hashes.cpp)
add_custom_target(hashes ALL DEPENDS \${CMAKE_CURRENT_BINARY_DIR}/hashes.cpp)
END
}

# made FOLDER: configures if needed, builds and prints the groups and their hashes
made() {
  [[ -d "$1 build" ]] || cmake -G Ninja -S "$1" -B "$1 build" >/dev/null
  cmake --build "$1 build" >"$tree/log" 2>&1
  sed -n 's/^    {"\(.*\)", "\(.*\)"},$/\1 \2/p' "$1 build/hashes.cpp"
}

# expected FOLDER FILES...: the hash of these files, by another program
expected() {
  cd "$1"
  for file in $(printf '%s\n' "${@:2}" | LC_ALL=C sort); do
    echo "$file $(sha256sum <"$file" | cut -d' ' -f1)"
  done | sha256sum | cut -c1-32
}

files=(engine/b.cpp engine/a.hpp engine/Z.cpp engine/sub/deep.h engine/teams/one/team.cpp engine/teams/one/team.hpp
  engine/unused/u.cpp engine/extra.hpp engine/notes.md lone.txt)
mapfile -t backwards < <(printf '%s\n' "${files[@]}" | tac)
first="$tree/first place" second="$tree/2nd"
project "$first" "${files[@]}"
project "$second" "${backwards[@]}"

engine=$(expected "$first" engine/b.cpp engine/a.hpp engine/Z.cpp engine/sub/deep.h lone.txt)
team=$(expected "$first" engine/teams/one/team.cpp engine/teams/one/team.hpp)
before=$(made "$first")
[[ $before == "engine $engine"$'\n'"team $team" ]] || failed "hashes: $before"
[[ $(made "$second") == "$before" ]] || failed "another place, another order: other hashes"

made "$first" >/dev/null
grep -q 'no work to do' "$tree/log" || failed "a build without a change: $(cat "$tree/log")"

# changed FILE GROUPS: appends to the file and expects those groups to change
changed() {
  local now groups
  echo more >>"$first/$1"
  now=$(made "$first")
  groups=$({ diff <(echo "$before") <(echo "$now") || true; } | sed -n 's/^> \([a-z]*\) .*/\1/p' | tr '\n' ' ')
  [[ $groups == "$2" ]] || failed "$1 changed: '$groups' instead of '$2'"
  before=$now
}
changed engine/sub/deep.h 'engine '
changed engine/teams/one/team.cpp 'team '
changed engine/unused/u.cpp ''
changed engine/extra.hpp ''
changed engine/notes.md ''
changed engine/new.cpp 'engine '
changed engine/teams/one/new.cpp 'team '
finish "hashes of sources: equal in other places, by the groups of the list, without work when nothing changes"
