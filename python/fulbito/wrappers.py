"""Wrappers of Gymnasium environments."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import gymnasium
from gymnasium.utils import RecordConstructorArgs

from fulbito.errors import UsageError

__all__ = ["RecordMatch"]


class RecordMatch(gymnasium.Wrapper[Any, Any, Any, Any], RecordConstructorArgs):
    """Writes recordings of chosen episodes: `folder/PREFIX-NUMBER.fbr`, which `fulbito replay` and fulbito.Recording
    read. A file is complete when its episode ends, or when the environment is reset or closed."""

    def __init__(self, env: gymnasium.Env[Any, Any], folder: str | Path, *,
                 episodes: Callable[[int], bool] = lambda number: True, prefix: str = "episode") -> None:
        """
        Args:
            env: an environment of this package.
            folder: made if it does not exist.
            episodes: whether to record the episode of this number, counted from 0 by calls of `reset`.
            prefix: of the names of files.
        """
        RecordConstructorArgs.__init__(self, folder=folder, episodes=episodes, prefix=prefix)
        gymnasium.Wrapper.__init__(self, env)
        if not hasattr(env.unwrapped, "record"):
            raise UsageError(f"RecordMatch: {env} has no recordings")
        self._folder = Path(folder)
        self._folder.mkdir(parents=True, exist_ok=True)
        self._episodes = episodes
        self._prefix = prefix
        self._number = 0
        self.files: list[Path] = []
        """Files so far, in order."""

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        """As the environment's; records the new episode if it is chosen."""
        if self._episodes(self._number):
            file = self._folder / f"{self._prefix}-{self._number}.fbr"
            self.env.unwrapped.record(str(file))  # type: ignore[attr-defined]
            self.files.append(file)
        self._number += 1
        return super().reset(seed=seed, options=options)
