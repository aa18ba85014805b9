#!/usr/bin/env bash
# Prints the commit that a change is compared with, or nothing if there is none. See --help.
set -euo pipefail
cd "$(dirname "$0")/.."

case "${1:-}" in
  -h | --help)
    cat <<'USAGE'
Usage: scripts/base-commit.sh

Prints the commit that the present branch left its base branch at; nothing on the base branch itself, as in a fresh clone,
and in a shallow clone that does not hold it. The base branch is the remote's default one, else main.

FULBITO_BASE in the environment names another commit: FULBITO_BASE=HEAD~3; FULBITO_BASE=none says that there is none.
USAGE
    exit 0 ;;
  "") ;;
  *) echo "base-commit.sh: unknown option '$1' (see --help)" >&2; exit 2 ;;
esac

if [ "${FULBITO_BASE:-}" = none ]; then exit 0; fi
if [ -n "${FULBITO_BASE:-}" ]; then
  git rev-parse --verify --quiet "$FULBITO_BASE^{commit}" ||
    { echo "base-commit.sh: FULBITO_BASE names no commit: $FULBITO_BASE" >&2; exit 2; }
  exit 0
fi
head=$(git rev-parse HEAD)
for branch in origin/HEAD origin/main main; do
  git rev-parse --verify --quiet "$branch^{commit}" >/dev/null || continue
  base=$(git merge-base HEAD "$branch" || true)
  if [ -n "$base" ] && [ "$base" != "$head" ]; then echo "$base"; fi
  exit 0
done
