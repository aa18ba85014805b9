"""What an environment that plays matches is made of."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from fulbito import _core
from fulbito.errors import UsageError

__all__ = ["ActionForm", "MatchSettings", "ObservationForm"]

ActionForm = Literal["wheels", "twist", "go-to", "skill", "compat"]
ObservationForm = Literal["absolute", "egocentric", "compat"]


@dataclass(frozen=True, kw_only=True)
class MatchSettings:
    """All settings of a match environment. Wrong values raise UsageError when the environment is made."""

    blue: Any = "idle"
    """Team of the blue robots that are no agents: a specification such as "libero:aggression=0.7", or a class of
    fulbito.team.Team, of which each match makes one."""
    yellow: Any = "idle"
    """The same for yellow."""
    blue_agents: Sequence[int] = (0,)
    """Numbers of the blue robots that are agents."""
    yellow_agents: Sequence[int] = ()
    """Numbers of the yellow robots that are agents."""
    rules: str = "vsss-3v3"
    """Preset or file of the rules."""
    only_goals: bool = False
    """Switches off every call of the referee but goals."""
    physics: str = "standard"
    """Preset or file of the physics."""
    control_rate: int | None = None
    """[Hz] Ticks per second; None: as the physics have it."""
    substeps: int | None = None
    """Physics steps per tick; None: as the physics have it."""
    robot_model: str = "vsss"
    """Preset or file of robots and ball."""
    randomise: Mapping[str, tuple[float, float]] = field(default_factory=dict[str, tuple[float, float]])
    """Ranges from which each episode draws numbers of the models, such as {"robot.mass": (0.12, 0.18)}: keys are
    those of robot files, in their units."""
    action: ActionForm = "wheels"
    """What an agent's action is; docs/environments.md has the forms."""
    navigator: str = "straight"
    """Navigator of the actions "go-to" and "skill"."""
    frame_skip: int = 1
    """Ticks per step, 1 ... 1000; the action holds meanwhile."""
    observation: ObservationForm = "absolute"
    """What an agent sees; docs/environments.md has the tables."""
    stack: int = 1
    """Observations of the last steps in one, the newest first, 1 ... 100."""
    reward: Literal["shaped", "compat"] = "shaped"
    """Which terms the reward has."""
    rewards: Mapping[str, float] = field(default_factory=dict[str, float])
    """Factors of the terms "goal", "ball", "move", "energy" and "foul"; missing ones keep their defaults."""
    start: Literal["kick-off", "random"] = "random"
    """Where episodes begin."""
    end: Literal["goal", "match"] = "goal"
    """"goal": a goal terminates the episode. "match": it ends as the rules say."""
    time_limit: float = 30.0
    """[s] Time after which an episode is truncated; 0: no limit."""
    latency_ticks: int = 0
    """Age of what agents see, 0 ... 60 ticks."""
    position_noise: float = 0.0
    """[m] Standard deviation of each coordinate that agents see, 0 ... 0.1."""
    heading_noise: float = 0.0
    """[rad] Standard deviation of headings that agents see."""
    dropout: float = 0.0
    """Probability per tick that an agent does not see a body, 0 ... 0.99."""

    def source(self) -> _core.Source:
        """A new source of such episodes."""
        values = {name: getattr(self, name) for name in self.__dataclass_fields__}
        kinds: dict[str, tuple[type, str]] = {"blue_agents": (list, "list of robot numbers"),
                                              "yellow_agents": (list, "list of robot numbers"),
                                              "randomise": (dict, "dict of pairs of numbers"),
                                              "rewards": (dict, "dict of numbers")}
        for name, (kind, words) in kinds.items():
            try:
                values[name] = kind(values[name])
            except (TypeError, ValueError) as error:
                raise UsageError(f"{name}: {values[name]!r} is no {words}") from error
        return _core.match_source(**values)
