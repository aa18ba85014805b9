"""Gymnasium environments. Importing this module registers their ids; docs/environments.md describes them."""

import gymnasium

from fulbito.envs.base import EpisodeEnv, EpisodeState
from fulbito.envs.settings import MatchSettings
from fulbito.envs.vector import EpisodeVectorEnv

__all__ = ["EpisodeEnv", "EpisodeState", "EpisodeVectorEnv", "MatchSettings", "register"]

_CLASSES = {"fulbito/VSS-v0": "vss:VSS", "fulbito/VSSCompat-v0": "vss:VSSCompat"}


def register() -> None:
    """Registers the ids with Gymnasium, those that are not yet known."""
    for name, place in _CLASSES.items():
        if name not in gymnasium.registry:
            gymnasium.register(name, f"fulbito.envs.{place}Env", vector_entry_point=f"fulbito.envs.{place}VectorEnv")


register()
