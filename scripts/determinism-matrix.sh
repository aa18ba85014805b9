#!/bin/bash
# Builds the engine, everything that matches need, and two hash programs with several compilers and levels. Runs
# each with and without the processor's fused multiply-add. Compares every scene's hash with
# tests/determinism/golden.txt, and every match's with tests/determinism/golden_matches.txt.
#
#   scripts/determinism-matrix.sh            all builds
#   scripts/determinism-matrix.sh gcc-O2     only the named builds
#   scripts/determinism-matrix.sh --reuse    for gcc-O2 and the builds with sanitizers, takes the programs of build/ci,
#                                            build/tsan and build/asan if those presets have been built, and
#                                            compiles only in groups
#   UPDATE_GOLDEN=1 scripts/determinism-matrix.sh   writes the golden files from the first build, then compares
#
# Exit code 0: all equal; 1: some differ; 2: a build failed.
set -euo pipefail
cd "$(dirname "$0")/.."

# Link-time optimisation also finds names with different definitions in different files.
lto="-flto=2 -Werror=odr"
addresses="-O1 -g1 -fsanitize=address,undefined -fno-sanitize=object-size,vptr -fno-sanitize-recover=all"
threads="-O1 -g1 -fsanitize=thread"
# name | compiler | flags | what is built | preset with the same programs. All builds compile files in groups, except gcc-O0: it
# compiles each file of the whole program alone, which finds missing includes.
builds=(
  "gcc-O2|g++|-O2 -DNDEBUG|groups|ci"
  "gcc-O0|g++|-O0|program|"
  "gcc-O3|g++|-O3 -DNDEBUG $lto|groups|"
  "clang-O2|clang++-19|-O2 -DNDEBUG|groups|"
  "gcc-threads|g++|$threads|groups|tsan"
  "clang-addresses|clang++-19|$addresses|groups|asan"
)

reuse=false
if [ "${1:-}" = --reuse ]; then
  reuse=true
  shift
fi

# Names for glibc 2.33 and later. On a processor without these features, the masked run equals the plain one.
no_fma="glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4"

active_features() {
  "$(ldconfig -p | awk '/ld-linux-x86-64/ {print $NF; exit}')" --list-diagnostics | grep 'features\[.*active'
}
features=$(active_features)
masked_features=$(GLIBC_TUNABLES=$no_fma active_features)
if grep -qw fma /proc/cpuinfo && [ "$features" = "$masked_features" ]; then
  echo "determinism-matrix: GLIBC_TUNABLES does not mask fused multiply-add here" >&2
  exit 2
fi

launcher=()
if command -v ccache > /dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

build() {  # name compiler flags groups|program
  local options=(-DFULBITO_ONLY_HASH_PROGRAM=ON -DCMAKE_UNITY_BUILD=ON) targets=(hash_program match_hash_program trig_program)
  if [ "$4" = program ]; then
    options=(-DFULBITO_BUILD_TESTS=ON)
    targets+=(fulbito)
  fi
  cmake -S . -B "build/matrix/$1" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$2" \
    -DCMAKE_CXX_FLAGS="$3" "${options[@]}" "${launcher[@]}" > "build/matrix/$1.log" 2>&1 &&
    cmake --build "build/matrix/$1" --target "${targets[@]}" >> "build/matrix/$1.log" 2>&1
}

verdict() {  # expected-file printed-file
  if cmp -s "$1" "$2"; then echo same; else echo DIFFERS; fi
}

compare() {  # build what program golden-file
  local golden=tests/determinism/$4 out=$folder/$3 plain masked
  "$folder/$3" > "$out.plain.txt"
  GLIBC_TUNABLES=$no_fma "$folder/$3" > "$out.masked.txt"
  if [ "${UPDATE_GOLDEN:-0}" = 1 ]; then cp "$out.plain.txt" "$golden"; fi
  plain=$(verdict "$golden" "$out.plain.txt")
  masked=$(verdict "$golden" "$out.masked.txt")
  printf '%-16s %-12s %-10s %-10s\n' "$1" "$2" "$plain" "$masked"
  if [ "$plain$masked" != samesame ]; then
    failures=1
    diff "$golden" "$out.plain.txt" || true
    diff "$golden" "$out.masked.txt" || true
  fi
}

mkdir -p build/matrix
failures=0
trig=build/matrix/trig.txt
rm -f "$trig"
printf '%-16s %-12s %-10s %-10s\n' build what plain "without FMA"
for entry in "${builds[@]}"; do
  IFS='|' read -r name compiler flags what preset <<< "$entry"
  if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then continue; fi
  folder=build/$preset/tests/determinism
  if ! $reuse || [ ! -x "$folder/match_hash_program" ] || [ ! -x "$folder/hash_program" ]; then
    if $reuse; then what=groups; fi
    if ! build "$name" "$compiler" "$flags" "$what"; then
      tail -n 20 "build/matrix/$name.log" >&2
      echo "determinism-matrix: $name does not build" >&2
      exit 2
    fi
    folder=build/matrix/$name/tests/determinism
  fi
  compare "$name" scenes hash_program golden.txt
  compare "$name" matches match_hash_program golden_matches.txt
  UPDATE_GOLDEN=0
  # One comparison is enough, because all builds use the same C library.
  if [ ! -e "$trig" ]; then
    "$folder/trig_program" > "$trig"
    masked=$(verdict "$trig" <(GLIBC_TUNABLES=$no_fma "$folder/trig_program"))
    printf '%-16s %-12s %-10s %-10s\n' "$name" "sinf, cosf" - "$masked"
    if [ "$masked" != same ]; then failures=1; fi
  fi
done
exit "$failures"
