"""Gymnasium environments. Importing this module registers their ids; docs/environments.md describes them."""

import gymnasium

from fulbito.envs.base import EpisodeEnv, EpisodeState
from fulbito.envs.drill import DrillCurriculum, DrillEnv, DrillSettings, DrillVectorEnv, drills
from fulbito.envs.navigate import NavigateEnv, NavigateSettings, NavigateVectorEnv
from fulbito.envs.settings import MatchSettings
from fulbito.envs.vector import EpisodeVectorEnv

__all__ = ["DrillCurriculum", "DrillEnv", "DrillSettings", "DrillVectorEnv", "EpisodeEnv", "EpisodeState",
           "EpisodeVectorEnv", "MatchSettings", "NavigateEnv", "NavigateSettings", "NavigateVectorEnv", "drills",
           "register"]

_CLASSES = {"fulbito/VSS-v0": "vss:VSS", "fulbito/VSSCompat-v0": "vss:VSSCompat", "fulbito/Drill-v0": "drill:Drill",
            "fulbito/Navigate-v0": "navigate:Navigate"}


def register() -> None:
    """Registers the ids with Gymnasium, those that are not yet known."""
    for name, place in _CLASSES.items():
        if name not in gymnasium.registry:
            gymnasium.register(name, f"fulbito.envs.{place}Env", vector_entry_point=f"fulbito.envs.{place}VectorEnv")


register()
