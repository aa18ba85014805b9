#!/usr/bin/env bash
# Tests the recipes for tournaments on more than one machine: tests/tournament/run.sh PROGRAM
# Slurm and GNU parallel really run here. Of GitHub's workflows it runs the steps, of Kubernetes' jobs the
# containers' commands.
set -euo pipefail
program=$(realpath "${1:?Usage: tests/tournament/run.sh PROGRAM}")
here=$(cd "$(dirname "$0")" && pwd)
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

# Installs the program and the files that it needs.
cmake --build "$(dirname "$program")" --target fulbito fulbito-team-host
install -D "$program" "$prefix/bin/fulbito"
install -D "$(dirname "$program")/fulbito-team-host" "$prefix/libexec/fulbito/fulbito-team-host"

"$here/parallel.sh" "$prefix/bin/fulbito"
"$here/slurm.sh" "$prefix/bin/fulbito"
# The packages are installed for the distribution's Python.
/usr/bin/python3 "$here/kubernetes_test.py" "$here/../.." "$prefix"
/usr/bin/python3 "$here/workflows_test.py" "$here/../.." "$prefix"

cd "$here/lint"
# npm writes its own lock file after installing. If it is newer than the project's, all packages are
# installed.
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --no-audit --no-fund
node --test --test-reporter=spec ./*.test.mjs
