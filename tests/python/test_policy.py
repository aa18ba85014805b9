"""Policies as files, and as teams."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import fulbito
from fulbito import _core
from fulbito.team import Commands, MatchInfo, Observation, Team

pytest.importorskip("onnxruntime")
onnx = pytest.importorskip("onnx")

from fulbito.policy import Policy, PolicyMaker, save_policy  # noqa: E402
from fulbito.policy_team import PolicyTeam  # noqa: E402

SIGHT = 71  # numbers that a robot of three sees


def layers(*sizes: int, seed: int = 1) -> list[tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Random dense layers."""
    chance = np.random.default_rng(seed)
    return [(chance.normal(0, 0.2, (out, into)), chance.normal(0, 0.2, out)) for into, out in zip(sizes, sizes[1:])]


@pytest.fixture(scope="module")
def striker(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A policy without sense for fulbito/VSS-v0."""
    path = tmp_path_factory.mktemp("policy") / "striker.onnx"
    options = {"observation": "egocentric", "action": "wheels", "frame_skip": 3}
    save_policy(path, layers(SIGHT, 16, 2), PolicyMaker("fulbito/VSS-v0", options, "a test"))
    return path


def test_a_policy_says_what_it_was_made_for(striker: Path) -> None:
    policy = Policy.load(striker)
    assert policy.maker == PolicyMaker("fulbito/VSS-v0", {"observation": "egocentric", "action": "wheels", "frame_skip": 3}, "a test")
    assert (policy.observation_size, policy.action_size) == (SIGHT, 2)


def test_it_is_tanh_between_dense_layers_and_clips(tmp_path: Path) -> None:
    given = layers(5, 7, 3, seed=2)
    given[-1] = (given[-1][0] * 10, given[-1][1])
    save_policy(tmp_path / "p.onnx", given, PolicyMaker("fulbito/Drill-v0"))
    policy = Policy.load(tmp_path / "p.onnx")
    seen = np.random.default_rng(3).normal(size=(40, 5)).astype(np.float32)
    (w0, b0), (w1, b1) = given
    expected = np.clip(np.tanh(seen @ w0.T + b0) @ w1.T + b1, -1, 1)
    assert np.allclose(policy(seen), expected, atol=1e-5)
    assert np.abs(expected).max() == 1.0
    assert np.allclose(policy(seen[7]), policy(seen)[7], atol=1e-6)
    assert policy(seen).dtype == np.float32


@pytest.mark.parametrize("wrong", [np.zeros(70), np.zeros((2, 72)), np.zeros((1, 1, 71)), np.full(71, np.nan), np.full(71, np.inf)])
def test_observations_that_do_not_fit(striker: Path, wrong: NDArray[np.float64]) -> None:
    with pytest.raises(fulbito.UsageError, match="observation"):
        Policy.load(striker)(wrong)


def test_files_that_are_no_policies(tmp_path: Path, striker: Path) -> None:
    with pytest.raises(fulbito.FileError, match="nobody.onnx: there is no such file"):
        Policy.load(tmp_path / "nobody.onnx")
    broken = tmp_path / "broken.onnx"
    broken.write_bytes(striker.read_bytes()[:200])
    with pytest.raises(fulbito.InputError, match="broken.onnx"):
        Policy.load(broken)
    model = onnx.load(str(striker))
    for text, reason in [(None, "does not say"), ('{"format": 9}', "format 9"), ("{", "broken"), ('{"format": 1}', "broken")]:
        del model.metadata_props[:]
        if text is not None:
            onnx.helper.set_model_props(model, {"fulbito": text})
        onnx.save(model, str(broken))
        with pytest.raises(fulbito.InputError, match=reason):
            Policy.load(broken)


def test_layers_that_do_not_fit(tmp_path: Path) -> None:
    maker = PolicyMaker("fulbito/Drill-v0")
    for wrong in ([], [(np.zeros((2, 3)), np.zeros(3))], [*layers(3, 4), *layers(5, 2)], [(np.zeros(3), np.zeros(3))]):
        with pytest.raises(fulbito.UsageError, match="layer"):
            save_policy(tmp_path / "p.onnx", wrong, maker)
    with pytest.raises(fulbito.FileError, match="nowhere"):
        save_policy(tmp_path / "nowhere" / "p.onnx", layers(3, 2), maker)


class Spy(Team):
    """Keeps what robot 0 of the team would see as an environment's observation."""

    forms = ("egocentric", "absolute")

    def __init__(self) -> None:
        super().__init__()
        self.seen: dict[str, list[NDArray[np.float32]]] = {form: [] for form in self.forms}
        self.agents: dict[str, _core.Agent] = {}

    def begin(self, info: MatchInfo) -> None:
        self.agents = {form: _core.Agent(info, form, "wheels") for form in self.forms}

    def decide(self, seen: Observation) -> Commands:
        for form, agent in self.agents.items():
            self.seen[form].append(agent.observe(seen, 0))
        return Commands()


@pytest.mark.parametrize("form", Spy.forms)
def test_a_team_sees_what_the_environment_tells(form: str) -> None:
    gymnasium = pytest.importorskip("gymnasium")
    import fulbito.envs  # noqa: F401  registers the environments

    spy = Spy()
    env: Any = gymnasium.make("fulbito/VSS-v0", mates=spy, opponents="chaser", observation=form, position_noise=0.002, latency_ticks=2)
    observation, _ = env.reset(seed=5)
    told = [observation]
    for _ in range(120):
        observation, _, terminated, truncated, _ = env.step(np.array([0.7, 0.4], dtype=np.float32))
        told.append(observation)
        if terminated or truncated:
            break
    played = spy.seen[form][-len(told) + 1:]
    assert len(played) > 20
    for expected, found in zip(told, played):
        np.testing.assert_allclose(found, expected, atol=1e-6)


def test_commands_of_each_form() -> None:
    info = MatchInfo()
    info.robot.max_wheel_speed, info.robot.wheel_radius, info.robot.axle_track = 50.0, 0.02, 0.08
    info.field.length, info.field.width = 1.5, 1.3
    info.rules = {"periods": {"half_seconds": 300.0}}
    half = np.array([0.5, -2.0], dtype=np.float32)
    assert _core.Agent(info, "egocentric", "wheels").command(half) == ("wheels", 25.0, -50.0)
    kind, linear, angular = _core.Agent(info, "egocentric", "twist").command(half)
    assert (kind, linear) == ("twist", 0.5)
    assert angular == pytest.approx(-25.0)
    place = np.array([1.0, -0.5, 1.0], dtype=np.float32)
    assert _core.Agent(info, "egocentric", "go-to").command(place) == pytest.approx(("go-to", 0.75, -0.325, np.pi))
    with pytest.raises(fulbito.UsageError, match="3 numbers, not 2"):
        _core.Agent(info, "egocentric", "go-to").command(half)
    with pytest.raises(fulbito.UsageError, match="'sideways' is none of"):
        _core.Agent(info, "egocentric", "sideways")
    with pytest.raises(fulbito.UsageError, match="'blind' is none of"):
        _core.Agent(info, "blind", "wheels")


@pytest.mark.skipif(Path(fulbito.__file__).is_symlink(), reason="the sandbox follows no links out of the package in a build folder")
def test_a_policy_plays_in_this_process_and_as_a_program_alike(striker: Path) -> None:
    here = fulbito.play(PolicyTeam(striker), "chaser", seed=3, half_seconds=5)
    program = f"cmd:{sys.executable} -m fulbito.policy_team {striker}"
    there = fulbito.play(program, "chaser", seed=3, half_seconds=5, time_ms=None)
    assert here.final_hash == there.final_hash
    assert here.statistics["blue"]["commands"]["rejected"] == 0


def test_the_policy_drives_the_nearest_robot_or_all(striker: Path) -> None:
    class Watched(PolicyTeam):
        chosen: set[tuple[int, ...]] = set()

        def strikers(self, seen: Observation) -> list[int]:
            chosen = super().strikers(seen)
            self.chosen.add(tuple(chosen))
            return chosen

    fulbito.play(Watched(striker), "chaser", seed=3, half_seconds=5)
    assert Watched.chosen == {(1,), (2,)}
    Watched.chosen = set()
    fulbito.play(Watched(striker, all_robots=True), "chaser", seed=3, half_seconds=2)
    assert Watched.chosen == {(0, 1, 2)}


def test_a_policy_that_sees_something_else_is_refused(tmp_path: Path) -> None:
    save_policy(tmp_path / "p.onnx", layers(9, 2), PolicyMaker("fulbito/VSS-v0", {"observation": "egocentric"}))
    with pytest.raises(fulbito.TeamError) as caught:
        fulbito.play(PolicyTeam(tmp_path / "p.onnx"), "idle", half_seconds=2)
    assert "9 numbers" in str(caught.value.__cause__)


def test_the_program_names_what_is_wrong(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-m", "fulbito.policy_team", str(tmp_path / "none.onnx")], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "none.onnx: there is no such file" in done.stderr
