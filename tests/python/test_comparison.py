"""Comparisons of navigators, some of them written in Python."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path as File
from typing import Any

import numpy as np
import pytest

import fulbito
from fulbito.navigation import Guidance, Navigator, Path, Scene
from teams import ByField, ByPath, ByWheels


def untimed(data: Any) -> Any:
    if isinstance(data, dict):
        return {key: untimed(value) for key, value in data.items() if not key.startswith(("wall_", "compute_"))}
    return [untimed(entry) for entry in data] if isinstance(data, list) else data


def test_a_comparison_has_the_figures_of_the_program(program: str) -> None:
    words = ["compare", "--suite", "corner", "--navigators", "bezier", "straight", "--speeds", "1.0", "--trials", "10",
             "--json"]
    printed = subprocess.run([program, *words], capture_output=True, check=True)
    here = fulbito.compare("corner", ["bezier", "straight"], speeds=[1.0], trials=10)
    assert untimed(here.data["summary"]) == untimed(json.loads(printed.stdout)["summary"])


def test_a_python_navigator_stands_beside_ours() -> None:
    comparison = fulbito.compare("corner", ["straight", ByPath, ByField, ByWheels], speeds=[1.0], trials=6)
    assert [row["navigator"] for row in comparison.rows] == ["straight", "ByPath", "by-field", "by-wheels"]
    straight, path = comparison.row("straight"), comparison.row("ByPath", speed=1.0)
    assert path["contacts"] == straight["contacts"]
    assert path["time_ratio_all"] == pytest.approx(straight["time_ratio_all"], rel=0.05)
    assert comparison.row("by-wheels")["plans_speed"]
    assert len(comparison.trials()) == 24
    traces = comparison.traces()
    assert len(traces) == 24
    assert traces[0].pose.shape == (len(traces[0].time), 3) and traces[0].commands.shape[1] == 2
    assert "| by-field |" in str(comparison)


def test_jobs_do_not_change_results() -> None:
    one, two = (fulbito.compare("corner", [ByField], speeds=[1.0], trials=6, jobs=jobs) for jobs in (1, 2))
    assert untimed(one.rows) == untimed(two.rows)
    assert np.array_equal(one.traces()[3].pose, two.traces()[3].pose)


def test_a_navigator_knows_the_scene() -> None:
    scenes: list[Scene] = []

    class Looks(Navigator):
        def plan(self, scene: Scene) -> Guidance:
            scenes.append(scene)
            return Path([scene.pose[:2], scene.goal])

    fulbito.compare("corner", [Looks], speeds=[1.0], only=17, jobs=1)
    layout = fulbito.layout("corner", 17)
    assert scenes[0].pose == pytest.approx(layout.start)
    assert scenes[0].goal == layout.goal
    wanted = np.sort([(*o.pose[:2], o.radius) for o in layout.obstacles], axis=0)
    assert np.sort(scenes[0].obstacles[:, :3], axis=0) == pytest.approx(wanted, abs=1e-6)
    assert scenes[0].field_size == (1.5, 1.3)
    assert scenes[0].robot.max_wheel_speed * scenes[0].robot.wheel_radius == pytest.approx(1.0)
    assert scenes[1].tick == scenes[0].tick + 1


def test_exceptions_of_navigators() -> None:
    class Raises(Navigator):
        def plan(self, scene: Scene) -> Guidance:
            raise ZeroDivisionError("no way")

    class Number(Navigator):
        def plan(self, scene: Scene) -> Guidance:
            return 7  # type: ignore[return-value]

    class NotFinite(Navigator):
        def plan(self, scene: Scene) -> Guidance:
            return Path([scene.pose[:2], (float("nan"), 0.0)])

    class Unmade(Navigator):
        def __init__(self, model: str) -> None:
            self.model = model

    for kind, text in ((Raises, "ZeroDivisionError: no way"), (Number, "must return Wheels, Path or Field, not int"),
                       (NotFinite, "points are not all finite"), (Unmade, "TypeError")):
        with pytest.raises(fulbito.TeamError, match=f"navigator '{kind.__name__}' raised .*{text}"):
            fulbito.compare("corner", [kind], trials=2)


def test_lists() -> None:
    assert {"bezier", "bspline-time", "dwa"} <= {info.name for info in fulbito.navigators()}
    assert {"corner", "walls"} <= {info.name for info in fulbito.suites()}
    by_name = {info.name: info for info in fulbito.navigators()}
    assert any(parameter.name == "clearance" and parameter.unit == "m" for parameter in by_name["bezier"].parameters)


def test_ctrl_c_stops_a_comparison() -> None:
    # What is started in the background of a shell ignores the signal until it says otherwise.
    script = ("import fulbito, signal; signal.signal(signal.SIGINT, signal.default_int_handler); print('go', flush=True)\n"
              "try: fulbito.compare('corner', ['dwa'], trials=100000, jobs=2)\n"
              "except KeyboardInterrupt: print('stopped')\n")
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True,
                          env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "go\n"
        time.sleep(0.5)
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline() == "stopped\n"


def test_a_bar_shows_the_progress(capsys: pytest.CaptureFixture[str], tmp_path: File) -> None:
    pytest.importorskip("tqdm")
    fulbito.compare("corner", ["straight"], speeds=[1.0], trials=2, progress=True)
    assert "compare corner" in capsys.readouterr().err
