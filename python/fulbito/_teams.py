"""What the C++ side calls for teams of this process."""

import sys
from typing import Callable, Optional

import fulbito.team

__all__ = ["conversation", "name_of"]


def conversation(team: object) -> Callable[[str], Optional[str]]:
    """The team's side of the line protocol: takes a line, gives the answer. It belongs to the module of the team's own
    base class, which may be a copy of fulbito_team.py."""
    for base in type(team).__mro__:
        made = getattr(sys.modules.get(base.__module__), "Conversation", None)
        if base.__name__ == "Team" and made is not None:
            take: Callable[[str], Optional[str]] = made(team).take
            return take
    return fulbito.team.Conversation(team).take  # type: ignore[arg-type]


def name_of(team: object) -> str:
    """The name of a team or of its class, for results: without the characters that mean something in specifications."""
    name = str(getattr(team, "name", ""))
    if name in ("", fulbito.team.Team.name):
        name = str(getattr(team, "__name__", type(team).__name__))
    return name.replace(":", " ").replace(",", " ")
