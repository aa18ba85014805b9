"""A team whose robots are driven by the simulator's navigators. The keeper stays in front of its goal, the striker
drives through the ball toward the opponents' goal, and the others support it. The team also reports roles, draws its
plans, chooses its places at restarts, and takes part in two exercises of drills.

    fulbito match "cmd:python3 examples/teams/trio.py" chaser
"""

import math
from typing import List, Optional

from fulbito_team import (
    Commands, Exercise, ExerciseReply, GoTo, Observation, Parameter, Placement, PlacementRequest, Point, Pose,
    Robot, Team, run)

KEEPER, STRIKER, SUPPORT = 1, 2, 3


def clamp(value: float, least: float, most: float) -> float:
    return max(least, min(most, value))


def length(x: float, y: float) -> float:
    # Products and roots have the same bits on every machine; hypot and powers may not.
    return math.sqrt(x * x + y * y)


class Trio(Team):
    name = "trio"
    version = "1.0"
    default_navigator = "bspline-time"
    parameters = {"depth": Parameter(0.10, 0.05, 0.30, "distance [m] of the keeper from its goal line")}

    def decide(self, seen: Observation) -> Commands:
        commands = Commands()
        striker = self.striker(seen)
        for number, robot in enumerate(seen.own):
            if robot is None:
                continue
            if number == 0:
                self.keep(commands, seen)
            elif number == striker:
                self.strike(commands, number, robot, seen)
            else:
                self.support(commands, number, seen)
        return commands

    def striker(self, seen: Observation) -> int:
        """The robot nearest to the ball; the keeper only if it is alone."""
        def distance(number: int) -> float:
            robot = seen.own[number]
            assert robot is not None
            return length(robot.x - seen.ball.x, robot.y - seen.ball.y)

        present: List[int] = [n for n, robot in enumerate(seen.own) if robot is not None and n > 0]
        return min(present, key=distance) if present else 0

    def keep(self, commands: Commands, seen: Observation) -> None:
        field = self.info.field
        x = -field.length / 2 + self.settings["depth"]
        y = clamp(seen.ball.y, -field.goal_width / 2, field.goal_width / 2)
        commands.roles[0] = KEEPER
        commands.go_to(0, GoTo(x, y, stop=True, tolerance=0.01))
        if seen.wants_drawings:
            commands.circle(x, y, 0.04)

    def strike(self, commands: Commands, number: int, robot: Robot, seen: Observation) -> None:
        ball = seen.ball
        # Aims at the half of the goal on the ball's side.
        aim_x, aim_y = self.info.field.length / 2, math.copysign(0.25 * self.info.field.goal_width, ball.y)
        far = max(0.01, length(aim_x - ball.x, aim_y - ball.y))
        along_x, along_y = (aim_x - ball.x) / far, (aim_y - ball.y) / far
        behind = (ball.x - robot.x) * along_x + (ball.y - robot.y) * along_y
        beside = (ball.x - robot.x) * along_y - (ball.y - robot.y) * along_x
        if behind > 0.0 and abs(beside) < 0.03:
            target = GoTo(ball.x + 0.3 * along_x, ball.y + 0.3 * along_y, avoid_opponents=False)
        else:
            target = GoTo(ball.x - 0.12 * along_x, ball.y - 0.12 * along_y, avoid_ball=True)
        commands.roles[number] = STRIKER
        commands.go_to(number, target)
        if seen.wants_drawings:
            commands.line(robot.x, robot.y, target.x, target.y)
            commands.text(target.x, target.y, "striker")

    def support(self, commands: Commands, number: int, seen: Observation) -> None:
        commands.roles[number] = SUPPORT
        side = 1.0 if number % 2 == 0 else -1.0
        commands.go_to(number, GoTo(0.5 * seen.ball.x - 0.25, side * 0.3, stop=True, speed_limit=0.8))

    def place(self, request: PlacementRequest) -> Optional[Placement]:
        if request.kind == "penalty" or not request.ours:
            return None
        placement = Placement()
        # Right behind the ball, so that the striker needs no turn.
        placement.robots[1] = Pose(request.ball.x - 0.1, request.ball.y, 0.0)
        if request.kind == "goal-kick":
            placement.ball = Point(request.ball.x, 0.9 * request.ball.y)
        return placement

    def exercise(self, now: Observation, task: Exercise) -> Optional[ExerciseReply]:
        reply = ExerciseReply()
        if task.kind == "reach-pose":
            reply.commands.go_to(0, GoTo(task.x, task.y, heading=task.heading, stop=True, tolerance=0.005))
        elif task.kind == "predict-ball":
            ball = now.ball
            reply.answer = Point(ball.x + task.horizon * ball.vx, ball.y + task.horizon * ball.vy)
        else:
            return None
        return reply


if __name__ == "__main__":
    run(Trio())
