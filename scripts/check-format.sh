#!/usr/bin/env bash
# Fails if a source file differs from the output of clang-format-19; --fix reformats the files.
set -euo pipefail
cd "$(dirname "$0")/.."
# Starters are templates; their placeholders are not C++.
sources() { git ls-files -z '*.c' '*.h' '*.cpp' '*.hpp' ':!sdk/starters'; }

case "${1:-}" in
  -h | --help) echo "Usage: scripts/check-format.sh [--fix]"; exit 0 ;;
  --fix) sources | xargs -0 clang-format-19 -i ;;
  "") sources | xargs -0 clang-format-19 --dry-run --Werror ;;
  *) echo "check-format.sh: unknown option '$1'" >&2; exit 2 ;;
esac
