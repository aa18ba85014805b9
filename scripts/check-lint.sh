#!/usr/bin/env bash
# Runs clang-tidy-19 on the sources of libraries and program, and shellcheck on the scripts. See --help.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/check-lint.sh [--all] [--list] [PRESET]

shellcheck looks at all scripts; clang-tidy-19 at the sources that changed since the base commit (scripts/base-commit.sh), and for
each changed header that none of them includes at one source that does. Without a base commit, as on the base branch itself, it
looks at what the last 25 commits changed, and at all files where there are fewer commits or the checks themselves changed. It then
leaves out one slow check: that of parameters passed by value, which says nothing of errors.

  PRESET   a configured preset, default: ci, whose files are compiled in groups: a group is checked whole, headers once a group
  --all    all files, all checks
  --list   print what clang-tidy would check, and stop
  -h, --help  this text
USAGE
}

all=false list=false preset=ci
for option in "$@"; do
  case $option in
    --all) all=true ;;
    --list) list=true ;;
    -h | --help) usage && exit 0 ;;
    -*) echo "check-lint.sh: unknown option '$option' (see --help)" >&2; exit 2 ;;
    *) preset=$option ;;
  esac
done
cd "$(dirname "$0")/.."
root=$PWD build=build/$preset
readonly folders='sdk|engine|navigation|strategies|referee|replays|match|tournament|experiments|bench|apps|bridge|python/environments'
[ -f "$build/compile_commands.json" ] || { echo "check-lint.sh: configure first: cmake --preset $preset" >&2; exit 2; }

changed_files() {
  git diff --name-only "$1"
  git ls-files --others --exclude-standard
}

# Prints each #include of a project header as "FILE NAME". NAME is the include path of a public header, else the file.
inclusions() {
  git grep --untracked -E '^#include "' -- '*.cpp' '*.hpp' '*.h' '*.c' | sed -E 's/^([^:]*):#include "([^"]*)".*/\1 \2/; s#^sdk/include/##'
}

# reached FROM TO: the files on standard input, and all files that inclusions lead to from column FROM to column TO, directly or indirectly.
reached() {
  awk -v from="$1" -v to="$2" 'FILENAME == ARGV[1] { queue[++last] = $0; hit[$0]; next }
    { next_of[$from] = next_of[$from] " " $to }
    END {
      for (i = 1; i <= last; ++i) {
        print queue[i]
        count = split(next_of[queue[i]], found, " ")
        for (k = 1; k <= count; ++k) if (!(found[k] in hit)) { hit[found[k]]; queue[++last] = found[k] }
      }
    }' <(sed 's#^sdk/include/##') <(inclusions)
}

# Prints what the build compiles in the folders: files, or groups of files.
compiled() {
  sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$build/compile_commands.json" | sort -u | grep -E \
    "^$root/(($folders)/.*\.cpp|$build/($folders)/.*Unity/.*\.cxx)$" | grep -v /learnt/  # a library of the SDK, as the examples are
}

# Prints the project's files in a compiled file.
parts() {
  case $1 in
    *.cxx) sed -n 's/^#include "\(.*\)"$/\1/p' "$1" ;;
    *) echo "$1" ;;
  esac | sed "s#^$root/##"
}

# Prints the parts of all compiled files on standard input.
all_parts() {
  local file
  while IFS= read -r file; do [ -z "$file" ] || parts "$file"; done
}

# has_part COMPILED FILES: whether a compiled file contains one of the files, one per line.
has_part() {
  parts "$1" | grep -xF -f <(echo "$2") >/dev/null
}

# Prints the compiled files whose sources changed since the commit, and one user of each changed header that none of these includes.
affected_since() {
  local changed chosen header users file
  changed=$(changed_files "$1")
  chosen=$(while IFS= read -r file; do if has_part "$file" "$changed"; then echo "$file"; fi; done < <(compiled))
  while IFS= read -r header; do
    users=$(reached 2 1 <<<"$header")
    while IFS= read -r file; do
      if has_part "$file" "$users"; then
        chosen+=$'\n'$file
        break
      fi
    done < <(compiled)
  done < <(grep -E "^($folders)/.*\.hp*$" <<<"$changed" | sed 's#^sdk/include/##' | grep -vxF -f <(all_parts <<<"$chosen" | reached 1 2))
  sort -u <<<"$chosen" | sed '/^$/d'
}

# The base commit for the base branch itself: its state 25 commits ago, so that the latest merges are checked.
recent_base() {
  git rev-list --first-parent --max-count=1 --skip=25 HEAD
}

base=$(scripts/base-commit.sh)
options=(-p "$build" --quiet --header-filter="($folders)/.*\.[ch]pp$")
unless_slow=--checks=-performance-unnecessary-value-param  # takes up to half of a group's time
if [ -z "$base" ] && [ "${FULBITO_BASE:-}" != none ]; then
  base=$(recent_base)
  options+=("$unless_slow")
fi
if $all; then
  files=$(compiled)
elif [ -z "$base" ] || changed_files "$base" | grep -x '\.clang-tidy' >/dev/null; then
  files=$(compiled)
  options+=(--checks=-performance-unnecessary-value-param)  # this check takes up to half of a group's time
else
  files=$(affected_since "$base")
fi

if $list; then
  all_parts <<<"$files"
  exit
fi
git ls-files -z 'scripts/*.sh' 'tests/**/*.sh' 'examples/**/*.sh' 'examples/**/*.sbatch' .ci/run | xargs -0 shellcheck
[ -n "$files" ] || { echo "check-lint.sh: no source changed"; exit 0; }
echo "check-lint.sh: $(wc -l <<<"$files") files or groups of $(compiled | wc -l)"
xargs -d '\n' -n 1 -P "$(nproc)" clang-tidy-19 "${options[@]}" <<<"$files"
