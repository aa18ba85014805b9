#!/usr/bin/env bash
# Fuzzes each reader of what others write for some seconds (default: 60), from the stored corpora, under
# sanitizers: recordings, the line protocol of teams, and messages and tables of shared libraries.
# Usage: scripts/fuzz.sh [SECONDS [READER...]]. What crashes one is left in build/asan/fuzz/READER/crashes.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
readers=("${@:2}")
if [ ${#readers[@]} -eq 0 ]; then readers=(recording lines abi); fi
cmake --preset asan -DFULBITO_BUILD_TESTS=ON > /dev/null
cmake --build --preset asan --target "${readers[@]/%/_fuzzer}"
for reader in "${readers[@]}"; do
  found=build/asan/fuzz/$reader/corpus crashes=build/asan/fuzz/$reader/crashes
  mkdir -p "$found" "$crashes"
  # The second folder is only read; what is new goes to the first.
  "build/asan/tests/fuzz/${reader}_fuzzer" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=20000 -print_final_stats=1 -artifact_prefix="$crashes/" "$found" "tests/fuzz/corpus/$reader"
done
