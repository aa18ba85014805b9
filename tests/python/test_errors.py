"""Errors of the program are exceptions with its text, and none ends the interpreter."""

import pytest

import fulbito
from fulbito import _core


@pytest.mark.parametrize(
    ("code", "kind", "builtin"),
    [(0, fulbito.UsageError, ValueError), (1, fulbito.InputError, ValueError), (2, fulbito.FileError, OSError),
     (3, fulbito.MachineError, RuntimeError), (4, fulbito.InterruptedRun, RuntimeError),
     (5, fulbito.StateError, RuntimeError)])
def test_each_code_has_its_exception(code: int, kind: type[Exception], builtin: type[Exception]) -> None:
    with pytest.raises(kind, match="^mine.toml:7: wrong$") as caught:
        _core._fail(code, "mine.toml:7: wrong")
    assert isinstance(caught.value, builtin)
    assert isinstance(caught.value, fulbito.FulbitoError)


def test_a_broken_assertion_is_an_exception() -> None:
    with pytest.raises(fulbito.InternalError, match="internal error: x > 0 does not hold"):
        _core._fail(-1, "x > 0")
    assert fulbito.__version__ == "0.1.0"


def test_the_engine_reads_no_clock_inside_the_module() -> None:
    assert _core._engine_profile_milliseconds() == 0.0
