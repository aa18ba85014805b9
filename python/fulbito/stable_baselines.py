"""The vector environments of this package for Stable-Baselines3.

    env = StableBaselinesVector(gymnasium.make_vec("fulbito/Drill-v0", 64, drill=3, autoreset_mode="SameStep"))
    model = stable_baselines3.PPO("MlpPolicy", env)

Needs the package `stable_baselines3`.
"""

from typing import Any, Optional, Sequence, Union

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from numpy.typing import NDArray
from stable_baselines3.common.vec_env import VecEnv

from fulbito.errors import UsageError

__all__ = ["StableBaselinesVector"]


class StableBaselinesVector(VecEnv):
    """A Gymnasium vector environment in the mode SAME_STEP as one of Stable-Baselines3.

    Its `infos` have `terminal_observation`, `TimeLimit.truncated` and `episode` (r: reward, l: steps) where an episode ends,
    and `final` with the last infos of that episode; other infos are empty. Raises UsageError for another mode.
    """

    def __init__(self, envs: VectorEnv[Any, Any, Any]) -> None:
        mode = envs.metadata.get("autoreset_mode")
        if mode != AutoresetMode.SAME_STEP:
            raise UsageError(f"Stable-Baselines3 needs the autoreset mode SAME_STEP; this vector has {mode}")
        self.envs = envs  # first: the base class asks it for its render mode
        super().__init__(envs.num_envs, envs.single_observation_space, envs.single_action_space)
        self._actions: NDArray[Any] = np.zeros(0)
        self._rewards = np.zeros(envs.num_envs)
        self._lengths = np.zeros(envs.num_envs, dtype=np.int64)

    def reset(self) -> NDArray[Any]:
        """Begins new episodes; those of `seed`, if it was called before."""
        seeds: Any = [seed for seed in self._seeds if seed is not None]
        observations, _ = self.envs.reset(seed=seeds if len(seeds) == self.num_envs else None)
        self._reset_seeds()
        self._reset_options()
        self._rewards[:] = 0.0
        self._lengths[:] = 0
        return np.array(observations)

    def step_async(self, actions: NDArray[Any]) -> None:
        """Keeps the actions for `step_wait`."""
        self._actions = np.ascontiguousarray(actions)

    def step_wait(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], list[dict[str, Any]]]:
        """Plays one step of all environments."""
        observations, rewards, terminated, truncated, told = self.envs.step(self._actions)
        done = np.logical_or(terminated, truncated)
        self._rewards += rewards
        self._lengths += 1
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for i in np.flatnonzero(done):
            infos[i] = {"terminal_observation": np.array(told["final_obs"][i]),
                        "TimeLimit.truncated": bool(truncated[i] and not terminated[i]),
                        "episode": {"r": float(self._rewards[i]), "l": int(self._lengths[i]), "t": 0.0},
                        "final": {key: values[i] for key, values in told["final_info"].items() if not key.startswith("_")}}
            self._rewards[i], self._lengths[i] = 0.0, 0
        return np.array(observations), np.asarray(rewards, dtype=np.float32), done, infos

    def close(self) -> None:
        """Closes the vector."""
        self.envs.close()

    def get_attr(self, attr_name: str, indices: Union[None, int, Sequence[int]] = None) -> list[Any]:
        """The same attribute of the vector for each environment."""
        return [getattr(self.envs, attr_name, None)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name: str, value: Any, indices: Union[None, int, Sequence[int]] = None) -> None:
        """Not possible: environments of a vector have no attributes of their own."""
        raise UsageError(f"{attr_name}: environments of this vector have no attributes of their own")

    def env_method(self, method_name: str, *method_args: Any, indices: Union[None, int, Sequence[int]] = None,
                   **method_kwargs: Any) -> list[Any]:
        """Not possible: environments of a vector are no objects."""
        raise UsageError(f"{method_name}: environments of this vector are no objects")

    def env_is_wrapped(self, wrapper_class: type[gymnasium.Wrapper[Any, Any, Any, Any]],
                       indices: Union[None, int, Sequence[int]] = None) -> list[bool]:
        """Episodes are counted here, as the wrapper Monitor does; no other wrapper is there."""
        name = wrapper_class.__name__
        return [name == "Monitor"] * len(list(self._get_indices(indices)))

    def get_images(self) -> Sequence[Optional[NDArray[Any]]]:
        """No pictures: make a single environment for these."""
        return [None] * self.num_envs
