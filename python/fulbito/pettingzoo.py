"""PettingZoo environments: each robot of both teams is an agent, for self-play.

    from fulbito.pettingzoo import vss_3v3_v0
    env = vss_3v3_v0.parallel_env()      # or vss_3v3_v0.env() for the AEC interface
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray
from pettingzoo import AECEnv, ParallelEnv
from pettingzoo.utils import OrderEnforcingWrapper, parallel_to_aec

from fulbito import _core
from fulbito.envs.base import EpisodeState, action_space_of, checked_actions, observation_space_of, seed_of, start_of
from fulbito.envs.settings import MatchSettings
from fulbito.errors import StateError, UsageError

__all__ = ["MatchParallelEnv", "vss_3v3_v0", "vss_5v5_v0"]

Observation = NDArray[np.float32]
_TEAMS = ("blue", "yellow")


class MatchParallelEnv(ParallelEnv[str, Observation, Any]):  # type: ignore[misc]
    """A match whose agents are robots: blue_0 ... and yellow_0 .... Each sees and acts in the frame of its own team,
    which attacks toward +x, so that one policy can play for all. All agents stay to the end of the episode."""

    def __init__(self, name: str, settings: MatchSettings, *, render_mode: str | None = None,
                 render_width: int = 600) -> None:
        """
        Args:
            name: for `metadata`.
            settings: of the match; `blue_agents` and `yellow_agents` become agents.
            render_mode: None or "rgb_array".
            render_width: width of pictures [px].
        """
        if render_mode not in (None, "rgb_array"):
            raise UsageError(f"render_mode: {render_mode!r} is none of None, 'rgb_array'")
        self.metadata = {"name": name, "render_modes": ["rgb_array"], "is_parallelizable": True, "render_fps": 60}
        self.render_mode = render_mode
        self.render_width = render_width
        self._settings = settings
        source = settings.source()
        shape = source.shape
        self.possible_agents = [f"{team}_{number}" for team, numbers in
                                zip(_TEAMS, (settings.blue_agents, settings.yellow_agents)) for number in sorted(numbers)]
        self.agents: list[str] = []
        agents = len(self.possible_agents)
        self._observations = np.zeros((agents, shape["observation"]), np.float32)
        terms = len(shape["terms"])
        self._numbers = np.zeros(agents * (1 + terms) + len(shape["figures"]))
        self._rewards = self._numbers[:agents]
        self._terms = self._numbers[agents:agents * (1 + terms)].reshape(agents, terms)
        self._figures = self._numbers[agents * (1 + terms):]
        self._term_names = [f"reward_{term}" for term in shape["terms"]]
        self._figure_names: list[str] = shape["figures"]
        self._spaces = {agent: (observation_space_of(shape), action_space_of(shape)) for agent in self.possible_agents}
        self._width: tuple[int, ...] = () if shape["choices"] else (shape["action"],)
        self._actions = np.zeros((agents, *self._width), np.float32)
        bound = np.float32(shape["bound"])
        self.state_space = spaces.Box(-bound, bound, (shape["state"],), np.float32)
        self._random = np.random.default_rng()
        self._seeded = False
        self._core = _core.Environment(source, self._observations.reshape(-1), self._numbers)

    def observation_space(self, agent: str) -> spaces.Space[Any]:
        """The space of an agent's observations: the same object each time."""
        return self._spaces[agent][0]

    def action_space(self, agent: str) -> spaces.Space[Any]:
        """The space of an agent's actions: the same object each time."""
        return self._spaces[agent][1]

    def reset(self, seed: int | None = None,
              options: dict[str, Any] | None = None) -> tuple[dict[str, Observation], dict[str, dict[str, Any]]]:
        """Begins an episode, as EpisodeEnv.reset. Returns observations and infos by agent."""
        start = start_of(options)
        if seed is not None:
            self._core.seed(seed_of(seed))
        elif not self._seeded:
            self._core.seed(int(self._random.integers(2**63)))
        self._seeded = True
        self._core.reset(start)
        self.agents = list(self.possible_agents)
        return self._seen(), self._infos()

    def step(self, actions: dict[str, Any]) -> tuple[
            dict[str, Observation], dict[str, float], dict[str, bool], dict[str, bool], dict[str, dict[str, Any]]]:
        """Plays one step. `actions` has one action for each agent; UsageError if one is missing or has another shape or
        dtype. Returns observations, rewards, terminations, truncations and infos by agent."""
        if not self.agents:
            raise StateError("there is no agent: call reset before the next step")
        for i, agent in enumerate(self.agents):
            if agent not in actions:
                raise UsageError(f"actions: there is none for {agent}")
            self._actions[i] = checked_actions(actions[agent], self._width)
        unknown = set(actions) - set(self.agents)
        if unknown:
            raise UsageError(f"actions: there is no agent {sorted(map(str, unknown))[0]}")
        end = self._core.step(self._actions.reshape(-1))
        agents = self.agents
        if end:
            self.agents = []
        return (self._seen(), dict(zip(agents, self._rewards.tolist())), dict.fromkeys(agents, end == 1),
                dict.fromkeys(agents, end == 2), self._infos())

    def _seen(self) -> dict[str, Observation]:
        return dict(zip(self.possible_agents, self._observations.copy()))

    def _infos(self) -> dict[str, dict[str, Any]]:
        figures = dict(zip(self._figure_names, self._figures.tolist()))
        return {agent: {**dict(zip(self._term_names, terms)), **figures}
                for agent, terms in zip(self.possible_agents, self._terms.tolist())}

    def state(self) -> Observation:
        """The whole world for a critic, float32 as `state_space`, in blue's frame and without errors."""
        out = np.zeros(self.state_space.shape, np.float32)
        self._core.world(out)
        return out

    def get_state(self) -> EpisodeState:
        """As EpisodeEnv.get_state."""
        return EpisodeState(*self._core.state())

    def set_state(self, state: EpisodeState) -> tuple[dict[str, Observation], dict[str, dict[str, Any]]]:
        """As EpisodeEnv.set_state."""
        end = self._core.restore(state.as_tuple())
        self._seeded = True
        self.agents = [] if end or state.start_seed is None else list(self.possible_agents)
        return self._seen(), self._infos()

    def record(self, file: str) -> None:
        """Records the next episode into a .fbr file."""
        self._core.record(str(file))

    def render(self) -> NDArray[np.uint8] | None:
        """A picture, uint8 of shape (height, width, 3); None without a render_mode."""
        if self.render_mode is None:
            return None
        picture: NDArray[np.uint8] = self._core.picture(self.render_width)
        return picture

    def close(self) -> None:
        """Ends the episode, and its recording. May be called twice."""
        self._core.close()

    def __getstate__(self) -> dict[str, Any]:
        kept = {name: value for name, value in self.__dict__.items()
                if name not in ("_core", "_rewards", "_terms", "_figures")}
        return {**kept, "_kept_state": self.get_state()}

    def __setstate__(self, kept: dict[str, Any]) -> None:
        state = kept.pop("_kept_state")
        self.__dict__.update(kept)
        agents, terms = len(self.possible_agents), len(self._term_names)
        self._rewards = self._numbers[:agents]
        self._terms = self._numbers[agents:agents * (1 + terms)].reshape(agents, terms)
        self._figures = self._numbers[agents * (1 + terms):]
        self._core = _core.Environment(self._settings.source(), self._observations.reshape(-1), self._numbers)
        self._core.restore(state.as_tuple())


class _Game:
    """One id of PettingZoo, used as its modules are: `vss_3v3_v0.parallel_env()`."""

    def __init__(self, name: str, rules: str, size: int) -> None:
        self._name, self._rules, self._size = name, rules, size

    def parallel_env(self, *, blue_agents: Sequence[int] | None = None, yellow_agents: Sequence[int] | None = None,
                     render_mode: str | None = None, render_width: int = 600, **settings: Any) -> MatchParallelEnv:
        """The parallel environment.

        Args:
            blue_agents, yellow_agents: numbers of the robots that are agents; None: all. Others play as `blue` and
                `yellow` say.
            settings: the others of fulbito.envs.MatchSettings.
        """
        everyone = range(self._size)
        made = MatchSettings(rules=self._rules, blue_agents=tuple(everyone if blue_agents is None else blue_agents),
                             yellow_agents=tuple(everyone if yellow_agents is None else yellow_agents), **settings)
        return MatchParallelEnv(self._name, made, render_mode=render_mode, render_width=render_width)

    def env(self, **settings: Any) -> AECEnv[str, Observation, Any]:
        """The same with PettingZoo's AEC interface; arguments as `parallel_env`."""
        return OrderEnforcingWrapper(parallel_to_aec(self.parallel_env(**settings)))


vss_3v3_v0 = _Game("vss_3v3_v0", "vsss-3v3", 3)
"""The game with three robots per team."""
vss_5v5_v0 = _Game("vss_5v5_v0", "vsss-5v5", 5)
"""The game with five robots per team."""
