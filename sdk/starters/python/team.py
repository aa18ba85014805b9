"""@NAME@: a team for Fulbito. `sh test.sh` plays it against `idle`, and

    fulbito match "cmd:python3 team.py" classic --view

shows it. Units are SI. Your own goal is at -x, whatever the colour.
"""

import math
from typing import Optional

from fulbito_team import Commands, GoTo, Observation, Parameter, Team, run


class MyTeam(Team):
    name = "@NAME@"
    version = "1.0"
    default_navigator = "univector"
    # Users set it: "cmd:python3 team.py :margin=0.05"
    parameters = {"margin": Parameter(0.03, 0.0, 0.3, "[m] how far behind the ball the attacker starts its run")}

    def decide(self, seen: Observation) -> Commands:
        commands = Commands()
        attacker = self.nearest_to_ball(seen)
        for number, robot in enumerate(seen.own):
            if robot is None:
                continue
            if number == 0:
                self.keep(seen, commands)
            elif number == attacker:
                self.attack(seen, number, commands)
            else:
                self.support(seen, number, commands)
        return commands

    def nearest_to_ball(self, seen: Observation) -> Optional[int]:
        """The robot nearest to the ball, without the keeper (robot 0)."""
        distances = [(math.hypot(robot.x - seen.ball.x, robot.y - seen.ball.y), number)
                     for number, robot in enumerate(seen.own) if robot is not None and number > 0]
        return min(distances)[1] if distances else None

    def keep(self, seen: Observation, commands: Commands) -> None:
        """The keeper stays on a line in front of the goal, level with the ball."""
        field = self.info.field
        reach = field.goal_width / 2
        y = max(-reach, min(reach, seen.ball.y))
        commands.go_to(0, GoTo(-field.length / 2 + self.info.robot.length, y, stop=True, avoid_mates=False,
                               avoid_opponents=False))

    def attack(self, seen: Observation, number: int, commands: Commands) -> None:
        """The attacker drives behind the ball first, then through it toward the goal."""
        robot, ball = seen.own[number], seen.ball
        assert robot is not None
        goal_x, goal_y = self.info.field.length / 2, 0.0
        far = max(math.hypot(goal_x - ball.x, goal_y - ball.y), 1e-6)
        way_x, way_y = (goal_x - ball.x) / far, (goal_y - ball.y) / far
        dx, dy = ball.x - robot.x, ball.y - robot.y
        behind = dx * way_x + dy * way_y  # [m] along the direction to the goal
        beside = abs(dx * way_y - dy * way_x)  # [m] off that line
        heading = math.atan2(way_y, way_x)
        if behind > 0.0 and beside < self.info.robot.width / 2:
            target = GoTo(ball.x + 0.2 * way_x, ball.y + 0.2 * way_y, heading)
        else:
            back = self.info.robot.length + self.settings["margin"]
            target = GoTo(ball.x - back * way_x, ball.y - back * way_y, heading, avoid_ball=True)
        target.avoid_opponents = False
        commands.go_to(number, target)
        if seen.wants_drawings:
            commands.line(ball.x, ball.y, goal_x, goal_y)

    def support(self, seen: Observation, number: int, commands: Commands) -> None:
        """The supporter stays behind the ball on the other side, in case the attacker loses it."""
        commands.go_to(number, GoTo(seen.ball.x - 0.35, -seen.ball.y / 2, stop=True, avoid_ball=True))


if __name__ == "__main__":
    run(MyTeam())
