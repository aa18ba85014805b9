#!/usr/bin/env bash
# clang-tidy-19 on the sources of the libraries and of the program, and shellcheck on the scripts. See --help.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/check-lint.sh [--all] [--list] [PRESET]

shellcheck looks at all scripts; clang-tidy-19 at what changed since the base commit (scripts/base-commit.sh) and at what includes
it. Without a base commit, or where the checks themselves changed, it looks at all files, but leaves out one slow check: that of
parameters passed by value, which says nothing of errors.

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
readonly folders='sdk|engine|navigation|strategies|referee|replays|match|tournament|trials|experiments|bench|apps|bridge'
[ -f "$build/compile_commands.json" ] || { echo "check-lint.sh: configure first: cmake --preset $preset" >&2; exit 2; }

changed_files() {
  git diff --name-only "$1"
  git ls-files --others --exclude-standard
}

# Those named on standard input, and all files that include them, directly or not. Public headers by their name in #include.
with_users() {
  awk 'FILENAME == ARGV[1] { queue[++last] = $0; hit[$0]; next }
    { split($0, part, ":"); split(part[2], quoted, "\""); users[quoted[2]] = users[quoted[2]] " " part[1] }
    END {
      for (i = 1; i <= last; ++i) {
        print queue[i]
        count = split(users[queue[i]], user, " ")
        for (k = 1; k <= count; ++k) if (!(user[k] in hit)) { hit[user[k]]; queue[++last] = user[k] }
      }
    }' <(sed 's#^sdk/include/##') <(git grep --untracked -E '^#include "' -- '*.cpp' '*.hpp' | sed 's#^sdk/include/##')
}

# What the build compiles of the folders: files, or groups of them.
compiled() {
  sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$build/compile_commands.json" | sort -u | grep -E \
    "^$root/(($folders)/.*\.cpp|$build/($folders)/.*Unity/.*\.cxx)$"
}

# The project's files in a compiled one.
parts() {
  case $1 in
    *.cxx) sed -n 's/^#include "\(.*\)"$/\1/p' "$1" ;;
    *) echo "$1" ;;
  esac | sed "s#^$root/##"
}

# Those of the compiled files that a change since the commit affects.
affected_since() {
  local file affected
  affected=$(changed_files "$1" | with_users)
  while IFS= read -r file; do
    if parts "$file" | grep -xF -f <(echo "$affected") >/dev/null; then echo "$file"; fi
  done < <(compiled)
}

base=$(scripts/base-commit.sh)
options=(-p "$build" --quiet)
if $all; then
  files=$(compiled)
elif [ -z "$base" ] || changed_files "$base" | grep -E '^(\.clang-tidy|scripts/check-lint\.sh)$' >/dev/null; then
  files=$(compiled)
  options+=(--checks=-performance-unnecessary-value-param)  # takes up to half of a group's time
else
  files=$(affected_since "$base")
fi

if $list; then
  while IFS= read -r file; do [ -z "$file" ] || parts "$file"; done <<<"$files"
  exit
fi
git ls-files -z 'scripts/*.sh' 'tests/**/*.sh' 'examples/**/*.sh' 'examples/**/*.sbatch' .ci/run | xargs -0 shellcheck
[ -n "$files" ] || { echo "check-lint.sh: no source changed"; exit 0; }
echo "check-lint.sh: $(wc -l <<<"$files") files or groups of $(compiled | wc -l)"
xargs -d '\n' -n 1 -P "$(nproc)" clang-tidy-19 "${options[@]}" <<<"$files"
