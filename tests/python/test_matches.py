"""`fulbito.play` is `fulbito match`, and teams of this process are teams."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

import fulbito
from fulbito.team import Commands, MatchInfo, Observation, Team
from teams import Chaser, Fails


def without_times(data: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in data.items() if not key.startswith(("wall_", "compute_", "x_realtime"))}


@pytest.mark.parametrize("words", [
    ("libero", "classic", "--seed", "7", "--half-seconds", "20"),
    ("classic", "chaser", "--half-seconds", "15", "--latency", "2,4", "--noise", "0.003", "--rules", "vsss-5v5"),
])
def test_a_match_has_the_figures_of_the_program(words: tuple[str, ...], program: str) -> None:
    printed = subprocess.run([program, "match", *words, "--json"], capture_output=True, check=True)
    if words[0] == "libero":
        result = fulbito.play("libero", "classic", seed=7, half_seconds=20)
    else:
        result = fulbito.play("classic", "chaser", half_seconds=15, latency=(2, 4), noise=0.003, rules="vsss-5v5")
    assert without_times(result.data) == without_times(json.loads(printed.stdout))


def test_a_result_says_what_happened(short_match: fulbito.MatchResult) -> None:
    assert short_match.teams == ("libero", "idle")
    goals = [event for event in short_match.events if event.event == "goal"]
    assert short_match.score == (sum(g.team == "blue" for g in goals), sum(g.team == "yellow" for g in goals))
    blue, yellow = short_match.score
    assert short_match.winner == ("blue" if blue > yellow else "yellow" if yellow > blue else None)
    assert len(goals) > 0
    table = short_match.event_table()
    assert len(table) == len(short_match.events)
    assert (table["event"] == "goal").sum() == len(goals)
    assert short_match.statistics["blue"]["shots"] > 0
    assert f"libero {blue} : {yellow} idle" in repr(short_match)
    assert "<iframe" in short_match._repr_html_()


def test_equal_arguments_give_equal_matches() -> None:
    one, two, other = (fulbito.play("random", "classic", seed=seed, half_seconds=5).final_hash for seed in (3, 3, 4))
    assert one == two != other


def test_a_team_of_this_process_plays(examples: Path) -> None:
    result = fulbito.play(Chaser, "idle", half_seconds=20, record=True)
    assert result.teams == ("chaser of this process", "idle")
    assert result.statistics["blue"]["shots"] > 0
    assert result.recording is not None and result.recording.verify()
    again = fulbito.play(Chaser(), "idle", half_seconds=20)
    assert again.final_hash == result.final_hash


def test_a_team_plays_the_same_here_and_as_a_program(examples: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(examples / "teams"))
    import chaser  # type: ignore[import-not-found,unused-ignore]  # pyright: ignore[reportMissingImports]
    team = next(kind for kind in vars(chaser).values()
                if isinstance(kind, type) and kind.__module__ == "chaser" and hasattr(kind, "decide"))
    here = fulbito.play(team, "classic", half_seconds=10, seed=5)
    there = fulbito.play(f"cmd:python3 {examples / 'teams' / 'chaser.py'}", "classic", half_seconds=10, seed=5)
    assert here.final_hash == there.final_hash


def test_a_team_learns_of_the_match() -> None:
    seen: list[str] = []

    class Listener(Team):
        def begin(self, info: MatchInfo) -> None:
            seen.append(f"begin {info.team} {info.team_size} {info.dt:.4f} {info.field.length}")

        def ready(self, now: Observation) -> None:
            seen.append("ready")

        def decide(self, seen: Observation) -> Commands:
            return Commands()

        def ended(self, end: Any) -> None:
            seen.append(f"ended {end.reason} {end.own_score}")

    fulbito.play("idle", Listener, half_seconds=1)
    assert seen[0] == "begin yellow 3 0.0167 1.5"
    assert seen[-1] == "ended played 0"
    assert seen.count("ready") >= 2


def test_an_exception_of_a_team_is_the_cause() -> None:
    with pytest.raises(fulbito.TeamError, match="team 'Fails' raised LookupError: the tenth") as caught:
        fulbito.play("idle", Fails, half_seconds=5)
    assert isinstance(caught.value.__cause__, LookupError)
    assert caught.value.__cause__.__traceback__ is not None


def test_a_recording_ends_where_a_team_fails(tmp_path: Path) -> None:
    file = tmp_path / "broken.fbr"
    with pytest.raises(fulbito.TeamError):
        fulbito.play("idle", Fails, half_seconds=5, record=file)
    cut = fulbito.Recording.open(file)
    assert 0 < cut.ticks < 100
    assert not cut.header["complete"]


def test_an_exception_before_the_match() -> None:
    class Refuses(Team):
        def __init__(self) -> None:
            raise OSError("no model")

    with pytest.raises(fulbito.TeamError, match="OSError: no model"):
        fulbito.play(Refuses, "idle", half_seconds=1)


def test_wrong_commands_are_exceptions() -> None:
    class Numbers(Team):
        def decide(self, seen: Observation) -> Commands:
            commands = Commands()
            commands.wheels(7, 1.0, 1.0)
            return commands

    class Nothing(Team):
        def decide(self, seen: Observation) -> Commands:
            return None  # type: ignore[return-value]

    with pytest.raises(fulbito.TeamError, match="a command for robot 7"):
        fulbito.play(Numbers, "idle", half_seconds=1)
    with pytest.raises(fulbito.TeamError, match="AttributeError"):
        fulbito.play(Nothing, "idle", half_seconds=1)


def test_other_threads_run_while_a_match_is_played() -> None:
    counted, stop = [0], threading.Event()

    def count() -> None:
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    fulbito.play("libero", "libero", half_seconds=60)
    stop.set()
    thread.join()
    assert counted[0] > 10


def test_several_threads_play_at_once() -> None:
    hashes: list[str] = []
    threads = [threading.Thread(target=lambda: hashes.append(fulbito.play(Chaser, "classic", half_seconds=5).final_hash))
               for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(hashes)) == 1 and len(hashes) == 4


@pytest.mark.parametrize("blue", ["'libero'", "Chaser"])
def test_ctrl_c_stops_a_match(blue: str, tmp_path: Path) -> None:
    # What is started in the background of a shell ignores the signal until it says otherwise.
    script = ("import fulbito, signal; from teams import Chaser\n"
              "signal.signal(signal.SIGINT, signal.default_int_handler); print('go', flush=True)\n"
              "try: fulbito.play(%s, 'libero', half_seconds=590)\n"
              "except KeyboardInterrupt: print('stopped')\n" % blue)
    paths = os.pathsep.join([str(Path(__file__).parent), *sys.path])
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True,
                          env={**os.environ, "PYTHONPATH": paths}) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "go\n"
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline() == "stopped\n"
    assert child.returncode == 0


def test_a_bar_shows_the_progress(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("tqdm")
    fulbito.play("idle", "idle", half_seconds=5, progress=True)
    assert "match" in capsys.readouterr().err
