"""What the tests share."""

from pathlib import Path

import pytest

import fulbito
from fulbito import MatchResult, Recording


@pytest.fixture(scope="session")
def short_match() -> MatchResult:
    """A match of two halves of twenty seconds, recorded in memory. Nobody defends, so any way to play scores."""
    return fulbito.play("libero", "idle", seed=5, half_seconds=20, record=True)


@pytest.fixture(scope="session")
def recording(short_match: MatchResult) -> Recording:
    """Its recording."""
    assert short_match.recording is not None
    return short_match.recording


@pytest.fixture(scope="session")
def program() -> str:
    """The program of the package. A build of the module alone has none."""
    if not fulbito.program_path().is_file():
        pytest.skip("the program is not built")
    return str(fulbito.program_path())


@pytest.fixture(scope="session")
def examples() -> Path:
    """The folder of the examples."""
    return Path(__file__).resolve().parents[2] / "examples"
