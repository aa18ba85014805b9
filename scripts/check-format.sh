#!/usr/bin/env bash
# Fails when a source file is not as clang-format-19 would write it; --fix rewrites them.
set -euo pipefail
cd "$(dirname "$0")/.."
# Starters are templates, of which the marks are not C++.
sources() { git ls-files -z '*.c' '*.h' '*.cpp' '*.hpp' ':!sdk/starters'; }

case "${1:-}" in
  -h | --help) echo "Usage: scripts/check-format.sh [--fix]"; exit 0 ;;
  --fix) sources | xargs -0 clang-format-19 -i ;;
  "") sources | xargs -0 clang-format-19 --dry-run --Werror ;;
  *) echo "check-format.sh: unknown option '$1'" >&2; exit 2 ;;
esac
