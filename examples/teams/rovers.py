"""rovers: the team at the end of docs/write-a-team.md. It beats `classic`.

    fulbito match "cmd:python3 examples/teams/rovers.py" classic -n 10 --half-seconds 60

Units are SI, and a way is the angle [rad] of a direction. The team's own goal is always at -x.
"""

import math
from typing import List, Optional, Tuple

from fulbito_team import (
    Command, Commands, GoTo, MatchInfo, Observation, Opponent, Parameter, Placement, PlacementRequest, Point, Pose,
    Robot, Team, Twist, run)

KEEPER, ATTACKER, SUPPORTER = 1, 2, 3
NAMES = {KEEPER: "keeper", ATTACKER: "attacker", SUPPORTER: "supporter"}


def clamp(value: float, most: float) -> float:
    return max(-most, min(most, value))


def wrap(angle: float) -> float:
    return math.remainder(angle, 2.0 * math.pi)


def sign(value: float) -> float:
    return math.copysign(1.0, value)


def turned(x: float, y: float, way: float) -> Tuple[float, float]:
    """The components of a vector along a way, and to its left."""
    c, s = math.cos(way), math.sin(way)
    return x * c + y * s, y * c - x * s


class Rovers(Team):
    name = "rovers"
    version = "2.0"
    default_navigator = "univector:follower=classic"
    parameters = {"round": Parameter(0.09, 0.06, 0.2, "[m] circle on which the attacker comes round the ball")}

    def begin(self, info: MatchInfo) -> None:
        self.attacker = min(1, info.team_size - 1)
        self.still = [0.0] * info.team_size  # [s] time for which each robot has stood still
        self.free = [0.0] * info.team_size  # [s] remaining time for which each robot frees itself
        self.untouched = [0.0] * info.team_size  # [s] time since each robot touched the ball
        self.half_length, self.half_width = info.field.length / 2, info.field.width / 2
        self.post, self.radius = info.field.goal_width / 2, info.ball.radius
        self.half, self.corner = info.robot.length / 2, math.hypot(info.robot.length, info.robot.width) / 2
        self.top, self.pace = info.robot.max_speed, info.robot.wheel_acceleration

    # ---- Predictions -------------------------------------------------------------------------------------

    def inside(self, x: float, y: float, room: float) -> Tuple[float, float]:
        """The nearest place at least `room` [m] away from the walls and the cut corners."""
        x, y = clamp(x, self.half_length - room), clamp(y, self.half_width - room)
        limit = self.half_length + self.half_width - self.info.field.corner - math.sqrt(2.0) * room
        over = max(0.0, abs(x) + abs(y) - limit) / 2
        return x - over * sign(x), y - over * sign(y)

    def ball_at(self, seen: Observation, time: float) -> Tuple[float, float]:
        """The place of the ball after a time [s]: rolling slows it down, and walls stop it."""
        ball, slowing = seen.ball, max(self.info.ball.roll_deceleration, 1e-6)
        speed = math.hypot(ball.vx, ball.vy)
        if speed > 0.0:
            rolling = min(time, speed / slowing)
            time = rolling - slowing * rolling * rolling / (2.0 * speed)
        return self.inside(ball.x + ball.vx * time, ball.y + ball.vy * time, self.radius)

    def time_to(self, robot: Opponent, x: float, y: float) -> float:
        """Time [s] to turn the nearer end toward a place and to drive there, starting at the present speed."""
        dx, dy = x - robot.x, y - robot.y
        far = max(1e-6, math.hypot(dx, dy))
        turn = abs(wrap(math.atan2(dy, dx) - robot.heading))
        turn = min(turn, math.pi - turn) * min(1.0, far / self.half)
        time = 1.4 * math.sqrt(turn * self.info.robot.axle_track / (2.0 * self.pace))
        speed = min(self.top, (robot.vx * dx + robot.vy * dy) / far)
        if speed < 0.0:
            time, far, speed = time - speed / self.pace, far + speed * speed / (2.0 * self.pace), 0.0
        ramp = (self.top * self.top - speed * speed) / (2.0 * self.pace)
        reached = math.sqrt(speed * speed + 2.0 * self.pace * min(far, ramp))
        return time + (reached - speed) / self.pace + max(0.0, far - ramp) / self.top

    def meeting(self, seen: Observation, robot: Robot) -> Tuple[float, float, float]:
        """Time [s] and place at which the robot can first be behind the ball. Half steps never jump over it."""
        time = 0.0
        while True:
            x, y = self.ball_at(seen, time)
            back = self.half / math.hypot(self.half_length - x, y)
            needed = self.time_to(robot, x - back * (self.half_length - x), y + back * y)
            if needed <= time or time > 2.0:
                return max(time, needed), x, y
            time += max(seen.dt, 0.5 * (needed - time))

    # ---- The whole team ----------------------------------------------------------------------------------

    def decide(self, seen: Observation) -> Commands:
        commands = Commands()
        self.choose_attacker(seen)
        for number, robot in enumerate(seen.own):
            if robot is None:
                continue
            if number == 0:
                role, command = KEEPER, self.keep(seen, robot)
            elif number == self.attacker and not self.is_keepers(seen):
                role, command = ATTACKER, self.attack(seen, robot, commands)
            else:
                role, command = SUPPORTER, self.support(seen, number)
            if number != 0:
                command = self.unstuck(seen, number, robot, command)
                command = self.legal(seen, number, robot, command)
            commands.robots[number], commands.roles[number] = command, role
            if seen.wants_drawings:
                commands.text(robot.x, robot.y - self.info.robot.length, NAMES[role])
        return commands

    def choose_attacker(self, seen: Observation) -> None:
        """Chooses the field player that is first behind the ball. One in front of the ball has to drive round it. The
        present attacker has an advantage, because two robots that take turns lose time."""
        best, least = self.attacker, math.inf
        for number, robot in enumerate(seen.own):
            if robot is None or number == 0:
                continue
            cost, x, _ = self.meeting(seen, robot)
            cost += (0.3 if robot.x > x else 0.0) - (0.2 if seen.playing and number == self.attacker else 0.0)
            if cost < least:
                best, least = number, cost
        self.attacker = best

    def is_keepers(self, seen: Observation) -> bool:
        """Whether the ball will soon be in the own goal area, where only the keeper may play."""
        x, y = self.ball_at(seen, 0.3)
        return seen.own[0] is not None and self.in_area(-x, y, self.corner)

    def drive(self, robot: Robot, way: float, speed: float) -> Twist:
        """Drives along a way with the nearer end, slower while it points elsewhere. A moving robot rather keeps its end."""
        error = wrap(way - robot.heading)
        forward, _ = turned(robot.vx, robot.vy, robot.heading)
        if abs(error) > math.pi / 2 + clamp(forward, 0.3):
            error, speed = wrap(error + math.pi), -speed
        return Twist(speed * max(0.0, math.cos(error)) ** 2, clamp(16.0 * error, 24.0))

    def drive_to(self, robot: Robot, x: float, y: float) -> Twist:
        return self.drive(robot, math.atan2(y - robot.y, x - robot.x), self.top)

    def unstuck(self, seen: Observation, number: int, robot: Robot, command: Command) -> Command:
        """Lets a stuck robot drive away for a moment, but not from a ball that is far from the opponents' goal."""
        meant = not isinstance(command, GoTo) or math.hypot(command.x - robot.x, command.y - robot.y) > 0.1
        slow = math.hypot(robot.vx, robot.vy) < 0.1 and abs(robot.omega) < 1.0
        self.still[number] = self.still[number] + seen.dt if seen.playing and meant and slow else 0.0
        if self.still[number] > 0.35 and (seen.ball.x > self.half_length / 2 or not self.touches(robot, seen)):
            self.still[number], self.free[number] = 0.0, 0.3
        self.free[number] -= seen.dt
        to_middle, _ = turned(-robot.x, -robot.y, robot.heading)
        return Twist(0.5 * sign(to_middle), 4.0) if self.free[number] > 0.0 else command

    # ---- Keeper ------------------------------------------------------------------------------------------

    def keep(self, seen: Observation, robot: Robot) -> Command:
        """Drives out to a ball that it reaches first, or along the end wall, or to where the ball will cross its line."""
        line = -self.half_length + self.half + 0.005
        if self.comes_out(seen, robot):
            return self.drive_to(robot, *self.ball_at(seen, 0.1))
        if self.meets_along_wall(seen, robot):
            return self.drive_to(robot, line, seen.ball.y + 0.1 * sign(seen.ball.y))
        # Drives along the line, slowly enough to stop in time, and leans toward the line if it is off it.
        off_x, off_y = line - robot.x, clamp(self.crossing(seen, line), self.post - self.radius) - robot.y
        if abs(off_x) > 0.06 or abs(off_y) > 2.0 * self.post:
            return GoTo(line, robot.y + off_y, math.pi / 2, stop=True)
        speed = min(self.top, math.sqrt(1.6 * self.pace * abs(off_y)), 20.0 * abs(off_y))
        lean = clamp(6.0 * off_x, 0.4) * min(1.0, speed / 0.2)
        return self.drive(robot, math.pi / 2 - lean * sign(off_y), speed * sign(off_y))

    def comes_out(self, seen: Observation, robot: Robot) -> bool:
        """Whether the keeper leaves its line: at a penalty, and for a slow ball that no opponent reaches first."""
        ball = seen.ball
        if seen.restart == "penalty" and not seen.restart_is_ours and seen.since_restart < 0.8:
            return True
        x, y = self.ball_at(seen, 0.1)
        if math.hypot(ball.vx, ball.vy) > 0.5 or ball.x < robot.x + 0.02 or not self.in_area(-x, y, self.corner):
            return False
        mine = self.time_to(robot, ball.x, ball.y)
        return all(other is None or self.time_to(other, ball.x, ball.y) > mine for other in seen.opponents)

    def meets_along_wall(self, seen: Observation, robot: Robot) -> bool:
        """Whether the ball is at the end wall, or rolls along it, and the keeper stands between it and the goal."""
        ball, side = seen.ball, sign(seen.ball.y)
        return (ball.x < -self.half_length + self.radius + 0.04 and self.post < abs(ball.y) < 2.75 * self.post
                and -ball.vy * side < self.top and robot.x < -self.half_length + 2.4 * self.half
                and robot.y * side < abs(ball.y) - 0.03)

    def crossing(self, seen: Observation, line: float) -> float:
        """The y at which the ball will cross the keeper's line; otherwise the y that covers both posts equally."""
        ball, front = seen.ball, line + self.radius
        for step in range(1, 41):
            x, y = self.ball_at(seen, 0.03 * step)
            if x <= front < ball.x:
                # Interpolates on the straight line to that place.
                y = ball.y + (y - ball.y) * (ball.x - front) / (ball.x - x)
                if abs(y) < self.post + 0.05:
                    return y
                break
        back = max(0.01, ball.x + self.half_length)
        left, right = math.atan2(self.post - ball.y, back), math.atan2(-self.post - ball.y, back)
        return ball.y + (ball.x - line) * math.tan((left + right) / 2)

    # ---- Attacker ----------------------------------------------------------------------------------------

    def attack(self, seen: Observation, robot: Robot, commands: Commands) -> Command:
        """Drives round the ball, then through it toward the goal, or along the wall if the ball is at one."""
        ball = seen.ball
        if self.rushes(seen):
            return self.drive_to(robot, ball.x, ball.y)
        _, x, y = self.meeting(seen, robot)
        if self.touches(robot, seen):
            x, y = ball.x + 0.03 * ball.vx, ball.y + 0.03 * ball.vy
        along = self.along_wall(x, y)
        if along is None:
            way = self.blow(seen, self.shot(seen, x, y))
        else:
            way, (x, y) = along, self.inside(x, y, self.half + 0.003)
        if seen.wants_drawings:
            commands.line(x, y, x + 0.3 * math.cos(way), y + 0.3 * math.sin(way))
            commands.circle(x, y, 0.03)
        return self.strike(robot, x, y, way)

    def rushes(self, seen: Observation) -> bool:
        """Whether a restart was just now, when touching the ball first matters more than its direction."""
        until = {"kick-off": 0.4, "free-ball": 1.0, "penalty": 0.5 if seen.restart_is_ours else 0.0}
        return seen.since_restart < until.get(seen.restart, 0.0)

    def shot(self, seen: Observation, x: float, y: float) -> float:
        """The way to a free part of the goal, preferably a wide one and near the middle."""
        aim, best = 0.0, -math.inf
        for share in (0.0, -0.33, 0.33, -0.67, 0.67, -1.0, 1.0):
            goal_y = share * (self.post - self.radius - 0.015)
            way = math.atan2(goal_y - y, self.half_length - x)
            free = 0.10
            for opponent in seen.opponents:
                if opponent is not None and x < opponent.x:
                    _, aside = turned(opponent.x - x, opponent.y - y, way)
                    free = min(free, abs(aside) - self.half - self.radius)
            if free - 0.06 * abs(goal_y) > best:
                aim, best = way, free - 0.06 * abs(goal_y)
        return aim

    def along_wall(self, x: float, y: float) -> Optional[float]:
        """The way to push a ball at a wall: forward along it and slightly into it, so that the ball stays there."""
        in_x, in_y = self.inside(x, y, self.radius + 0.03)
        if abs(y) < self.post or (in_x == x and in_y == y):
            return None
        off_wall = math.atan2(in_y - y, in_x - x)
        _, left = turned(1.0, -sign(x * y), off_wall)
        return off_wall + (math.pi / 2 + 0.15) * sign(left)

    def blow(self, seen: Observation, way: float) -> float:
        """The way to strike a rolling ball so that it leaves along `way`: the blow stops its sideways speed."""
        along, across = turned(seen.ball.vx, seen.ball.vy, way)
        return way - math.atan2(across, max(0.7 * self.top, 1.1 * self.top - along))

    def strike(self, robot: Robot, x: float, y: float, way: float) -> Twist:
        """Drives through a place in the direction `way`: first on a circle round it, then on the line through it."""
        here_x, here_y = robot.x + 0.045 * robot.vx, robot.y + 0.045 * robot.vy
        behind, left = turned(x - here_x, y - here_y, way)
        if behind < 0.03 or abs(left) > 0.35 * behind:
            far, circle = math.hypot(behind, left), float(self.settings["round"])
            off = math.atan2(left, behind)
            most = math.asin(circle / far) if far > circle else math.pi / 2 + 1.5 * (1.0 - far / circle)
            return self.drive(robot, way + off + clamp(2.7 * off, most), self.top)
        # Slow enough to be on the line and to face along it when it touches the ball.
        gap = max(0.0, behind - self.half - self.radius)
        skew = abs(math.remainder(way - robot.heading, math.pi))
        speed = min(self.top, 0.5 + (gap + 0.025) / max(skew / 8.0 + abs(left) / 0.35, 0.01))
        return self.drive(robot, way + math.atan2(left, max(0.045, 0.5 * gap)), speed)

    # ---- Supporter ---------------------------------------------------------------------------------------

    def support(self, seen: Observation, number: int) -> GoTo:
        """Stays between ball and goal in the own half, waits for rebounds in the other, and avoids the keeper."""
        field, (x, y) = self.info.field, self.ball_at(seen, 0.15)
        edge = -self.half_length + field.goal_area_depth + field.goal_area_arc_depth + 0.09
        if self.is_keepers(seen):
            x, y = edge + 0.2, 0.4 * sign(y if number == self.attacker else -y)
        elif x > 0.15:
            x, y = min(x - 0.2, self.half_length - 0.35), -0.18 * sign(y)
        else:
            back = max(edge, x - 0.35)
            y *= clamp((back + self.half_length) / max(0.05, x + self.half_length), 1.0)
            x, y = back, clamp(y, 0.25 if x < edge + 0.1 else self.half_width - 0.06)
        return GoTo(x, y, stop=True, avoid_ball=True)

    # ---- Rules -------------------------------------------------------------------------------------------

    def legal(self, seen: Observation, number: int, robot: Robot, command: Command) -> Command:
        """Turns a robot away from a foul while it can still brake in time."""
        self.untouched[number] = 0.0 if self.touches(robot, seen) else self.untouched[number] + seen.dt
        time = seen.dt + math.hypot(robot.vx, robot.vy) / (2.0 * self.pace)
        x, y = robot.x + robot.vx * time, robot.y + robot.vy * time
        if seen.own[0] is not None and self.in_area(-x, y, 0.015):
            return self.drive(robot, 0.0, self.top)
        if self.in_area(x, y, self.corner) and not self.may_enter(seen, number, robot):
            return self.drive(robot, math.pi, self.top)
        for other in seen.opponents:
            if (other is not None and self.untouched[number] > 0.15 and self.in_area(other.x, other.y)
                    and math.hypot(other.x - x, other.y - y) < 3.0 * self.half):
                return self.round_keeper(seen, robot, other)
        return command

    def may_enter(self, seen: Observation, number: int, robot: Robot) -> bool:
        """Whether a robot may enter the opponents' area: only the attacker, and only if no team-mate is there."""
        mates = [mate for mate in seen.own if mate is not None and mate is not robot]
        return number == self.attacker and (
            self.in_area(robot.x, robot.y, self.corner)
            or not any(self.in_area(mate.x, mate.y, self.corner) for mate in mates))

    def round_keeper(self, seen: Observation, robot: Robot, keeper: Opponent) -> Twist:
        """Drives round the keeper on the side of the ball, or away from the goal, because charging it is a foul."""
        off = math.atan2(robot.y - keeper.y, robot.x - keeper.x)
        x, y = (0.0, 0.0) if robot.x > self.half_length - self.corner else (seen.ball.x, seen.ball.y)
        _, left = turned(x - robot.x, y - robot.y, off)
        return self.drive(robot, off + 1.2 * sign(left), self.top)

    def touches(self, robot: Opponent, seen: Observation) -> bool:
        """Whether the ball touches the robot's outline."""
        ahead, aside = turned(seen.ball.x - robot.x, seen.ball.y - robot.y, robot.heading)
        return math.hypot(max(0.0, abs(ahead) - self.half), max(0.0, abs(aside) - self.half)) < self.radius + 0.005

    def in_area(self, x: float, y: float, margin: float = 0.0) -> bool:
        """Whether a place is at most `margin` [m] outside the goal area at +x. For the own area, pass -x."""
        field = self.info.field
        arc = field.goal_area_arc_depth if abs(y) < field.goal_area_arc_width / 2 else 0.0
        return (x > self.half_length - field.goal_area_depth - arc - margin
                and abs(y) < field.goal_area_width / 2 + margin)

    # ---- Restarts ----------------------------------------------------------------------------------------

    def place(self, request: PlacementRequest) -> Optional[Placement]:
        """Takes kick-offs and penalties at an angle, past opponents on the straight line."""
        if request.kind == "kick-off" and not request.ours:
            return self.await_kick_off(request)
        taker = self.nearest(request.defaults, request.ball)
        if taker is None or not request.ours or request.kind not in ("kick-off", "penalty"):
            return None
        angle, back = (0.1, 0.3) if request.kind == "penalty" else (0.6, 0.085)
        x, y = request.ball.x - back * math.cos(angle), request.ball.y - back * math.sin(angle)
        return Placement({taker: Pose(x, y, angle)})

    def await_kick_off(self, request: PlacementRequest) -> Placement:
        """Puts a robot on each side of the line along which the taker will kick, as its position shows."""
        number = self.nearest(request.opponents or [], request.ball)
        taker = request.opponents[number] if request.opponents and number is not None else None
        line = math.atan2(taker.y, taker.x) if taker is not None else 0.0
        circle, places = self.info.field.centre_circle_radius + 0.001, {}
        for robot, far, turn in ((1, circle, -0.5 * sign(line)), (2, circle + 0.14, 0.87 * sign(line))):
            x, y = -far * math.cos(line + turn), -far * math.sin(line + turn)
            if robot < self.info.team_size:
                places[robot] = Pose(min(x, -self.corner), y, math.atan2(-y, -x))
        return Placement(places)

    def nearest(self, poses: List[Optional[Pose]], ball: Point) -> Optional[int]:
        """The number of the robot nearest to the ball."""
        ways = {i: math.hypot(pose.x - ball.x, pose.y - ball.y) for i, pose in enumerate(poses) if pose is not None}
        return min(ways, key=lambda i: ways[i]) if ways else None


if __name__ == "__main__":
    run(Rovers())
