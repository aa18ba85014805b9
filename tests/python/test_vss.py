"""fulbito/VSS-v0 and fulbito/VSSCompat-v0: conformance, seeds, states, settings."""

# pyright: reportPossiblyUnboundVariable=false

import copy
import os
import pickle
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

import fulbito
import fulbito.envs
import fulbito.team
from gymnasium.utils.env_checker import check_env

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")  # windows without a screen
IDS = ["fulbito/VSS-v0", "fulbito/VSSCompat-v0"]
FORMS: list[dict[str, Any]] = [
    {"action": "twist", "observation": "egocentric", "stack": 3, "frame_skip": 4},
    {"action": "go-to", "navigator": "univector", "mates": "chaser", "opponents": "chaser"},
    {"action": "skill", "opponents": "classic", "start": "kick-off", "end": "match"},
    {"latency_ticks": 3, "position_noise": 0.002, "heading_noise": 0.05, "dropout": 0.1},
    {"randomise": {"robot.mass": (0.12, 0.18), "ball.roll_deceleration": (0.05, 0.3)}},
    {"rules": "vsss-5v5", "robot": 4, "control_rate": 30, "substeps": 4},
]


def trace(env: Any, seed: int | None, steps: int, actions: int = 0) -> list[bytes]:
    """What an episode tells, as bytes."""
    random = np.random.default_rng(actions)
    observation, info = env.reset(seed=seed)
    told = [observation.tobytes(), repr(info).encode()]
    for _ in range(steps):
        action = action_of(env, random)
        observation, reward, terminated, truncated, info = env.step(action)
        told += [observation.tobytes(), repr((reward, terminated, truncated, info)).encode()]
        if terminated or truncated:
            observation, info = env.reset()
            told.append(observation.tobytes())
    return told


def action_of(env: Any, random: np.random.Generator) -> Any:
    if isinstance(env.action_space, gymnasium.spaces.Discrete):
        return int(random.integers(env.action_space.n))
    return random.uniform(-1, 1, env.action_space.shape).astype(np.float32)


@pytest.mark.parametrize("name", IDS)
def test_gymnasium_finds_no_fault(name: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gymnasium.make(name, render_mode="rgb_array").unwrapped)


@pytest.mark.parametrize("name", IDS)
def test_stable_baselines_finds_no_fault(name: str) -> None:
    checker = pytest.importorskip("stable_baselines3.common.env_checker")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        checker.check_env(gymnasium.make(name).unwrapped, warn=True)


@pytest.mark.parametrize("form", FORMS)
def test_every_form_conforms_and_repeats(form: dict[str, Any]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(gymnasium.make("fulbito/VSS-v0", **form).unwrapped, skip_render_check=True)
    first, second = (gymnasium.make("fulbito/VSS-v0", **form) for _ in range(2))
    assert trace(first, 7, 200) == trace(second, 7, 200)
    assert trace(first, 7, 50) != trace(second, 8, 50)


@pytest.mark.parametrize("name", IDS)
def test_a_state_goes_on_as_the_environment_does(name: str) -> None:
    env = gymnasium.make(name).unwrapped
    trace(env, 3, 120)
    state = env.get_state()
    copies = [copy.deepcopy(env), pickle.loads(pickle.dumps(env)), env.copy()]
    follow = trace(env, None, 60, actions=5)
    for other in copies:
        assert other.get_state() == state
        assert trace(other, None, 60, actions=5) == follow
    fresh = gymnasium.make(name).unwrapped
    fresh.set_state(pickle.loads(pickle.dumps(state)))
    assert trace(fresh, None, 60, actions=5) == follow


def test_a_state_amid_an_episode_repeats_its_observation() -> None:
    env, other = (gymnasium.make("fulbito/VSS-v0", opponents="classic", stack=2).unwrapped for _ in range(2))
    env.reset(seed=4)
    random = np.random.default_rng(0)
    for _ in range(80):
        observation, reward, terminated, truncated, info = env.step(action_of(env, random))
    again, told = other.set_state(env.get_state())
    np.testing.assert_array_equal(again, observation)
    assert told == info
    actions = [action_of(env, random) for _ in range(40)]
    assert [env.step(a)[1] for a in actions] == [other.step(a)[1] for a in actions]


def test_terms_add_up_to_the_reward() -> None:
    for name in IDS:
        env = gymnasium.make(name)
        env.reset(seed=1)
        random = np.random.default_rng(0)
        for _ in range(300):
            _, reward, terminated, truncated, info = env.step(action_of(env, random))
            assert reward == pytest.approx(sum(v for k, v in info.items() if k.startswith("reward_")), abs=1e-12)
            if terminated or truncated:
                break


def test_a_goal_ends_the_episode_and_pays() -> None:
    start = """
[ball]
position = [0.70, 0.0]
velocity = [1.5, 0.0]
[[robot]]
team = "blue"
number = 0
position = [0.0, 0.3]
"""
    for name, paid in [("fulbito/VSS-v0", 10.0), ("fulbito/VSSCompat-v0", 10.0)]:
        env = gymnasium.make(name)
        observation, _ = env.reset(seed=1, options={"start": start})
        assert observation[0] > 0.7
        for _ in range(60):
            observation, reward, terminated, truncated, info = env.step(np.zeros(2, np.float32))
            if terminated:
                break
        assert terminated and not truncated
        assert info["reward_goal"] == paid
        assert observation in env.observation_space


def test_an_episode_is_truncated_at_its_time() -> None:
    env = gymnasium.make("fulbito/VSSCompat-v0", opponents="idle", mates="idle")
    env.reset(seed=1)
    for step in range(1, 1201):
        _, _, terminated, truncated, _ = env.step(np.zeros(2, np.float32))
        if terminated or truncated:
            break
    assert (step, terminated, truncated) == (1200, False, True)


def test_a_whole_match_goes_through_its_halves() -> None:
    env = gymnasium.make("fulbito/VSS-v0", mates="classic", opponents="chaser", end="match", start="kick-off",
                         time_limit=0, frame_skip=60)
    env.reset(seed=1)
    terminated, steps = False, 0
    while not terminated:
        _, _, terminated, truncated, info = env.step(np.zeros(2, np.float32))
        steps += 1
        assert not truncated
    assert 500 < steps < 1000 and info["seconds"] > 500


class Ahead(fulbito.team.Team):
    """All robots drive ahead."""

    def decide(self, seen: Any) -> Any:
        commands = fulbito.team.Commands()
        for number in range(3):
            commands.wheels(number, 20.0, 20.0)
        return commands


class Broken(fulbito.team.Team):
    """It raises."""

    def decide(self, seen: Any) -> Any:
        raise RuntimeError("no idea")


def full_speed(observations: Any) -> Any:
    """A policy."""
    assert observations.dtype == np.float32
    return np.full((len(observations), 2), 20.0 / 46.08, np.float32)


def test_teams_and_policies_of_this_process_play() -> None:
    ours = gymnasium.make("fulbito/VSS-v0", opponents=Ahead, mates=Ahead)
    assert trace(ours, 1, 200) == trace(gymnasium.make("fulbito/VSS-v0", opponents=Ahead, mates=Ahead), 1, 200)
    policy = gymnasium.make("fulbito/VSS-v0", opponents=full_speed, mates=full_speed, robot=1)
    team = gymnasium.make("fulbito/VSS-v0", opponents=Ahead, mates=Ahead, robot=1)
    seen, same = policy.reset(seed=2)[0], team.reset(seed=2)[0]
    for _ in range(60):
        np.testing.assert_allclose(seen, same, atol=1e-5)
        seen, same = policy.step(np.ones(2))[0], team.step(np.ones(2))[0]
    copied = copy.deepcopy(policy.unwrapped)
    np.testing.assert_array_equal(copied.step(np.ones(2))[0], policy.step(np.ones(2))[0])


def test_policies_drive_the_others_of_a_vector() -> None:
    vector = gymnasium.make_vec("fulbito/VSS-v0", 3, opponents=full_speed, robot=2)
    single = gymnasium.make("fulbito/VSS-v0", opponents=full_speed, robot=2)
    observations, seen = vector.reset(seed=5)[0], single.reset(seed=6)[0]
    for _ in range(100):
        np.testing.assert_array_equal(observations[1], seen)
        observations, rewards, *_ = vector.step(np.ones((3, 2), np.float32))
        seen, reward, *_ = single.step(np.ones(2, np.float32))
        assert rewards.shape == (3,) and rewards[1] == reward


def test_a_class_plays_in_each_environment_of_a_vector() -> None:
    vector = gymnasium.make_vec("fulbito/VSS-v0", 4, opponents=Ahead, threads=3)
    single = gymnasium.make("fulbito/VSS-v0", opponents=Ahead)
    observations, seen = vector.reset(seed=5)[0], single.reset(seed=7)[0]
    for _ in range(50):
        np.testing.assert_array_equal(observations[2], seen)
        observations = vector.step(np.ones((4, 2), np.float32))[0]
        seen = single.step(np.ones(2, np.float32))[0]
    broken = gymnasium.make_vec("fulbito/VSS-v0", 4, opponents=Broken, threads=3)
    with pytest.raises(fulbito.TeamError, match="no idea"):
        broken.reset(seed=1)
        broken.step(np.ones((4, 2), np.float32))
    broken.close()
    with pytest.raises(fulbito.UsageError, match="needs its class"):
        gymnasium.make_vec("fulbito/VSS-v0", 2, opponents=Ahead())


def test_what_a_team_raises_is_told() -> None:
    env = gymnasium.make("fulbito/VSS-v0", opponents=Broken)
    with pytest.raises(fulbito.TeamError, match="no idea") as caught:
        env.reset(seed=1)
        env.step(np.zeros(2, np.float32))
    assert isinstance(caught.value.__cause__, RuntimeError)


@pytest.mark.parametrize("name", IDS)
def test_pictures_have_pixels(name: str) -> None:
    env = gymnasium.make(name, render_mode="rgb_array")
    env.reset(seed=1)
    picture = env.render()
    assert picture.dtype == np.uint8 and picture.shape[1:] == (600, 3) and picture.std() > 10


def test_a_window_shows_each_step() -> None:
    env = gymnasium.make("fulbito/VSS-v0", render_mode="human", render_width=300)
    env.reset(seed=1)
    for _ in range(5):
        env.step(np.ones(2, np.float32))
    assert env.render() is None
    env.close()


def test_chosen_episodes_are_recorded(tmp_path: Path) -> None:
    from fulbito.wrappers import RecordMatch
    env = RecordMatch(gymnasium.make("fulbito/VSS-v0", time_limit=1.0), tmp_path / "new", episodes=lambda n: n % 2 == 0)
    for seed in range(3):
        env.reset(seed=seed)
        over = False
        while not over:
            _, _, terminated, truncated, _ = env.step(env.action_space.sample())
            over = terminated or truncated
    assert [file.name for file in env.files] == ["episode-0.fbr", "episode-2.fbr"]
    for file in env.files:
        fulbito.Recording.open(file).verify()
