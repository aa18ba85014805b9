"""Navigation trials as tasks of one agent: fulbito/Navigate-v0. docs/environments.md has its tables."""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from gymnasium.vector import AutoresetMode

from fulbito import _core
from fulbito.envs.base import EpisodeEnv
from fulbito.envs.drill import ObservedNumber
from fulbito.envs.vector import EpisodeVectorEnv

__all__ = ["NavigateEnv", "NavigateSettings", "NavigateVectorEnv", "OUTCOMES"]

OUTCOMES: tuple[str, ...] = tuple(_core.trial_outcomes())
"""Names of a trial's outcomes, by the number that info["outcome"] has."""


@dataclass(frozen=True, kw_only=True)
class NavigateSettings:
    """All settings of an environment of navigation. Wrong values raise UsageError when the environment is made."""

    suite: str = "corner"
    """Name of a suite of layouts; see `fulbito.suites()`."""
    layout: "str | os.PathLike[str]" = ""
    """A layout file: the same in all episodes, instead of the suite's."""
    speed: float = 1.0
    """[m/s] Top speed of the robot, 0.05 ... 10."""
    action: Literal["wheels", "twist", "heading"] = "wheels"
    """What the agent's action is. "heading": a direction seen from that of the goal, over pi, and the speed from -1 (none)
    to 1 (the top speed); the follower of the built-in navigators drives it."""
    frame_skip: int = 1
    """Ticks per step, 1 ... 60; the action holds meanwhile."""
    split: Literal["train", "test"] = "train"
    """Layouts to train on, or others that are never trained on, as `fulbito compare` has them."""
    heading: Literal["layout", "random", "away"] = "layout"
    """The robot's heading at the start: the layout's, any, or away from the goal."""
    ends_at_contact: bool = False
    """A forbidden contact ends the episode; else it only fails it, as in `fulbito compare`."""
    rewards: Mapping[str, float] = field(default_factory=dict[str, float])
    """Weights of the terms "success", "failure", "time", "goal", "contact", "clearance" and "effort"; missing ones
    keep their defaults."""
    robot_model: str = "jung-lee-2015"
    """Preset or file of the robot."""
    physics: str = "standard"
    """Preset or file of the physics."""
    latency_ticks: int = 0
    """Age of what the agent sees, 0 ... 60 ticks."""
    position_noise: float = 0.0
    """[m] Standard deviation of each coordinate, 0 ... 0.1; that of headings follows, as in `fulbito compare`."""
    dropout: float = 0.0
    """Probability per tick that a body is not seen, 0 ... 0.99."""

    def source(self) -> _core.Source:
        """A new source of such episodes."""
        values = {name: getattr(self, name) for name in self.__dataclass_fields__}
        values["layout"] = os.fspath(self.layout)
        values["rewards"] = dict(self.rewards)
        return _core.navigation_source(**values)


class NavigateEnv(EpisodeEnv):
    """fulbito/Navigate-v0: a robot drives to a goal among obstacles, scored as in `fulbito compare`.

    Observations: float32 of shape (77,), see `observation_table`. Actions: float32 of shape (2,). `info` has the terms
    of the reward, and "success", "outcome" (see OUTCOMES), "time" [s], "time_ratio" (T/T*), "length" [m],
    "length_ratio" (L/L*), "contacts", "clearance" [m] and "layout". reset(options={"start": "layout 7 of seed 3"})
    plays that layout of `fulbito compare`; without a seed it is one of the program's default. {"start": "layout
    fig4-wall"} plays one with a name.
    """

    def __init__(self, *, render_mode: str | None = None, render_width: int = 600, **settings: Any) -> None:
        """Args: see NavigateSettings and EpisodeEnv."""
        self.settings = NavigateSettings(**settings)
        super().__init__(self.settings.source, render_mode=render_mode, render_width=render_width)

    @staticmethod
    def observation_table() -> list[ObservedNumber]:
        """The numbers of an observation, in their order."""
        return [ObservedNumber(*row) for row in _core.navigation_sight()]


class NavigateVectorEnv(EpisodeVectorEnv):
    """Many of fulbito/Navigate-v0 over threads."""

    def __init__(self, num_envs: int = 1, *, threads: int = 0,
                 autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP, states: bool = False,
                 render_mode: str | None = None, render_width: int = 600, **settings: Any) -> None:
        """Args: see NavigateSettings and EpisodeVectorEnv."""
        self.settings = NavigateSettings(**settings)
        super().__init__(self.settings.source, num_envs, threads=threads, autoreset_mode=autoreset_mode, states=states,
                         render_mode=render_mode, render_width=render_width)
