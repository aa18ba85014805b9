#!/usr/bin/env bash
# Tests what needs Stable-Baselines3, torch and Ray, and makes the committed policies anew. Not part of .ci/run. See --help.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/check-training.sh [--train] [PYTEST ARGUMENTS]

  (no option)  installs torch, Stable-Baselines3 and Ray (gigabytes) with the package into build/training-venv, and runs
               tests/python/test_training.py: the environments' checks, PPO, tournaments and training on a Ray cluster of two nodes
  --train      makes examples/python/policies anew: drill-3.onnx in 12 minutes, then striker.onnx in 32; prints how they do
  -h, --help   this text

PYTHON names the interpreter (default: python3).
USAGE
}

train=false
case ${1:-} in
  -h | --help) usage; exit 0 ;;
  --train) train=true; shift ;;
esac
cd "$(dirname "$0")/.."
venv=$PWD/build/training-venv
export PYTHONDONTWRITEBYTECODE=1 PIP_DISABLE_PIP_VERSION_CHECK=1

[ -x "$venv/bin/python" ] || "${PYTHON:-python3}" -m venv "$venv"
PATH=$venv/bin:$PATH
pip install -q "nanobind>=2.4" "scikit-build-core>=0.10" numpy "gymnasium>=1.0" pettingzoo onnx onnxruntime stable-baselines3 torch "ray>=2.9" pytest
settings=()
# With the settings of the preset, nothing is compiled twice.
[ ! -f build/ci/CMakeCache.txt ] || settings=(-C build-dir=build/ci -C cmake.define.FULBITO_BUILD_TESTS=ON -C cmake.define.FULBITO_WERROR=ON)
pip install -q --no-deps --no-build-isolation "${settings[@]}" .

if $train; then
  out=$(mktemp -d)
  python examples/python/train_ppo.py drill 3 --minutes 12 --out "$out/drill-3"
  python examples/python/train_ppo.py vss --from "$out/drill-3" --minutes 20 --out "$out/striker-1"
  python examples/python/train_ppo.py vss --from "$out/striker-1" --start kick-off --end match --seconds 30 --minutes 12 --out "$out/striker"
  for name in drill-3 striker; do
    cp "$out/$name/policy.onnx" "examples/python/policies/$name.onnx"
    python examples/python/evaluate.py "examples/python/policies/$name.onnx"
  done
else
  python -m pytest -q -p no:cacheprovider tests/python/test_training.py "$@"
fi
