"""fulbito/Drill-v0: conformance, seeds, the judge of the program, state, bad input."""

import json
import pickle
import subprocess
import warnings
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from numpy.typing import NDArray

import fulbito
from fulbito.envs import DrillCurriculum, DrillEnv, DrillVectorEnv, drills

Floats = NDArray[np.float32]
PLAYABLE = [drill.number for drill in drills() if drill.playable]


def make(**settings: Any) -> DrillEnv:
    env = gymnasium.make("fulbito/Drill-v0", **settings).unwrapped
    assert isinstance(env, DrillEnv)
    return env


def play(env: DrillEnv, seed: int, actions: Floats) -> list[Any]:
    """All that an episode tells, for comparisons of bits."""
    told: list[Any] = [env.reset(seed=seed)[0].tobytes()]
    for action in actions:
        observation, reward, terminated, truncated, info = env.step(action)
        told.append((observation.tobytes(), reward, terminated, truncated, tuple(info.values())))
        if terminated or truncated:
            break
    return told


def random_actions(env: DrillEnv, count: int, seed: int = 0) -> Floats:
    generator = np.random.default_rng(seed)
    assert env.action_space.shape is not None
    return generator.uniform(-1, 1, (count, *env.action_space.shape)).astype(np.float32)


def test_drills_of_trials_are_playable() -> None:
    assert PLAYABLE == list(range(1, 18))
    assert [drill.number for drill in drills()] == list(range(1, 22))


@pytest.mark.parametrize("number", PLAYABLE)
def test_conformance(number: int) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(make(drill=number, frame_skip=6), skip_render_check=number != 3)


@pytest.mark.parametrize("action, numbers", [("wheels", 2), ("twist", 2), ("go-to", 3)])
def test_actions(action: str, numbers: int) -> None:
    env = make(action=action)
    assert env.action_space.shape == (numbers,)
    assert env.observation_space.shape == (len(DrillEnv.observation_table()),)
    told = play(env, 1, random_actions(env, 20))
    assert len(told) == 21


def test_equal_seeds_and_actions_give_equal_bits() -> None:
    one, other = make(drill=14, frame_skip=4), make(drill=14, frame_skip=4)
    actions = random_actions(one, 200)
    first = play(one, 5, actions)
    play(other, 6, actions)
    assert play(other, 5, actions) == first
    assert play(one, 6, actions) != first


def test_reward_is_the_sum_of_its_terms() -> None:
    env = make(frame_skip=4)
    env.reset(seed=3)
    for action in random_actions(env, 50):
        _, reward, _, _, info = env.step(action)
        assert reward == pytest.approx(sum(value for name, value in info.items() if name.startswith("reward_")))


def test_weights_switch_terms_off() -> None:
    env = make(rewards={name: 0.0 for name in ("success", "failure", "time", "ball", "approach", "align", "answer")})
    env.reset(seed=3)
    assert all(env.step(action)[1] == 0.0 for action in random_actions(env, 50))


def test_train_and_test_differ_and_test_is_among_the_trials_of_the_program() -> None:
    train, test = make(), make(split="test")
    assert not np.array_equal(train.reset(seed=7)[0], test.reset(seed=7)[0])
    seen, info = test.reset(seed=7)
    seed = test.get_state().start_seed
    assert seed is not None
    again, _ = train.reset(options={"start": f"trial {int(info['trial'])} of seed {seed % 2**63}"})
    assert np.array_equal(seen, again)


def test_the_program_judges_like_the_environment() -> None:
    """An agent that does nothing, beside a team that does nothing."""
    done = subprocess.run([fulbito.program_path(), "drill", "idle", "--drill", "10", "--trials", "24", "--seed", "3",
                           "--json"], capture_output=True, text=True, check=True)
    expected = sum(round(bar["value"] * bar["count"]) for bar in json.loads(done.stdout)["drills"][0]["bars"])
    env = make(drill=10, mates="idle", frame_skip=10)
    successes = 0
    for trial in range(24):
        env.reset(options={"start": f"trial {trial} of seed 3"})
        while True:
            _, _, terminated, truncated, info = env.step(np.zeros(2, np.float32))
            if terminated or truncated:
                break
        successes += info["success"]
    assert successes == expected > 0


def test_state_copy_and_pickle_play_on_alike() -> None:
    env = make(drill=14, frame_skip=4)
    actions = random_actions(env, 60)
    env.reset(seed=2)
    for action in actions[:20]:
        env.step(action)
    state = env.get_state()
    copies = [env.copy(), pickle.loads(pickle.dumps(env))]
    expected = [env.step(action)[0].tobytes() for action in actions[20:]]
    fresh = make(drill=14, frame_skip=4)
    fresh.set_state(state)
    for other in (*copies, fresh):
        assert [other.step(action)[0].tobytes() for action in actions[20:]] == expected
    env.set_state(state)
    assert [env.step(action)[0].tobytes() for action in actions[20:]] == expected


def test_vector_plays_what_single_environments_play() -> None:
    count, steps = 4, 80
    vector = gymnasium.make_vec("fulbito/Drill-v0", num_envs=count, frame_skip=4)
    assert isinstance(vector.unwrapped, DrillVectorEnv)
    observations, _ = vector.reset(seed=9)
    singles = [make(frame_skip=4) for _ in range(count)]
    first = [env.reset(seed=9 + i)[0] for i, env in enumerate(singles)]
    assert np.array_equal(observations, first)
    generator = np.random.default_rng(0)
    for _ in range(steps):
        actions = generator.uniform(-1, 1, (count, 2)).astype(np.float32)
        observations, rewards, terminated, truncated, infos = vector.step(actions)
        if (terminated | truncated).any():
            break
        for i, env in enumerate(singles):
            observation, reward, *_, info = env.step(actions[i])
            assert np.array_equal(observations[i], observation) and rewards[i] == reward
            assert infos["reward_ball"][i] == info["reward_ball"]
    vector.close()


def test_a_picture_and_a_recording(tmp_path: Path) -> None:
    env = make(render_mode="rgb_array", frame_skip=6, render_width=480)
    env.record(str(tmp_path / "trial.fbr"))
    env.reset(seed=1)
    while True:
        *_, terminated, truncated, _ = env.step(np.array([1, 0.8], np.float32))
        if terminated or truncated:
            break
    picture = env.render()
    assert picture is not None
    assert picture.dtype == np.uint8 and picture.shape[1:] == (480, 3)
    assert subprocess.run([fulbito.program_path(), "replay", "verify", tmp_path / "trial.fbr"]).returncode == 0


def test_a_drill_of_ones_own(tmp_path: Path) -> None:
    file = tmp_path / "tap.toml"
    file.write_text('[drill]\nnumber = 900\nwhat = "tap in"\nduration = 2.0\nreferee = false\n[[start]]\n'
                    'ball = [[0.5, 0.0]]\n[[robot]]\nfrom_ball = true\nat = [[-0.1, 0.0]]\n'
                    '[[success]]\nwhat = "goal"\n[[pass]]\nvalue = "success"\nstatistic = "rate"\nat_least = 0.5\n')
    env = make(file=file, action="twist")
    assert env.starts() == ["all"]
    env.reset(seed=1)
    while True:
        *_, terminated, truncated, info = env.step(np.array([1, 0], np.float32))
        if terminated or truncated:
            break
    assert terminated and info["success"] == 1 and info["reward_success"] == 10 and 0 < info["time"] < 1


def test_models_are_drawn_anew() -> None:
    env = make(randomise={"ball.roll_deceleration": (0.05, 0.5)}, drill=6)
    actions = np.zeros((60, 2), np.float32)
    assert play(env, 1, actions) == play(env, 1, actions)
    assert play(env, 1, actions)[-1] != play(make(drill=6), 1, actions)[-1]


def test_curriculum() -> None:
    curriculum = DrillCurriculum([1, 3], bar=0.5, window=4)
    assert curriculum.drill == 1
    for success in (False, True, True):
        curriculum.add(1, success)
    assert curriculum.drill == 1 and curriculum.rate(1) == pytest.approx(2 / 3)
    curriculum.add(1, False)
    assert curriculum.drill == 3
    for _ in range(4):
        curriculum.add(3, True)
    assert curriculum.drill is None


@pytest.mark.parametrize("settings, text", [
    ({"drill": 18}, "plays whole matches"),
    ({"drill": 20}, "repeats other drills"),
    ({"drill": 99}, "there is no drill 99"),
    ({"drill": "three"}, "drill: 'three' is no whole number"),
    ({"file": "/no/such/drill.toml"}, "/no/such/drill.toml"),
    ({"action": "skill"}, "none of wheels, twist, go-to"),
    ({"split": "both"}, "none of train, test"),
    ({"frame_skip": 0}, "frame_skip: 0 is outside 1 ... 60"),
    ({"robot": 2}, "has no own robot 2"),
    ({"mates": "liberooo"}, "liberooo"),
    ({"rewards": {"goal": 1.0}}, "'goal' is none of success"),
    ({"rewards": {"time": float("nan")}}, "time is not finite"),
    ({"position_noise": -1.0}, "noise"),
    ({"latency_ticks": 61}, "61"),
    ({"randomise": {"ball.colour": (0, 1)}}, "ball.colour"),
    ({"randomise": {"ball.friction": (0.3, 0.1)}}, "empty"),
    ({"physics": "none-such"}, "none-such"),
    ({"navigator": "none-such"}, "none-such"),
    ({"render_mode": "ansi"}, "render_mode"),
])
def test_wrong_settings(settings: dict[str, Any], text: str) -> None:
    with pytest.raises((fulbito.UsageError, fulbito.FileError), match="(?s).*" + text):
        DrillEnv(**settings)


def test_wrong_calls() -> None:
    env = DrillEnv()
    with pytest.raises(fulbito.StateError, match="reset"):
        env.step(np.zeros(2, np.float32))
    env.reset(seed=1)
    for action in (np.zeros(3, np.float32), np.zeros((1, 2), np.float32), np.full(2, np.nan, np.float32), "left",
                   np.zeros(2, bool), [[0.0], [0.0, 1.0]]):
        with pytest.raises(fulbito.UsageError):
            env.step(action)
    for start in ("trial", "trial -1", "trial 1.5", "layout 3", 7):
        with pytest.raises(fulbito.UsageError):
            env.reset(options={"start": start})
    env.close()
    with pytest.raises(fulbito.StateError):
        env.reset()
    wrong: list[tuple[list[int], dict[str, Any]]] = [([18], {}), ([], {}), ([3], {"bar": 0.0}), ([3], {"window": 0})]
    for numbers, values in wrong:
        with pytest.raises(fulbito.UsageError):
            DrillCurriculum(numbers, **values)
    with pytest.raises(fulbito.UsageError):
        DrillCurriculum([3]).add(4, True)
