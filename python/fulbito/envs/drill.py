"""Drills as tasks of one agent: fulbito/Drill-v0. docs/environments.md has its tables."""

import os
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from gymnasium.vector import AutoresetMode

from fulbito import _core
from fulbito.envs.base import EpisodeEnv
from fulbito.envs.vector import EpisodeVectorEnv
from fulbito.errors import UsageError

__all__ = ["DrillCurriculum", "DrillEnv", "DrillInfo", "DrillSettings", "DrillVectorEnv", "ObservedNumber", "drills"]


class ObservedNumber(NamedTuple):
    """One number of an observation."""

    name: str
    """Such as "ball-x"."""
    unit: str
    """Such as "m"; empty: a share or a direction."""
    meaning: str
    """One line."""


@dataclass(frozen=True)
class DrillInfo:
    """A built-in drill."""

    number: int
    """As in `DrillSettings.drill`."""
    name: str
    """Its name in tables."""
    what: str
    """One line."""
    trials: int
    """Trials of a run of the program `fulbito drill`."""
    starts: tuple[str, ...]
    """Names of its starts, by the number that info["start"] has."""
    playable: bool
    """It consists of trials, so it is an environment."""


def drills() -> list[DrillInfo]:
    """All built-in drills, in the order of their numbers."""
    return [DrillInfo(row["number"], row["name"], row["what"], row["trials"], tuple(row["starts"]), row["playable"])
            for row in _core.drill_table()]


@dataclass(frozen=True, kw_only=True)
class DrillSettings:
    """All settings of an environment of a drill. Wrong values raise UsageError when the environment is made."""

    drill: int = 3
    """Number of a built-in drill; see `drills()`."""
    file: "str | os.PathLike[str]" = ""
    """A drill of your own (docs/drills.md), instead of `drill`."""
    action: Literal["wheels", "twist", "go-to"] = "wheels"
    """What the agent's action is. Drills that ask for a prediction have the predicted place, in either case."""
    frame_skip: int = 1
    """Ticks per step, 1 ... 60; the action holds meanwhile."""
    split: Literal["train", "test"] = "train"
    """Trials to train on, or others that are never trained on."""
    robot: int | None = None
    """Number of the agent's robot in its team; None: the drill's."""
    mates: Any = "classic"
    """Team that plays the other own robots, where there are any: a specification such as "libero", or a class of
    fulbito.team.Team, of which each trial makes one."""
    itself: Any = "classic"
    """Team that plays where a drill asks for the tested team itself, likewise."""
    rewards: Mapping[str, float] = field(default_factory=dict[str, float])
    """Weights of the terms "success", "failure", "time", "ball", "approach", "align", "answer" and "effort"; missing
    ones keep their defaults."""
    robot_model: str = "vsss"
    """Preset or file of robots and ball."""
    physics: str = "standard"
    """Preset or file of the physics."""
    navigator: str = "bspline-time"
    """Navigator of the action "go-to"."""
    randomise: Mapping[str, tuple[float, float]] = field(default_factory=dict[str, tuple[float, float]])
    """Ranges from which each episode draws numbers of the models, such as {"robot.mass": (0.12, 0.18)}: keys are
    those of robot files, in their units."""
    latency_ticks: int | None = None
    """Age of what the agent sees, 0 ... 60 ticks; None for this and the next three: as the drill has it."""
    position_noise: float | None = None
    """[m] Standard deviation of each coordinate, 0 ... 0.1."""
    heading_noise: float | None = None
    """[rad] Standard deviation of headings."""
    dropout: float | None = None
    """Probability per tick that a body is not seen, 0 ... 0.99."""

    def source(self) -> _core.Source:
        """A new source of such episodes."""
        values = {name: getattr(self, name) for name in self.__dataclass_fields__}
        values["file"] = os.fspath(self.file)
        for name in ("randomise", "rewards"):
            values[name] = dict(values[name])
        return _core.drill_source(**values)


class DrillEnv(EpisodeEnv):
    """fulbito/Drill-v0: a drill's trials as episodes, judged by the drill.

    Observations: float32 of shape (71,), see `observation_table`. Actions: float32 of shape (2,), or (3,) for
    "go-to". `info` has the terms of the reward, and "success" (1 once the drill counts it), "time" [s] since the
    signal, "ideal" [s], "counted", "start" and "trial". reset(options={"start": "trial 7 of seed 3"}) plays that trial
    of `fulbito drill`; without a seed it is one of the program's default.
    """

    def __init__(self, *, render_mode: str | None = None, render_width: int = 600, **settings: Any) -> None:
        """Args: see DrillSettings and EpisodeEnv."""
        self.settings = DrillSettings(**settings)
        super().__init__(self.settings.source, render_mode=render_mode, render_width=render_width)

    @staticmethod
    def observation_table() -> list[ObservedNumber]:
        """The numbers of an observation, in their order."""
        return [ObservedNumber(*row) for row in _core.drill_sight()]

    def starts(self) -> list[str]:
        """Names of the drill's starts, by the number that info["start"] has."""
        return list(_core.drill_starts(drill=self.settings.drill, file=os.fspath(self.settings.file)))


class DrillVectorEnv(EpisodeVectorEnv):
    """Many of fulbito/Drill-v0 over threads."""

    def __init__(self, num_envs: int = 1, *, threads: int = 0,
                 autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP, states: bool = False,
                 render_mode: str | None = None, render_width: int = 600, **settings: Any) -> None:
        """Args: see DrillSettings and EpisodeVectorEnv."""
        self.settings = DrillSettings(**settings)
        super().__init__(self.settings.source, num_envs, threads=threads, autoreset_mode=autoreset_mode, states=states,
                         render_mode=render_mode, render_width=render_width)


class DrillCurriculum:
    """Which drill to train next: the first one whose rate of success over its last episodes is below the bar.

        curriculum = DrillCurriculum([1, 3, 14])
        while (number := curriculum.drill) is not None:
            env = gymnasium.make("fulbito/Drill-v0", drill=number)
            ...  # an episode
            curriculum.add(number, bool(info["success"]))
    """

    def __init__(self, numbers: Sequence[int], *, bar: float = 0.9, window: int = 100) -> None:
        """
        Args:
            numbers: drills in the order in which they are trained.
            bar: rate of success that is enough, above 0 and at most 1.
            window: episodes over which it counts, at least 1.

        Raises UsageError for numbers that are no drills of trials, and for a bar or window out of its range.
        """
        playable = {drill.number for drill in drills() if drill.playable}
        wrong = [number for number in numbers if number not in playable]
        if wrong or not numbers:
            raise UsageError(f"drills: {wrong or 'an empty list'}; drills of trials are {sorted(playable)}")
        if not 0.0 < bar <= 1.0:
            raise UsageError(f"bar: {bar} is outside 0 ... 1")
        if window < 1:
            raise UsageError(f"window: {window} is below 1")
        self.numbers = tuple(numbers)
        self.bar = bar
        self._last: dict[int, deque[bool]] = {number: deque(maxlen=window) for number in numbers}

    def add(self, drill: int, success: bool) -> None:
        """Counts an episode. Raises UsageError for a drill that is not of this curriculum."""
        if drill not in self._last:
            raise UsageError(f"drill: {drill} is not in this curriculum: {list(self.numbers)}")
        self._last[drill].append(bool(success))

    def rate(self, drill: int) -> float:
        """Rate of success over the last episodes of a drill; 0 before the first one."""
        last = self._last.get(drill)
        if last is None:
            raise UsageError(f"drill: {drill} is not in this curriculum: {list(self.numbers)}")
        return sum(last) / len(last) if last else 0.0

    def passed(self, drill: int) -> bool:
        """Whether the rate over a whole window reaches the bar."""
        return self.rate(drill) >= self.bar and len(self._last[drill]) == self._last[drill].maxlen

    @property
    def drill(self) -> int | None:
        """The drill to train now; None: all are passed."""
        return next((number for number in self.numbers if not self.passed(number)), None)
