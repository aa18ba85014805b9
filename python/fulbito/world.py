"""A world of robots, balls and obstacles, without rules or teams: step the bodies yourself."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from fulbito import _core
from fulbito.errors import UsageError

__all__ = ["Contact", "World"]

_Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Contact:
    """Two bodies that press on each other during a tick."""

    a: tuple[str, int]
    """The first body: "wall", "robot", "ball" or "obstacle", and its index (walls: 0)."""
    b: tuple[str, int]
    """The other body."""
    point: tuple[float, float]
    """[m] of the first impulse of the tick."""
    normal: tuple[float, float]
    """Unit vector from a to b."""
    impulse: float
    """[kg m/s] along the normal, summed over the tick."""
    began: bool
    """They did not touch in the previous tick."""


def _numbers(name: str, values: npt.ArrayLike) -> _Floats:
    """The values as contiguous doubles. Raises UsageError for complex numbers, text, and rows of different lengths."""
    try:
        if np.asarray(values).dtype.kind not in "biuf":
            raise TypeError
        return np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise UsageError(f"{name}: not an array of numbers") from None


def _rows(name: str, values: npt.ArrayLike, least: int, most: int) -> _Floats:
    """The values as rows of `most` columns; missing ones are 0."""
    rows = _numbers(name, values)
    if rows.size == 0:
        return np.zeros((0, most))
    if rows.ndim != 2 or not least <= rows.shape[1] <= most:
        raise UsageError(f"{name}: the shape is {rows.shape}, not (n, {least} ... {most})")
    whole = np.zeros((rows.shape[0], most))
    whole[:, :rows.shape[1]] = rows
    return whole


class World:
    """Walls, robots, balls and obstacles, stepped in control ticks. SI units; the origin is the field's centre.

    Equal arguments and commands give equal states, bit for bit. To reset a world, create a new one.
    """

    def __init__(self, *, robots: npt.ArrayLike = (), balls: npt.ArrayLike = (), discs: npt.ArrayLike = (),
                 field: str = "vsss-3v3", robot: str = "vsss", physics: str = "standard") -> None:
        """Creates a world.

        Args:
            robots: (n, 3 ... 6) x [m], y [m], heading [rad], velocity along x and y [m/s], yaw rate [rad/s].
            balls: (n, 2 ... 6) x [m], y [m], velocity along x and y [m/s], spin times radius along x and y [m/s]. A ball
                given without spin rolls: its spin is its velocity.
            discs: (n, 3) x [m], y [m], radius [m] of fixed round obstacles.
            field: preset or TOML file.
            robot: preset or TOML file of robots and balls.
            physics: profile or TOML file.

        Raises:
            UsageError: a shape is wrong, or a name is unknown.
            InputError: a body lies outside the field, or a value is outside its range.
        """
        placed = _rows("balls", balls, 2, 6)
        if np.asarray(balls).size > 0 and np.asarray(balls).shape[1] <= 4:
            placed[:, 4:] = placed[:, 2:4]
        self._world = _core.SteppedWorld(field, robot, physics, _rows("robots", robots, 3, 6), placed,
                                         _rows("discs", discs, 3, 3))

    def step(self, commands: npt.ArrayLike, *, ticks: int = 1) -> None:
        """Runs ticks with the same commands.

        Args:
            commands: (robots, 2) left and right wheel [rad/s]; NaN counts as 0, faster ones are clamped.
            ticks: number of ticks, at least 0.

        Raises:
            UsageError: the shape is wrong.
            StateError: another thread uses the world.
        """
        if ticks < 0:
            raise UsageError(f"ticks = {ticks} is negative")
        self._world.step(self._commands(commands, (self.robot_count, 2)), ticks)

    def run(self, commands: npt.ArrayLike) -> tuple[_Floats, _Floats]:
        """Runs one tick per row.

        Args:
            commands: (ticks, robots, 2) left and right wheel [rad/s].

        Returns:
            Robots (ticks, robots, 8) and balls (ticks, balls, 6) after each tick, with the columns of `robots` and `balls`.

        Raises:
            UsageError: the shape is wrong.
            StateError: another thread uses the world.
        """
        return self._world.run(self._commands(commands, (-1, self.robot_count, 2)))

    @staticmethod
    def _commands(commands: npt.ArrayLike, shape: tuple[int, ...]) -> _Floats:
        values = _numbers("commands", commands)
        if values.ndim != len(shape) or any(want not in (-1, got) for want, got in zip(shape, values.shape)):
            wanted = ", ".join("ticks" if n < 0 else str(n) for n in shape)
            raise UsageError(f"commands: the shape is {values.shape}, not ({wanted})")
        return values

    @property
    def robots(self) -> _Floats:
        """(n, 8) x [m], y [m], heading [rad], velocity along x, y [m/s], yaw rate [rad/s], left, right wheel [rad/s]."""
        return self._world.state()[0]

    @property
    def balls(self) -> _Floats:
        """(n, 6) x [m], y [m], velocity along x, y [m/s], spin times radius along x, y [m/s]."""
        return self._world.state()[1]

    @property
    def obstacles(self) -> _Floats:
        """(n, 5) x [m], y [m], heading [rad], velocity along x, y [m/s]."""
        return self._world.state()[2]

    @property
    def contacts(self) -> list[Contact]:
        """Contacts of the last tick."""
        return [Contact((c[0], c[1]), (c[2], c[3]), (c[4], c[5]), (c[6], c[7]), c[8], c[9])
                for c in self._world.contacts()]

    @property
    def tick(self) -> int:
        """Ticks so far."""
        return self._world.tick

    @property
    def dt(self) -> float:
        """[s] length of a tick."""
        return self._world.dt

    @property
    def max_wheel_speed(self) -> float:
        """[rad/s] Commands beyond it are clamped."""
        return self._world.max_wheel_speed

    @property
    def robot_count(self) -> int:
        """Number of robots."""
        return self._world.robot_count

    def state_hash(self) -> int:
        """Hash of the present state: equal states have equal hashes."""
        return self._world.hash()
