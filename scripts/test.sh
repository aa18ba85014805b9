#!/usr/bin/env bash
# Goes from a fresh clone to all tests: installs missing packages, builds, runs ctest.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1:-}" = "-h" ] || [ "${1:-}" = "--help" ]; then
  echo "Usage: scripts/test.sh [PRESET] [ctest options]   default preset: release; e.g. scripts/test.sh dev -L unit"
  exit 0
fi
preset=${1:-release}
shift || true

scripts/install-deps.sh
cmake --preset "$preset" -DFULBITO_BUILD_TESTS=ON
cmake --build --preset "$preset"
# Runs one test more than there are cores, because some tests mostly wait.
ctest --preset "$preset" --no-tests=error -j "$(($(nproc) + 1))" "$@"
