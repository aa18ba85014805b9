"""PettingZoo: conformance, seeds, self-play, the critic's state."""

# pyright: reportPossiblyUnboundVariable=false

import pickle
import warnings
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pettingzoo")

from fulbito.pettingzoo import vss_3v3_v0, vss_5v5_v0
from pettingzoo.test import api_test, parallel_api_test, parallel_seed_test, seed_test

GAMES = [vss_3v3_v0, vss_5v5_v0]


@pytest.mark.parametrize("game", GAMES)
def test_pettingzoo_finds_no_fault(game: Any) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        parallel_api_test(game.parallel_env(time_limit=1.0), num_cycles=200)
        api_test(game.env(time_limit=1.0), num_cycles=200)
        parallel_seed_test(game.parallel_env, num_cycles=50)
        seed_test(game.env, num_cycles=50)


def test_both_teams_see_the_game_from_their_side() -> None:
    env = vss_3v3_v0.parallel_env(start="kick-off")
    observations, _ = env.reset(seed=1)
    assert list(observations) == ["blue_0", "blue_1", "blue_2", "yellow_0", "yellow_1", "yellow_2"]
    ahead = {agent: np.array([1.0, 1.0], np.float32) for agent in env.agents}
    for _ in range(20):
        observations, rewards, *_ = env.step(ahead)
    assert all(seen in env.observation_space(agent) for agent, seen in observations.items())
    assert observations["blue_0"][0] == pytest.approx(-observations["yellow_0"][0], abs=1e-6)
    assert env.state() in env.state_space
    assert env.state()[:2] == pytest.approx(observations["blue_0"][:2])


def test_a_goal_pays_one_team_and_costs_the_other() -> None:
    start = '[ball]\nposition = [0.70, 0.0]\nvelocity = [1.5, 0.0]\n'
    for team in ("blue", "yellow"):
        for number in range(3):
            x = -0.3 if team == "blue" else -0.5
            start += f'[[robot]]\nteam = "{team}"\nnumber = {number}\nposition = [{x}, {0.3 * number - 0.3}]\n'
    env = vss_3v3_v0.parallel_env()
    env.reset(seed=1, options={"start": start})
    still = {agent: np.zeros(2, np.float32) for agent in env.agents}
    infos: dict[str, Any] = {}
    while env.agents:
        _, _, terminations, _, infos = env.step(still)
    assert all(terminations.values())
    assert infos["blue_0"]["reward_goal"] == 10.0 and infos["yellow_2"]["reward_goal"] == -10.0


def test_some_robots_may_play_by_themselves() -> None:
    env = vss_3v3_v0.parallel_env(blue_agents=[1], yellow_agents=[], blue="classic", yellow="chaser")
    observations, _ = env.reset(seed=1)
    assert list(observations) == ["blue_1"]


def test_a_state_goes_on_as_the_game_does() -> None:
    env = vss_3v3_v0.parallel_env()
    env.reset(seed=3)
    random = np.random.default_rng(0)

    def moves() -> dict[str, Any]:
        return {agent: random.uniform(-1, 1, 2).astype(np.float32) for agent in env.possible_agents}

    for _ in range(50):
        env.step(moves())
    other = pickle.loads(pickle.dumps(env))
    for _ in range(50):
        chosen = moves()
        ours: Any = env.step(chosen)
        for one, same in zip(ours[:2], other.step(chosen)[:2]):
            for agent in one:
                np.testing.assert_array_equal(one[agent], same[agent])
