"""Comparisons of navigators: `fulbito.compare("corner", ["bezier", MyNavigator])`."""

import csv
import io
import json
import os
from dataclasses import dataclass
from typing import Any, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from fulbito import _core
from fulbito._progress import Bar
from fulbito.errors import UsageError
from fulbito.navigation import Navigator

__all__ = ["Comparison", "NavigatorLike", "Trace", "compare"]

#: A specification, or a class of this process.
NavigatorLike = Union[str, type[Navigator]]


@dataclass(frozen=True)
class Trace:
    """One trial, tick by tick."""

    suite: str
    """Name of the suite."""
    speed: float
    """[m/s] top speed."""
    navigator: str
    """Its specification."""
    index: int
    """Number of the layout."""
    time: npt.NDArray[np.float64]
    """(n,) [s]"""
    pose: npt.NDArray[np.float64]
    """(n, 3) x [m], y [m], heading [rad]."""
    velocity: npt.NDArray[np.float64]
    """(n, 3) along x and y [m/s], yaw rate [rad/s]."""
    wheels: npt.NDArray[np.float64]
    """(n, 2) [rad/s] as they turn."""
    commands: npt.NDArray[np.float64]
    """(n, 2) [rad/s] as commanded."""


class Comparison:
    """The results of a comparison."""

    def __init__(self, core: _core.FinishedComparison) -> None:
        """`compare` makes it."""
        self._core = core
        self.data: dict[str, Any] = json.loads(core.json())
        """All results, as `fulbito compare --json` prints them (docs/results-format.md)."""

    @property
    def rows(self) -> list[dict[str, Any]]:
        """One row per suite, speed and navigator: success, time_ratio (T/T*), length_ratio (L/L*) and more."""
        rows: list[dict[str, Any]] = self.data["summary"]
        return rows

    def row(self, navigator: str, *, speed: Optional[float] = None) -> dict[str, Any]:
        """The first row of a navigator, at a top speed [m/s] if given. Raises UsageError if there is none."""
        for row in self.rows:
            if row["navigator"] == navigator and (speed is None or row["speed"] == speed):
                return row
        raise UsageError(f"there is no row of '{navigator}': " + ", ".join({row["navigator"] for row in self.rows}))

    def trials(self) -> list[dict[str, str]]:
        """One entry per trial, with the columns of trials.csv (docs/results-format.md)."""
        return list(csv.DictReader(io.StringIO(self._core.csv())))

    def traces(self) -> list[Trace]:
        """The trials of the first layouts of each block, tick by tick."""
        return [Trace(suite, speed, navigator, index, rows[:, 0], rows[:, 1:4], rows[:, 4:7], rows[:, 7:9], rows[:, 9:])
                for suite, speed, navigator, index, rows in self._core.traces()]

    def markdown(self) -> str:
        """Tables for people."""
        return self._core.markdown()

    def __str__(self) -> str:
        return self.markdown()

    def _repr_markdown_(self) -> str:
        return self.markdown()


def _own(navigator: object) -> tuple[object, str, bool]:
    if not isinstance(navigator, type) or not callable(getattr(navigator, "plan", None)):
        raise UsageError(f"a navigator is a specification or a class with `reset` and `plan`, not {navigator!r}")
    name = str(getattr(navigator, "name", "") or navigator.__name__)
    return navigator, name, bool(getattr(navigator, "plans_speed", False))


def compare(suite: str = "jung-lee-2015", navigators: Sequence[NavigatorLike] = (), *, speeds: Sequence[float] = (),
            trials: Optional[int] = None, seed: int = 2015, only: Optional[int] = None,
            jobs: Optional[int] = None, robot: Union[str, "os.PathLike[str]"] = "jung-lee-2015",
            physics: Union[str, "os.PathLike[str]"] = "standard", latency: int = 0, noise: float = 0.0,
            dropout: float = 0.0, traces: int = 8, progress: bool = False) -> Comparison:
    """Runs navigators on the layouts of a suite, as `fulbito compare` does.

    Args:
        suite: name of the suite, see `fulbito.suites()`.
        navigators: specifications such as "bezier:clearance=0.02", and classes like `fulbito.navigation.Navigator`.
            None: the suite's. Classes come last in the tables.
        speeds: [m/s] top speeds; none: the suite's.
        trials: layouts per block; None: the suite's.
        seed: of the layouts, 0 ... 2**64 - 1.
        only: only this layout of each block.
        jobs: worker threads; None: all cores, or one with classes, since threads that call Python wait for each other.
        robot: preset or TOML file.
        physics: profile or TOML file.
        latency: [ticks] age of observations, 0 ... 60.
        noise: [m] standard deviation of observed positions, 0 ... 0.1.
        dropout: probability per tick that a body is not seen, 0 ... 0.99.
        traces: layouts per block whose trials are kept tick by tick.
        progress: show a bar (needs tqdm).

    Raises:
        UsageError, InputError, FileError: a name, file or value is wrong; the text names it.
        TeamError: a navigator of this process raised an exception, which is the cause.
        KeyboardInterrupt: after Ctrl-C.
    """
    if isinstance(navigators, str):
        raise UsageError(f"navigators: a list, not the text {navigators!r}")
    config = _core.ComparisonConfig()
    config.suite, config.robot, config.physics = suite, os.fspath(robot), os.fspath(physics)
    config.navigators = [entry for entry in navigators if isinstance(entry, str)]
    own = [_own(entry) for entry in navigators if not isinstance(entry, str)]
    for name, value, least in (("seed", seed, 0), ("trials", trials, 1), ("only", only, 0), ("jobs", jobs, 1),
                               ("traces", traces, 0)):
        if value is not None and not least <= value < 2**31 and not (name in ("seed", "only") and 0 <= value < 2**64):
            raise UsageError(f"{name} = {value} is below {least} or too large")
    config.speeds, config.trials, config.seed = list(speeds), trials or 0, seed
    config.only, config.jobs, config.traces = only, jobs or (1 if own else 0), traces
    config.sensors = (latency, noise, dropout)
    with Bar(progress, f"compare {suite}", "trial") as bar:
        return Comparison(_core.compare(config, own, bar.work if progress else None))
