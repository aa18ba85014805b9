"""Teams and navigators of this process, for tests."""

import math

from fulbito.navigation import Field, Guidance, Navigator, Path, Scene, Wheels
from fulbito.team import Commands, GoTo, Observation, Team


class Chaser(Team):
    """Drives all robots to the ball."""

    name = "chaser of this process"
    version = "3"

    def navigators(self) -> list[str]:
        return ["bezier"]

    def decide(self, seen: Observation) -> Commands:
        commands = Commands()
        for number, robot in enumerate(seen.own):
            if robot is not None:
                commands.go_to(number, GoTo(seen.ball.x, seen.ball.y))
        return commands


class Fails(Team):
    """Raises an exception at its tenth decision."""

    def __init__(self) -> None:
        super().__init__()
        self.decisions = 0

    def decide(self, seen: Observation) -> Commands:
        self.decisions += 1
        if self.decisions == 10:
            raise LookupError("the tenth")
        return Commands()


class ByPath(Navigator):
    """A straight path."""

    def plan(self, scene: Scene) -> Guidance:
        return Path([scene.pose[:2], scene.goal])


class ByField(Navigator):
    """A field that points to the goal."""

    name = "by-field"

    def plan(self, scene: Scene) -> Guidance:
        x, y = scene.goal
        return Field(lambda px, py: math.atan2(y - py, x - px))


class ByWheels(Navigator):
    """Full speed ahead."""

    name = "by-wheels"
    plans_speed = True

    def plan(self, scene: Scene) -> Guidance:
        return Wheels(scene.robot.max_wheel_speed, scene.robot.max_wheel_speed)
