"""The package itself: types, docstrings, what it needs, how fast it loads."""

import dataclasses
import importlib
import importlib.metadata
import inspect
import os
import pkgutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

import fulbito
from fulbito.team import Team

def modules() -> list[ModuleType]:
    names = ["fulbito"] + [m.name for m in pkgutil.walk_packages(fulbito.__path__, "fulbito.", onerror=lambda name: None)]
    found = []
    for name in names:
        try:
            found.append(importlib.import_module(name))
        except ImportError as error:
            # Only modules with an optional package may be missing.
            assert error.name is not None and not error.name.startswith("fulbito"), name
    return found


def test_every_public_symbol_has_a_docstring() -> None:
    missing = []
    for module in modules():
        if not module.__doc__:
            missing.append(module.__name__)
        for name in getattr(module, "__all__", []):
            symbol = getattr(module, name)
            if not (inspect.isclass(symbol) or inspect.isroutine(symbol)) or getattr(symbol, "__module__", "") == "typing":
                continue
            if not inspect.getdoc(symbol):
                missing.append(f"{module.__name__}.{name}")
            members = vars(symbol).items() if inspect.isclass(symbol) else []
            fields = {f.name for f in dataclasses.fields(symbol)} if dataclasses.is_dataclass(symbol) else set()
            for member, value in members:
                public = not member.startswith("_") and member not in fields
                described = isinstance(value, (property, classmethod, staticmethod)) or inspect.isfunction(value)
                if public and described and not inspect.getdoc(getattr(symbol, member)):
                    missing.append(f"{module.__name__}.{name}.{member}")
    assert missing == []


def test_all_names_exist() -> None:
    for module in modules():
        for name in getattr(module, "__all__", []):
            assert hasattr(module, name), f"{module.__name__}.{name}"


def test_it_is_typed() -> None:
    folder = Path(fulbito.__file__).parent
    assert (folder / "py.typed").is_file()
    assert (folder / "_core.pyi").is_file()


def test_it_needs_numpy_only() -> None:
    script = ("import sys, fulbito\n"
              "print([n for n in ('gymnasium', 'pettingzoo', 'ray', 'torch', 'onnxruntime', 'tqdm') if n in sys.modules])")
    assert subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout == "[]\n"


def _processor_time(statement: str) -> float:
    times = []
    for _ in range(5):
        before = os.times()
        subprocess.run([sys.executable, "-c", statement], check=True)
        after = os.times()
        times.append(after.children_user + after.children_system - before.children_user - before.children_system)
    return min(times)


def test_it_loads_fast() -> None:
    # A ratio, since machines differ: NumPy is the largest thing that the package imports.
    numpy, package = _processor_time("import numpy"), _processor_time("import fulbito")
    print(f"processor time, the interpreter included: import numpy {numpy:.2f} s, import fulbito {package:.2f} s")
    assert package < 1.8 * numpy, (numpy, package)


def test_its_version_is_that_of_the_wheel() -> None:
    try:
        installed = importlib.metadata.version("fulbito")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("not installed from a wheel")
    assert installed == fulbito.__version__


def test_the_sdk_module_is_the_package_s() -> None:
    if Path(fulbito.__file__).parent.parent.name != "site-packages":
        pytest.skip("in a build folder, the program's copy comes first")
    assert getattr(importlib.import_module("fulbito_team"), "Team") is Team
