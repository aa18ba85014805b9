#!/usr/bin/env bash
# Plants each kind of trouble in a small tree and expects scripts/check-determinism.sh to name it.
# Usage: check_determinism_test.sh CHECK_SCRIPT COMPILER
set -euo pipefail

check=$1
compiler=$2
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
failures=0

fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

# expect CODE TEXT NAME [ARGUMENTS...]: the exit code and a piece of the output.
expect() {
  local code=$1 text=$2 name=$3 output status=0
  shift 3
  output=$("$check" --root "$tree" "$@" 2>&1) || status=$?
  if ((status != code)) || [[ $output != *"$text"* ]]; then
    fail "$name: exit code $status instead of $code, or no '$text' in: $output"
  fi
}

# caught LINE: a library source with this as its second line is refused, and the place is named.
caught() {
  printf '// A file.\n%s\n' "$1" >"$tree/navigation/planted.cpp"
  expect 1 'navigation/planted.cpp:2: ' "caught: $1"
}

# passed LINE: this line is no finding.
passed() {
  printf '// A file.\n%s\n' "$1" >"$tree/navigation/planted.cpp"
  expect 0 'nothing found' "passed: $1"
}

mkdir -p "$tree"/{engine/core/math,navigation,replays/render,tests}
expect 0 'nothing found' 'an empty tree'

caught 'double y = std::sin(x);'
caught 'double y = ::atan2(x, 1.0);'
caught 'double y = 2.0*exp(x);'
caught 'std::transform(a, b, c, std::cos);'
caught 'double y = std::hypot(x, 1.0);'
caught "if (c == '\"') y = std::pow(x, 2.0);"
caught 'double y = std::norm(z);'
caught 'double y = std::fma(a, b, c);'
caught 'auto t = std::chrono::steady_clock::now();'
caught 'auto t = Clock::clock_gettime(CLOCK_MONOTONIC, &now);'
caught 'auto t = time(nullptr);'
caught 'std::mt19937_64 generator(1);'
caught 'std::uniform_real_distribution<double> d;'
caught 'std::random_device device;'
caught 'int n = rand();'
caught 'std::unordered_map<int, int> m;'
caught 'std::set<const Robot*> robots;'
caught 'double y = std::log(x);  // determinism-ok:'

passed 'double y = math::sin(x) + fulbito::math::log(x);'
passed 'double y = path.exp(x) + path->log(x) + basin(x) + arcsin(x);'
passed '// std::sin(x) is what this avoids.'
passed 'const char* text = "std::sin(x) // rand()";'
passed 'double y = std::log(x);  // determinism-ok: printed only'
passed 'double y = std::sqrt(x) + std::floor(x) + std::abs(x);'
passed 'double time(int ticks);'
rm "$tree/navigation/planted.cpp"

echo 'double sin(double x); double y = std::sin(1.0);' >"$tree/engine/core/math/trig.cpp"
expect 1 'engine/core/math/trig.cpp:1: ' "the project's own math may not call the C library's"
echo 'double sin(double x);' >"$tree/engine/core/math/trig.cpp"
echo 'double y = std::sin(1.0);' | tee "$tree/replays/render/picture.cpp" >"$tree/tests/some_test.cpp"
expect 0 'nothing found' 'own definitions, pictures and tests are free'

for option in -march=native -mfma -ffast-math -Ofast -ffp-contract=fast; do
  printf 'project(x)\nadd_compile_options(%s)\n' "$option" >"$tree/CMakeLists.txt"
  expect 1 'CMakeLists.txt:2: ' "CMake option $option"
done
printf '# not -ffast-math\nadd_compile_options(-ffp-contract=off -fno-fast-math)\n' >"$tree/CMakeLists.txt"
expect 0 'nothing found' 'the project options pass'
echo '{"CMAKE_CXX_FLAGS": "-march=x86-64-v3"}' >"$tree/CMakePresets.json"
expect 1 'CMakePresets.json:1: ' 'an option in a preset'
rm "$tree/CMakePresets.json"

# compile SOURCE OBJECT FLAGS...
compile() {
  mkdir -p "$tree/build/$(dirname "$2")"
  "$compiler" -x c++ -O2 -c -o "$tree/build/$2" "${@:3}" - <<<"$1"
}
multiply_add='double f(double a, double b, double c) { return a * b + c; }'
call_sine='extern "C" double sin(double); double g(double x) { return sin(x); }'

mkdir "$tree/build"
expect 2 'no objects' 'a build without objects' --objects "$tree/build"
compile "$multiply_add" navigation/plain.o
compile "$call_sine" replays/render/picture.o
compile "$call_sine" tests/some_test.o
expect 0 'checked 2 objects' 'plain objects' --objects "$tree/build"
compile "$call_sine" navigation/calls.o
expect 1 "navigation/calls.o:0: library object calls the C library's sin" 'a call of sin' --objects "$tree/build"
rm "$tree/build/navigation/calls.o"
if [[ $(uname -m) == x86_64 ]]; then
  compile "$multiply_add" apps/fused.o -mfma -ffp-contract=fast
  expect 1 'apps/fused.o:0: fused multiply-add in <_Z1fddd>' 'a fused multiply-add' --objects "$tree/build"
fi

expect 2 'unknown argument' 'an unknown argument' --bogus
expect 2 'lacks its value' 'an option without its value' --objects
expect 2 'no folder' 'a build that does not exist' --objects "$tree/nothing"
expect 0 'Usage:' 'the help' --help

((failures == 0)) || exit 1
echo 'all checks passed'
