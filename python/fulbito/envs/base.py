"""The Gymnasium environment of one agent over a source of episodes."""

import copy
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from fulbito import _core
from fulbito.errors import UsageError

__all__ = ["EpisodeEnv", "EpisodeState", "Others", "Policy", "action_space_of", "checked_actions",
           "observation_space_of"]

Info = dict[str, Any]
Policy = Callable[[NDArray[np.float32]], Any]
"""What drives agents beside the caller: takes observations, float32 of shape (agents, numbers), and returns their
actions, (agents, numbers of an action), or (agents,) for choices. An environment pickles if its policies do."""
Others = Sequence[tuple[Sequence[int], Policy]]
"""Numbers of agents of a source, and what drives them."""


@dataclass(frozen=True)
class EpisodeState:
    """The state of an environment: how its episode began, and the actions since. A plain value that pickles."""

    seed: int
    """Seed of the environment's own stream, from which episodes get their seeds."""
    episodes: int
    """Episodes begun since that seed was set."""
    start_seed: int | None
    """Seed of the present episode; None before the first one."""
    start: str
    """What reset(options={"start": ...}) was given."""
    actions: bytes
    """The actions of the present episode: float32, steps x agents x numbers."""

    def as_tuple(self) -> tuple[int, int, int | None, str, bytes]:
        """The same as a tuple."""
        return (self.seed, self.episodes, self.start_seed, self.start, self.actions)


def observation_space_of(shape: dict[str, Any]) -> spaces.Box:
    """The space of one agent's observations."""
    bound = np.float32(shape["bound"])
    return spaces.Box(-bound, bound, (shape["observation"],), np.float32)


def action_space_of(shape: dict[str, Any]) -> spaces.Space[Any]:
    """The space of one agent's actions."""
    if shape["choices"]:
        return spaces.Discrete(shape["choices"])
    return spaces.Box(np.float32(-1), np.float32(1), (shape["action"],), np.float32)


def checked_actions(actions: Any, shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Actions as a contiguous array of float32. Raises UsageError for another shape, or for what is no number."""
    if type(actions) is np.ndarray and actions.dtype == np.float32 and actions.shape == shape:
        return actions if actions.flags.c_contiguous else np.ascontiguousarray(actions)
    try:
        given = np.asarray(actions)
    except ValueError as error:
        raise UsageError(f"actions: {error}") from error
    if given.dtype.kind not in "fiu":
        raise UsageError(f"actions: dtype {given.dtype} is no number")
    if given.shape != shape:
        raise UsageError(f"actions: shape {given.shape} is not {shape}")
    return np.ascontiguousarray(given, np.float32)


def seed_of(seed: int) -> int:
    """A seed as the C++ side takes it: its lower 64 bits."""
    return int(seed) % 2**64


def start_of(options: dict[str, Any] | None) -> str:
    """The start of the options of reset. Raises UsageError for one that is no text."""
    start = (options or {}).get("start", "")
    if not isinstance(start, str):
        raise UsageError(f"options: start is {start!r}, not text")
    return start


class EpisodeEnv(gymnasium.Env[NDArray[np.float32], Any]):
    """One agent in episodes of a source. `step` plays in C++, without the lock of the interpreter.

    Equal seeds and actions give equal episodes, bit for bit. Without a seed, `reset` takes the next one of the
    environment's own stream. One thread at a time may use it.
    """

    metadata = {"render_modes": ["rgb_array", "human"], "render_fps": 60}

    def __init__(self, make_source: Callable[[], _core.Source], *, agent: int = 0, others: Others = (),
                 render_mode: str | None = None, render_width: int = 600) -> None:
        """
        Args:
            make_source: makes a new source of episodes; it pickles if the environment shall.
            agent: number of the agent that the caller drives.
            others: what drives the other agents of the source.
            render_mode: None, "rgb_array" (`render` returns uint8 of shape (height, width, 3)) or "human" (a window).
            render_width: width of pictures [px], 160 ... 16384.
        """
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise UsageError(f"render_mode: {render_mode!r} is none of None, 'rgb_array', 'human'")
        self.render_mode = render_mode
        self.render_width = render_width
        self._make_source = make_source
        self._agent = agent
        self._others = [(list(rows), policy) for rows, policy in others]
        source = make_source()
        shape = source.shape
        if sorted([agent, *(row for rows, _ in self._others for row in rows)]) != list(range(shape["agents"])):
            raise UsageError("each agent needs one that drives it; fulbito.pettingzoo has environments of many agents")
        self.observation_space: spaces.Space[Any] = observation_space_of(shape)
        self.action_space = action_space_of(shape)
        self._action_shape: tuple[int, ...] = () if shape["choices"] else (shape["action"],)
        self._terms = tuple(f"reward_{term}" for term in shape["terms"])
        self._figures = tuple(shape["figures"])
        self._agents: int = shape["agents"]
        self._seeded = False
        self._window: _core.Window | None = None
        self._shown_at = 0.0
        self._attach(source)

    def _attach(self, source: _core.Source) -> None:
        shape = source.shape
        self._seen = np.zeros((self._agents, shape["observation"]), np.float32)
        self._observation = self._seen[self._agent]
        self._actions = np.zeros((self._agents, *self._action_shape), np.float32)
        self._numbers = np.zeros(self._agents * (1 + len(self._terms)) + len(self._figures))
        self._core = _core.Environment(source, self._seen.reshape(-1), self._numbers)

    def reset(self, *, seed: int | None = None,
              options: dict[str, Any] | None = None) -> tuple[NDArray[np.float32], Info]:
        """Begins an episode.

        Args:
            seed: the episode becomes the first one of this seed; None: the next one of the environment's stream.
            options: {"start": text} begins where the text says.

        Returns: the first observation, float32, and info.
        """
        super().reset(seed=seed)
        start = start_of(options)
        if seed is not None:
            self._core.seed(seed_of(seed))
            self._seeded = True
        elif not self._seeded:
            self._core.seed(int(self.np_random.integers(2**63)))
            self._seeded = True
        self._core.reset(start)
        if self.render_mode == "human":
            self.render()
        return self._observation.copy(), self._info()

    def step(self, action: Any) -> tuple[NDArray[np.float32], float, bool, bool, Info]:
        """Plays one step.

        Args:
            action: as `action_space`: float32 of its shape (numbers beyond -1 ... 1 count as the nearer end), or the
                number of a choice. Raises UsageError for another shape or dtype, and for numbers that are not finite.

        Returns: observation (float32), reward, terminated, truncated, info. `info` has the terms of the reward as
        "reward_NAME", and the figures of the environment. Raises StateError before `reset`, after the end of an
        episode and after `close`.
        """
        action = checked_actions(action, self._action_shape)
        end = self._core.step(self._joined(action) if self._others else action)
        if self.render_mode == "human":
            self.render()
        return (self._observation.copy(), self._numbers.item(self._agent), end == 1, end == 2, self._info())

    def _joined(self, action: NDArray[np.float32]) -> NDArray[np.float32]:
        self._actions[self._agent] = action
        for rows, policy in self._others:
            self._actions[rows] = checked_actions(policy(self._seen[rows]), (len(rows), *self._action_shape))
        return self._actions.reshape(-1)

    def _info(self) -> Info:
        numbers = self._numbers.tolist()
        terms = self._agents + self._agent * len(self._terms)
        info = dict(zip(self._terms, numbers[terms:terms + len(self._terms)]))
        info.update(zip(self._figures, numbers[len(numbers) - len(self._figures):]))
        return info

    def render(self) -> NDArray[np.uint8] | None:
        """With "rgb_array" a picture of the present moment, uint8 of shape (height, width, 3). With "human" the window
        shows it, at most 60 times per second; FileError if there is no screen."""
        if self.render_mode is None:
            gymnasium.logger.warn("render() without a render_mode: pass one to make()")
            return None
        picture: NDArray[np.uint8] = self._core.picture(self.render_width)
        if self.render_mode == "rgb_array":
            return picture
        if self._window is None:
            self._window = _core.Window("fulbito")
        self._window.show(picture)
        time.sleep(max(0.0, self._shown_at + 1 / self.metadata["render_fps"] - time.monotonic()))
        self._shown_at = time.monotonic()
        return None

    def get_state(self) -> EpisodeState:
        """The state as a value: an environment of the same settings plays on from it as this one would. It costs
        nothing, since the environment keeps the actions of its episode."""
        return EpisodeState(*self._core.state())

    def set_state(self, state: EpisodeState) -> tuple[NDArray[np.float32], Info]:
        """Plays the episode of `state` again up to its last action, which takes as long as these steps took.

        Returns: the observation and the info of that moment. Raises UsageError for a state of other settings.
        """
        self._core.restore(state.as_tuple())
        self._seeded = True
        return self._observation.copy(), self._info()

    def copy(self) -> "EpisodeEnv":
        """A new environment in the same state."""
        return copy.deepcopy(self)

    def record(self, file: str) -> None:
        """Records the next episode into a .fbr file; see fulbito.wrappers.RecordMatch."""
        self._core.record(str(file))

    def close(self) -> None:
        """Ends the episode, and its recording. May be called twice."""
        self._window = None
        self._core.close()

    def __getstate__(self) -> dict[str, Any]:
        made = ("_core", "_seen", "_observation", "_actions", "_numbers")
        kept = {name: value for name, value in self.__dict__.items() if name not in made}
        return {**kept, "_window": None, "_state": self.get_state()}

    def __setstate__(self, kept: dict[str, Any]) -> None:
        state = kept.pop("_state")
        self.__dict__.update(kept)
        self._attach(self._make_source())
        self._core.restore(state.as_tuple())
