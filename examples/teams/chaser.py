"""The built-in team `chaser` in Python. Every robot drives straight at the ball with its nearer end, and backs off
from a wall when it has stood there for a while.

    fulbito match "cmd:python3 examples/teams/chaser.py" classic
"""

import math
from typing import List, Optional

from fulbito_team import Commands, MatchInfo, Observation, Robot, Team, Twist, run


def wrap(angle: float) -> float:
    """The angle modulo 2 pi, in [-pi, pi)."""
    wrapped = math.remainder(angle, 2.0 * math.pi)
    return wrapped - 2.0 * math.pi if wrapped >= math.pi else wrapped


class Standing:
    """Time [s] for which a robot has stood still, and remaining time [s] for which it backs off."""

    __slots__ = ("held", "left", "speed")

    def __init__(self) -> None:
        self.held = 0.0
        self.left = 0.0
        self.speed = 0.0

    def back_off(self, robot: Robot, meant: bool, dt: float) -> Optional[Twist]:
        """The twist that frees a robot that should move, but has stood still for 0.8 s."""
        if self.left > 0.0:
            self.left -= dt
            return Twist(self.speed, 3.0)
        still = math.sqrt(robot.vx * robot.vx + robot.vy * robot.vy) < 0.03 and abs(robot.omega) < 1.0
        self.held = self.held + dt if meant and still else 0.0
        if self.held < 0.8:
            return None
        self.held = 0.0
        self.left = 0.25
        # Away from the direction in which the wheels push.
        self.speed = -0.5 if robot.left + robot.right > 0.0 else 0.5
        return Twist(self.speed, 3.0)


class Chaser(Team):
    name = "chaser"
    version = "1.0"

    def begin(self, info: MatchInfo) -> None:
        body, field = info.robot, info.field
        self.near = math.sqrt(body.length * body.length + body.width * body.width) / 2.0 + 0.02
        self.half_length, self.half_width = field.length / 2, field.width / 2
        self.corner = field.length / 2 + field.width / 2 - field.corner if field.corner > 0.0 else math.inf
        self.standing: List[Standing] = [Standing() for _ in range(info.team_size)]

    def decide(self, seen: Observation) -> Commands:
        commands = Commands()
        for number, robot in enumerate(seen.own):
            if robot is None:
                continue
            at_wall = seen.playing and self.wall_clearance(robot.x, robot.y) < self.near
            free = self.standing[number].back_off(robot, at_wall, seen.dt)
            commands.robots[number] = free or self.chase(robot, seen.ball.x, seen.ball.y)
        return commands

    def chase(self, robot: Robot, x: float, y: float) -> Twist:
        error = wrap(math.atan2(y - robot.y, x - robot.x) - robot.heading)
        backward = abs(error) > math.pi / 2
        if backward:
            error = wrap(error + math.pi)
        speed = self.info.robot.max_speed * max(0.0, math.cos(error))
        return Twist(-speed if backward else speed, 10.0 * error)

    def wall_clearance(self, x: float, y: float) -> float:
        """Distance [m] to the nearest wall or corner triangle; goals do not count."""
        x, y = abs(x), abs(y)
        return min(self.half_length - x, self.half_width - y, (self.corner - x - y) / math.sqrt(2.0))


if __name__ == "__main__":
    run(Chaser())
