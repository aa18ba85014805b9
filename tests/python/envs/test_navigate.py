"""fulbito/Navigate-v0: conformance, seeds, the scores of `compare`, state, bad input."""

import pickle
import warnings
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from numpy.typing import NDArray

import fulbito
from fulbito.envs import NavigateEnv, NavigateVectorEnv
from fulbito.envs.navigate import OUTCOMES
from fulbito.navigation import Guidance, Navigator, Scene, Wheels, learnt

Floats = NDArray[np.float32]
ROOT = Path(__file__).resolve().parents[3]


def make(**settings: Any) -> NavigateEnv:
    env = gymnasium.make("fulbito/Navigate-v0", **settings).unwrapped
    assert isinstance(env, NavigateEnv)
    return env


def finish(env: NavigateEnv, action: Floats) -> tuple[Any, Any, bool, bool, dict[str, Any]]:
    """Plays to the end; the last step."""
    while True:
        step = env.step(action)
        if step[2] or step[3]:
            return step


@pytest.mark.parametrize("suite", [suite.name for suite in fulbito.suites()])
def test_conformance(suite: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(make(suite=suite, frame_skip=4), skip_render_check=suite != "corner")


@pytest.mark.parametrize("action", ["wheels", "twist", "heading"])
def test_equal_seeds_and_actions_give_equal_bits(action: str) -> None:
    env = make(action=action, suite="moving", frame_skip=3)
    assert env.action_space.shape == (2,)
    assert env.observation_space.shape == (len(NavigateEnv.observation_table()),)
    actions = np.random.default_rng(0).uniform(-1, 1, (40, 2)).astype(np.float32)

    def told(seed: int) -> list[Any]:
        rows: list[Any] = [env.reset(seed=seed)[0].tobytes()]
        for row in actions:
            observation, reward, terminated, truncated, info = env.step(row)
            rows.append((observation.tobytes(), reward, tuple(info.values())))
            assert reward == pytest.approx(sum(v for name, v in info.items() if name.startswith("reward_")))
            if terminated or truncated:
                break
        return rows

    first = told(5)
    assert told(6) != first
    assert told(5) == first


class HalfAhead(Navigator):
    """Both wheels at half their greatest speed."""

    def plan(self, scene: Scene) -> Guidance:
        return Wheels(0.5 * scene.robot.max_wheel_speed, 0.5 * scene.robot.max_wheel_speed)


@pytest.mark.parametrize("suite", ["corner", "moving", "walls"])
def test_scores_are_those_of_compare(suite: str) -> None:
    trials = fulbito.compare(suite, [HalfAhead], speeds=[1.0], trials=6, seed=3).trials()
    env = make(suite=suite, split="test")
    for trial in trials:
        env.reset(options={"start": f"layout {trial['index']} of seed 3"})
        info = finish(env, np.array([0.5, 0.5], np.float32))[4]
        assert OUTCOMES[int(info["outcome"])] == trial["outcome"]
        assert info["time"] == pytest.approx(float(trial["time_s"]), abs=0)
        assert info["length"] == pytest.approx(float(trial["path_length_m"]), abs=0)


def test_the_straight_way_arrives_where_nothing_is_in_it() -> None:
    env = make(suite="short", action="heading", frame_skip=2)
    successes = 0
    for seed in range(20):
        env.reset(seed=seed)
        info = finish(env, np.array([0.0, 1.0], np.float32))[4]
        successes += info["success"]
        if info["success"]:
            assert info["reward_success"] == 10 and 0.9 <= info["time_ratio"] < 1.3
    assert 1 <= successes < 20


def test_a_named_layout_and_one_of_a_file(tmp_path: Path) -> None:
    env = make(suite="cases")
    _, info = env.reset(options={"start": "layout fig4-wall"})
    assert info["layout"] == 4
    file = tmp_path / "free.toml"
    file.write_text("[start]\nposition = [-0.5, 0.0]\nheading = 0.0\n[goal]\nposition = [0.5, 0.0]\n")
    env = make(layout=file)
    env.reset(seed=1)
    _, _, terminated, _, info = finish(env, np.array([1, 1], np.float32))
    assert terminated and info["success"] == 1 and info["length_ratio"] == pytest.approx(1.0, abs=0.05)


def test_a_contact_ends_an_episode_if_asked() -> None:
    ended = make(ends_at_contact=True)
    going = make()
    for env, wall in ((ended, True), (going, False)):
        env.reset(seed=1)
        info = finish(env, np.array([1, 1], np.float32))[4]
        assert OUTCOMES[int(info["outcome"])] == "collided" and info["success"] == 0
        assert (info["time"] < 3.0) == wall


def test_state_copy_and_pickle_play_on_alike() -> None:
    env = make(suite="moving", frame_skip=2, position_noise=0.002)
    actions = np.random.default_rng(1).uniform(-1, 1, (30, 2)).astype(np.float32)
    env.reset(seed=2)
    for action in actions[:10]:
        env.step(action)
    copies = [env.copy(), pickle.loads(pickle.dumps(env))]
    expected = [env.step(action)[0].tobytes() for action in actions[10:]]
    for other in copies:
        assert [other.step(action)[0].tobytes() for action in actions[10:]] == expected


def test_vector_plays_what_single_environments_play() -> None:
    vector = gymnasium.make_vec("fulbito/Navigate-v0", num_envs=3, frame_skip=3)
    assert isinstance(vector.unwrapped, NavigateVectorEnv)
    observations, _ = vector.reset(seed=4)
    singles = [make(frame_skip=3) for _ in range(3)]
    assert np.array_equal(observations, [env.reset(seed=4 + i)[0] for i, env in enumerate(singles)])
    for _ in range(20):
        actions = np.full((3, 2), 0.4, np.float32)
        observations, rewards, terminated, truncated, infos = vector.step(actions)
        for i, env in enumerate(singles):
            observation, reward, *_, info = env.step(actions[i])
            assert np.array_equal(observations[i], observation) and rewards[i] == reward
            assert infos["time_ratio"][i] == info["time_ratio"]
        assert not (terminated | truncated).any()
    vector.close()


def test_a_picture_and_a_recording(tmp_path: Path) -> None:
    env = make(render_mode="rgb_array", render_width=480)
    env.record(str(tmp_path / "trial.fbr"))
    env.reset(seed=1)
    finish(env, np.array([1, 0.9], np.float32))
    picture = env.render()
    assert picture is not None
    assert picture.dtype == np.uint8 and picture.shape[1:] == (480, 3)
    assert fulbito.Recording.open(tmp_path / "trial.fbr").verify() is not None


@pytest.mark.parametrize("settings, text", [
    ({"suite": "cornr"}, "Did you mean 'corner'"),
    ({"suite": "jung-lee-2015"}, "there is no suite"),
    ({"suite": 3}, "suite: 3 is no text"),
    ({"layout": "/no/such/layout.toml"}, "/no/such/layout.toml"),
    ({"speed": 20.0}, "20 is outside 0.05 ... 10"),
    ({"speed": "fast"}, "speed: 'fast' is no number"),
    ({"action": "go-to"}, "none of wheels, twist, heading"),
    ({"split": "all"}, "none of train, test"),
    ({"heading": "north"}, "none of layout, random, away"),
    ({"frame_skip": 100}, "frame_skip: 100 is outside 1 ... 60"),
    ({"rewards": {"ball": 1.0}}, "'ball' is none of success"),
    ({"rewards": {"goal": float("inf")}}, "goal is not finite"),
    ({"robot_model": "none-such"}, "none-such"),
    ({"physics": "none-such"}, "none-such"),
    ({"latency_ticks": -1}, "latency"),
    ({"dropout": 1.5}, "dropout"),
])
def test_wrong_settings(settings: dict[str, Any], text: str) -> None:
    with pytest.raises((fulbito.UsageError, fulbito.FileError), match="(?s).*" + text):
        NavigateEnv(**settings)


def test_wrong_calls() -> None:
    env = NavigateEnv()
    with pytest.raises(fulbito.StateError, match="reset"):
        env.step(np.zeros(2, np.float32))
    for start in ("layout", "layout north", "layout 1 of seed x", "trial 3", 3):
        with pytest.raises(fulbito.UsageError):
            env.reset(options={"start": start})
    env.reset(seed=1)
    for action in (np.zeros(3, np.float32), np.full(2, np.inf, np.float32), "left"):
        with pytest.raises(fulbito.UsageError):
            env.step(action)
    with pytest.raises(TypeError):
        NavigateEnv(colour="red")
    env.close()
    with pytest.raises(fulbito.StateError):
        env.reset()


def test_the_trained_navigator_stands_in_the_table_of_compare() -> None:
    table = fulbito.compare("corner", ["straight", learnt()], speeds=[1.0], trials=40)
    rows = {row["navigator"].rsplit(":")[-1]: row for row in table.rows}
    assert rows["learnt"]["success_rate"] >= 0.9 > rows["straight"]["success_rate"]


def test_the_trained_navigator_sees_what_the_environment_shows() -> None:
    """The network in NumPy drives an episode as the shared library does in `compare`."""
    layers = network()
    table = fulbito.compare("corner", [learnt()], speeds=[1.0], trials=4, seed=5)
    env = make(action="heading")
    for trial in table.trials():
        seen, _ = env.reset(options={"start": f"layout {trial['index']} of seed 5"})
        while True:
            seen, _, terminated, truncated, info = env.step(action_of(layers, seen))
            if terminated or truncated:
                break
        assert info["time"] == pytest.approx(float(trial["time_s"]), abs=0.05)
        assert info["length"] == pytest.approx(float(trial["path_length_m"]), abs=0.02)


def network() -> list[Floats]:
    """The layers of the trained navigator, from its source."""
    text = (ROOT / "python/environments/navigation/learnt/weights.inc").read_text().split("\n", 1)[1]
    numbers = np.array([float(number.strip().rstrip("f")) for number in text.split(",") if number.strip()], np.float32)
    layers, at = [], 0
    for shape in ((69, 48), (48,), (48, 48), (48,), (48, 2), (2,)):
        layers.append(numbers[at:at + int(np.prod(shape))].reshape(shape))
        at += layers[-1].size
    assert at == numbers.size
    return layers


def action_of(layers: list[Floats], seen: Floats) -> Floats:
    w1, b1, w2, b2, w3, b3 = layers
    return np.asarray(np.clip(np.tanh(np.tanh(seen[:69] @ w1 + b1) @ w2 + b2) @ w3 + b3, -1, 1), np.float32)
