"""The program `fulbito` that comes with the package."""

from pathlib import Path

__all__ = ["companions", "program_path"]


def program_path() -> Path:
    """The path of the program `fulbito` inside the package. `python -m fulbito` runs it."""
    return Path(__file__).parent / "bin" / "fulbito"


def companions() -> tuple[str, str]:
    """The program that hosts teams of shared libraries, and the folder of the module that teams in Python import."""
    folder = program_path().resolve().parent
    return str(folder / "fulbito-team-host"), str(folder / "python")
