#!/usr/bin/env bash
# Plants changed golden hashes in a small repository, with and without the signature in a message, and expects
# scripts/check-behaviour.sh to tell them apart. Usage: check_behaviour_test.sh PROJECT
set -euo pipefail
project=$1
# shellcheck source=tests/scripts/small_repository.sh
. "$project"/tests/scripts/small_repository.sh

# behaves SIGNATURE: the program prints it from now on, and the golden file says so too.
behaves() {
  printf '#!/bin/sh\necho %s\n' "$1" >"$tree/program"
  chmod +x "$tree/program"
  echo "scene $1" >tests/determinism/golden.txt
}

# commit MESSAGE
commit() {
  git add -A
  git commit -q --allow-empty -m "$1"
}

# expect CODE TEXT NAME: the exit code and a piece of the output.
expect() {
  local output status=0
  output=$(scripts/check-behaviour.sh "$tree/program" 2>&1) || status=$?
  if ((status != $1)) || [[ $output != *"$2"* ]]; then
    failed "$3: exit code $status instead of $1, or no '$2' in: $output"
  fi
}

git init -q -b main "$tree/repository"
cd "$tree/repository"
mkdir -p scripts tests/determinism
cp "$project"/scripts/check-behaviour.sh "$project"/scripts/base-commit.sh scripts
behaves 1111aaaa1111aaaa
commit 'Begin'
expect 1 'no commit message names the signature 1111aaaa1111aaaa' 'on main, never named'
commit 'The first signature is 1111aaaa1111aaaa.'
expect 0 'names the signature' 'on main, named later'

git checkout -q -b work
expect 0 'names the signature' 'a branch without commits'
commit 'No functional change'
expect 0 'golden hashes are those of' 'a branch that changes nothing'
behaves 2222bbbb2222bbbb
expect 1 'no commit message names the signature 2222bbbb2222bbbb' 'changed, not committed'
commit 'Robots brake later'
expect 1 'no commit message names the signature 2222bbbb2222bbbb' 'changed without a word'
commit 'The signature was 1111aaaa1111aaaa'
expect 1 'no commit message names the signature 2222bbbb2222bbbb' 'the old signature is named'
git commit -q --amend --allow-empty -m 'Robots brake later

Signature 2222bbbb2222bbbb.'
expect 0 'names the signature 2222bbbb2222bbbb' 'changed and named'
behaves 1111aaaa1111aaaa
commit 'Robots brake as before'
expect 0 'golden hashes are those of' 'changed back'
behaves 3333cccc3333cccc
commit 'Robots brake at once'
expect 1 'no commit message names' 'changed once more'
FULBITO_BASE=HEAD expect 0 'golden hashes are those of' 'another base'
FULBITO_BASE=none expect 1 'no commit message names' 'no base'
FULBITO_BASE=nothing expect 2 'names no commit' 'a base that is none'

finish 'check-behaviour tells them apart'
