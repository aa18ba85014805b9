#!/usr/bin/env bash
# Installs the packages that Fulbito needs for building and testing, from the distribution.
# Tested on Debian 12; also written for Ubuntu 24.04. Does nothing if all packages are installed.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/install-deps.sh [--ci] [--list]
  (no option)  what building, running and testing needs
  --ci         also what .ci/run needs: clang 19 with its tools, shellcheck, ffmpeg, headless Chromium, Node, an X server in memory,
               Slurm, GNU parallel
  --list       print the packages and stop
USAGE
}

packages=(
  g++ make cmake ninja-build git ca-certificates binutils pkg-config
  libbox2d-dev libeigen3-dev libsdl2-dev libsdl2-ttf-dev fonts-dejavu-core libpng-dev libdeflate-dev libgif-dev
  libfmt-dev libexpected-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev
  librandom123-dev libxxhash-dev zlib1g-dev
  libseccomp-dev libprotobuf-dev protobuf-compiler
  libxml2-utils catch2 libmpfr-dev libgmp-dev
  python3 python3-dev python3-venv python3-pip mypy python3-jsonschema python3-protobuf
)
ci_packages=(
  clang-19 clang-format-19 clang-tidy-19 libclang-rt-19-dev lld-19 shellcheck
  ffmpeg chromium-headless-shell xvfb xdotool
  slurmctld slurmd slurm-client munge parallel python3-yaml
)
# Debian's npm does not work with a Node from another source, so an installed npm stays.
command -v npm >/dev/null || ci_packages+=(nodejs npm)

list=false
for option in "$@"; do
  case "$option" in
    --ci) packages+=("${ci_packages[@]}") ;;
    --list) list=true ;;
    -h | --help) usage; exit 0 ;;
    *) echo "install-deps.sh: unknown option '$option'" >&2; usage >&2; exit 2 ;;
  esac
done
if $list; then printf '%s\n' "${packages[@]}"; exit 0; fi

if ! command -v apt-get >/dev/null; then
  echo "install-deps.sh: this script needs apt-get (Debian or Ubuntu). Elsewhere install: ${packages[*]}" >&2
  exit 2
fi

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  echo "install-deps.sh: all packages are there"
  exit 0
fi

root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "install-deps.sh: run as root, or install sudo" >&2; exit 2; }
  root=(sudo)
fi
echo "install-deps.sh: installing ${missing[*]}"
"${root[@]}" apt-get update -qq
"${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
