"""Fulbito: deterministic 2D robot soccer. See docs/python.md."""

from fulbito._core import version
from fulbito.comparison import Comparison, compare
from fulbito.errors import (FileError, FulbitoError, InputError, InternalError, InterruptedRun, MachineError, StateError,
                            TeamError, UsageError)
from fulbito.events import Event
from fulbito.matches import Containment, MatchResult, play
from fulbito.navigation import layout, navigators, suites
from fulbito.program import program_path
from fulbito.recording import Recording
from fulbito.world import World

__all__ = ["__version__", "Comparison", "Containment", "Event", "FileError", "FulbitoError", "InputError",
           "InternalError", "InterruptedRun", "MachineError", "MatchResult", "Recording", "StateError", "TeamError",
           "UsageError", "World", "compare", "layout", "navigators", "play", "program_path", "suites"]

__version__ = version()
