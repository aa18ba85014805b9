"""rovers: the team at the end of docs/write-a-team.md. It comes near to `classic`.

    fulbito match "cmd:python3 examples/teams/rovers.py" classic -n 10 --half-seconds 60

Units are SI. The team's own goal is at -x, whatever the colour.
"""

import math
from typing import List, Optional, Tuple

from fulbito_team import (
    Commands, GoTo, MatchInfo, Observation, Opponent, Parameter, Placement, PlacementRequest, Pose, Robot, Team, Twist, run)

KEEPER, ATTACKER, SUPPORTER = 1, 2, 3
NAMES = {KEEPER: "keeper", ATTACKER: "attacker", SUPPORTER: "supporter"}


def clamp(value: float, most: float) -> float:
    return max(-most, min(most, value))


def wrap(angle: float) -> float:
    return math.remainder(angle, 2.0 * math.pi)


class Rovers(Team):
    name = "rovers"
    version = "1.0"
    default_navigator = "univector:follower=classic"
    parameters = {"margin": Parameter(0.03, 0.0, 0.3, "[m] how far behind the ball the attacker starts its run")}

    def begin(self, info: MatchInfo) -> None:
        self.attacker = 1
        self.lined_up = False
        self.still = [0.0] * info.team_size  # [s] how long each robot has not moved
        self.free = [0.0] * info.team_size  # [s] how long each still backs off

    # ---- Where things will be ----------------------------------------------------------------------------

    def ball_at(self, seen: Observation, time: float) -> Tuple[float, float]:
        """The ball after a time [s], slowed by rolling, inside the walls."""
        ball, model, field = seen.ball, self.info.ball, self.info.field
        speed = math.hypot(ball.vx, ball.vy)
        if speed > 0.0:
            rolling = min(time, speed / max(model.roll_deceleration, 1e-6))
            time = rolling - model.roll_deceleration * rolling * rolling / (2.0 * speed)
        return (clamp(ball.x + ball.vx * time, field.length / 2 - model.radius),
                clamp(ball.y + ball.vy * time, field.width / 2 - model.radius))

    def meeting(self, seen: Observation, robot: Robot) -> Tuple[float, float, float]:
        """When [s] and where the robot can be at the ball."""
        time, step = 0.0, 0.05
        while True:
            x, y = self.ball_at(seen, time)
            if self.time_to(robot.x, robot.y, robot.heading, x, y) <= time or time > 2.0:
                return time, x, y
            time += step

    def time_to(self, x: float, y: float, heading: float, to_x: float, to_y: float) -> float:
        """A turn of the nearer end, then the way at top speed [s]."""
        turn = abs(wrap(math.atan2(to_y - y, to_x - x) - heading))
        turn = min(turn, math.pi - turn)
        way = max(0.0, math.hypot(to_x - x, to_y - y) - self.info.robot.length / 2 - self.info.ball.radius)
        return way / self.info.robot.max_speed + 0.1 * turn

    # ---- The whole team ----------------------------------------------------------------------------------

    def decide(self, seen: Observation) -> Commands:
        commands = Commands()
        if not seen.playing:
            self.lined_up = False
        self.choose_attacker(seen)
        for number, robot in enumerate(seen.own):
            if robot is None:
                continue
            if number == 0:
                commands.roles[number] = KEEPER
                self.keep(seen, robot, commands)
            elif number == self.attacker:
                commands.roles[number] = ATTACKER
                self.attack(seen, number, robot, commands)
            else:
                commands.roles[number] = SUPPORTER
                self.support(seen, number, commands)
            self.unstick(seen, number, robot, commands)
            if seen.wants_drawings:
                commands.text(robot.x, robot.y - self.info.robot.length, NAMES[commands.roles[number]])
        return commands

    def choose_attacker(self, seen: Observation) -> None:
        """The field player that is first at the ball. One in front of the ball has to go round it; a change must
        pay, or two robots would take turns at hesitating."""
        best, least = self.attacker, math.inf
        for number, robot in enumerate(seen.own):
            if robot is None or number == 0:
                continue
            time, x, _ = self.meeting(seen, robot)
            cost = time + (0.5 if robot.x > x else 0.0) - (0.2 if number == self.attacker else 0.0)
            if cost < least:
                best, least = number, cost
        if best != self.attacker:
            self.attacker, self.lined_up = best, False

    def drive(self, robot: Robot, x: float, y: float, speed: float) -> Twist:
        """Straight at a place, with whichever end is nearer, slower the less it faces it."""
        error = wrap(math.atan2(y - robot.y, x - robot.x) - robot.heading)
        if abs(error) > math.pi / 2:
            error, speed = wrap(error + math.pi), -speed
        return Twist(speed * max(0.0, math.cos(error)), 10.0 * error)

    def unstick(self, seen: Observation, number: int, robot: Robot, commands: Commands) -> None:
        """A robot that has not moved for half a second although it was told to backs off for a moment."""
        command = commands.robots.get(number)
        meant = isinstance(command, Twist) and abs(command.linear) > 0.1 or (
            isinstance(command, GoTo) and math.hypot(command.x - robot.x, command.y - robot.y) > 0.1)
        slow = math.hypot(robot.vx, robot.vy) < 0.05 and abs(robot.omega) < 1.0
        self.still[number] = self.still[number] + seen.dt if seen.playing and meant and slow else 0.0
        if self.still[number] > 0.5:
            self.still[number], self.free[number] = 0.0, 0.25
        if self.free[number] > 0.0:
            self.free[number] -= seen.dt
            back = -1.0 if robot.left + robot.right >= 0.0 and robot.sent_left + robot.sent_right >= 0.0 else 1.0
            commands.twist(number, 0.6 * back, 4.0)

    # ---- Roles -------------------------------------------------------------------------------------------

    def keep(self, seen: Observation, robot: Robot, commands: Commands) -> None:
        """On a line in front of the goal, where the ball will cross it; out to a slow ball in the area."""
        field, ball, top = self.info.field, seen.ball, self.info.robot.max_speed
        line = -field.length / 2 + self.info.robot.length + self.info.ball.radius
        slow = math.hypot(ball.vx, ball.vy) < 0.3
        in_front = ball.x > robot.x + 0.02
        if slow and in_front and self.in_area(-ball.x, ball.y) and self.first_at_ball(seen, robot, 0.1):
            if self.touches(robot, ball.x, ball.y) and self.at_wall(ball.x, ball.y):
                commands.robots[0] = self.spin(robot, ball.x, ball.y, 0.5, math.copysign(1.0, ball.y))
            else:
                commands.robots[0] = self.drive(robot, ball.x, ball.y, top)
            return
        y = clamp(self.crossing(seen, line), field.goal_width / 2 - 0.02)
        if abs(line - robot.x) > 0.06:
            commands.go_to(0, GoTo(line, y, math.pi / 2, stop=True))
            return
        # Sideways along the line: a lean leads back onto it, and a turn comes before the way.
        up = 1.0 if math.sin(robot.heading) >= 0.0 else -1.0
        off = y - robot.y
        lean = clamp(6.0 * (line - robot.x), 0.35) * math.copysign(1.0, -off) if abs(off) > 0.01 else 0.0
        error = wrap(up * math.pi / 2 + lean - robot.heading)
        speed = up * clamp(9.0 * off, top) if abs(error) < 0.6 else 0.0
        commands.twist(0, speed, 8.0 * error)

    def crossing(self, seen: Observation, line: float) -> float:
        """Where the ball will pass the keeper's line; otherwise the place with equal gaps to both posts."""
        field, ball = self.info.field, seen.ball
        for step in range(1, 41):
            x, y = self.ball_at(seen, 0.05 * step)
            if x <= line < ball.x:
                # On the straight way to that place.
                y = ball.y + (y - ball.y) * (ball.x - line) / (ball.x - x)
                if abs(y) < field.goal_width / 2 + 0.05:
                    return y
                break
        back = ball.x + field.length / 2
        left, right = math.atan2(field.goal_width / 2 - ball.y, back), math.atan2(-field.goal_width / 2 - ball.y, back)
        return ball.y + (ball.x - line) * math.tan((left + right) / 2)

    def attack(self, seen: Observation, number: int, robot: Robot, commands: Commands) -> None:
        """Behind the ball first, then through it toward the goal."""
        field, size, ball = self.info.field, self.info.robot.length, seen.ball
        time, x, y = self.meeting(seen, robot)
        if self.in_area(-x, y) and seen.own[0] is not None:
            # The keeper's ball: a second defender in the area costs a penalty.
            commands.go_to(number, GoTo(-field.length / 2 + field.goal_area_depth + 0.12, y))
            return
        if self.in_area(ball.x, ball.y) and any(o and self.touches(o, ball.x, ball.y) for o in seen.opponents):
            # To charge a keeper in its area is a foul: wait where the ball may come out.
            commands.go_to(number, GoTo(field.length / 2 - 0.35, -math.copysign(0.2, ball.y)))
            return
        if self.touches(robot, ball.x, ball.y) and self.at_wall(ball.x, ball.y):
            commands.robots[number] = self.spin(robot, ball.x, ball.y, 1.0, -math.copysign(0.3, ball.y))
            return
        way_x, way_y = self.shot(seen, x, y)
        to_x, to_y = ball.x - robot.x, ball.y - robot.y
        behind, beside = to_x * way_x + to_y * way_y, abs(to_x * way_y - to_y * way_x)
        self.lined_up = behind > 0.0 and beside < (size if self.lined_up else size / 2)
        target = GoTo(x - (size + self.settings["margin"]) * way_x, y - (size + self.settings["margin"]) * way_y,
                            math.atan2(way_y, way_x), avoid_ball=behind < 0.0)
        if self.lined_up:
            commands.robots[number] = self.drive(robot, ball.x + 0.2 * way_x, ball.y + 0.2 * way_y,
                                                 self.info.robot.max_speed)
        elif to_x > 0.02 and not self.first_at_ball(seen, robot, 0.2):
            # An opponent is there before the run could begin: meet the ball straight, as long as it goes upfield.
            commands.robots[number] = self.drive(robot, x + 0.1, y, self.info.robot.max_speed)
        else:
            close = math.hypot(to_x, to_y) < 0.25
            target.avoid_opponents = target.avoid_mates = not close
            target.x = clamp(target.x, field.length / 2 - 0.04)
            target.y = clamp(target.y, field.width / 2 - 0.04)
            commands.go_to(number, target)
        if seen.wants_drawings:
            commands.line(x, y, x + 0.3 * way_x, y + 0.3 * way_y)
            commands.circle(x, y, 0.03)

    def support(self, seen: Observation, number: int, commands: Commands) -> None:
        """Between ball and goal in the own half; behind the ball and nearer the middle in the other."""
        field = self.info.field
        x, y = self.ball_at(seen, 0.3)
        edge = -field.length / 2 + field.goal_area_depth + 0.12
        if x < 0.0:
            share = 0.5
            goal = -field.length / 2
            place = (max(edge, goal + share * (x - goal)), y * share)
        else:
            place = (min(x - 0.3, field.length / 2 - field.goal_area_depth - 0.2),
                     clamp(y - math.copysign(0.15, y), field.width / 2 - 0.2))
        if seen.own[0] is None:
            place = (edge - 0.1, clamp(y, field.goal_width / 2))
        commands.go_to(number, GoTo(place[0], place[1], stop=True, avoid_ball=True))

    def shot(self, seen: Observation, x: float, y: float) -> Tuple[float, float]:
        """The unit way on which the ball shall go: at the widest free part of the goal."""
        field = self.info.field
        goal_x, aim, widest = field.length / 2, 0.0, -1.0
        if field.width / 2 - abs(y) < self.info.ball.radius + 0.03:
            return 1.0, 0.0
        for share in (-0.7, -0.35, 0.0, 0.35, 0.7):
            goal_y = share * field.goal_width / 2
            far = math.hypot(goal_x - x, goal_y - y)
            gap = 0.15 - 0.02 * abs(share)
            for opponent in seen.opponents:
                if opponent is None or opponent.x < x:
                    continue
                along = ((opponent.x - x) * (goal_x - x) + (opponent.y - y) * (goal_y - y)) / max(far, 1e-6)
                off = abs((opponent.x - x) * (goal_y - y) - (opponent.y - y) * (goal_x - x)) / max(far, 1e-6)
                if 0.0 < along < far + 0.05:
                    gap = min(gap, off)
            if gap > widest:
                aim, widest = goal_y, gap
        far = max(math.hypot(goal_x - x, aim - y), 1e-6)
        return (goal_x - x) / far, (aim - y) / far

    def touches(self, robot: Opponent, x: float, y: float) -> bool:
        return math.hypot(x - robot.x, y - robot.y) < self.info.robot.length / 2 + self.info.ball.radius + 0.02

    def at_wall(self, x: float, y: float) -> bool:
        """No robot gets between ball and wall."""
        field, room = self.info.field, self.info.ball.radius + 0.05
        return field.width / 2 - abs(y) < room or (
            field.length / 2 - abs(x) < room and abs(y) > field.goal_width / 2)

    def spin(self, robot: Robot, x: float, y: float, way_x: float, way_y: float) -> Twist:
        """Turns on the spot, so that the ball leaves along the way."""
        return Twist(0.0, math.copysign(30.0, (x - robot.x) * way_y - (y - robot.y) * way_x))

    def first_at_ball(self, seen: Observation, robot: Robot, lead: float) -> bool:
        mine = self.time_to(robot.x, robot.y, robot.heading, seen.ball.x, seen.ball.y)
        return all(o is None or self.time_to(o.x, o.y, o.heading, seen.ball.x, seen.ball.y) > mine + lead
                   for o in seen.opponents)

    def in_area(self, x: float, y: float) -> bool:
        """Whether a place lies in the goal area at +x; with -x it asks for the own one."""
        field = self.info.field
        return x > field.length / 2 - field.goal_area_depth and abs(y) < field.goal_area_width / 2

    # ---- Restarts ----------------------------------------------------------------------------------------

    def place(self, request: PlacementRequest) -> Optional[Placement]:
        """Kick-offs and penalties at an angle, past whoever waits on the straight line."""
        if not request.ours or request.kind not in ("kick-off", "penalty"):
            return None
        taker: Optional[int] = None
        least = math.inf
        for number, pose in enumerate(request.defaults):
            if pose is None:
                continue
            far = math.hypot(pose.x - request.ball.x, pose.y - request.ball.y)
            if far < least:
                taker, least = number, far
        if taker is None:
            return None
        angle = 0.35 if request.kind == "penalty" else 0.6
        return Placement({taker: Pose(request.ball.x - least * math.cos(angle),
                                      request.ball.y - least * math.sin(angle), angle)})


if __name__ == "__main__":
    run(Rovers())
