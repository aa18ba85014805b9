"""Recordings (`.fbr`): what moved, what was called, pictures and pages."""

import html
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator, Optional, Union

import numpy as np
import numpy.typing as npt

from fulbito import _core
from fulbito.errors import UsageError
from fulbito.events import Event, event_table

__all__ = ["Recording", "Samples", "States", "Verification"]

_Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Samples:
    """Poses as the recording keeps them: about 30 times per second, positions to 0.5 mm. NaN: not on the field."""

    ticks: npt.NDArray[np.int64]
    """(n,) ticks of the recording."""
    seconds: _Floats
    """(n,) [s] time in the recording."""
    poses: _Floats
    """(n, bodies, 3): x [m], y [m], heading [rad], in the order of `Recording.bodies`."""
    score: npt.NDArray[np.int32]
    """(n, 2) goals of blue and yellow."""
    playing: npt.NDArray[np.bool_]
    """(n,) False while a restart waits for its signal."""


@dataclass(frozen=True)
class States:
    """Exact states after each tick, which are computed again from the commands. NaN: not on the field."""

    ticks: npt.NDArray[np.int64]
    """(n,) ticks of the recording."""
    seconds: _Floats
    """(n,) [s] time in the recording."""
    pose: _Floats
    """(n, bodies, 3): x [m], y [m], heading [rad], in the order of `Recording.bodies`; a ball has no heading."""
    velocity: _Floats
    """(n, bodies, 3): along x and y [m/s], yaw rate [rad/s] of robots."""
    wheels: _Floats
    """(n, robots, 2) [rad/s] left and right wheel as they turn."""
    commands: _Floats
    """(n, robots, 2) [rad/s] as commanded."""


@dataclass(frozen=True)
class Verification:
    """What simulating a recording again has shown."""

    same: bool
    """Every hash is as recorded, bit for bit. False also if it cannot be simulated again: see `heard`."""
    difference: str
    """The first difference in one sentence; empty: none."""
    heard: bool
    """The motion is another program's, so nothing is verified."""
    finished: bool
    """False: the recording is cut off; what there is was verified."""
    same_build: bool
    """The same compiler and libraries made it."""
    ticks: int
    """Number of ticks."""
    plays: int
    """Number of plays."""
    seconds: float
    """[s] simulated time."""
    final_hash: int
    """Hash of all states."""

    def __bool__(self) -> bool:
        return self.same


class Recording:
    """A recording of a match or trial. All its functions may be called from any thread, one at a time."""

    def __init__(self, file: _core.RecordingFile) -> None:
        """Use `open` or `parse`."""
        self._file = file
        self._header = file.header()
        self._events: Optional[list[Event]] = None

    @classmethod
    def open(cls, path: Union[str, "os.PathLike[str]"], *, salvage: bool = False) -> "Recording":
        """Opens a file.

        Args:
            path: the file.
            salvage: read a damaged file up to the damage.

        Raises:
            FileError: it cannot be read.
            InputError: it is no recording, of another version, or damaged. A cut-off file is no error.
        """
        return cls(_core.RecordingFile.open(os.fspath(path), salvage))

    @classmethod
    def parse(cls, data: bytes, *, origin: str = "recording", salvage: bool = False) -> "Recording":
        """Opens the bytes of a file; `origin` is its name in errors. Raises as `open`."""
        return cls(_core.RecordingFile.parse(data, origin, salvage))

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the recording to a file. Raises OSError."""
        Path(path).write_bytes(self._file.bytes())

    @property
    def header(self) -> dict[str, Any]:
        """What its header and its end say: kind, level, control_rate [Hz], seed, ticks, finished, and more."""
        return dict(self._header)

    @property
    def teams(self) -> list[str]:
        """Specifications of blue and yellow; empty for a trial."""
        return list(self._header["teams"])

    @property
    def bodies(self) -> list[str]:
        """Names of the bodies, in the order of all arrays: "blue 0" ... "yellow 2", "ball"."""
        return list(self._header["bodies"])

    @property
    def ticks(self) -> int:
        """Number of ticks."""
        return int(self._header["ticks"])

    @property
    def seconds(self) -> float:
        """[s] length, stoppages included."""
        return float(self.ticks / self._header["control_rate"])

    @property
    def score(self) -> Optional[tuple[int, int]]:
        """Goals of blue and yellow; None for an unfinished recording."""
        score: Optional[tuple[int, int]] = self._header.get("score")
        return score

    @property
    def events(self) -> list[Event]:
        """The referee's calls, in order of time."""
        if self._events is None:
            self._events = [Event.of(entry) for entry in self._file.events()]
        return list(self._events)

    def event_table(self) -> npt.NDArray[Any]:
        """The events as a structured array, see `fulbito.events.EVENT_DTYPE`."""
        return event_table(self.events)

    def samples(self) -> Samples:
        """The recorded poses. States of a recipe are simulated first. Raises InputError for a damaged recording."""
        parts = self._file.samples()
        return Samples(parts["ticks"], parts["ticks"] / self._header["control_rate"], parts["poses"], parts["score"],
                       parts["playing"].astype(np.bool_))

    def states(self) -> States:
        """The exact states of all ticks: a second of computing for a match of ten minutes."""
        parts = self._file.states()
        return States(parts["ticks"], parts["ticks"] / self._header["control_rate"], parts["pose"], parts["velocity"],
                      parts["wheels"], parts["commands"])

    def path(self, body: str) -> _Floats:
        """(n, 3) recorded poses of one body: x [m], y [m], heading [rad]. Raises UsageError for an unknown name."""
        if body not in self._header["bodies"]:
            raise UsageError(f"there is no body '{body}': {', '.join(self._header['bodies'])}")
        poses: _Floats = self.samples().poses[:, self._header["bodies"].index(body)]
        return poses

    def to_html(self, path: Optional[Union[str, "os.PathLike[str]"]] = None) -> str:
        """The viewer with this recording as one HTML page, which is also written to `path`."""
        page = self._file.html()
        if path is not None:
            Path(path).write_text(page, encoding="utf-8")
        return page

    def frame(self, seconds: float, *, width: int = 900, theme: str = "dark") -> npt.NDArray[np.uint8]:
        """(height, width, 3) RGB picture of one moment [s]. Raises as `frames`."""
        return self._film(width, theme, 1.0).pixels(seconds)

    def png(self, seconds: float, *, width: int = 900, theme: str = "dark") -> bytes:
        """A PNG file of one moment [s]. Raises as `frames`."""
        return self._film(width, theme, 1.0).png(seconds)

    def frames(self, *, fps: float = 30.0, speed: float = 1.0, start: float = 0.0, stop: Optional[float] = None,
               width: int = 900, theme: str = "dark", trail_seconds: float = 1.0) -> Iterator[npt.NDArray[np.uint8]]:
        """The frames of a film, drawn one by one.

        Args:
            fps: frames per second of the film.
            speed: seconds of the recording per second of the film.
            start: [s] first moment.
            stop: [s] moment after the last; None: the end.
            width: [px] 160 ... 16384; the height follows from the field.
            theme: "dark" or "light".
            trail_seconds: [s] length of the trails; 0: none.

        Yields:
            (height, width, 3) RGB pictures.

        Raises:
            UsageError: an argument is outside its range.
            FileError: the font of the pictures is missing (fonts-dejavu-core, or FULBITO_FONT).
        """
        if not (0.0 < fps < np.inf and 0.0 < speed < np.inf):
            raise UsageError(f"fps = {fps} and speed = {speed} must be positive")
        for name, value in (("start", start), ("stop", 0.0 if stop is None else stop), ("trail_seconds", trail_seconds)):
            if not np.isfinite(value):
                raise UsageError(f"{name} = {value} is not a finite number")
        end = self.seconds if stop is None else min(stop, self.seconds)
        film = self._film(width, theme, trail_seconds)
        count = max(0, int(np.ceil((end - start) * fps / speed - 1e-9)))
        return (film.pixels(start + i * speed / fps) for i in range(count))

    def verify(self) -> Verification:
        """Simulates the recording again and compares every hash. Raises InputError if it gives no valid world."""
        parts = self._file.verify()
        same = not parts["difference"] and not parts["heard"]
        return Verification(same=same, **parts)

    def _film(self, width: int, theme: str, trail_seconds: float) -> _core.Film:
        if theme not in ("dark", "light"):
            raise UsageError(f"theme = {theme!r} is neither 'dark' nor 'light'")
        return _core.Film(self._file, width, theme == "light", trail_seconds, True, True)

    def __repr__(self) -> str:
        between = f" {self.score[0]} : {self.score[1]} " if self.score is not None else " - "
        return f"<Recording {between.join(self.teams) or 'of a trial'}, {self.seconds:.1f} s>"

    def _repr_html_(self) -> str:
        page = html.escape(self.to_html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width:100%;height:720px;border:0" allowfullscreen></iframe>'
