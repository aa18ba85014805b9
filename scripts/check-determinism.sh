#!/usr/bin/env bash
# Finds code that could make results differ between CPUs, compilers, runs or libraries. See --help.
set -euo pipefail

usage() {
  cat <<'EOF'
Usage: scripts/check-determinism.sh [--root DIR] [--objects BUILD_DIR]

Checks that nothing that state can depend on differs between CPUs, compilers, runs or libraries:
  sources   the C library's transcendentals on doubles, fused multiply-add, clocks, foreign randomness,
            unordered containers (library folders, without replays/render)
  CMake     options that change floating-point results (-march, -mfma, -ffast-math, ...)
  objects   (with --objects) fused multiply-add instructions in any object of the build, tests apart, and
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

readonly library_folders=(sdk engine navigation strategies referee replays match experiments bridge)
# Pictures are not part of the state, and neither are the starters of users' teams.
readonly allowed_folder='replays/render'
# These files define the project's own functions, so plain names in them are not calls of the C library.
readonly own_math='^(engine/core/math/(constants|exp|inverse|math|trig)\.[ch]pp|sdk/include/fulbito/detail/math\.hpp)$'
readonly functions='sin|cos|sincos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|exp10|expm1|log|log2|log10|log1p|pow|hypot|cbrt|erf|erfc|tgamma|lgamma'

findings=0

# report FILE LINE WHY
report() {
  echo "$1:$2: $3"
  findings=$((findings + 1))
}

texts=$(mktemp -d)
trap 'rm -rf "$texts"' EXIT

# copy FOLDER SED_OPTIONS...: copies the files named on standard input and edits the copies; line numbers stay.
copy() {
  mkdir -p "$texts/$1"
  xargs -d '\n' -r cp --parents -t "$texts/$1"
  find "$texts/$1" -type f -print0 | xargs -0 -r chmod u+w --
  find "$texts/$1" -type f -print0 | xargs -0 -r sed -i -E -e '/determinism-ok: *[^ ]/s/.*//' "${@:2}" --
}

# search FOLDER PATTERN WHY [NOT_IN]: searches all files with one process, except those that match NOT_IN.
search() {
  local file line
  while IFS=: read -r file line _; do
    file=${file#./}
    [[ -n ${4-} && $file =~ $4 ]] || report "$file" "$line" "$3"
  done < <(cd "$texts/$1" && grep -rnP -- "$2" . | sort -t: -k1,1 -k2,2n)
}

# Copies the sources without comments and strings.
copy_sources() {
  { find "${library_folders[@]}" -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' -o -name '*.c' \) \
    -not -path "$allowed_folder/*" -not -path 'sdk/starters/*' 2>/dev/null || true; } |
    copy sources -e "s/'\\\\?\"'/' '/g" -e 's/"([^"\\]|\\.)*"/""/g' -e 's#//.*##' -e 's#/\*([^*]|\*[^/])*\*/##g'
}

check_sources() {
  local start='(?<![\w:.])(?<!->)'
  copy_sources
  search sources "\bstd::($functions)\b" "differs between CPUs: use fulbito::math or std::sqrt"
  search sources "$start::($functions)\s*\(" "differs between CPUs: use fulbito::math"
  search sources "$start($functions)\s*\(" "differs between CPUs if the C library's: write math:: before it" "$own_math"
  search sources '\bstd::(complex|norm|polar)\b|<complex>' 'complex functions call the C library'
  search sources "$start(std::|::)?fma\s*\(|\b_mm\w*_f(n?m)(add|sub)" 'fused multiply-add'
  search sources '\b\w+_clock\s*::\s*now\b|\b(clock_gettime|gettimeofday|timespec_get|__rdtsc)\b' 'reads a clock'
  search sources "$start(std::|::)?(time\s*\(\s*(nullptr|NULL|0|&)|clock\s*\(\s*\))" 'reads a clock'
  search sources '\bstd::(random_device|mt19937|minstd_rand|ranlux|default_random_engine|\w+_distribution\b|shuffle\b|sample\b)|<random>' \
    'differs between runs or libraries: use Rng'
  search sources "$start(std::|::)?(s?rand|random|[dlm]rand48)\s*\(" 'differs between runs or libraries: use Rng'
  search sources '\bunordered_(multi)?(map|set)\b|\bstd::hash\b' 'order differs between libraries: use a vector or std::map'
  search sources '\bstd::(multi)?(map|set)\s*<[^,<>]*\*' 'ordered by address, which differs between runs'
}

check_cmake() {
  find . -path ./build -prune -o -type f \
    \( -name CMakeLists.txt -o -name '*.cmake' -o -name '*.cmake.in' -o -name 'CMake*Presets.json' \) -print | copy cmake -e 's/#.*//'
  search cmake '-march\b|-mfma|-mfpmath|-Ofast|-ffast-math|-funsafe-math|-fassociative-math|-freciprocal-math|-ffp-contract=(on|fast)' \
    'changes floating-point results'
}

# Reports the first few functions of each object that contain fused multiply-adds.
check_fused() {
  local file where
  while IFS=: read -r file where; do
    report "$file" 0 "fused multiply-add in $where"
  done < <(tr '\n' '\0' <"$texts/objects" | xargs -0 objdump -d --no-show-raw-insn | awk '
    /^\.\/.* file format / { file = substr($1, 3, length($1) - 3) }
    />:$/ { name = $2 }
    /[ \t]vfn?m(add|sub)/ && !((file, name) in seen) { seen[file, name]; if (++count[file] <= 3) names[file] = names[file] name " " }
    END { for (file in names) print file ":" names[file] }' | sort)
}

# Reports objects of the libraries that refer to functions of the C library.
check_symbols() {
  local file names folders
  folders=$(IFS='|'; echo "${library_folders[*]}")
  while IFS=: read -r file names; do
    report "$file" 0 "library object calls the C library's $names"
  done < <(grep -E "^\./($folders)/" "$texts/objects" | grep -v "^\./$allowed_folder/" | tr '\n' '\0' | xargs -0 -r nm -A -u 2>/dev/null |
    awk -v wanted="^($functions|fma)\$" '
    { name = $NF; sub(/@.*/, "", name); file = substr($1, 3); sub(/:.*/, "", file) }
    name ~ wanted && !((file, name) in seen) { seen[file, name]; names[file] = names[file] name " " }
    END { for (file in names) print file ":" names[file] }' | sort)
}

check_objects() {
  type objdump nm >/dev/null || fail_usage 'objdump and nm (binutils) are missing'
  cd "$build"
  find . -path ./tests -prune -o -type f -name '*.o' -print | sort >"$texts/objects"
  [[ -s $texts/objects ]] || fail_usage "no objects in '$build'"
  check_fused
  check_symbols
  echo "checked $(wc -l <"$texts/objects") objects"
}

cd "$root"
check_sources
check_cmake
[[ -z $build ]] || check_objects
if ((findings > 0)); then
  echo "check-determinism: $findings findings" >&2
  exit 1
fi
echo 'check-determinism: nothing found'
