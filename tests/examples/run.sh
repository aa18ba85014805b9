#!/usr/bin/env bash
# Runs every command that README, CONTRIBUTING and docs show in ```sh blocks, in a folder of its own, with the given program as
# `fulbito`. Lines that begin with scripts/, cmake, ctest, git or pip are for the reader's checkout: .ci/run runs those scripts.
# Usage: tests/examples/run.sh PROGRAM [PAGES]
set -euo pipefail
program=$(realpath "${1:?Usage: tests/examples/run.sh PROGRAM [PAGES]}")
root=$(cd "$(dirname "$0")/../.." && pwd)
shift
pages=()
for page in "$@"; do pages+=("$(realpath "$page")"); done
[ "${#pages[@]}" -gt 0 ] || pages=("$root"/README.md "$root"/CONTRIBUTING.md "$root"/docs/*.md)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"
ln -s "$program" "$work/bin/fulbito"
export PATH="$work/bin:$PATH"

count=0
for page in "${pages[@]}"; do
  mkdir -p "$work/run/examples"
  cp -r "$root/examples/drills" "$root/examples/teams" "$root/examples/paths" "$root/examples/tournaments" "$work/run/examples"
  cd "$work/run"
  while IFS= read -r line; do
    case "$line" in
      fulbito* | SDL_VIDEODRIVER=dummy\ fulbito* | build/release/fulbito* | make\ -C\ * | sh\ *test.sh | cp\ -r\ * | sed\ -i\ *) ;;
      scripts/* | cmake* | ctest* | git* | pip\ install* | cd* | '#'* | '') continue ;;
      *) echo "${page#"$root"/}: a command that this check does not know: $line" >&2; exit 1 ;;
    esac
    line=${line/#build\/release\/fulbito/fulbito}
    echo "+ (${page#"$root"/}) $line"
    if ! bash -euo pipefail -c "$line" >"$work/log" 2>&1; then
      cat "$work/log"
      echo "${page#"$root"/}: failed: $line" >&2
      exit 1
    fi
    count=$((count + 1))
  done < <(awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$page")
  cd "$root"
  rm -rf "$work/run"
done
[ "$count" -gt 0 ] || { echo "no commands found" >&2; exit 1; }
echo "$count commands ran"
