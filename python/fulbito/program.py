"""The program `fulbito` that comes with the package."""

from pathlib import Path

__all__ = ["program_path"]


def program_path() -> Path:
    """The path of the program `fulbito` inside the package. `python -m fulbito` runs it."""
    return Path(__file__).parent / "bin" / "fulbito"
