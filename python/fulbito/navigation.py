"""Navigation research: a navigator of your own in Python, the built-in ones, and layouts of the suites.

    class Straight(fulbito.navigation.Navigator):
        name = "straight-line"

        def plan(self, scene: Scene) -> Guidance:
            return Path([scene.pose[:2], scene.goal])

    print(fulbito.compare("corner", ["bezier", Straight], trials=50))
"""

import math
from dataclasses import dataclass
from typing import Any, Callable, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from fulbito import _core
from fulbito.errors import UsageError
from fulbito.program import program_path

__all__ = ["Field", "Guidance", "Layout", "Navigator", "NavigatorInfo", "Obstacle", "ParameterInfo", "Path",
           "RobotLimits", "Scene", "SuiteInfo", "Wheels", "layout", "learnt", "navigators", "suites"]

_Floats = npt.NDArray[np.float64]


class RobotLimits(NamedTuple):
    """The robot of a trial."""

    max_wheel_speed: float
    """[rad/s] speed limit of the trial."""
    wheel_radius: float
    """[m]"""
    axle_track: float
    """[m] between the wheels."""
    length: float
    """[m] body along its front."""
    width: float
    """[m] body across."""


class Scene:
    """What a navigator knows at one control tick. SI units; the origin is the field's centre."""

    __slots__ = ("tick", "dt", "pose", "velocity", "wheels", "goal", "goal_heading", "tolerance", "stop", "obstacles",
                 "field_size", "robot")

    def __init__(self, tick: int, dt: float, pose: tuple[float, float, float], velocity: tuple[float, float, float],
                 wheels: tuple[float, float], goal: tuple[float, float], goal_heading: Optional[float],
                 tolerance: float, stop: bool, obstacles: _Floats, field_size: tuple[float, float],
                 robot: tuple[float, float, float, float, float]) -> None:
        self.tick = tick  #: control ticks since the start
        self.dt = dt  #: [s] control period
        self.pose = pose  #: x [m], y [m], heading [rad] as far as known
        self.velocity = velocity  #: along x and y [m/s], yaw rate [rad/s]
        self.wheels = wheels  #: [rad/s] left and right wheel
        self.goal = goal  #: x [m], y [m]
        self.goal_heading = goal_heading  #: [rad] on arrival; None: any
        self.tolerance = tolerance  #: [m] distance that counts as arrival
        self.stop = stop  #: stop at the goal; otherwise the robot may pass it at speed
        self.obstacles = obstacles  #: (n, 5) x [m], y [m], radius [m], velocity along x and y [m/s]
        self.field_size = field_size  #: [m] along x and y
        self.robot = RobotLimits(*robot)  #: its size and limits


@dataclass(frozen=True, slots=True)
class Wheels:
    """Guidance by wheel speeds: the navigator does all by itself."""

    left: float
    """[rad/s]"""
    right: float
    """[rad/s]"""


@dataclass(frozen=True, slots=True, eq=False)
class Path:
    """Guidance by a path, which the follower drives along. Return the same object again as long as it holds."""

    points: npt.ArrayLike
    """(n, 2) [m] from the robot to the goal, n >= 2."""
    speeds: Optional[npt.ArrayLike] = None
    """(n,) [m/s] at each point; None: the follower chooses."""
    speed_cap: float = math.inf
    """[m/s] present limit."""


@dataclass(frozen=True, slots=True)
class Field:
    """Guidance by a heading at every place."""

    heading: Callable[[float, float], float]
    """Direction [rad] of travel for a robot at x [m], y [m]."""
    speed_cap: float = math.inf
    """[m/s] present limit."""


Guidance = Union[Wheels, Path, Field]


class Navigator:
    """A navigator of your own. `compare` makes one for each trial, possibly in several threads."""

    name = ""
    """Its name in tables; empty: that of the class."""
    plans_speed = False
    """It chooses speeds by itself: tables mark it."""

    def reset(self) -> None:
        """A new trial begins: forget the last one."""

    def plan(self, scene: Scene) -> Guidance:
        """The guidance for one control tick."""
        raise NotImplementedError("a navigator must define `plan`")


def checked(guidance: Any) -> tuple[Any, ...]:
    """Guidance as the C++ side takes it. Raises UsageError."""
    if isinstance(guidance, Wheels):
        return "wheels", _finite("left", guidance.left), _finite("right", guidance.right)
    if isinstance(guidance, Path):
        points = _floats("points", guidance.points)
        if points.ndim != 2 or points.shape[0] < 2 or points.shape[1] != 2:
            raise UsageError(f"a path: the shape is {points.shape}, not (n, 2) with n >= 2")
        speeds = None if guidance.speeds is None else _floats("speeds", guidance.speeds)
        if speeds is not None and speeds.shape != (points.shape[0],):
            raise UsageError(f"a path: speeds of shape {speeds.shape}, not ({points.shape[0]},)")
        return "path", points, speeds, float(guidance.speed_cap)
    if isinstance(guidance, Field):
        return "field", guidance.heading, None, float(guidance.speed_cap)
    raise UsageError(f"`plan` must return Wheels, Path or Field, not {type(guidance).__name__}")


def angle(value: float) -> float:
    """A heading that a field gave. Raises UsageError if it is not finite."""
    return _finite("a heading", value)


def _finite(name: str, value: float) -> float:
    number = float(value)
    if not math.isfinite(number):
        raise UsageError(f"{name} = {number} is not finite")
    return number


def _floats(name: str, values: npt.ArrayLike) -> _Floats:
    array = np.ascontiguousarray(values, dtype=np.float64)
    if not np.isfinite(array).all():
        raise UsageError(f"a path: {name} are not all finite")
    return array


@dataclass(frozen=True)
class ParameterInfo:
    """A parameter of a method, as in "bezier:clearance=0.02"."""

    name: str
    """As in specifications."""
    type: str
    """number, integer, flag or choice."""
    default: Union[float, str]
    """Default value; of a flag: 0 or 1; of a choice: its name."""
    minimum: float
    """Least value."""
    maximum: float
    """Largest value."""
    unit: str
    """Such as "m/s"; empty: none."""
    doc: str
    """One line."""
    choices: tuple[str, ...]
    """Of a choice: its values."""


@dataclass(frozen=True)
class NavigatorInfo:
    """A built-in navigation method."""

    name: str
    """As in specifications."""
    summary: str
    """One line."""
    source: str
    """Paper, section."""
    plans_speed: bool
    """It chooses speeds by itself."""
    parameters: tuple[ParameterInfo, ...]
    """Its own parameters."""


def learnt() -> str:
    """The specification of the trained navigator that comes with the package, for `compare` and for the program. It is a
    shared library, made by examples/python/train_navigator.py (docs/environments.md)."""
    return f"{program_path().parent / 'learnt.so'}:learnt"


def navigators() -> list[NavigatorInfo]:
    """All built-in navigation methods, in the order of the tables."""
    found: list[NavigatorInfo] = []
    for name, summary, source, plans_speed, parameters in _core.navigators():
        own = tuple(ParameterInfo(p[0], p[1], p[7][int(p[2])] if p[7] else p[2], p[3], p[4], p[5], p[6], tuple(p[7]))
                    for p in parameters)
        found.append(NavigatorInfo(name, summary, source, plans_speed, own))
    return found


@dataclass(frozen=True)
class SuiteInfo:
    """A seeded family of layouts."""

    name: str
    """As in `compare`."""
    summary: str
    """One line."""
    trials: int
    """Default number of layouts."""
    speeds: tuple[float, ...]
    """[m/s] default top speeds."""


def suites() -> list[SuiteInfo]:
    """All suites of layouts."""
    return [SuiteInfo(name, summary, trials, tuple(speeds)) for name, summary, trials, speeds in _core.suites()]


@dataclass(frozen=True)
class Obstacle:
    """An obstacle of a layout."""

    shape: str
    """disc or box."""
    motion: str
    """fixed, path or pushable."""
    pose: tuple[float, float, float]
    """x [m], y [m], heading [rad] at the start."""
    radius: float
    """[m] of a disc."""
    length: float
    """[m] of a box along its x."""
    width: float
    """[m] of a box along its y."""
    path: Sequence[tuple[float, float]]
    """[m] waypoints of one that moves."""
    speed: float
    """[m/s] along the path."""


@dataclass(frozen=True)
class Layout:
    """A navigation problem: from the start to the goal among obstacles."""

    name: str
    """For tables."""
    field: str
    """Preset of the field."""
    start: tuple[float, float, float]
    """x [m], y [m], heading [rad]."""
    goal: tuple[float, float]
    """x [m], y [m]."""
    goal_heading: Optional[float]
    """[rad] on arrival; None: any."""
    tolerance: float
    """[m] distance that counts as arrival."""
    obstacles: tuple[Obstacle, ...]
    """In the order of the layout."""


def layout(suite: str, index: int, *, seed: int = 2015) -> Layout:
    """Layout number `index` of a suite and seed. Raises UsageError for an unknown suite, with a suggestion."""
    if index < 0 or not 0 <= seed < 2**64:
        raise UsageError(f"index = {index} and seed = {seed} must not be negative")
    name, field, start, goal, heading, tolerance, obstacles = _core.layout(suite, seed, index)
    return Layout(name, field, start, goal, heading, tolerance, tuple(Obstacle(**entry) for entry in obstacles))
