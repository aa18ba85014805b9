#!/usr/bin/env bash
# Fails if golden hashes changed and no later commit message names the new signature. See --help.
set -euo pipefail

case "${1:-}" in
  -h | --help)
    cat <<'USAGE'
Usage: scripts/check-behaviour.sh PROGRAM      PROGRAM: the fulbito that is checked, e.g. build/release/fulbito

Where tests/determinism/golden*.txt differ from the base commit (scripts/base-commit.sh), a commit message since must name what
`PROGRAM bench --signature` prints. Without a base commit, as on the base branch itself, any message of the history may name it.

Exit code: 0 nothing changed, or it is named; 1 it is not named; 2 wrong use.
USAGE
    exit 0 ;;
  "") echo "check-behaviour.sh: PROGRAM is missing (see --help)" >&2; exit 2 ;;
esac
program=$(realpath "$1")
[ -x "$program" ] || { echo "check-behaviour.sh: no program '$1'" >&2; exit 2; }
cd "$(dirname "$0")/.."

base=$(scripts/base-commit.sh)
if [ -n "$base" ] && git diff --quiet "$base" -- ':(glob)tests/determinism/golden*.txt'; then
  echo "check-behaviour: the golden hashes are those of $base"
  exit 0
fi
signature=$("$program" bench --signature)
# Without a pipe, because grep may end before git, which then fails.
messages=$(git log --format=%B "${base:+$base..}HEAD")
if grep -qF -- "$signature" <<<"$messages"; then
  echo "check-behaviour: a commit message names the signature $signature"
elif [ -z "$base" ] && [ "$(git rev-parse --is-shallow-repository)" = true ]; then
  echo "check-behaviour: not known: a shallow clone lacks the messages (git fetch --unshallow)"
else
  echo "check-behaviour: golden hashes changed${base:+ since $base}, and no commit message names the signature $signature" >&2
  echo "Say in a commit message what moves differently, and the signature." >&2
  exit 1
fi
