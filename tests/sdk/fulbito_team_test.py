"""Tests of the Python SDK: what a team receives, what it answers, and what happens when it is wrong."""

import io
import json
import os
import pathlib
import subprocess
import sys
import unittest
from typing import Any, Dict, List, Optional

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "sdk/python"))

import fulbito_team as f  # noqa: E402


def session() -> Dict[str, List[Dict[str, Any]]]:
    """What the simulator says in the sample session, by type."""
    said: Dict[str, List[Dict[str, Any]]] = {}
    for line in (ROOT / "docs/team-protocol-session.txt").read_text().splitlines():
        if line.startswith("> "):
            message = json.loads(line[2:])
            said.setdefault(message["type"], []).append(message)
    return said


SESSION = session()


class Probe(f.Team):
    """Keeps what it is told and answers what a test wants."""

    name = "probe"
    version = "3"
    default_navigator = "bspline-time"
    parameters = {
        "depth": f.Parameter(0.1, 0.05, 0.3), "count": f.Parameter(3), "bold": f.Parameter(False),
        "mood": f.Parameter("calm")}

    def __init__(self) -> None:
        super().__init__()
        self.heard: List[Any] = []
        self.commands = f.Commands()
        self.wishes: Optional[f.Placement] = None
        self.reply: Optional[f.ExerciseReply] = None

    def begin(self, info: f.MatchInfo) -> None:
        self.heard.append(info)

    def decide(self, seen: f.Observation) -> f.Commands:
        self.heard.append(seen)
        return self.commands

    def place(self, request: f.PlacementRequest) -> Optional[f.Placement]:
        self.heard.append(request)
        return self.wishes

    def stopped(self, cause: Optional[f.Call], now: f.Observation) -> None:
        self.heard.append(cause)

    def ready(self, now: f.Observation) -> None:
        self.heard.append(now)

    def ended(self, end: f.End) -> None:
        self.heard.append(end)

    def exercise(self, now: f.Observation, task: f.Exercise) -> Optional[f.ExerciseReply]:
        self.heard.append(task)
        return self.reply


class Talk(unittest.TestCase):
    def setUp(self) -> None:
        self.probe = Probe()
        self.conversation = f.Conversation(self.probe)

    def take(self, kind: str, number: int = 0) -> Any:
        """The answer to a message of the sample session; None if it gets none."""
        answer = self.conversation.take(json.dumps(SESSION[kind][number]))
        return json.loads(answer, parse_constant=self.fail) if answer is not None else None

    def decided(self) -> Any:
        self.take("begin")
        return self.take("decide")


class Receiving(Talk):
    def test_settings(self) -> None:
        self.assertEqual(
            self.take("hello"),
            {"type": "hello", "id": 1, "protocol": "fulbito-team/1", "name": "probe", "version": "3"})
        self.assertEqual(self.probe.settings["depth"], 0.125)
        self.assertEqual(self.take("begin"), {"type": "begin", "id": 2, "navigators": ["bezier:clearance=0.03"]})

    def test_match_info(self) -> None:
        self.take("begin")
        info = self.probe.heard[0]
        self.assertEqual((info.team, info.side, info.dt, info.team_size), ("yellow", "right", 1 / 60, 3))
        self.assertEqual(info.seed, 18446744073709551615)
        self.assertEqual(info.field.corner, 0.07)
        self.assertEqual(list(info.field.free_ball_mark), [0.375, 0.4])
        self.assertEqual(info.robot.max_speed, info.robot.max_wheel_speed * info.robot.wheel_radius)
        self.assertEqual(info.ball.radius, SESSION["begin"][0]["ball"]["radius"])
        self.assertEqual(info.vision.heading_noise, 0.01)
        self.assertEqual(info.decision_time.held, 30)
        self.assertEqual(info.rules["periods"]["half_seconds"], 300.0)
        self.assertEqual(info.physics["control_rate"], 60)

    def test_every_value_of_the_tables_has_a_member(self) -> None:
        message = SESSION["begin"][0]
        for kind, table in ((f.Field, "field"), (f.RobotModel, "robot"), (f.BallModel, "ball"),
                            (f.Vision, "vision"), (f.DecisionTime, "decision_time")):
            self.assertEqual(set(kind.__dataclass_fields__), set(message[table]))

    def test_random_numbers_follow_the_seed(self) -> None:
        self.take("begin")
        first = self.probe.random.random()
        self.probe.random.random()
        self.take("begin")
        self.assertEqual(self.probe.random.random(), first)

    def test_observation(self) -> None:
        self.take("begin")
        self.take("decide", 2)
        seen = self.probe.heard[1]
        message = SESSION["decide"][2]["now"]
        for name in ("tick", "period", "remaining", "playing", "restart", "restart_is_ours", "since_restart",
                     "own_score", "opponent_score", "wants_drawings"):
            self.assertEqual(getattr(seen, name), message[name])
        self.assertEqual(seen.dt, 1 / 60)
        for name, value in message["ball"].items():
            self.assertEqual(getattr(seen.ball, name), value)
        for name, value in message["own"][1].items():
            self.assertEqual(getattr(seen.own[1], name), value)
        for name, value in message["opponents"][1].items():
            self.assertEqual(getattr(seen.opponents[1], name), value)
        self.assertIsNone(seen.opponents[2])

    def test_restarts_and_notices(self) -> None:
        self.take("begin")
        for kind in ("stopped", "ready", "ended"):
            self.assertIsNone(self.take(kind))
        cause, ready, end = self.probe.heard[1:]
        self.assertEqual((cause.clause, cause.robot, cause.team), ("goal", 1, "yellow"))
        self.assertEqual(ready.since_restart, -0.5)
        self.assertEqual((end.reason, end.winner, end.cause.clause), ("played", "yellow", "full-time"))
        self.take("place", 1)
        request = self.probe.heard[-1]
        self.assertEqual((request.kind, request.ours, request.now.own_score), ("kick-off", False, 1))
        self.assertEqual(request.defaults[2], f.Pose(-0.4, 0.3, 0.0))
        self.assertEqual(len(request.opponents), 3)

    def test_members_and_notices_of_later_versions(self) -> None:
        message = dict(SESSION["begin"][0], weather={"rain": True})
        message["field"] = dict(message["field"], grass="wet")
        self.assertIsNotNone(self.conversation.take(json.dumps(message)))
        self.assertIsNone(self.conversation.take('{"type":"weather","rain":true}'))


class Answering(Talk):
    def test_commands(self) -> None:
        commands = self.probe.commands
        commands.wheels(0, 1, -2.5)
        commands.go_to(2, f.GoTo(0.1, 0.2, heading=1.0, stop=True, speed_limit=0.5, avoid_ball=True, avoid_mates=False,
                                 avoid_opponents=False, tolerance=0.01, either_front=False, navigator=3))
        commands.roles[1] = 7
        commands.line(0, 1, 2, 3)
        commands.circle(4, 5, float("nan"))
        commands.text(6, 7, 'quoted "word" é')
        self.assertEqual(self.decided(), {
            "type": "decide", "id": 4,
            "robots": [
                {"left": 1.0, "right": -2.5}, None,
                {"go_to": {"x": 0.1, "y": 0.2, "heading": 1.0, "stop": True, "speed_limit": 0.5, "avoid_ball": True,
                           "avoid_mates": False, "avoid_opponents": False, "tolerance": 0.01,
                           "either_front": False, "navigator": 3}}],
            "roles": [0, 7, 0],
            "drawings": [{"line": [0.0, 1.0, 2.0, 3.0]}, {"text": [6.0, 7.0, 'quoted "word" é']}]})

    def test_numbers_that_are_none(self) -> None:
        commands = self.probe.commands
        commands.twist(0, float("nan"), float("inf"))
        commands.go_to(1, f.GoTo(0, 0, heading=float("nan")))
        commands.go_to(2, f.GoTo(0, 0, speed_limit=float("inf")))
        robots = self.decided()["robots"]
        self.assertEqual(robots[0], {"linear": None, "angular": None})
        self.assertIsNone(robots[1]["go_to"]["x"])
        self.assertEqual(robots[2], {"go_to": {"x": 0.0, "y": 0.0, "tolerance": 0.03}})

    def test_numbers_of_other_types(self) -> None:
        class Half:
            """As numbers of numpy: not a float, but it can become one."""

            def __float__(self) -> float:
                return 0.5

        self.probe.commands.wheels(0, Half(), True)  # type: ignore[arg-type]
        self.assertEqual(self.decided()["robots"][0], {"left": 0.5, "right": 1.0})

    def test_robots_that_the_team_lacks(self) -> None:
        for number in (3, -1):
            self.probe.commands = f.Commands()
            self.probe.commands.wheels(number, 1, 1)
            with self.assertRaisesRegex(ValueError, "the team's robots are 0 to 2"):
                self.decided()
        self.probe.commands = f.Commands()
        self.probe.commands.roles[3] = 1
        with self.assertRaisesRegex(ValueError, "a role for robot 3"):
            self.decided()

    def test_placement(self) -> None:
        self.take("begin")
        self.assertEqual(self.take("place"), {"type": "place", "id": 3})
        self.probe.wishes = f.Placement({1: f.Pose(0.1, 0.2, 0.3)}, f.Point(-0.6, 0.3))
        self.assertEqual(self.take("place"), {
            "type": "place", "id": 3, "poses": [None, {"x": 0.1, "y": 0.2, "heading": 0.3}, None],
            "ball": {"x": -0.6, "y": 0.3}})

    def test_exercise(self) -> None:
        self.take("begin")
        self.assertEqual(self.take("exercise"), {"type": "exercise", "id": 9})
        self.assertEqual(self.probe.heard[-1].kind, "reach-pose")
        self.probe.reply = f.ExerciseReply(answer=f.Point(1, 2))
        self.probe.reply.commands.wheels(0, 3, 4)
        self.assertEqual(self.take("exercise"), {
            "type": "exercise", "id": 9, "robots": [{"left": 3.0, "right": 4.0}, None, None],
            "answer": {"x": 1.0, "y": 2.0}})

    def test_settings_of_each_type(self) -> None:
        def hello(**settings: str) -> Dict[str, Any]:
            message = dict(SESSION["hello"][0], settings=settings)
            answer: Dict[str, Any] = json.loads(self.conversation.take(json.dumps(message)) or "")
            return answer

        self.assertNotIn("error", hello(count="5", bold="on", mood="angry", depth="0.3"))
        self.assertEqual(self.probe.settings, {"count": 5, "bold": True, "mood": "angry", "depth": 0.3})
        self.assertEqual(hello(speed="1")["error"], "'probe' has no parameter 'speed'")
        self.assertEqual(hello(depth="1")["error"], "parameter 'depth' = '1': it must lie between 0.05 and 0.3")
        self.assertIn("parameter 'count' = '1.5'", hello(count="1.5")["error"])
        self.assertIn("it must be true or false", hello(bold="maybe")["error"])
        self.assertIn("it must lie between", hello(depth="nan")["error"])

    def test_another_protocol(self) -> None:
        message = dict(SESSION["hello"][0], protocol="fulbito-team/2")
        answer = json.loads(self.conversation.take(json.dumps(message)) or "")
        self.assertEqual(answer["error"], "this team speaks fulbito-team/1")


PROGRAM = """
import os, sys
from fulbito_team import *
class Loud(Team):
    name = "loud"
    def decide(self, seen):
        print("said to sys.stdout")
        os.write(1, b"said to descriptor 1\\n")
        if seen.tick == 60:
            raise RuntimeError("no idea")
        return Commands()
run(Loud())
"""


class Program(unittest.TestCase):
    def run_program(self, messages: List[Dict[str, Any]]) -> "subprocess.CompletedProcess[str]":
        lines = "".join(json.dumps(message) + "\n" for message in messages)
        environment = dict(os.environ, PYTHONPATH=str(ROOT / "sdk/python"), PYTHONDONTWRITEBYTECODE="1")
        return subprocess.run([sys.executable, "-c", PROGRAM], input=lines, capture_output=True, text=True,
                              timeout=60, env=environment)

    def test_what_a_team_prints_is_not_in_the_protocol(self) -> None:
        hello = dict(SESSION["hello"][0], settings={})
        done = self.run_program([hello, SESSION["begin"][0], SESSION["decide"][0]])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([json.loads(line)["type"] for line in done.stdout.splitlines()], ["hello", "begin", "decide"])
        self.assertIn("said to sys.stdout", done.stderr)
        self.assertIn("said to descriptor 1", done.stderr)

    def test_an_exception_shows_its_traceback_and_ends_the_program(self) -> None:
        done = self.run_program([SESSION["begin"][0], SESSION["decide"][1], SESSION["decide"][0]])
        self.assertEqual(done.returncode, 1)
        self.assertEqual(len(done.stdout.splitlines()), 1)
        self.assertIn("Traceback", done.stderr)
        self.assertIn("RuntimeError: no idea", done.stderr)

    def test_a_conversation_without_the_simulator(self) -> None:
        answers = io.BytesIO()
        f.converse(Probe(), io.BytesIO(json.dumps(SESSION["hello"][0]).encode() + b"\n"), answers)
        self.assertEqual(json.loads(answers.getvalue())["name"], "probe")


if __name__ == "__main__":
    unittest.main()
