"""A trained policy as a team, for matches, drills and tournaments.

    fulbito match "cmd:python -m fulbito.policy_team striker.onnx" classic
    fulbito.play(PolicyTeam("striker.onnx"), "classic")

The policy drives the robot that is nearest to the ball. Robot 0 keeps goal, and the others wait between ball and own goal:
that is `PolicyTeam`, which you can subclass. `--all` lets the policy drive all robots.
"""

import argparse
import contextlib
import math
import os
import sys
from pathlib import Path
from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from fulbito import _core
from fulbito.errors import FulbitoError, InputError
from fulbito.policy import Policy
from fulbito.team import Command, Commands, Exercise, ExerciseReply, GoTo, MatchInfo, Observation, Robot, Team, Twist, Wheels, run

__all__ = ["PolicyTeam", "main"]

_NEARER = 0.1  # [m] by which another robot must be nearer to the ball to take over, so that roles do not flap
_KEEPER_OUT = 0.06  # [m] the keeper's centre before the goal line: a robot's length fits
_SHADOW = 0.5  # share of the way from the ball to the own goal at which the others wait
_ASIDE = 0.1  # [m] between robots that wait


class PolicyTeam(Team):
    """Plays a policy of `fulbito/VSS-v0` or `fulbito/Drill-v0` as a team.

    `policy`: a file, or a loaded Policy. `all_robots`: the policy drives each robot, none keeps goal. Raises FileError and
    InputError, also if the policy's environment shows what a team does not see.
    """

    name = "policy"

    def __init__(self, policy: Union[str, Path, Policy], *, all_robots: bool = False) -> None:
        super().__init__()
        self._policy = policy if isinstance(policy, Policy) else Policy.load(policy)
        self.name = self._policy.path.stem
        self._all = all_robots
        options: Mapping[str, Any] = self._policy.maker.options
        self._observation = str(options.get("observation", "egocentric"))
        self._action = str(options.get("action", "wheels"))
        self._stack = int(options.get("stack", 1))
        self._hold = int(options.get("frame_skip", 1))
        self._striker = -1
        self._ticks = 0
        self._commands: dict[int, Command] = {}
        self._seen: dict[int, list[NDArray[np.float32]]] = {}
        self._agent: Optional[_core.Agent] = None

    def begin(self, info: MatchInfo) -> None:
        """A new match begins."""
        self._agent = _core.Agent(info, self._observation, self._action)
        self._forget()

    def navigators(self) -> Sequence[str]:
        """The robots without policy drive straight."""
        return ["straight"]

    def ready(self, now: Observation) -> None:
        """A new play begins: the policy has no memory of the last one."""
        self._forget()

    def decide(self, seen: Observation) -> Commands:
        """The policy's commands, and those of the other robots."""
        commands = Commands()
        chosen = self.strikers(seen)
        if self._ticks % self._hold == 0:
            self._commands = {number: self._act(seen, number) for number in chosen}
        self._ticks += 1
        for number, robot in enumerate(seen.own):
            if robot is None:
                continue
            driven = self._commands.get(number) if number in chosen else None
            commands.robots[number] = driven if driven is not None else self.support(seen, number, robot)
        return commands

    def exercise(self, now: Observation, task: Exercise) -> Optional[ExerciseReply]:
        """Policies know no tasks but the game."""
        return None

    def strikers(self, seen: Observation) -> list[int]:
        """The robots that the policy drives now: the one nearest to the ball, but for robot 0."""
        there = [number for number, robot in enumerate(seen.own) if robot is not None]
        if self._all or len(there) == 1:
            return there
        gaps = {number: self._gap(seen, number) for number in there if number != 0}
        nearest = min(gaps, key=lambda number: gaps[number])
        if self._striker not in gaps or gaps[nearest] < gaps[self._striker] - _NEARER:
            self._striker = nearest
        return [self._striker]

    def support(self, seen: Observation, number: int, robot: Robot) -> Command:
        """What a robot does that the policy does not drive. Robot 0 keeps goal, the others wait behind the ball."""
        field, ball = self.info.field, seen.ball
        if number == 0:
            return self._keep(robot, self._crossing(seen))
        waiting = [n for n, other in enumerate(seen.own) if other is not None and n not in (0, self._striker)]
        aside = _ASIDE * (waiting.index(number) - (len(waiting) - 1) / 2) if number in waiting else 0.0
        goal = -field.length / 2
        x = max(ball.x + _SHADOW * (goal - ball.x), goal + field.goal_area_depth + self.info.robot.length)
        way = (x - goal) / max(ball.x - goal, 1e-3)
        return GoTo(x, ball.y * min(way, 1.0) + aside, stop=True, avoid_ball=True)

    def _crossing(self, seen: Observation) -> float:
        """[m] Where the ball passes the keeper's line if it goes on as it does; else where it is now."""
        ball, line = seen.ball, -self.info.field.length / 2 + _KEEPER_OUT
        if ball.vx > -0.1 or ball.x < line:
            return ball.y
        return ball.y + ball.vy * (line - ball.x) / ball.vx

    def _keep(self, robot: Robot, y: float) -> Command:
        """Along the goal line to that place, with whichever end leads."""
        field = self.info.field
        line, reach = -field.length / 2 + _KEEPER_OUT, field.goal_width / 2 - self.info.robot.width / 2
        wanted = min(max(y, -reach), reach)
        upright = math.remainder(math.pi / 2 - robot.heading, math.pi)
        if abs(robot.x - line) > 0.04:
            return GoTo(line, wanted, heading=math.pi / 2, stop=True)
        if abs(upright) > 0.35:
            return Twist(0.0, 8.0 * upright)
        sense = 1.0 if math.sin(robot.heading) > 0 else -1.0
        return Twist(sense * 10.0 * (wanted - robot.y), 8.0 * upright)

    def _gap(self, seen: Observation, number: int) -> float:
        robot = seen.own[number]
        assert robot is not None
        # A robot on the wrong side of the ball first has to go round it.
        behind = max(0.0, robot.x - seen.ball.x)
        return math.hypot(robot.x - seen.ball.x, robot.y - seen.ball.y) + behind

    def _act(self, seen: Observation, number: int) -> Command:
        assert self._agent is not None
        now = self._agent.observe(seen, number)
        past = self._seen.setdefault(number, [now] * self._stack)
        past.insert(0, now)
        del past[self._stack:]
        observation = np.concatenate(past)
        if observation.size != self._policy.observation_size:
            raise InputError(f"{self._policy.path}: its observations have {self._policy.observation_size} numbers, but a team of "
                             f"{self.info.team_size} sees {observation.size} of the form '{self._observation}'")
        kind, *numbers = self._agent.command(self._policy(observation))
        if kind == "wheels":
            return Wheels(numbers[0], numbers[1])
        if kind == "twist":
            return Twist(numbers[0], numbers[1])
        return GoTo(numbers[0], numbers[1], heading=numbers[2])

    def _forget(self) -> None:
        self._ticks = 0
        self._striker = -1
        self._commands, self._seen = {}, {}


def _import_quietly() -> None:
    """ONNX Runtime looks for GPUs when it is imported. In a sandbox it may not, and says so each time."""
    with contextlib.suppress(OSError, ImportError), open(os.devnull, "wb") as nothing:
        kept = os.dup(2)
        try:
            os.dup2(nothing.fileno(), 2)
            import onnxruntime  # noqa: F401  Policy.load uses it
        finally:
            os.dup2(kept, 2)
            os.close(kept)


def main(words: Optional[Sequence[str]] = None) -> int:
    """The command `python -m fulbito.policy_team`: a team's program. Returns its exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m fulbito.policy_team", description="Plays a trained policy as a team.",
        epilog='Example: fulbito match "cmd:python -m fulbito.policy_team striker.onnx" classic')
    parser.add_argument("policy", help="an ONNX file of fulbito.policy.save_policy")
    parser.add_argument("--all", action="store_true", help="the policy drives all robots, and none keeps goal")
    known = parser.parse_args(words)
    _import_quietly()
    try:
        team = PolicyTeam(known.policy, all_robots=known.all)
    except FulbitoError as error:
        print(f"fulbito.policy_team: {error}", file=sys.stderr)
        return 2
    run(team)
    return 0


if __name__ == "__main__":
    sys.exit(main())
