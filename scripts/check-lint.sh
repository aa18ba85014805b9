#!/usr/bin/env bash
# clang-tidy-19 on the sources of the libraries and of the program, but for those that parse its flags, and shellcheck on the scripts.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ "${1:-}" = "-h" ] || [ "${1:-}" = "--help" ]; then
  echo "Usage: scripts/check-lint.sh [PRESET]   a configured preset with compile_commands.json; default: release"
  exit 0
fi
build=build/${1:-release}
[ -f "$build/compile_commands.json" ] || { echo "check-lint.sh: configure first: cmake --preset ${1:-release}" >&2; exit 2; }
git ls-files -z 'scripts/*.sh' 'tests/**/*.sh' .ci/run | xargs -0 shellcheck
{
  git ls-files -z 'engine/*.cpp' 'navigation/*.cpp' 'strategies/*.cpp' 'referee/*.cpp' 'replays/*.cpp' 'match/*.cpp' \
    'experiments/*.cpp' 'bench/*.cpp'
  # A file with the command-line library takes three times as long as another.
  git grep -zL 'CLI/CLI.hpp' -- 'apps/*.cpp'
} |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy-19 -p "$build" --quiet --extra-arg=-Wno-unknown-warning-option
