"""Matches: `fulbito.play("libero", "classic", seed=7)`."""

import html
import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional, TypeVar, Union

from fulbito import _core
from fulbito._progress import Bar
from fulbito.errors import UsageError
from fulbito.events import Event, event_table
from fulbito.recording import Recording
from fulbito.team import Team

__all__ = ["Containment", "MatchResult", "PathLike", "PerTeam", "TeamLike", "play"]

_T = TypeVar("_T")
#: One value for both teams, or one for blue and one for yellow.
PerTeam = Union[_T, tuple[_T, _T]]
#: A specification, or a team of this process: a class is created anew for each match.
TeamLike = Union[str, Team, type[Team]]
PathLike = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True, kw_only=True)
class Containment:
    """How teams that are files or programs are contained (docs/sandbox.md). Teams of this process are not."""

    isolate: str = "process"
    """A shared library runs in a contained "process", or for trusted code in this one: "none"."""
    sandbox: str = "best"
    """"best": all containment that this system allows; "require": or refuse."""
    memory_mb: float = 1024.0
    """[MiB] memory of each team, 16 ... 1048576."""
    processes: int = 64
    """Processes and threads of each team, 1 ... 10000."""
    network: bool = False
    """Teams may use the network."""

    def to_core(self) -> _core.Containment:
        """As the C++ side takes it."""
        core = _core.Containment()
        core.isolate, core.sandbox = self.isolate, self.sandbox
        core.memory_mb, core.processes, core.network = self.memory_mb, self.processes, self.network
        return core


@dataclass(frozen=True)
class MatchResult:
    """The result of a match."""

    data: dict[str, Any]
    """All figures, as `fulbito match --json` prints them (docs/results-format.md)."""
    recording: Optional[Recording]
    """The match, if it was recorded."""

    @property
    def teams(self) -> tuple[str, str]:
        """The names of blue and yellow."""
        return self.data["teams"]["blue"], self.data["teams"]["yellow"]

    @property
    def score(self) -> tuple[int, int]:
        """Goals of blue and yellow."""
        return self.data["score"]["blue"], self.data["score"]["yellow"]

    @property
    def winner(self) -> Optional[str]:
        """"blue" or "yellow"; None after a draw."""
        winner = self.data["score"].get("winner")
        return winner if winner in ("blue", "yellow") else None

    @property
    def events(self) -> list[Event]:
        """Calls and restarts, in order of time."""
        return [Event.of(entry) for entry in self.data["events"]]

    @property
    def statistics(self) -> dict[str, Any]:
        """Figures of play: possession, shots, fouls, distances [m], times [s] and more, for each team and robot."""
        stats: dict[str, Any] = self.data["stats"]
        return stats

    @property
    def final_hash(self) -> str:
        """Hash of all states of the match, 16 hexadecimal digits: equal matches have equal hashes."""
        return str(self.data["final_hash"])

    def event_table(self) -> Any:
        """The events as a structured NumPy array, see `fulbito.events.EVENT_DTYPE`."""
        return event_table(self.events)

    def __repr__(self) -> str:
        (blue, yellow), (ours, theirs) = self.teams, self.score
        return f"<MatchResult {blue} {ours} : {theirs} {yellow}>"

    def _repr_html_(self) -> str:
        (blue, yellow), (ours, theirs) = self.teams, self.score
        head = f"<p><b>{html.escape(blue)} {ours} : {theirs} {html.escape(yellow)}</b></p>"
        return head + (self.recording._repr_html_() if self.recording is not None else "")


def _pair(name: str, value: PerTeam[Any], kind: type) -> tuple[Any, Any]:
    values: Any = value if isinstance(value, (tuple, list)) else (value, value)
    if len(values) != 2:
        raise UsageError(f"{name}: one value, or one for blue and one for yellow, not {value!r}")
    try:
        pair = kind(values[0]), kind(values[1])
    except (TypeError, ValueError):
        raise UsageError(f"{name}: {value!r} is not a number") from None
    if kind is int and not all(-2**31 <= n < 2**31 and n == given for n, given in zip(pair, values)):
        raise UsageError(f"{name}: {value!r} is not a small whole number")
    return pair


def play(blue: TeamLike, yellow: TeamLike, *, seed: int = 1, rules: str = "vsss-3v3", robot: str = "vsss",
         physics: str = "standard", half_seconds: Optional[float] = None, latency: PerTeam[int] = 0,
         noise: PerTeam[float] = 0.0, dropout: PerTeam[float] = 0.0, time_ms: Optional[float] = None,
         start: Optional[PathLike] = None, record: Union[PathLike, bool] = False, recipe: bool = False,
         drawings: bool = False, containment: Containment = Containment(), progress: bool = False) -> MatchResult:
    """Plays a match by the rules, as `fulbito match` does. Equal arguments give equal matches, bit for bit.

    Args:
        blue: the team that defends the left goal: a specification such as "libero" or "cmd:python3 team.py", or an
            object or class like `fulbito.team.Team`, which runs in this process.
        yellow: the other team.
        seed: of all random numbers, 0 ... 2**64 - 1.
        rules: profile, such as "vsss-3v3" or "vsss-5v5", or a TOML file.
        robot: preset or TOML file, for both teams.
        physics: profile or TOML file.
        half_seconds: [s] play time of a half; None: from the rules.
        latency: [ticks] age of what the teams see, 0 ... 60.
        noise: [m] standard deviation of observed positions, 0 ... 0.1.
        dropout: probability per tick that a body is not seen, 0 ... 0.99.
        time_ms: [ms] wall time per decision; None: the rules limit programs only; infinity: no limit.
        start: TOML file with a start state; None: a kick-off.
        record: file of the recording; True: keep it in memory.
        recipe: record without states, which are computed when it is read.
        drawings: also record the teams' drawings, 10 times per second.
        containment: for teams that are files or programs.
        progress: show a bar (needs tqdm).

    Raises:
        UsageError, InputError, FileError: a name, file or value is wrong; the text names it.
        TeamError: a team of this process raised an exception, which is the cause.
        MachineError: the machine lacks what a team needs.
        KeyboardInterrupt: after Ctrl-C. A recording then ends at that tick.
    """
    options = _core.MatchOptions()
    options.rules, options.robot, options.physics = str(rules), str(robot), str(physics)
    if not 0 <= seed < 2**64:
        raise UsageError(f"seed: {seed!r} is outside 0 ... 2**64 - 1")
    options.seed, options.half_seconds, options.time_ms = seed, half_seconds, time_ms
    options.latency = _pair("latency", latency, int)
    options.noise = _pair("noise", noise, float)
    options.dropout = _pair("dropout", dropout, float)
    options.start = "" if start is None else os.fspath(start)
    options.keep = record is True
    options.record = "" if isinstance(record, bool) else os.fspath(record)
    options.recipe, options.drawings = recipe, drawings
    with Bar(progress, "match", "tick") as bar:
        text, recording = _core.play(blue, yellow, options, containment.to_core(), bar.match if progress else None)
    kept = Recording.parse(recording) if options.keep else Recording.open(Path(options.record)) if options.record else None
    return MatchResult(json.loads(text), kept)
