#!/usr/bin/env bash
# Each kind of `fulbito new-team` builds with one command and beats `idle` in its own test, all within 300 s; wrong names and
# folders are refused and left alone. The starter in Python passes mypy with its SDK.
set -euo pipefail
program=$(realpath "${1:?Usage: tests/teams/new_team.sh FULBITO MYPY}")
mypy=${2:?Usage: tests/teams/new_team.sh FULBITO MYPY}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export FULBITO=$program PYTHONDONTWRITEBYTECODE=1
fail() { echo "new_team.sh: $1" >&2; exit 1; }

begin=$SECONDS
for kind in cpp c python program; do
  "$program" new-team "$kind" "my-$kind" >created
  grep -q "cd my-$kind" created || fail "$kind: the answer does not name the folder"
  if [ "$kind" = python ]; then
    sh my-python/test.sh >log 2>&1 || { cat log; fail "python does not beat idle"; }
  else
    make -s -C "my-$kind" >log 2>&1 || { cat log; fail "$kind does not build"; }
    [ ! -s log ] || { cat log; fail "$kind builds with warnings"; }
    make -s -C "my-$kind" test >log 2>&1 || { cat log; fail "$kind does not beat idle"; }
  fi
  grep -q "my-$kind beats idle" log || { cat log; fail "$kind: its test says nothing"; }
done
took=$((SECONDS - begin))
[ "$took" -lt 300 ] || fail "all kinds took $took s"

# The test that new-team writes can fail.
cat >my-python/team.py <<'TEAM'
from fulbito_team import Commands, Observation, Team, run


class Still(Team):
    def decide(self, seen: Observation) -> Commands:
        return Commands()


run(Still())
TEAM
if sh my-python/test.sh >log 2>&1; then fail "a team that stands still passes its test"; fi

# refused WORDS ARGUMENTS...: exit code 2, and the message has the words.
refused() {
  local words=$1 code=0
  shift
  "$program" new-team "$@" >out 2>err || code=$?
  [ "$code" -eq 2 ] || fail "new-team $*: exit code $code"
  grep -qF -- "$words" err || { cat err; fail "new-team $*: no '$words'"; }
}
refused "cannot be a name" python 'a;b'
refused "cannot be a name" cpp 'quote"d'
refused "cannot be a name" cpp fine --name 'this name is longer than forty characters is'
refused "not in {cpp,c,python,program}" perl other
for folder in 'a;b' 'quote"d' fine other; do
  [ ! -e "$folder" ] || fail "a refused team left '$folder'"
done
mkdir full
echo mine >full/team.py
refused "not empty" python full
[ "$(cat full/team.py) $(ls full)" = "mine team.py" ] || fail "a folder that was not empty has changed"
mkdir empty
"$program" new-team python empty --name "Rovers 2" >/dev/null
grep -q 'name = "Rovers 2"' empty/team.py || fail "--name is not the team's name"

(cd empty && "$mypy" --strict --python-version 3.9 --cache-dir "$work/mypy" team.py fulbito_team.py) || fail "mypy"
echo "all kinds built and beat idle in $took s"
