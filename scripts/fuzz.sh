#!/usr/bin/env bash
# Fuzzes the readers of foreign bytes in parallel for some seconds (default: 60), from stored corpora, under sanitizers:
# recordings, messages and tables of shared libraries, and the line protocol of teams.
# Usage: scripts/fuzz.sh [SECONDS [TARGET ...]]. Inputs that crash a reader are kept in build/asan/fuzz/crashes.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=(recording abi lines wire)
cmake --preset asan -DFULBITO_BUILD_TESTS=ON > /dev/null
cmake --build --preset asan --target "${targets[@]/%/_fuzzer}"
crashes=build/asan/fuzz/crashes
running=()
for target in "${targets[@]}"; do
  found=build/asan/fuzz/corpus/$target
  mkdir -p "$found" "$crashes"
  # The second folder is only read; new inputs go to the first.
  "build/asan/tests/fuzz/${target}_fuzzer" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=20000 -print_final_stats=1 -artifact_prefix="$crashes/$target-" "$found" "tests/fuzz/corpus/$target" \
    > "$crashes/$target.log" 2>&1 &
  running+=($!)
done
failed=0
for i in "${!targets[@]}"; do
  wait "${running[$i]}" || failed=1
  echo "== ${targets[$i]}"
  tail -n 40 "$crashes/${targets[$i]}.log"
done
exit $failed
