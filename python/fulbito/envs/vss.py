"""One robot in matches of the league: fulbito/VSS-v0 and fulbito/VSSCompat-v0."""

from typing import Any

from gymnasium.vector import AutoresetMode

from fulbito import _core
from fulbito.envs.base import EpisodeEnv
from fulbito.envs.settings import MatchSettings
from fulbito.envs.vector import EpisodeVectorEnv
from fulbito.errors import UsageError

__all__ = ["VSSCompatEnv", "VSSCompatVectorEnv", "VSSEnv", "VSSVectorEnv", "compat_settings", "vss_settings"]


def vss_settings(*, mates: Any = "random", opponents: Any = "random", robot: int = 0, **settings: Any) -> MatchSettings:
    """Settings of fulbito/VSS-v0.

    Args:
        mates: team of the other blue robots, as MatchSettings.blue; or a policy, see fulbito.envs.base.Policy, which
            drives each of them as the agent is driven.
        opponents: the same for the yellow robots, as MatchSettings.yellow.
        robot: number of the agent, in blue.
        settings: the others of MatchSettings.
    """
    size = _core.team_size(settings.get("rules", "vsss-3v3")) if _is_policy(mates) or _is_policy(opponents) else 0
    blue = range(size) if _is_policy(mates) else (robot,)
    if robot not in blue:
        raise UsageError(f"robot: there is no robot {robot}")
    return MatchSettings(blue="idle" if _is_policy(mates) else mates, blue_agents=tuple(blue),
                         yellow="idle" if _is_policy(opponents) else opponents,
                         yellow_agents=tuple(range(size)) if _is_policy(opponents) else (), **settings)


def _is_policy(team: Any) -> bool:
    return callable(team) and not isinstance(team, type) and not hasattr(team, "decide")


def _seats(settings: MatchSettings, robot: int, mates: Any, opponents: Any) -> dict[str, Any]:
    """Who drives which agent of the source."""
    blue = len(settings.blue_agents)
    others: list[tuple[list[int], Any]] = []
    if blue > 1:
        others.append(([number for number in range(blue) if number != robot], mates))
    if settings.yellow_agents:
        others.append(([blue + number for number in range(len(settings.yellow_agents))], opponents))
    return {"make_source": settings.source, "agent": robot if blue > 1 else 0, "others": others}


def _check_classes(num_envs: int, **teams: Any) -> None:
    """A team that is an object plays one match at a time."""
    for name, team in teams.items():
        if num_envs > 1 and not isinstance(team, (str, type, type(None))) and not _is_policy(team):
            raise UsageError(f"{name}: {team!r} plays one match at a time; a vector needs its class")


def _vss(settings: dict[str, Any], num_envs: int = 1) -> dict[str, Any]:
    _check_classes(num_envs, mates=settings.get("mates"), opponents=settings.get("opponents"))
    return _seats(vss_settings(**settings), settings.get("robot", 0), settings.get("mates"), settings.get("opponents"))


# A wheel of rSoccer's other robots is an Ornstein-Uhlenbeck process with theta 0.17 and sigma 0.5, in steps of 1/40 s.
_COMPAT_OTHERS = "random:memory=5.857,share=0.857"


def compat_settings(*, mates: Any = _COMPAT_OTHERS, opponents: Any = _COMPAT_OTHERS) -> MatchSettings:
    """Settings of fulbito/VSSCompat-v0: `mates` and `opponents` as for fulbito/VSS-v0."""
    return MatchSettings(blue=mates, yellow=opponents, blue_agents=(0,), only_goals=True, control_rate=40, substeps=3,
                         action="compat", observation="compat", reward="compat", start="random", end="goal",
                         time_limit=30.0)


class VSSEnv(EpisodeEnv):
    """fulbito/VSS-v0: one robot in a match, against and beside any teams."""

    def __init__(self, *, render_mode: str | None = None, render_width: int = 600, **settings: Any) -> None:
        """Args: see `vss_settings`, MatchSettings and EpisodeEnv."""
        super().__init__(**_vss(settings), render_mode=render_mode, render_width=render_width)


class VSSVectorEnv(EpisodeVectorEnv):
    """Many of fulbito/VSS-v0 over threads."""

    def __init__(self, num_envs: int = 1, *, threads: int = 0,
                 autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP, states: bool = False,
                 render_mode: str | None = None, render_width: int = 600, **settings: Any) -> None:
        """Args: see `vss_settings`, MatchSettings and EpisodeVectorEnv."""
        super().__init__(**_vss(settings, num_envs), num_envs=num_envs, threads=threads, autoreset_mode=autoreset_mode,
                         states=states, render_mode=render_mode, render_width=render_width)


class VSSCompatEnv(EpisodeEnv):
    """fulbito/VSSCompat-v0: observations, actions and rewards of rSoccer's VSS-v0."""

    def __init__(self, *, mates: Any = _COMPAT_OTHERS, opponents: Any = _COMPAT_OTHERS,
                 render_mode: str | None = None, render_width: int = 600) -> None:
        """Args: see `compat_settings` and EpisodeEnv."""
        super().__init__(compat_settings(mates=mates, opponents=opponents).source, render_mode=render_mode,
                         render_width=render_width)


class VSSCompatVectorEnv(EpisodeVectorEnv):
    """Many of fulbito/VSSCompat-v0 over threads."""

    def __init__(self, num_envs: int = 1, *, threads: int = 0,
                 autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP, states: bool = False,
                 mates: Any = _COMPAT_OTHERS, opponents: Any = _COMPAT_OTHERS,
                 render_mode: str | None = None, render_width: int = 600) -> None:
        """Args: see `compat_settings` and EpisodeVectorEnv."""
        _check_classes(num_envs, mates=mates, opponents=opponents)
        super().__init__(compat_settings(mates=mates, opponents=opponents).source, num_envs, threads=threads,
                         autoreset_mode=autoreset_mode, states=states, render_mode=render_mode,
                         render_width=render_width)
