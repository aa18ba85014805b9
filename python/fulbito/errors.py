"""Exceptions of the package. Their text is the program's own: it names file, line or argument, and what is allowed.

All derive from `FulbitoError`, and from the built-in exception that fits:

| exception | is also a | when |
|---|---|---|
| `UsageError` | `ValueError` | a name, value, shape or dtype is not allowed |
| `InputError` | `ValueError` | a file can be read, but what it says is wrong |
| `FileError` | `OSError` | a file or folder cannot be read or written |
| `MachineError` | `RuntimeError` | the machine lacks memory, processes or room: a later attempt may succeed |
| `InterruptedRun` | `RuntimeError` | work was stopped before its end |
| `TeamError` | `RuntimeError` | a team, navigator or policy of this process raised an exception: the `__cause__` |
| `StateError` | `RuntimeError` | an object is used after `close`, by two threads at once, or after a fork |
| `InternalError` | `RuntimeError` | an error of Fulbito itself |
"""

__all__ = ["FulbitoError", "UsageError", "InputError", "FileError", "MachineError", "InterruptedRun", "TeamError",
           "StateError", "InternalError"]


class FulbitoError(Exception):
    """The base of all exceptions of this package."""


class UsageError(FulbitoError, ValueError):
    """A name, value, shape or dtype is not allowed."""


class InputError(FulbitoError, ValueError):
    """A file can be read, but what it says is wrong."""


class FileError(FulbitoError, OSError):
    """A file or folder cannot be read or written."""


class MachineError(FulbitoError, RuntimeError):
    """The machine lacks memory, processes, descriptors or room. A later attempt may succeed."""


class InterruptedRun(FulbitoError, RuntimeError):
    """Work was stopped before its end. Ctrl-C itself raises KeyboardInterrupt."""


class TeamError(FulbitoError, RuntimeError):
    """A team, navigator or policy of this process raised an exception, which is the `__cause__`."""


class StateError(FulbitoError, RuntimeError):
    """An object is used after `close`, by two threads at once, or after a fork."""


class InternalError(FulbitoError, RuntimeError):
    """An error of Fulbito itself: please report it. Do not use the object that raised it any more."""
