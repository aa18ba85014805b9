"""Fulbito: deterministic 2D robot soccer. See docs/python.md."""

from fulbito._core import version
from fulbito.errors import (FileError, FulbitoError, InputError, InternalError, InterruptedRun, MachineError, StateError,
                            TeamError, UsageError)
from fulbito.events import Event
from fulbito.matches import Containment, MatchResult, play
from fulbito.program import program_path
from fulbito.recording import Recording

__all__ = ["__version__", "Containment", "Event", "FileError", "FulbitoError", "InputError", "InternalError",
           "InterruptedRun", "MachineError", "MatchResult", "Recording", "StateError", "TeamError", "UsageError", "play",
           "program_path"]

__version__ = version()
