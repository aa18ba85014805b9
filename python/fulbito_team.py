"""The module that teams of the line protocol import, for teams that run in this process."""

from fulbito.team import *  # noqa: F403
