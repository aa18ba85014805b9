"""A team of your own in Python: write one class and call `run`.

    from fulbito_team import Commands, Observation, Team, run

    class MyTeam(Team):
        name = "my team"

        def decide(self, seen: Observation) -> Commands:
            commands = Commands()
            for number, robot in enumerate(seen.own):
                if robot is not None:
                    commands.wheels(number, 10.0, 10.0)
            return commands

    if __name__ == "__main__":
        run(MyTeam())

Play it with `fulbito match "cmd:python3 my_team.py" classic`. This file needs Python 3.9 and its standard
library only; copy it next to your program. The protocol below it is docs/team-protocol.md.

Units are SI: m, s, rad, m/s, rad/s. Each team sees its own goal at -x. The origin is the field's centre, y
points to the left, headings are counter-clockwise, 0 along +x, in [-pi, pi). What the team prints goes to
standard error, since standard output belongs to the protocol.
"""

import dataclasses
import json
import os
import random
import sys
import traceback
from dataclasses import dataclass
from typing import Any, BinaryIO, Callable, Dict, Iterable, List, NamedTuple, Optional, Sequence, Type, TypeVar, Union

PROTOCOL = "fulbito-team/1"

_Object = Dict[str, Any]
_T = TypeVar("_T")


# ---- What the team receives ------------------------------------------------------------------------------


class Point(NamedTuple):
    """A point of the field [m]."""

    x: float
    y: float


class Pose(NamedTuple):
    """Position [m] and heading [rad]."""

    x: float
    y: float
    heading: float


class Ball:
    """The ball: position [m], velocity [m/s]."""

    __slots__ = ("x", "y", "vx", "vy")

    def __init__(self, values: _Object) -> None:
        self.x: float = values["x"]
        self.y: float = values["y"]
        self.vx: float = values["vx"]
        self.vy: float = values["vy"]


class Opponent:
    """A robot of the other team: pose [m, rad], velocity [m/s], yaw rate `omega` [rad/s]."""

    __slots__ = ("x", "y", "heading", "vx", "vy", "omega")

    def __init__(self, values: _Object) -> None:
        self.x: float = values["x"]
        self.y: float = values["y"]
        self.heading: float = values["heading"]
        self.vx: float = values["vx"]
        self.vy: float = values["vy"]
        self.omega: float = values["omega"]


class Robot(Opponent):
    """A robot of the team: also its wheels as they turn, and as they were commanded in the last tick [rad/s]."""

    __slots__ = ("left", "right", "sent_left", "sent_right")

    def __init__(self, values: _Object) -> None:
        self.x = values["x"]
        self.y = values["y"]
        self.heading = values["heading"]
        self.vx = values["vx"]
        self.vy = values["vy"]
        self.omega = values["omega"]
        self.left: float = values["left"]
        self.right: float = values["right"]
        self.sent_left: float = values["sent_left"]
        self.sent_right: float = values["sent_right"]


class Observation:
    """The game at one control tick. A robot that is not on the field is None."""

    __slots__ = ("tick", "dt", "period", "remaining", "playing", "restart", "restart_is_ours", "since_restart",
                 "own_score", "opponent_score", "wants_drawings", "ball", "own", "opponents")

    def __init__(self, values: _Object, dt: float) -> None:
        self.tick: int = values["tick"]
        """Tick of the match that it shows."""
        self.dt = dt
        """[s] Control period: time between two decisions."""
        self.period: int = values["period"]
        """1, 2: halves; 3: overtime; 4: shoot-out."""
        self.remaining: float = values["remaining"]
        """[s] Play left in the period."""
        self.playing: bool = values["playing"]
        """False while a restart waits for its signal."""
        self.restart: str = values["restart"]
        """What began this play: kick-off, free-ball, free-kick, penalty, goal-kick or given."""
        self.restart_is_ours: bool = values["restart_is_ours"]
        """The team takes it (a free ball: it attacks that half)."""
        self.since_restart: float = values["since_restart"]
        """[s] Play since the signal; negative before it."""
        self.own_score: int = values["own_score"]
        self.opponent_score: int = values["opponent_score"]
        self.wants_drawings: bool = values["wants_drawings"]
        """Somebody keeps the drawings of this tick."""
        self.ball = Ball(values["ball"])
        self.own: List[Optional[Robot]] = [Robot(v) if v is not None else None for v in values["own"]]
        """The team's robots, by number."""
        self.opponents: List[Optional[Opponent]] = [
            Opponent(v) if v is not None else None for v in values["opponents"]]
        """The other team's robots, by number."""


@dataclass
class Field:
    """The field [m]: a rectangle with two goals and corner triangles. 0: the field has no such thing."""

    name: str = ""
    length: float = 0.0
    width: float = 0.0
    goal_width: float = 0.0
    goal_depth: float = 0.0
    corner: float = 0.0
    wall_thickness: float = 0.0
    goal_area_width: float = 0.0
    goal_area_depth: float = 0.0
    goal_area_arc_width: float = 0.0
    goal_area_arc_depth: float = 0.0
    big_area_width: float = 0.0
    big_area_depth: float = 0.0
    centre_circle_radius: float = 0.0
    penalty_mark: float = 0.0
    free_ball_mark: Sequence[float] = (0.0, 0.0)


@dataclass
class RobotModel:
    """The robots of both teams: a rectangle on two wheels (docs/models.md)."""

    name: str = ""
    length: float = 0.0
    width: float = 0.0
    mass: float = 0.0
    wheel_radius: float = 0.0
    axle_track: float = 0.0
    max_wheel_speed: float = 0.0
    wheel_acceleration: float = 0.0
    wheel_braking: float = 0.0
    yaw_acceleration: float = 0.0
    rolling_drag: float = 0.0
    longitudinal_grip: float = 0.0
    lateral_grip: float = 0.0
    spin_slow_speed: float = 0.0
    spin_slow_ratio: float = 1.0
    spin_fast_speed: float = 0.0
    spin_fast_ratio: float = 1.0
    wheel_width: float = 0.0
    support_distance: float = 0.0
    support_sink: float = 0.0
    support_settling: float = 0.0
    mass_height: float = 0.0
    ground_clearance: float = 0.0
    load_shift: float = 0.0
    rim_mass: float = 0.0
    curve_widening: float = 0.0
    curve_widening_rise: float = 0.0
    friction: float = 0.0
    restitution: float = 0.0

    @property
    def max_speed(self) -> float:
        """[m/s] Largest speed straight ahead."""
        return self.max_wheel_speed * self.wheel_radius


@dataclass
class BallModel:
    """The ball (docs/models.md). After a kick it slides; then it rolls and slowly stops."""

    radius: float = 0.0
    mass: float = 0.0
    roll_keep: float = 0.0
    slide_deceleration: float = 0.0
    roll_deceleration: float = 0.0
    stop_speed: float = 0.0
    wall_restitution: float = 0.0
    wall_spin_keep: float = 0.0
    robot_restitution: float = 0.0
    friction: float = 0.0


@dataclass
class Vision:
    """What the team's observations are like."""

    age: float = 0.0
    """[s] Age of each observation."""
    position_noise: float = 0.0
    """[m] Standard deviation of positions."""
    heading_noise: float = 0.0
    """[rad] Standard deviation of headings."""
    dropout: float = 0.0
    """Probability per tick that a body is not seen."""


@dataclass
class DecisionTime:
    """Limits of the decision time, in wall time."""

    decision: float = 0.0
    """[s] Limit of each decision."""
    bank: float = 0.0
    """[s] Total time beyond it per period."""
    held: int = 0
    """Late decisions in a row for which the last command stays in force."""


@dataclass
class MatchInfo:
    """What the team knows before the match."""

    team: str = "blue"
    """The team's colour: blue or yellow."""
    side: str = "left"
    """The goal of pictures that it defends at first: left or right."""
    dt: float = 1.0 / 60.0
    """[s] Control period: time between two decisions."""
    team_size: int = 3
    """Robots per team."""
    seed: int = 0
    """Seed of `Team.random`."""
    field: Field = dataclasses.field(default_factory=Field)
    robot: RobotModel = dataclasses.field(default_factory=RobotModel)
    ball: BallModel = dataclasses.field(default_factory=BallModel)
    vision: Vision = dataclasses.field(default_factory=Vision)
    decision_time: Optional[DecisionTime] = None
    """None: no limit."""
    physics: _Object = dataclasses.field(default_factory=dict)
    """Time steps of the physics, by the keys of physics files."""
    rules: _Object = dataclasses.field(default_factory=dict)
    """The rules by the keys of rules files, such as rules["periods"]["half_seconds"]."""


@dataclass
class Call:
    """A call of the referee, with its measured value."""

    clause: str
    """Name of the rule, e.g. "goal-kick.attackers"."""
    law: str
    """Section of the rule book."""
    team: Optional[str]
    """Team that the call is against; for a goal, the scoring team."""
    robot: Optional[int]
    """The robot at fault or the scorer."""
    x: float
    """[m] The ball's place."""
    y: float
    tick: int
    period: int
    play_time: float
    """[s] Play time in the period."""
    value: float
    """Measured value, in the unit of the threshold."""
    threshold: float
    margin: float


@dataclass
class PlacementRequest:
    """The request for the team's placement at a restart."""

    kind: str
    """kick-off, free-ball, free-kick, penalty, goal-kick or given."""
    ours: bool
    """The team takes the restart."""
    delay: float
    """[s] From the placement to the signal."""
    ball: Point
    """For the other team, after the taker's choice."""
    defaults: List[Optional[Pose]]
    """Placement by the rules, by robot number."""
    opponents: Optional[List[Optional[Pose]]]
    """The other team's placement, if the rule lets it place first."""
    cause: Optional[Call]
    """The call that stopped play."""
    now: Observation
    """Score, time and all poses when play stopped."""


@dataclass
class Exercise:
    """A task of a drill for the team's first robot."""

    kind: str
    """reach-pose, turn, reach-ball, push or predict-ball."""
    x: float
    y: float
    heading: float
    speed: float
    horizon: float
    """[s] predict-ball: the ball's position that long from now."""


@dataclass
class End:
    """The notice that the match is over."""

    reason: str
    """played, abandoned or interrupted."""
    tick: int
    own_score: int
    opponent_score: int
    winner: Optional[str]
    """The winner's colour; None after a draw."""
    cause: Optional[Call]


# ---- What the team answers -------------------------------------------------------------------------------


class Wheels(NamedTuple):
    """Wheel speeds [rad/s] as given; positive drives forward."""

    left: float
    right: float


class Twist(NamedTuple):
    """Forward speed [m/s] and yaw rate [rad/s], limited so that the robot can always steer."""

    linear: float
    angular: float


@dataclass
class GoTo:
    """A place to drive to. The simulator's navigator plans the path among the other robots."""

    x: float
    y: float
    heading: Optional[float] = None
    """[rad] On arrival; None: any."""
    stop: bool = False
    """Stop at the target; otherwise pass it at speed."""
    speed_limit: Optional[float] = None
    """[m/s] Largest speed; None: no limit."""
    avoid_ball: bool = False
    avoid_mates: bool = True
    avoid_opponents: bool = True
    tolerance: float = 0.03
    """[m] Distance that counts as arrival."""
    either_front: bool = True
    """Either end may lead; False: the front leads."""
    navigator: int = 0
    """Index in the list of `Team.navigators`."""


Command = Union[Wheels, Twist, GoTo]


class Commands:
    """The team's decision for one tick. Robots without a command stand still."""

    __slots__ = ("robots", "roles", "drawings")

    def __init__(self) -> None:
        self.robots: Dict[int, Command] = {}
        """By robot number."""
        self.roles: Dict[int, int] = {}
        """A number of your choice from 1 to 255 per robot: drills count how often roles change hands."""
        self.drawings: List[str] = []
        """As JSON; see `line`, `circle` and `text`."""

    def wheels(self, number: int, left: float, right: float) -> None:
        """Wheel speeds [rad/s] for a robot."""
        self.robots[number] = Wheels(left, right)

    def twist(self, number: int, linear: float, angular: float) -> None:
        """A forward speed [m/s] and a yaw rate [rad/s] for a robot."""
        self.robots[number] = Twist(linear, angular)

    def go_to(self, number: int, target: GoTo) -> None:
        """A place to drive to for a robot, by the navigator of `Team.navigators`."""
        self.robots[number] = target

    def line(self, x1: float, y1: float, x2: float, y2: float) -> None:
        """Draws a line [m] for viewers."""
        self._draw("line", (x1, y1, x2, y2))

    def circle(self, x: float, y: float, radius: float) -> None:
        """Draws a circle [m] for viewers."""
        self._draw("circle", (x, y, radius))

    def text(self, x: float, y: float, words: str) -> None:
        """Writes words at a place [m] for viewers."""
        self._draw("text", (x, y), words)

    def _draw(self, shape: str, numbers: Iterable[float], words: Optional[str] = None) -> None:
        parts = [_number(value) for value in numbers]
        if "null" in parts:
            return
        if words is not None:
            parts.append(json.dumps(words))
        self.drawings.append('{"%s":[%s]}' % (shape, ",".join(parts)))


@dataclass
class Placement:
    """The team's wishes at a restart. The referee repairs poses that are not allowed."""

    robots: Dict[int, Pose] = dataclasses.field(default_factory=dict)
    """By robot number; the others keep the place by the rules."""
    ball: Optional[Point] = None
    """For the team's own goal kick, if the rules leave it free."""


@dataclass
class ExerciseReply:
    """The team's reply in an exercise."""

    commands: Commands = dataclasses.field(default_factory=Commands)
    """The command of its first robot."""
    answer: Point = Point(0.0, 0.0)
    """The predicted place of the ball, for predict-ball."""


@dataclass
class Parameter:
    """A parameter of a team, which users set: `cmd:python3 my_team.py :aggression=0.7`."""

    default: Union[float, int, bool, str]
    """Its type is the parameter's."""
    minimum: float = float("-inf")
    maximum: float = float("inf")
    doc: str = ""


# ---- The team --------------------------------------------------------------------------------------------


class Team:
    """A team. The simulator calls `begin` first and `ended` last. For each play it calls `place`, `ready`,
    `decide` once per tick, and `stopped`.

    For the same observations, give the same commands: use `self.random`, no clock, and no other chance.
    """

    name = "a Python team"
    version = ""
    parameters: Dict[str, Parameter] = {}
    default_navigator = ""
    """Not empty: the team takes the setting `navigator=NAME`, with this default."""

    def __init__(self) -> None:
        self.info = MatchInfo()
        """What the team knows since `begin`."""
        self.random = random.Random(0)
        """The team's random numbers: the same in each match with the same seed."""
        self.settings: Dict[str, Any] = {key: p.default for key, p in self.parameters.items()}
        """The values of the parameters."""
        self.navigator = self.default_navigator

    def begin(self, info: MatchInfo) -> None:
        """A new match begins: reset all memory."""

    def navigators(self) -> Sequence[str]:
        """Specifications of the simulator's navigators that `GoTo.navigator` indexes. Called after `begin`."""
        return [self.navigator] if self.navigator else []

    def decide(self, seen: Observation) -> Commands:
        """The decision for one control tick."""
        raise NotImplementedError("a team must define `decide`")

    def place(self, request: PlacementRequest) -> Optional[Placement]:
        """The team's placement at a restart; None: no wishes."""
        return None

    def stopped(self, cause: Optional[Call], now: Observation) -> None:
        """Play is stopped. Called before the placement requests of the restart."""

    def ready(self, now: Observation) -> None:
        """The new play is placed. Called before its first decision, with exact poses."""

    def ended(self, end: End) -> None:
        """The match is over."""

    def exercise(self, now: Observation, task: Exercise) -> Optional[ExerciseReply]:
        """One tick of an exercise; None: the team lacks the skill."""
        return None


# ---- The protocol ----------------------------------------------------------------------------------------


def _number(value: float) -> str:
    """JSON of a number; null for NaN and infinities, which JSON lacks. Takes numbers of numpy too."""
    value = float(value)
    return repr(value) if value - value == 0.0 else "null"


def _go_to(target: GoTo) -> str:
    heading = None if target.heading is None else _number(target.heading)
    limit = target.speed_limit
    # Null would mean "any heading" and "no limit": a target that is no number says so by its place.
    broken = heading == "null" or limit != limit
    text = '{"go_to":{"x":%s,"y":%s' % ("null" if broken else _number(target.x), _number(target.y))
    if heading is not None:
        text += ',"heading":%s' % heading
    if limit is not None and limit - limit == 0.0:
        text += ',"speed_limit":%s' % _number(limit)
    text += ',"tolerance":%s' % _number(target.tolerance)
    if target.stop:
        text += ',"stop":true'
    if target.avoid_ball:
        text += ',"avoid_ball":true'
    if not target.avoid_mates:
        text += ',"avoid_mates":false'
    if not target.avoid_opponents:
        text += ',"avoid_opponents":false'
    if not target.either_front:
        text += ',"either_front":false'
    if target.navigator:
        text += ',"navigator":%d' % target.navigator
    return text + "}}"


def _command(command: Optional[Command]) -> str:
    if command is None:
        return "null"
    if isinstance(command, Twist):
        return '{"linear":%s,"angular":%s}' % (_number(command.linear), _number(command.angular))
    if isinstance(command, Wheels):
        return '{"left":%s,"right":%s}' % (_number(command.left), _number(command.right))
    return _go_to(command)


def _check_numbers(numbers: Iterable[int], team_size: int, what: str) -> None:
    for number in numbers:
        if not 0 <= number < team_size:
            raise ValueError("%s for robot %r: the team's robots are 0 to %d" % (what, number, team_size - 1))


def _commands(commands: Commands, team_size: int) -> str:
    robots = commands.robots
    if len(robots) > team_size or any(not 0 <= number < team_size for number in robots):
        _check_numbers(robots, team_size, "a command")
    text = ',"robots":[%s]' % ",".join([_command(robots.get(number)) for number in range(team_size)])
    if commands.roles:
        _check_numbers(commands.roles, team_size, "a role")
        text += ',"roles":[%s]' % ",".join(["%d" % commands.roles.get(number, 0) for number in range(team_size)])
    if commands.drawings:
        text += ',"drawings":[%s]' % ",".join(commands.drawings)
    return text


def _point(name: str, point: Point) -> str:
    return ',"%s":{"x":%s,"y":%s}' % (name, _number(point[0]), _number(point[1]))


def _pose(pose: Optional[Pose]) -> str:
    if pose is None:
        return "null"
    return '{"x":%s,"y":%s,"heading":%s}' % (_number(pose[0]), _number(pose[1]), _number(pose[2]))


def _placement(placement: Optional[Placement], team_size: int) -> str:
    if placement is None:
        return ""
    _check_numbers(placement.robots, team_size, "a place")
    text = ',"poses":[%s]' % ",".join([_pose(placement.robots.get(number)) for number in range(team_size)])
    return text + (_point("ball", placement.ball) if placement.ball is not None else "")


def _known(kind: Type[_T], values: _Object) -> _T:
    """A dataclass from an object, without the members that only later versions know."""
    names = getattr(kind, "__dataclass_fields__")
    return kind(**{name: value for name, value in values.items() if name in names})


def _poses(values: Optional[List[Optional[_Object]]]) -> Optional[List[Optional[Pose]]]:
    if values is None:
        return None
    return [Pose(v["x"], v["y"], v["heading"]) if v is not None else None for v in values]


def _call(values: Optional[_Object]) -> Optional[Call]:
    return _known(Call, values) if values is not None else None


def _info(message: _Object) -> MatchInfo:
    limits = message["decision_time"]
    return MatchInfo(
        team=message["team"], side=message["side"], dt=message["dt"], team_size=message["team_size"],
        seed=int(message["seed"]), field=_known(Field, message["field"]),
        robot=_known(RobotModel, message["robot"]), ball=_known(BallModel, message["ball"]),
        vision=_known(Vision, message["vision"]), physics=message["physics"], rules=message["rules"],
        decision_time=_known(DecisionTime, limits) if limits is not None else None)


def _value(parameter: Parameter, text: str) -> Union[float, int, bool, str]:
    """The value of a parameter from its text. Raises ValueError."""
    default = parameter.default
    if isinstance(default, str):
        return text
    if isinstance(default, bool):
        if text not in ("true", "on", "1", "false", "off", "0"):
            raise ValueError("it must be true or false")
        return text in ("true", "on", "1")
    value: Union[float, int] = int(text) if isinstance(default, int) else float(text)
    if not parameter.minimum <= value <= parameter.maximum:
        raise ValueError("it must lie between %g and %g" % (parameter.minimum, parameter.maximum))
    return value


class Conversation:
    """A team's side of the protocol: a line in, a line out or nothing."""

    def __init__(self, team: Team) -> None:
        self._team = team
        self._size = 0
        self._answers: Dict[str, Callable[[_Object], Optional[str]]] = {
            "hello": self._hello, "begin": self._begin, "decide": self._decide, "place": self._place,
            "exercise": self._exercise, "stopped": self._stopped, "ready": self._ready, "ended": self._ended}

    def take(self, line: str) -> Optional[str]:
        """Takes a line of the simulator. Returns the answer, without its line end; None: it gets none."""
        message: _Object = json.loads(line)
        kind = message["type"]
        answer = self._answers.get(kind)
        if answer is None:
            return None  # a notice of a later version
        members = answer(message)
        if members is None:
            return None
        return '{"type":"%s","id":%d%s}' % (kind, message["id"], members)

    def _seen(self, message: _Object) -> Observation:
        return Observation(message["now"], self._team.info.dt)

    def _hello(self, message: _Object) -> str:
        try:
            if message["protocol"] != PROTOCOL:
                raise ValueError("this team speaks " + PROTOCOL)
            for name, text in message["settings"].items():
                self._set(name, text)
        except ValueError as error:
            return ',"error":%s' % json.dumps(str(error))
        return ',"protocol":"%s","name":%s,"version":%s' % (
            PROTOCOL, json.dumps(self._team.name), json.dumps(self._team.version))

    def _set(self, name: str, text: str) -> None:
        team = self._team
        if name == "navigator" and team.default_navigator:
            team.navigator = text
        elif name not in team.parameters:
            raise ValueError("'%s' has no parameter '%s'" % (team.name, name))
        else:
            try:
                team.settings[name] = _value(team.parameters[name], text)
            except ValueError as error:
                raise ValueError("parameter '%s' = '%s': %s" % (name, text, error)) from None

    def _begin(self, message: _Object) -> str:
        team = self._team
        team.info = _info(message)
        team.random = random.Random(team.info.seed)
        self._size = team.info.team_size
        team.begin(team.info)
        return ',"navigators":%s' % json.dumps(list(team.navigators()))

    def _decide(self, message: _Object) -> str:
        return _commands(self._team.decide(self._seen(message)), self._size)

    def _place(self, message: _Object) -> str:
        request = PlacementRequest(
            kind=message["kind"], ours=message["ours"], delay=message["delay"],
            ball=Point(message["ball"]["x"], message["ball"]["y"]), defaults=_poses(message["defaults"]) or [],
            opponents=_poses(message["opponents"]), cause=_call(message["cause"]), now=self._seen(message))
        return _placement(self._team.place(request), self._size)

    def _exercise(self, message: _Object) -> str:
        reply = self._team.exercise(self._seen(message), _known(Exercise, message["exercise"]))
        if reply is None:
            return ""
        return _commands(reply.commands, self._size) + _point("answer", reply.answer)

    def _stopped(self, message: _Object) -> None:
        self._team.stopped(_call(message["cause"]), self._seen(message))

    def _ready(self, message: _Object) -> None:
        self._team.ready(self._seen(message))

    def _ended(self, message: _Object) -> None:
        self._team.ended(End(
            reason=message["reason"], tick=message["tick"], own_score=message["own_score"],
            opponent_score=message["opponent_score"], winner=message["winner"], cause=_call(message["cause"])))


def converse(team: Team, lines: BinaryIO, answers: BinaryIO) -> None:
    """Plays until the lines end. For tests of a team without the simulator; programs call `run`."""
    take = Conversation(team).take
    for line in iter(lines.readline, b""):
        answer = take(line.decode())
        if answer is not None:
            answers.write(answer.encode() + b"\n")


def run(team: Team) -> None:
    """Runs the team as a program, until the simulator closes the conversation.

    An exception of the team ends the program: its traceback goes to standard error, and the exit code is 1.
    """
    # From here on, standard output is standard error, for all that the team and its libraries print.
    answers = os.fdopen(os.dup(1), "wb", buffering=0)
    sys.stdout.flush()
    os.dup2(2, 1)
    sys.stdout = sys.stderr
    try:
        converse(team, os.fdopen(os.dup(0), "rb", buffering=1 << 16), answers)
    except (BrokenPipeError, KeyboardInterrupt):
        pass
    except Exception:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)  # not by way of whatever threads the team may have left
