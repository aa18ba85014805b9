"""Wrong use of environments: a clear exception each, and the environment goes on where it can."""

# pyright: reportPossiblyUnboundVariable=false

import gc
import multiprocessing
import os
import pickle
import threading
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

import fulbito.envs
import fulbito.envs.vss
from fulbito import FulbitoError, InputError, StateError, UsageError, _core

HALF = np.full(2, 0.5, np.float32)


def env(**settings: Any) -> Any:
    made = gymnasium.make("fulbito/VSS-v0", **settings).unwrapped
    made.reset(seed=1)
    return made


def vector(**settings: Any) -> Any:
    made = gymnasium.make_vec("fulbito/VSS-v0", 3, **settings).unwrapped
    made.reset(seed=1)
    return made


BAD_SETTINGS: list[tuple[dict[str, Any], str]] = [
    ({"opponents": "nobody"}, "nobody"),
    ({"opponents": 7}, "team"),
    ({"mates": "libero:agression=1"}, "agression"),
    ({"robot": 3}, "no robot 3"),
    ({"robot": -1}, "no robot -1"),
    ({"robot": "keeper"}, "list of robot numbers"),
    ({"rules": "vsss-9v9"}, "vsss-9v9"),
    ({"physics": "none"}, "none"),
    ({"control_rate": 0}, "control_rate"),
    ({"robot_model": "nothing"}, "nothing"),
    ({"action": "jump"}, "wheels, twist, go-to, skill"),
    ({"observation": 3}, "observation"),
    ({"navigator": "gps"}, "gps"),
    ({"frame_skip": 0}, "frame_skip"),
    ({"frame_skip": 1.5}, "frame_skip"),
    ({"stack": 0}, "stack"),
    ({"time_limit": -1.0}, "seconds"),
    ({"time_limit": float("nan")}, "seconds"),
    ({"rewards": {"gaol": 1.0}}, "gaol"),
    ({"rewards": {"goal": float("inf")}}, "goal"),
    ({"rewards": 5}, "rewards"),
    ({"randomise": {"robot.mas": (0.1, 0.2)}}, "robot.mass"),
    ({"randomise": {"robot.mass": (0.2, 0.1)}}, "robot.mass"),
    ({"randomise": {"robot.mass": (-1.0, 0.1)}}, "robot.mass"),
    ({"latency_ticks": 61}, "latency"),
    ({"position_noise": -0.1}, "noise"),
    ({"dropout": 1.0}, "drop"),
    ({"start": "middle"}, "kick-off, random"),
    ({"end": "never"}, "goal, match"),
    ({"render_mode": "ansi"}, "ansi"),
]


@pytest.mark.parametrize(("settings", "text"), BAD_SETTINGS)
def test_settings_are_checked(settings: dict[str, Any], text: str) -> None:
    with pytest.raises((FulbitoError, TypeError), match=text):
        fulbito.envs.vss.VSSEnv(**settings)


BAD_ACTIONS: list[Any] = [np.zeros(3, np.float32), np.zeros((2, 1), np.float32), np.array([np.nan, 0], np.float32),
                          np.array([0, np.inf], np.float32), np.array(["a", "b"]), [0.1], None, "left",
                          np.zeros(2, complex), [[1], [2, 3]], {"left": 1}]


@pytest.mark.parametrize("action", BAD_ACTIONS, ids=repr)
def test_actions_are_checked_and_change_nothing(action: Any) -> None:
    one, other = env(), env()
    with pytest.raises(UsageError, match="actions"):
        one.step(action)
    np.testing.assert_array_equal(one.step(HALF)[0], other.step(HALF)[0])


def test_actions_of_any_real_dtype_and_order_are_taken() -> None:
    expected = env().step(HALF)[0]
    frozen = HALF.copy()
    frozen.flags.writeable = False
    for action in (HALF.astype(np.float64), HALF.astype(np.float16), [0.5, 0.5], frozen, np.full(4, 0.5, np.float32)[::2]):
        np.testing.assert_array_equal(env().step(action)[0], expected)
    np.testing.assert_array_equal(env().step(np.array([1, 1]))[0], env().step(np.full(2, 7.5))[0])  # clipped


@pytest.mark.parametrize("choice", [-1, 10, 2.5, np.nan, "strike", None, [1, 2]])
def test_choices_are_checked(choice: Any) -> None:
    with pytest.raises(UsageError, match="actions"):
        env(action="skill").step(choice)


@pytest.mark.parametrize("actions", [np.zeros((2, 2), np.float32), np.zeros((3, 3), np.float32), np.zeros(6, np.float32),
                                     np.full((3, 2), np.nan, np.float32), "all", None], ids=repr)
def test_actions_of_a_vector_are_checked(actions: Any) -> None:
    with pytest.raises(UsageError, match="actions"):
        vector().step(actions)


@pytest.mark.parametrize("ids", [[3], [-1], [0, 0], [], [0.5], [[0]], "all"])
def test_numbers_of_environments_are_checked(ids: Any) -> None:
    with pytest.raises(UsageError):
        vector().send(np.zeros((len(ids), 2), np.float32), ids)


@pytest.mark.parametrize("mask", [np.zeros(2, np.bool_), np.zeros(3), np.zeros((3, 1), np.bool_)], ids=repr)
def test_masks_are_checked(mask: Any) -> None:
    with pytest.raises(UsageError, match="reset_mask"):
        vector().reset(options={"reset_mask": mask})


@pytest.mark.parametrize("start", [3, "no toml", "[ball]\nposition = [9, 9]\n", "[ball]\nposition = [0, 0]\n"])
def test_starts_are_checked(start: Any) -> None:
    made = env()
    with pytest.raises((UsageError, InputError)):
        made.reset(options={"start": start})
    made.reset(seed=1)
    made.step(HALF)


BAD_VECTORS: list[dict[str, Any]] = [{"num_envs": 0}, {"num_envs": -1}, {"autoreset_mode": "Never"},
                                     {"render_mode": "human"}]


@pytest.mark.parametrize("settings", BAD_VECTORS, ids=repr)
def test_settings_of_a_vector_are_checked(settings: dict[str, Any]) -> None:
    with pytest.raises(UsageError):
        fulbito.envs.vss.VSSVectorEnv(**settings)


def test_seeds_are_checked() -> None:
    with pytest.raises(UsageError, match="2 seeds for 3"):
        vector().reset(seed=[1, 2])
    with pytest.raises(gymnasium.error.Error):
        env().reset(seed=-1)


def test_the_order_of_calls() -> None:
    made = fulbito.envs.vss.VSSEnv(time_limit=1 / 60)
    with pytest.raises(StateError, match="reset"):
        made.step(HALF)
    made.reset(seed=1)
    assert made.step(HALF)[3]
    with pytest.raises(StateError, match="over"):
        made.step(HALF)
    with pytest.raises(StateError, match="reset"):
        fulbito.envs.vss.VSSVectorEnv(2).step(np.zeros((2, 2), np.float32))
    with pytest.raises(StateError, match="send before recv"):
        vector().recv()


def test_a_step_that_is_under_way_comes_first() -> None:
    made = vector()
    made.send(np.zeros((3, 2), np.float32))
    for call in (made.reset, lambda: made.step(np.zeros((3, 2), np.float32))):
        with pytest.raises(StateError, match="under way"):
            call()
    made.recv()
    made.send(np.zeros((3, 2), np.float32))
    made.close()


def test_use_after_close() -> None:
    one, many = env(render_mode="rgb_array"), vector(states=True)
    one.close()
    one.close()
    many.close()
    many.close()
    calls: list[Callable[[], Any]] = [
        lambda: one.step(HALF), one.reset, one.get_state, one.render, lambda: pickle.dumps(one),
        lambda: many.step(np.zeros((3, 2), np.float32)), many.reset, many.get_states, many.recv]
    for call in calls:
        with pytest.raises(StateError, match="closed"):
            call()


def test_states_of_other_environments() -> None:
    with pytest.raises(UsageError, match="not one of this"):
        env().set_state(fulbito.envs.EpisodeState(0, 0, 1, "", b"1234"))
    with pytest.raises(UsageError, match="not one of this"):
        env().set_state(fulbito.envs.EpisodeState(0, 0, 1, "", b"123"))
    with pytest.raises(UsageError, match="states"):
        vector().get_states()
    with pytest.raises(UsageError, match="1 states for 3"):
        vector(states=True).set_states([env().get_state()])


def test_a_vector_does_not_pickle() -> None:
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(vector())


def test_arrays_of_the_core_are_checked() -> None:
    settings = fulbito.envs.MatchSettings()
    source = settings.source()
    seen, numbers = np.zeros(56, np.float32), np.zeros(10)
    frozen = np.zeros(56, np.float32)
    frozen.flags.writeable = False
    wrong: list[Any] = [frozen, seen.astype(np.float64), np.zeros(112, np.float32)[::2]]
    for observations in wrong:
        with pytest.raises(TypeError):
            _core.Environment(source, observations, numbers)
    with pytest.raises(UsageError):
        _core.Environment(source, np.zeros(55, np.float32), numbers)


def test_two_threads_in_one_environment() -> None:
    made = vector(opponents="libero", mates="libero", frame_skip=100, time_limit=0)
    errors: list[Exception] = []
    begin = threading.Barrier(2)

    def run() -> None:
        begin.wait()
        for _ in range(50):
            try:
                made.step(np.zeros((3, 2), np.float32))
            except StateError as error:
                errors.append(error)

    threads = [threading.Thread(target=run) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors and "another thread" in str(errors[0])
    made.step(np.zeros((3, 2), np.float32))


def in_fork(work: Callable[[], None]) -> int:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # Python warns that this process has threads
        child = os.fork()
    if child == 0:
        try:
            work()
            os._exit(0)
        except StateError as error:
            os._exit(3 if "fork" in str(error) else 4)
        except BaseException:
            os._exit(5)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def test_a_fork_has_no_threads_but_single_environments() -> None:
    one, many = env(), vector(threads=2)
    assert in_fork(lambda: many.step(np.zeros((3, 2), np.float32)) and None) == 3
    assert in_fork(lambda: one.step(HALF) and None) == 0
    many.step(np.zeros((3, 2), np.float32))


def test_a_fork_may_drop_a_vector() -> None:
    many = [vector(threads=2)]

    def drop() -> None:
        many.clear()
        gc.collect()

    assert in_fork(drop) == 0


def test_a_spawned_process_makes_its_own() -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        observation = pool.apply(first_observation)
    np.testing.assert_array_equal(observation, env().reset(seed=1)[0])


def first_observation() -> Any:
    return env().reset(seed=1)[0]


def test_a_folder_that_cannot_be_written() -> None:
    made = env()
    made.record("/proc/nothing/here.fbr")
    with pytest.raises(OSError, match="here.fbr"):
        made.reset(seed=1)
    made.reset(seed=1)
    made.step(HALF)
