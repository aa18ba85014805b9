#!/usr/bin/env bash
# Changes files of a small repository and expects scripts/check-lint.sh to choose those, and one that includes each changed header.
# Usage: check_lint_test.sh PROJECT
set -euo pipefail
project=$1
# shellcheck source=tests/scripts/small_repository.sh
. "$project"/tests/scripts/small_repository.sh

# expect FILES NAME [OPTIONS...]
expect() {
  local chosen name=$2
  chosen=$(scripts/check-lint.sh --list "${@:3}" 2>&1 | tr '\n' ' ')
  if [[ $chosen != "$1 " && $chosen != "$1" ]]; then
    failed "$name: '$chosen' instead of '$1'"
  fi
}

cd "$tree"
git init -q -b main
mkdir -p scripts engine/core match build/{ci,release,ci/match/Unity}
cp "$project"/scripts/check-lint.sh "$project"/scripts/base-commit.sh scripts
echo /build/ >.gitignore
touch engine/core/base.hpp
echo '#include "engine/core/base.hpp"' | tee engine/core/base.cpp >match/rule.hpp
echo '#include "match/rule.hpp"' >match/rule.cpp
echo '#include <vector>' >match/other.cpp
# As many includes as a large project has: more than fit into an argument.
yes '#include "match/rule.hpp"' | head -n 6000 >match/all.hpp || true
{
  echo '['
  for file in engine/core/base.cpp match/rule.cpp match/other.cpp; do echo "{ \"file\": \"$tree/$file\" },"; done |
    sed 's/{ \(.*\) }/{\n  \1\n}/'
  echo ']'
} >build/release/compile_commands.json
printf '[{\n  "file": "%s"\n}]\n' "$tree/build/ci/match/Unity/group.cxx" >build/ci/compile_commands.json
printf '#include "%s"\n' "$tree/match/rule.cpp" "$tree/match/other.cpp" >build/ci/match/Unity/group.cxx
git add -A
git commit -q -m 'Begin'

expect 'engine/core/base.cpp match/other.cpp match/rule.cpp' 'a short history' release
echo '// Later.' >>match/other.cpp
git commit -q -a -m 'Later'
for ((i = 0; i < 24; ++i)); do git commit -q --allow-empty -m 'More'; done
expect 'match/other.cpp' 'the last 25 commits of the base branch' release
git commit -q --allow-empty -m 'More'
expect '' 'no more than 25 commits of the base branch' release
FULBITO_BASE=none expect 'engine/core/base.cpp match/other.cpp match/rule.cpp' 'no base' release
git checkout -q -b work
git commit -q --allow-empty -m 'Work'
expect '' 'nothing changed' release
expect 'engine/core/base.cpp match/other.cpp match/rule.cpp' '--all' --all release
echo '// More.' >>match/other.cpp
expect 'match/other.cpp' 'a source' release
expect 'match/rule.cpp match/other.cpp' 'a group with a changed source'
git commit -q -a -m 'More'
expect 'match/other.cpp' 'a source, committed' release
FULBITO_BASE=HEAD expect '' 'another base' release
echo '// More.' >>engine/core/base.hpp
FULBITO_BASE=HEAD expect 'engine/core/base.cpp' 'one that includes a header' release
git commit -q -a -m 'A header'
echo '// More.' >>match/all.hpp
FULBITO_BASE=HEAD expect '' 'a header that nothing compiled includes' release
echo '// More.' >>match/rule.hpp
FULBITO_BASE=HEAD expect 'match/rule.cpp' 'one that includes a header' release
sed -i '1i #include "match/all.hpp"' match/rule.cpp
FULBITO_BASE=HEAD expect 'match/rule.cpp' 'a source that changed and includes the header' release
git checkout -q match
echo '#include "match/rule.hpp"' >match/rule.cpp
sed -i 's/"match.rule.hpp"/"engine\/core\/base.hpp"/' match/all.hpp
echo '#include "match/all.hpp"' >>match/other.cpp
git commit -q -a -m 'Through two headers'
echo '// More.' >>engine/core/base.hpp
echo '// More.' >>match/other.cpp
FULBITO_BASE=HEAD expect 'match/other.cpp' 'a source that changed and includes a header through another' release
touch .clang-tidy
FULBITO_BASE=HEAD expect 'engine/core/base.cpp match/other.cpp match/rule.cpp' 'the checks changed' release

finish 'check-lint chooses what it should'
