"""Many environments over C++ threads, as Gymnasium's VectorEnv."""

from collections.abc import Callable, Sequence
from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from fulbito import _core
from fulbito.envs.base import (EpisodeState, Others, action_space_of, checked_actions, observation_space_of, seed_of, start_of)
from fulbito.errors import UsageError

__all__ = ["EpisodeVectorEnv"]

Info = dict[str, Any]
Step = tuple[NDArray[np.float32], NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], Info]
_MODES = [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP, AutoresetMode.DISABLED]


class _Rows:
    """The arrays of one set of rows, and the views of them that a step returns: of all agents, or of one of each
    environment."""

    def __init__(self, envs: int, shape: dict[str, Any], agent: int | None) -> None:
        agents: int = shape["agents"]
        count = envs * agents
        terms: list[str] = shape["terms"]
        self.names: list[str] = shape["figures"]
        self.observations = np.zeros((count, shape["observation"]), np.float32)
        self.rewards = np.zeros(count)
        self.terminated = np.zeros(count, np.bool_)
        self.truncated = np.zeros(count, np.bool_)
        self.terms = np.zeros((count, len(terms)))
        self.figures = np.zeros((envs, len(self.names)))
        self.shown = slice(None) if agent is None else slice(agent, None, agents)
        self.out = (self.observations[self.shown], self.rewards[self.shown], self.terminated[self.shown],
                    self.truncated[self.shown])
        self._repeats = agents if agent is None else 1
        there = np.ones(len(self.out[1]), np.bool_)
        self.info: Info = {}
        for i, name in enumerate(terms):
            self.info[f"reward_{name}"] = self.terms[self.shown, i]
            self.info[f"_reward_{name}"] = there
        for i, name in enumerate(self.names):
            self.info[name] = self.figures[:, i]
            self.info[f"_{name}"] = there

    def arrays(self) -> list[Any]:
        """All arrays, as the C++ side takes them."""
        return [self.observations, self.rewards, self.terminated, self.truncated, self.terms, self.figures]

    def told(self) -> Info:
        """A new dict with views of the arrays."""
        info = dict(self.info)
        if self._repeats > 1:
            for name in self.names:
                info[name] = np.repeat(info[name], self._repeats)
        return info


class EpisodeVectorEnv(VectorEnv[NDArray[np.float32], Any, Any]):
    """Environments that C++ threads step. What it returns are views of two sets of arrays in turn: it stays as it is
    until the call after the next one. Results never depend on the number of threads.

    Environment i with seed s plays what the single environment plays with seed s + i. If the source has several
    agents, each of them counts as an environment: `num_envs` is environments x agents.
    """

    def __init__(self, make_source: Callable[[], _core.Source], num_envs: int = 1, *, agent: int | None = None,
                 others: Others = (), threads: int = 0,
                 autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP, states: bool = False,
                 render_mode: str | None = None, render_width: int = 600) -> None:
        """
        Args:
            make_source: makes a new source of episodes.
            num_envs: environments, 1 ... 1,048,575.
            agent: number of the agent of each environment that the caller drives; None: all agents.
            others: what drives the other agents.
            threads: C++ threads, the caller's included; 0: one per core.
            autoreset_mode: what happens when an episode ends, as Gymnasium defines it.
            states: keeps the actions of the present episodes, for `get_states`.
            render_mode: None or "rgb_array".
            render_width: width of pictures [px].
        """
        try:
            self._mode = AutoresetMode(autoreset_mode)
        except ValueError as error:
            raise UsageError(f"autoreset_mode: {error}") from error
        if render_mode not in (None, "rgb_array"):
            raise UsageError(f"render_mode: {render_mode!r} is none of None, 'rgb_array'")
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": 60, "autoreset_mode": self._mode}
        self.render_mode = render_mode
        self.render_width = render_width
        self._envs = num_envs
        self._keeps_states = states
        sources = [make_source() for _ in range(num_envs)]
        self._core = _core.Vector(sources, threads, _MODES.index(self._mode), states)
        shape = self._core.shape
        self._agents: int = shape["agents"]
        self._agent = agent
        driven = [] if agent is None else [agent, *(row for rows, _ in others for row in rows)]
        if agent is not None and sorted(driven) != list(range(self._agents)):
            raise UsageError("each agent needs one that drives it")
        first = np.arange(num_envs)[:, None] * self._agents
        self._others = [((first + np.asarray(rows)).reshape(-1), policy) for rows, policy in others]
        self._each = self._agents if agent is None else 1
        self.num_envs = num_envs * self._each
        self.single_observation_space = observation_space_of(shape)
        self.single_action_space = action_space_of(shape)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self._width: tuple[int, ...] = () if shape["choices"] else (shape["action"],)
        self._action_shape = (self.num_envs, *self._width)
        self._joint = np.zeros((num_envs * self._agents, *self._width), np.float32)
        self._all = [_Rows(num_envs, shape, agent) for _ in range(2)]
        self._some = [_Rows(num_envs, shape, agent) for _ in range(2)]
        self._last = _Rows(num_envs, shape, agent)
        self._now = self._all[0]
        self._ended = np.zeros(num_envs, np.bool_)
        arrays = [array for rows in (*self._all, *self._some) for array in rows.arrays()]
        self._core.use([*arrays, self._last.observations, self._last.figures, self._ended])
        self._seeded = False
        self._sent: NDArray[np.uint32] | None = None
        self._everyone = np.zeros(0, np.uint32)

    @property
    def threads(self) -> int:
        """Threads that step, the caller's included."""
        return self._core.threads

    def reset(self, *, seed: int | Sequence[int | None] | None = None,
              options: dict[str, Any] | None = None) -> tuple[NDArray[np.float32], Info]:
        """Begins episodes.

        Args:
            seed: s gives environment i the seed s + i; a sequence has one per environment.
            options: {"reset_mask": bool array of shape (environments,)} begins those only; the rows of the others stay.
                {"start": text} begins where the text says.
        """
        super().reset(seed=seed if isinstance(seed, int) else None)
        start = start_of(options)
        mask = np.asarray((options or {}).get("reset_mask", np.zeros(0, np.bool_)))
        if mask.dtype != np.bool_ or mask.ndim != 1:
            raise UsageError(f"reset_mask: {mask.dtype} of shape {mask.shape} is no array of bool")
        self._seed(seed)
        self._now = self._all[self._core.reset(np.ascontiguousarray(mask), start)]
        return self._now.out[0], self._now.told()

    def _seed(self, seed: int | Sequence[int | None] | None) -> None:
        if seed is None:
            if self._seeded:
                return
            seed = int(self.np_random.integers(2**62))
        seeds = [seed + i for i in range(self._envs)] if isinstance(seed, (int, np.integer)) else list(seed)
        if len(seeds) != self._envs:
            raise UsageError(f"seed: {len(seeds)} seeds for {self._envs} environments")
        for i, each in enumerate(seeds):
            if each is not None:
                self._core.seed(i, seed_of(each))
        self._seeded = True

    def step(self, actions: Any) -> Step:
        """Plays one step of all environments.

        Args:
            actions: as `action_space`: float32 of shape (num_envs, numbers), or choices of shape (num_envs,). Raises
                UsageError for another shape or dtype, and for numbers that are not finite.

        Returns: observations (float32), rewards (float64), terminations, truncations (bool) and infos. Terms of the
        reward are "reward_NAME" of infos. With SAME_STEP, "final_obs" and "final_info" have the rows of "_final_obs".
        """
        return self._told(self._all[self._core.step(self._joined(actions))])

    def _joined(self, actions: Any) -> NDArray[np.float32]:
        given = checked_actions(actions, self._action_shape)
        if self._agent is None or self._agents == 1:
            return given
        self._joint[self._agent::self._agents] = given
        for rows, policy in self._others:
            self._joint[rows] = checked_actions(policy(self._now.observations[rows]), (len(rows), *self._width))
        return self._joint

    def _told(self, rows: _Rows) -> Step:
        self._now = rows
        info = rows.told()
        if self._mode is AutoresetMode.SAME_STEP and self._ended.any():
            self._add_final(info)
        return (*rows.out, info)

    def _add_final(self, info: Info) -> None:
        ended = np.repeat(self._ended, self._each)
        final: Info = {name: self._last.info[name].copy() for name in self._last.names}
        final |= {name: value for name, value in info.items() if name.startswith("reward_")}
        info |= {"final_obs": self._last.out[0].copy(), "_final_obs": ended, "final_info": final,
                 "_final_info": ended}

    def send(self, actions: Any, env_ids: Any = None) -> None:
        """Begins a step and returns at once; `recv` waits for it.

        Args:
            actions: as `step`; with `env_ids`, those of these environments only, in their order.
            env_ids: distinct numbers of environments; None: all.
        """
        if env_ids is None:
            self._core.send(self._joined(actions), self._everyone)
            self._sent = None
            return
        if self._others:
            raise UsageError("env_ids: a vector with policies steps all of its environments")
        ids = np.asarray(env_ids)
        if ids.dtype.kind not in "iu" or ids.ndim != 1 or ids.size == 0 or ids.min() < 0:
            raise UsageError(f"env_ids: {env_ids!r} are no numbers of environments")
        ids = np.ascontiguousarray(ids, np.uint32)
        self._core.send(checked_actions(actions, (ids.size * self._agents, *self._width)), ids)
        self._sent = ids

    def recv(self) -> Step:
        """Waits for the step that `send` began and returns what `step` would. After a `send` with `env_ids` the rows
        are those of these environments in that order, and infos has them as "env_id"."""
        row = self._core.receive()
        if self._sent is None:
            return self._told(self._all[row])
        rows, count = self._some[row], self._sent.size * self._each
        info = {name: value[:count] for name, value in rows.told().items()} | {"env_id": self._sent}
        seen, rewards, terminated, truncated = rows.out
        return seen[:count], rewards[:count], terminated[:count], truncated[:count], info

    def get_states(self) -> list[EpisodeState]:
        """The states of all environments, if the vector was made with `states`."""
        if not self._keeps_states:
            raise UsageError("states: make the vector with states=True to have them")
        return [EpisodeState(*state) for state in self._core.states()]

    def set_states(self, states: Sequence[EpisodeState]) -> None:
        """Plays the episodes of these states again; see EpisodeEnv.set_state. The next step goes on from there."""
        if len(states) != self._envs:
            raise UsageError(f"states: {len(states)} states for {self._envs} environments")
        for i, state in enumerate(states):
            self._core.restore(i, state.as_tuple())
        self._seeded = True

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """A picture of each environment, uint8 of shape (height, width, 3)."""
        if self.render_mode is None:
            gymnasium.logger.warn("render() without a render_mode: pass one to make_vec()")
            return None
        return tuple(self._core.picture(i, self.render_width) for i in range(self._envs))

    def close_extras(self, **kwargs: Any) -> None:
        """Ends the threads and the episodes."""
        self._core.close()
