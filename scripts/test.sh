#!/usr/bin/env bash
# From a fresh clone to all tests: installs what is missing, builds, runs ctest.
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
# One test more than there are cores: some wait.
ctest --preset "$preset" --no-tests=error -j "$(($(nproc) + 1))" "$@"
