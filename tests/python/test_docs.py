"""The code of docs/python.md, docs/environments.md and docs/train-an-agent.md runs, block after block."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import fulbito

PAGE = Path(__file__).resolve().parents[2] / "docs" / "python.md"


def test_the_page_of_python_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) >= 5
    names: dict[str, Any] = {}
    for block in blocks:
        exec(compile(block, str(PAGE), "exec"), names)
    assert (tmp_path / "match.html").is_file()
    assert len(list(names["film"])) == 20
    assert names["ball"].shape[1] == 2


def test_the_page_of_environments_runs() -> None:
    pytest.importorskip("gymnasium")
    pytest.importorskip("pettingzoo")
    page = PAGE.with_name("environments.md")
    blocks = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    assert len(blocks) >= 6
    names: dict[str, Any] = {}
    for block in blocks:
        exec(compile(block, str(page), "exec"), names)
    assert names["observations"]


def in_a_folder_with_examples(folder: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Goes there, and gives the page about training."""
    shutil.copytree(PAGE.parents[1] / "examples" / "python", folder / "examples" / "python")
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PATH", f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    return PAGE.with_name("train-an-agent.md").read_text(encoding="utf-8")


def test_the_code_of_the_page_of_training_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("onnxruntime")
    page = in_a_folder_with_examples(tmp_path, monkeypatch)
    (block,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    names: dict[str, Any] = {}
    exec(compile(block, "train-an-agent.md", "exec"), names)
    assert names["info"]["success"] == 1.0
    assert (tmp_path / "episode.html").is_file()


@pytest.mark.skipif(Path(fulbito.__file__).is_symlink(), reason="the sandbox follows no links out of the package in a build folder")
def test_the_commands_of_the_page_of_training_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("onnxruntime")
    page = in_a_folder_with_examples(tmp_path, monkeypatch)
    commands = [line for block in re.findall(r"```bash\n(.*?)```", page, re.DOTALL) for line in block.splitlines()]
    assert len(commands) >= 5
    printed = {}
    for command in commands:
        done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
        # A sequential test ends with 1 if the new team is not better, and with 6 if it plays all pairs without a verdict.
        assert done.returncode in ((0, 1, 6) if "sprt" in command else (0,)), f"{command}\n{done.stderr}"
        printed[command] = done.stdout
    success = re.search(r"success ([0-9.]+) %", next(text for command, text in printed.items() if "drill-3.onnx --episodes" in command))
    assert success is not None and float(success[1]) >= 90.0
