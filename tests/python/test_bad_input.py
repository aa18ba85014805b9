"""Wrong arguments are clear exceptions, and never a crash. Each case is a call and the text that it must give."""

import copy
import os
import pickle
import sys
import threading
from pathlib import Path
from typing import Any, Callable

import numpy as np
import pytest

import fulbito
from fulbito import FileError, FulbitoError, InputError, Recording, UsageError, World, _core
from fulbito.matches import Containment
from fulbito.team import Team
from teams import ByPath

NAN, INF = float("nan"), float("inf")
ONE: Any = [[0.0, 0.0, 0.0]]

Case = tuple[Callable[[], Any], type[BaseException], str]


def play(**arguments: Any) -> Callable[[], Any]:
    return lambda: fulbito.play(**{"blue": "idle", "yellow": "idle", "half_seconds": 1, **arguments})


def world(**arguments: Any) -> Callable[[], Any]:
    return lambda: World(**{"robots": ONE, **arguments})


def step(commands: Any, **arguments: Any) -> Callable[[], Any]:
    return lambda: World(robots=ONE).step(commands, **arguments)


def compare(**arguments: Any) -> Callable[[], Any]:
    return lambda: fulbito.compare(**{"suite": "corner", "navigators": ["straight"], "trials": 1, **arguments})


CASES: dict[str, Case] = {
    "unknown team": (play(blue="liber"), UsageError, "libero"),
    "unknown parameter": (play(blue="libero:agression=1"), UsageError, "agression"),
    "empty team": (play(blue=""), UsageError, ""),
    "team of another type": (play(blue=7), UsageError, "a team is a specification or has the functions"),
    "no team": (play(yellow=None), UsageError, "not None"),
    "module as team": (play(yellow=sys), UsageError, "a team is a specification"),
    "team that is no file": (play(blue="./none.so"), UsageError, "none.so"),
    "program that is none": (play(blue="cmd:/none/team"), FulbitoError, "none/team"),
    "script that is none": (play(blue="cmd:python3 none.py"), FulbitoError, "none.py"),
    "zero byte in a team": (play(blue="lib\0ero"), FulbitoError, ""),
    "unknown rules": (play(rules="vsss-4v4"), UsageError, "vsss-4v4"),
    "rules that are no file": (play(rules="none.toml"), FileError, "none.toml"),
    "unknown robot": (play(robot="robbie"), UsageError, "robbie"),
    "unknown physics": (play(physics="magic"), UsageError, "magic"),
    "negative half": (play(half_seconds=-1.0), FulbitoError, "half_seconds"),
    "half of NaN": (play(half_seconds=NAN), FulbitoError, "half_seconds"),
    "half that is text": (play(half_seconds="long"), TypeError, ""),
    "negative seed": (play(seed=-1), UsageError, "seed: -1"),
    "seed beyond 64 bits": (play(seed=2**64), UsageError, "seed"),
    "seed that is a fraction": (play(seed=0.5), TypeError, ""),
    "latency beyond its range": (play(latency=61), FulbitoError, "latency"),
    "negative latency": (play(latency=-1), FulbitoError, "latency"),
    "latency that overflows": (play(latency=2**40), FulbitoError, "latency"),
    "three latencies": (play(latency=(1, 2, 3)), UsageError, "latency: one value, or one for blue"),
    "noise of NaN": (play(noise=NAN), FulbitoError, "noise"),
    "too much noise": (play(noise=(0.0, 0.2)), FulbitoError, "noise"),
    "noise that is text": (play(noise="much"), UsageError, "noise: 'much' is not a number"),
    "certain dropout": (play(dropout=1.0), FulbitoError, "dropout"),
    "time of NaN": (play(time_ms=NAN), FulbitoError, "decision"),
    "negative time": (play(time_ms=-5.0), FulbitoError, "decision"),
    "start that is no file": (play(start="none.toml"), FileError, "none.toml"),
    "recording in no folder": (play(record="/none/match.fbr"), FileError, "/none/match.fbr"),
    "recording onto a folder": (play(record="/tmp"), FileError, "/tmp"),
    "unknown isolation": (play(containment=Containment(isolate="jail")), UsageError, "isolate = 'jail'"),
    "unknown sandbox": (play(containment=Containment(sandbox="some")), UsageError, "sandbox = 'some'"),
    "little memory": (play(containment=Containment(memory_mb=1.0)), UsageError, "16 ... 1048576"),
    "no processes": (play(containment=Containment(processes=0)), UsageError, "1 ... 10000"),
    "recording that is none": (lambda: Recording.open("/none/match.fbr"), FileError, "/none/match.fbr"),
    "recording that is a folder": (lambda: Recording.open("/tmp"), FileError, "/tmp"),
    "recording of other bytes": (lambda: Recording.parse(b"not a recording"), InputError, "recording"),
    "recording of no bytes": (lambda: Recording.parse(b""), InputError, ""),
    "recording of text": (lambda: Recording.parse("text"), TypeError, ""),  # type: ignore[arg-type]
    "robots of a wrong shape": (world(robots=[[0.0, 0.0]]), UsageError, "robots: the shape is (1, 2)"),
    "robots of one dimension": (world(robots=[0.0, 0.0, 0.0]), UsageError, "robots: the shape is (3,)"),
    "robots of three dimensions": (world(robots=np.zeros((1, 1, 3))), UsageError, "(1, 1, 3)"),
    "robots of text": (world(robots=[["a", "b", "c"]]), UsageError, "robots: not an array of numbers"),
    "ragged robots": (world(robots=[[0, 0, 0], [0, 0]]), UsageError, "robots: not an array of numbers"),
    "robots of complex numbers": (world(robots=np.zeros((1, 3), complex)), UsageError, "robots: not an array of numbers"),
    "a robot at NaN": (world(robots=[[NAN, 0, 0]]), InputError, "robot 0"),
    "a robot at infinity": (world(robots=[[0, INF, 0]]), InputError, "robot 0"),
    "a robot outside": (world(robots=[[5, 0, 0]]), InputError, "robot 0"),
    "a ball outside": (world(balls=[[0, 5]]), InputError, "ball 0"),
    "balls of one dimension": (world(balls=[0.0, 0.0]), UsageError, "balls: the shape is (2,)"),
    "discs without radius": (world(discs=[[0, 0]]), UsageError, "discs: the shape is (1, 2)"),
    "a disc of no size": (world(discs=[[0.3, 0.3, -1.0]]), InputError, "obstacle 0"),
    "unknown field": (world(field="moon"), UsageError, "moon"),
    "commands of a wrong shape": (step([[1.0, 2.0, 3.0]]), UsageError, "commands: the shape is (1, 3), not (1, 2)"),
    "commands for two robots": (step(np.zeros((2, 2))), UsageError, "not (1, 2)"),
    "commands of text": (step([["a", "b"]]), UsageError, "commands: not an array of numbers"),
    "no commands": (step(None), UsageError, "commands"),
    "negative ticks": (step([[0, 0]], ticks=-1), UsageError, "ticks = -1 is negative"),
    "ticks that are a fraction": (step([[0, 0]], ticks=0.5), TypeError, ""),
    "a run of a wrong shape": (lambda: World(robots=ONE).run(np.zeros((5, 2))), UsageError, "not (ticks, 1, 2)"),
    "unknown suite": (compare(suite="cornr"), UsageError, "corner"),
    "unknown navigator": (compare(navigators=["bezir"]), UsageError, "bezier"),
    "unknown parameter of a navigator": (compare(navigators=["bezier:speed=1"]), UsageError, "speed"),
    "navigators that are text": (compare(navigators="bezier"), UsageError, "a list, not the text 'bezier'"),
    "navigator of another type": (compare(navigators=[7]), UsageError, "a navigator is a specification or a class"),
    "navigator that is an object": (compare(navigators=[ByPath()]), UsageError, "a class with `reset` and `plan`"),
    "no trials": (compare(trials=0), UsageError, "trials = 0"),
    "negative jobs": (compare(jobs=-1), UsageError, "jobs = -1"),
    "speed of NaN": (compare(speeds=[NAN]), UsageError, "speed"),
    "negative speed": (compare(speeds=[-1.0]), UsageError, "speed"),
    "layout beyond the suite": (compare(only=10**9), UsageError, "only"),
    "noise of a comparison": (compare(noise=7.0), FulbitoError, "noise"),
    "unknown suite of a layout": (lambda: fulbito.layout("moon", 0), UsageError, "moon"),
    "negative layout": (lambda: fulbito.layout("corner", -1), UsageError, "index = -1"),
    "row that is none": (lambda: compare()().row("dwa"), UsageError, "there is no row of 'dwa'"),
    "pickled world": (lambda: pickle.dumps(World(robots=ONE)), TypeError, "pickle"),
    "copied world": (lambda: copy.deepcopy(World(robots=ONE)), TypeError, "pickle"),
    "core world without arguments": (lambda: _core.SteppedWorld(), TypeError, ""),  # type: ignore[call-arg]
    "core world of 32 bits": (lambda: _core.SteppedWorld(  # a dtype that the public class would convert
        "vsss-3v3", "vsss", "standard", np.zeros((1, 6), "i4"), np.zeros((0, 6)), np.zeros((0, 3))), TypeError, ""),
    "core world of few columns": (lambda: _core.SteppedWorld(
        "vsss-3v3", "vsss", "standard", np.zeros((1, 2)), np.zeros((0, 6)), np.zeros((0, 3))), UsageError, "6 columns"),
    "core commands of few robots": (lambda: World(robots=ONE)._world.step(np.zeros((0, 2)), 1), UsageError, "each of 1 robots"),
    "latency that is a fraction": (play(latency=1.5), UsageError, "latency"),
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_it_is_a_clear_exception(case: Case) -> None:
    call, kind, text = case
    with pytest.raises(kind) as caught:
        call()
    assert text in str(caught.value)
    assert str(caught.value) or kind is TypeError


@pytest.mark.parametrize(("arguments", "text"), [
    ({"width": 10}, ""), ({"width": 10**6}, ""), ({"theme": "pink"}, "theme = 'pink'"), ({"fps": 0}, "must be positive"),
    ({"speed": -1.0}, "must be positive"), ({"fps": NAN}, "must be positive"), ({"start": NAN}, "start"),
    ({"trail_seconds": NAN}, "trail_seconds")])
def test_wrong_pictures(recording: Recording, arguments: dict[str, Any], text: str) -> None:
    with pytest.raises(UsageError) as caught:
        next(iter(recording.frames(**{"start": 1.0, "stop": 2.0, **arguments})))
    assert text in str(caught.value)


def test_moments_outside_are_clamped(recording: Recording) -> None:
    assert recording.frame(-5.0, width=320).shape == recording.frame(1e9, width=320).shape
    with pytest.raises(UsageError, match="not a finite number"):
        recording.frame(NAN, width=320)


def test_read_only_and_strided_arrays_are_taken() -> None:
    commands = np.full((1, 2), 20.0)
    commands.flags.writeable = False
    one, other = World(robots=ONE), World(robots=ONE)
    one.step(commands)
    other.step(np.full((1, 4), 20.0)[:, ::2])
    assert one.state_hash() == other.state_hash()


def test_nan_commands_stop_a_robot() -> None:
    one, other = World(robots=ONE), World(robots=ONE)
    one.step([[NAN, INF]], ticks=5)
    other.step([[0.0, 1e300]], ticks=5)
    assert one.state_hash() == other.state_hash()


def test_a_team_that_fails_at_every_call_ends_one_match_only() -> None:
    class Broken(Team):
        def __getattribute__(self, name: str) -> Any:
            raise RuntimeError("broken")

    for _ in range(3):
        with pytest.raises(FulbitoError):
            fulbito.play(Broken, "idle", half_seconds=1)
    assert fulbito.play("idle", "idle", half_seconds=1).score == (0, 0)


def test_a_team_may_play_a_match_of_its_own() -> None:
    class Nested(Team):
        def begin(self, info: Any) -> None:
            self.score = fulbito.play("idle", "idle", half_seconds=1).score

        def decide(self, seen: Any) -> Any:
            from fulbito.team import Commands
            return Commands()

    assert fulbito.play(Nested, "idle", half_seconds=1).score == (0, 0)


def test_a_fork_after_threads_plays(tmp_path: Path) -> None:
    fulbito.compare("corner", ["straight"], trials=4, jobs=2)
    thread = threading.Thread(target=lambda: fulbito.play("libero", "classic", half_seconds=20))
    thread.start()
    child = os.fork()
    if child == 0:
        code = 1
        try:
            code = 0 if fulbito.play("idle", "idle", half_seconds=1).score == (0, 0) else 2
        finally:
            os._exit(code)
    thread.join()
    assert os.waitpid(child, 0)[1] == 0


def test_an_interpreter_ends_with_objects_alive() -> None:
    import subprocess
    script = ("import fulbito; from fulbito.team import Team\n"
              "w = fulbito.World(); r = fulbito.play('idle', 'idle', half_seconds=1, record=True); f = r.recording.frames()\n"
              "c = fulbito.compare('corner', ['straight'], trials=1)\n")
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)})
    assert (done.returncode, done.stderr) == (0, "")
