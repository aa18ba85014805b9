"""Events of a match: the referee's calls, and the restarts that follow them."""

from dataclasses import dataclass
from typing import Any, Iterable, Mapping, Optional

import numpy as np
import numpy.typing as npt

__all__ = ["Event", "EVENT_DTYPE", "event_table"]

#: The columns of `event_table`. A missing team is "", a missing robot -1.
EVENT_DTYPE = np.dtype([("tick", "i8"), ("seconds", "f8"), ("period", "i4"), ("play_seconds", "f8"), ("event", "U40"),
                        ("law", "U12"), ("kind", "U12"), ("team", "U6"), ("robot", "i4"), ("x", "f8"), ("y", "f8"),
                        ("value", "f8"), ("threshold", "f8"), ("margin", "f8")])


@dataclass(frozen=True)
class Event:
    """One call of the referee, or one restart."""

    tick: int
    """Tick of the match."""
    seconds: float
    """[s] of the match, stoppages included."""
    period: int
    """1, 2: halves; 3: overtime; 4: shoot-out."""
    play_seconds: float
    """[s] play time in the period."""
    event: str
    """Clause of the call, such as "goal" or "goal-kick.attackers"; "restart" for a restart."""
    law: str
    """Paragraph of the rule book; empty for a restart."""
    kind: str
    """Kind of a restart, such as "kick-off"; empty for a call."""
    team: Optional[str]
    """"blue" or "yellow": the team that the call is against, that scored or that takes the restart; None: none."""
    robot: Optional[int]
    """Number of the robot at fault, or of the scorer; None: unknown."""
    x: float
    """[m] of the ball."""
    y: float
    """[m] of the ball."""
    value: float
    """Measured value, in the unit of the threshold; 0 for a restart."""
    threshold: float
    """Limit of the rule."""
    margin: float
    """Distance of the value from the limit."""

    @classmethod
    def of(cls, entry: Mapping[str, Any]) -> "Event":
        """An event from an entry of the results' JSON (docs/results-format.md)."""
        return cls(entry["tick"], entry["time_s"], entry["period"], entry["play_s"], entry["event"],
                   entry.get("law", ""), entry.get("kind", ""), entry.get("team"), entry.get("robot"), entry["x"],
                   entry["y"], entry.get("value", 0.0), entry.get("threshold", 0.0), entry.get("margin", 0.0))


def event_table(events: Iterable[Event]) -> npt.NDArray[Any]:
    """The events as a structured array of `EVENT_DTYPE`, one row per event. `pandas.DataFrame` takes it as it is."""
    rows = [(e.tick, e.seconds, e.period, e.play_seconds, e.event, e.law, e.kind, e.team or "",
             -1 if e.robot is None else e.robot, e.x, e.y, e.value, e.threshold, e.margin) for e in events]
    return np.array(rows, dtype=EVENT_DTYPE)
