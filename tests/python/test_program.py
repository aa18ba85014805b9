"""`python -m fulbito` is the program."""

import subprocess
import sys

import fulbito


def run(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "fulbito", *words], capture_output=True, text=True, check=False)


def test_the_program_comes_with_the_package(program: str) -> None:
    assert run("--version").stdout.strip() == fulbito.__version__


def test_its_exit_code_is_the_command_s(program: str) -> None:
    wrong = run("match", "libero", "nobody")
    assert wrong.returncode == 2
    assert "nobody" in wrong.stderr
