#!/usr/bin/env bash
# Fuzzes the reader of recordings for some seconds (default: 60), from the stored corpus, under sanitizers.
# Usage: scripts/fuzz.sh [SECONDS]. What crashes it is left in build/asan/fuzz/crashes.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
cmake --preset asan -DFULBITO_BUILD_TESTS=ON > /dev/null
cmake --build --preset asan --target recording_fuzzer
found=build/asan/fuzz/corpus crashes=build/asan/fuzz/crashes
mkdir -p "$found" "$crashes"
# The second folder is only read; what is new goes to the first.
build/asan/tests/fuzz/recording_fuzzer -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=20000 \
  -print_final_stats=1 -artifact_prefix="$crashes/" "$found" tests/fuzz/corpus/recording
