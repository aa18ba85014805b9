#!/usr/bin/env bash
# Looks for what would let results differ between CPUs, compilers, runs or libraries. See --help.
set -euo pipefail

usage() {
  cat <<'EOF'
Usage: scripts/check-determinism.sh [--root DIR] [--objects BUILD_DIR]

Checks that nothing that state can depend on differs between CPUs, compilers, runs or libraries:
  sources   the C library's transcendentals on doubles, fused multiply-add, clocks, foreign randomness,
            unordered containers (library folders, without replays/render)
  CMake     options that change floating-point results (-march, -mfma, -ffast-math, ...)
  objects   (with --objects) fused multiply-add instructions in any object or archive of the build, and
            references from library objects to the C library's transcendentals

A source or CMake line with the comment "determinism-ok: REASON" is left out.

  --root DIR           the repository (default: the one that holds this script)
  --objects BUILD_DIR  check the objects of this build as well, e.g. build/release
  -h, --help           this text

Exit code: 0 nothing found, 1 findings (printed as file:line: why), 2 wrong use.
Examples:
  scripts/check-determinism.sh
  scripts/check-determinism.sh --objects build/release
EOF
}

fail_usage() {
  echo "check-determinism: $1 (see --help)" >&2
  exit 2
}

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=''
while (($# > 0)); do
  case $1 in
    --root) root=${2-} && shift ;;
    --objects) build=${2-} && shift ;;
    -h | --help) usage && exit 0 ;;
    *) fail_usage "unknown argument '$1'" ;;
  esac
  shift || fail_usage 'an option lacks its value'
done
[[ -d $root ]] || fail_usage "no folder '$root'"
[[ -z $build || -d $build ]] || fail_usage "no folder '$build'"
[[ -z $build ]] || build=$(cd "$build" && pwd)

readonly library_folders=(engine navigation strategies referee replays match experiments)
# Pictures are not state.
readonly allowed_folder='replays/render'
# The project's own functions are defined here, so their plain names are no calls of the C library's.
readonly own_math='^engine/core/math[a-z_]*\.[ch]pp$'
readonly functions='sin|cos|sincos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|hypot|cbrt|erf|erfc|tgamma|lgamma'

findings=0

# report FILE LINE WHY
report() {
  echo "$1:$2: $3"
  findings=$((findings + 1))
}

# The text of a file without allowed lines, comments and strings; line numbers stay.
code_of() {
  sed -E -e '/determinism-ok: *[^ ]/s/.*//' -e "s/'\\\\?\"'/' '/g" -e 's/"([^"\\]|\\.)*"/""/g' -e 's#//.*##' -e 's#/\*([^*]|\*[^/])*\*/##g' "$1"
}

# search FILE TEXT PATTERN WHY
search() {
  local line
  while IFS=: read -r line _; do
    [[ -n $line ]] && report "$1" "$line" "$4"
  done < <(grep -nP -- "$3" <<<"$2" || true)
}

check_source() {
  local file=$1 text start='(?<![\w:.])(?<!->)'
  text=$(code_of "$file")
  search "$file" "$text" "\bstd::($functions)\b" "differs between CPUs: use fulbito::math or std::sqrt"
  search "$file" "$text" "$start::($functions)\s*\(" "differs between CPUs: use fulbito::math"
  if [[ ! $file =~ $own_math ]]; then
    search "$file" "$text" "$start($functions)\s*\(" "differs between CPUs if the C library's: write math:: before it"
  fi
  search "$file" "$text" '\bstd::(complex|norm|polar)\b|<complex>' 'complex functions call the C library'
  search "$file" "$text" "$start(std::|::)?fma\s*\(|\b_mm\w*_f(n?m)(add|sub)" 'fused multiply-add'
  search "$file" "$text" '\b\w+_clock\s*::\s*now\b|\b(clock_gettime|gettimeofday|timespec_get|__rdtsc)\b' 'reads a clock'
  search "$file" "$text" "$start(std::|::)?(time\s*\(\s*(nullptr|NULL|0|&)|clock\s*\(\s*\))" 'reads a clock'
  search "$file" "$text" '\bstd::(random_device|mt19937|minstd_rand|ranlux|default_random_engine|\w+_distribution\b|shuffle\b|sample\b)|<random>' \
    'differs between runs or libraries: use Rng'
  search "$file" "$text" "$start(std::|::)?(s?rand|random|[dlm]rand48)\s*\(" 'differs between runs or libraries: use Rng'
  search "$file" "$text" '\bunordered_(multi)?(map|set)\b|\bstd::hash\b' 'order differs between libraries: use a vector or std::map'
  search "$file" "$text" '\bstd::(multi)?(map|set)\s*<[^,<>]*\*' 'ordered by address, which differs between runs'
}

check_cmake() {
  local text
  text=$(sed -E -e '/determinism-ok: *[^ ]/s/.*//' -e 's/#.*//' "$1")
  search "$1" "$text" '-march\b|-mfma|-mfpmath|-Ofast|-ffast-math|-funsafe-math|-fassociative-math|-freciprocal-math|-ffp-contract=(on|fast)' \
    'changes floating-point results'
}

check_sources() {
  local file
  cd "$root"
  while IFS= read -r file; do
    [[ $file == "$allowed_folder"/* ]] || check_source "$file"
  done < <(find "${library_folders[@]}" -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' -o -name '*.c' \) 2>/dev/null | sort)
  while IFS= read -r file; do
    check_cmake "${file#./}"
  done < <(find . -path ./build -prune -o -type f \
    \( -name CMakeLists.txt -o -name '*.cmake' -o -name '*.cmake.in' -o -name 'CMake*Presets.json' \) -print | sort)
}

# Names the first few functions of an object or archive that contain fused multiply-adds.
check_fused() {
  local where
  where=$(objdump -d --no-show-raw-insn "$1" |
    awk '/>:$/ { name = $2 } /[ \t]vfn?m(add|sub)/ { if (!(name in seen)) { seen[name]; if (++n <= 3) printf "%s ", name } }')
  [[ -z $where ]] || report "$1" 0 "fused multiply-add in $where"
}

check_symbols() {
  local names
  names=$(nm -u "$1" 2>/dev/null | awk '{ sub(/@.*/, "", $NF); print $NF }' | grep -xE "$functions|fma" | sort -u | tr '\n' ' ' || true)
  [[ -z $names ]] || report "$1" 0 "library object calls the C library's $names"
}

check_objects() {
  local file folder count=0
  type objdump nm >/dev/null || fail_usage 'objdump and nm (binutils) are missing'
  cd "$build"
  while IFS= read -r file; do
    file=${file#./}
    count=$((count + 1))
    check_fused "$file"
    [[ $file == "$allowed_folder"/* ]] && continue
    for folder in "${library_folders[@]}"; do
      [[ $file == "$folder"/* ]] && check_symbols "$file"
    done
  done < <(find . -type f \( -name '*.o' -o -name '*.a' \) | sort)
  ((count > 0)) || fail_usage "no objects in '$build'"
  echo "checked $count objects and archives"
}

check_sources
[[ -z $build ]] || check_objects
if ((findings > 0)); then
  echo "check-determinism: $findings findings" >&2
  exit 1
fi
echo 'check-determinism: nothing found'
