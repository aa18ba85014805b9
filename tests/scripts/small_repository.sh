# Sourced: a folder `tree` that goes at the end, a git that knows nobody's settings, and a count of failures.
# shellcheck shell=bash
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
unset FULBITO_BASE
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b
failures=0

# failed TEXT: counts a failure and says it.
failed() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

# finish TEXT: ends the test, with that text if nothing failed.
finish() {
  if ((failures > 0)); then
    echo "$failures failures" >&2
    exit 1
  fi
  echo "$1"
}
