#!/usr/bin/env bash
# Runs test programs as the user nobody: as_nobody.sh FOLDER_OF_MISBEHAVING_TEAM PROGRAM... -- ARGUMENTS
# They are copied to where nobody can read them. Exit code 77: this is not root, or the system lacks setpriv.
set -euo pipefail

command -v setpriv >/dev/null && [ "$(id -u)" -eq 0 ] || exit 77
team=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
programs=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  if [ -x "$1" ]; then
    cp "$1" "$folder/"
    programs+=("$folder/$(basename "$1")")
  else
    programs+=("$1")
  fi
  shift
done
[ $# -eq 0 ] || shift
mkdir "$folder/team" "$folder/tmp"
cp "$team" "$folder/team/misbehaving_team"
chmod -R a+rX "$folder"
chmod 1777 "$folder/tmp"
cd "$folder"
FULBITO_MISBEHAVING_TEAM=$folder/team/misbehaving_team TMPDIR=$folder/tmp HOME=$folder/tmp \
  PATH=/usr/local/bin:/usr/bin:/bin \
  setpriv --reuid=65534 --regid=65534 --clear-groups "${programs[@]}" "$@"
