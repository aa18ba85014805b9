"""Fulbito: deterministic 2D robot soccer. See docs/python.md."""

from fulbito._core import version
from fulbito.errors import (FileError, FulbitoError, InputError, InternalError, InterruptedRun, MachineError, StateError,
                            TeamError, UsageError)
from fulbito.program import program_path

__all__ = ["__version__", "FileError", "FulbitoError", "InputError", "InternalError", "InterruptedRun", "MachineError",
           "StateError", "TeamError", "UsageError", "program_path"]

__version__ = version()
