"""The vector of environments: Gymnasium's autoreset modes, threads, send and recv, states."""

# pyright: reportPossiblyUnboundVariable=false

import hashlib
import os
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

import fulbito.envs
from gymnasium.vector import AutoresetMode

SHORT = {"time_limit": 1.0, "start": "random"}


def make(count: int, **settings: Any) -> Any:
    return gymnasium.make_vec("fulbito/VSS-v0", count, **{**SHORT, **settings})


def actions_of(vector: Any, steps: int) -> np.ndarray[Any, Any]:
    random = np.random.default_rng(0)
    return random.uniform(-1, 1, (steps, *vector.action_space.shape)).astype(np.float32)


def trace(vector: Any, steps: int, seed: Any = 5) -> list[bytes]:
    observations, infos = vector.reset(seed=seed)
    told = [observations.tobytes()]
    for actions in actions_of(vector, steps):
        observations, rewards, terminated, truncated, infos = vector.step(actions)
        told += [a.tobytes() for a in (observations, rewards, terminated, truncated, infos["seconds"])]
    return told


def test_the_registered_vector_is_native() -> None:
    vector = make(3)
    assert isinstance(vector.unwrapped, fulbito.envs.EpisodeVectorEnv)
    assert vector.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
    observations, infos = vector.reset(seed=1)
    assert observations.shape == (3, 56) and observations in vector.observation_space
    assert infos["_reward_goal"].all()


@pytest.mark.parametrize("mode", list(AutoresetMode)[:2])
def test_it_plays_what_single_environments_play(mode: AutoresetMode) -> None:
    settings = {**SHORT, "opponents": "chaser"}
    vector = make(4, autoreset_mode=mode, opponents="chaser")
    singles = gymnasium.vector.SyncVectorEnv([lambda: gymnasium.make("fulbito/VSS-v0", **settings)] * 4,
                                             autoreset_mode=mode)
    ours, theirs = vector.reset(seed=11)[0], singles.reset(seed=11)[0]
    np.testing.assert_array_equal(ours, theirs)
    for actions in actions_of(vector, 150):
        ours, theirs = vector.step(actions), singles.step(actions)
        for one, other in zip(ours[:4], theirs[:4]):
            np.testing.assert_array_equal(one, other)
        assert ("final_obs" in ours[4]) == ("final_obs" in theirs[4])
        if "final_obs" in ours[4]:
            ended = theirs[4]["_final_obs"]
            np.testing.assert_array_equal(ours[4]["_final_obs"], ended)
            np.testing.assert_array_equal(ours[4]["final_obs"][ended], np.stack(theirs[4]["final_obs"][ended]))
            np.testing.assert_array_equal(ours[4]["final_info"]["seconds"][ended],
                                          theirs[4]["final_info"]["seconds"][ended])


def test_the_caller_resets_where_the_vector_does_not() -> None:
    vector = make(3, autoreset_mode=AutoresetMode.DISABLED, time_limit=0.5)
    vector.reset(seed=1)
    terminated = truncated = np.zeros(3, np.bool_)
    for actions in actions_of(vector, 30):
        _, _, terminated, truncated, _ = vector.step(actions)
    ended = terminated | truncated
    assert ended.all()
    before = [rows.out[0] for rows in vector.unwrapped._all]
    with pytest.raises(fulbito.StateError, match="environment 0 has no episode"):
        vector.step(actions)
    observations, _ = vector.reset(options={"reset_mask": np.array([True, False, True])})
    assert any(observations is kept for kept in before)
    with pytest.raises(fulbito.StateError, match="environment 1 has no episode"):
        vector.step(actions)
    vector.reset(options={"reset_mask": np.array([False, True, False])})
    vector.step(actions)


@pytest.mark.parametrize("threads", [1, 2, 4])
def test_threads_change_no_bit(threads: int) -> None:
    assert trace(make(9, threads=threads), 150) == trace(make(9, threads=1), 150)


def hash_of_thousand_episodes(threads: int) -> str:
    """Of all that 1,000 episodes tell; half-way another vector goes on from the states."""
    told = hashlib.sha256()
    vector = make(100, threads=threads, states=True, time_limit=0.25)
    vector.reset(seed=3)
    ended = 0
    for step, actions in enumerate(actions_of(vector, 200)):
        if step == 80:
            states = vector.unwrapped.get_states()
            vector.close()
            vector = make(100, threads=threads, states=True, time_limit=0.25)
            vector.unwrapped.set_states(states)
        for part in vector.step(actions)[:4]:
            told.update(part.tobytes())
        ended += int((vector.unwrapped._now.out[2] | vector.unwrapped._now.out[3]).sum())
    assert ended >= 1000
    return told.hexdigest()


def test_a_thousand_episodes_are_the_same_in_processes_threads_and_after_states() -> None:
    script = ("import sys; sys.path.insert(0, sys.argv[1]); import test_vector as t; "
              "print(*{t.hash_of_thousand_episodes(threads) for threads in (1, 2, 4)})")
    told = [subprocess.run([sys.executable, "-c", script, os.path.dirname(__file__)], capture_output=True, text=True,
                           check=True).stdout for _ in range(2)]
    assert told[0] == told[1] and len(told[0].split()) == 1


def test_states_go_on_as_the_vector_does() -> None:
    vector, other = make(5, states=True, threads=2), make(5, states=True, threads=1)
    trace(vector, 100)
    other.unwrapped.set_states(vector.unwrapped.get_states())
    for actions in actions_of(vector, 100):
        for one, same in zip(vector.step(actions)[:4], other.step(actions)[:4]):
            np.testing.assert_array_equal(one, same)


def test_what_a_step_told_stays_until_the_call_after_the_next() -> None:
    vector = make(2)
    vector.reset(seed=1)
    actions = actions_of(vector, 3)
    first = vector.step(actions[0])
    kept = [part.copy() for part in first[:4]]
    vector.step(actions[1])
    for part, copy in zip(first[:4], kept):
        np.testing.assert_array_equal(part, copy)
    assert vector.step(actions[2])[0] is first[0]


def test_send_and_recv_play_the_same() -> None:
    vector, other = make(4).unwrapped, make(4).unwrapped
    vector.reset(seed=2)
    other.reset(seed=2)
    for actions in actions_of(vector, 70):
        whole = [part.copy() for part in vector.step(actions)[:4]]
        for ids in ([2, 0], [3, 1]):
            other.send(actions[ids], ids)
            part = other.recv()
            assert part[4]["env_id"].tolist() == ids
            for one, all_rows in zip(part[:4], whole):
                np.testing.assert_array_equal(one, all_rows[ids])
    other.send(actions)
    assert other.recv()[0].shape == (4, 56)


def test_a_list_of_seeds_has_one_for_each() -> None:
    vector, single = make(3), gymnasium.make("fulbito/VSS-v0", **SHORT)
    observations, _ = vector.reset(seed=[7, 8, 7])
    np.testing.assert_array_equal(observations[0], single.reset(seed=7)[0])
    np.testing.assert_array_equal(observations[0], observations[2])


def test_wrappers_of_gymnasium_work() -> None:
    vector = gymnasium.wrappers.vector.RecordEpisodeStatistics(make(3))
    vector.reset(seed=1)
    ended = 0
    for actions in actions_of(vector, 130):
        infos = vector.step(actions)[4]
        ended += int(infos.get("_episode", np.zeros(3)).sum())
    assert ended >= 3


def test_pictures_of_all() -> None:
    vector = make(2, render_mode="rgb_array", render_width=300)
    vector.reset(seed=1)
    pictures = vector.render()
    assert len(pictures) == 2 and pictures[0].shape[1:] == (300, 3)
