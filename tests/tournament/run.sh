#!/usr/bin/env bash
# Tests the recipes for tournaments on more than one machine: tests/tournament/run.sh PROGRAM
# Slurm and GNU parallel run here for real; of GitHub's workflows the steps, and of Kubernetes' jobs the containers' commands.
set -euo pipefail
program=$(realpath "${1:?Usage: tests/tournament/run.sh PROGRAM}")
here=$(cd "$(dirname "$0")" && pwd)
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

# The program and what it needs of its own, as they are installed.
cmake --build "$(dirname "$program")" --target fulbito fulbito-team-host
install -D "$program" "$prefix/bin/fulbito"
install -D "$(dirname "$program")/fulbito-team-host" "$prefix/libexec/fulbito/fulbito-team-host"

"$here/parallel.sh" "$prefix/bin/fulbito"
"$here/slurm.sh" "$prefix/bin/fulbito"
# The distribution's Python has its packages.
/usr/bin/python3 "$here/kubernetes_test.py" "$here/../.." "$prefix"
/usr/bin/python3 "$here/workflows_test.py" "$here/../.." "$prefix"

cd "$here/lint"
# npm leaves its lock file beside what it has installed: newer than ours, it is what ours asks for.
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --no-audit --no-fund
node --test --test-reporter=spec ./*.test.mjs
