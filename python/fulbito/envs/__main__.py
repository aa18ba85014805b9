"""`python -m fulbito.envs ID`: what a policy that acts at random achieves in an environment, and how fast it is."""

import argparse
import json
import time
from typing import Any

import gymnasium
import numpy as np

import fulbito.envs  # noqa: F401


def play(name: str, episodes: int, seed: int, settings: dict[str, Any]) -> str:
    """Plays episodes with uniform random actions and returns their results as text."""
    count = min(64, episodes)
    vector = gymnasium.make_vec(name, count, vectorization_mode="vector_entry_point", **settings)
    random = np.random.default_rng(seed)
    space = vector.single_action_space
    vector.reset(seed=seed)
    # Each environment plays equally many episodes, so that short ones do not count more.
    left = np.full(count, episodes // count) + (np.arange(count) < episodes % count)
    returns, sums, lengths = [], np.zeros(count), np.zeros(count)
    terminations = 0
    successes: list[float] = []
    begun_at, steps = time.monotonic(), 0
    while left.any():
        if isinstance(space, gymnasium.spaces.Discrete):
            actions = random.integers(space.n, size=count)
        else:
            actions = random.uniform(-1, 1, (count, *(space.shape or ()))).astype(np.float32)
        _, rewards, terminated, truncated, infos = vector.step(actions)
        steps += count
        sums += rewards
        lengths += 1
        ended = (terminated | truncated) & (left > 0)
        for i in np.flatnonzero(ended):
            returns.append((sums[i], lengths[i]))
            terminations += int(terminated[i])
            if "success" in infos:
                successes.append(float(infos["success"][i]))
        over = terminated | truncated
        left -= ended
        sums[over], lengths[over] = 0.0, -1.0  # the step that begins the next episode does not count
    seconds = time.monotonic() - begun_at
    vector.close()
    gained, long = np.array(returns).T
    error = gained.std(ddof=1) / np.sqrt(len(gained)) if len(gained) > 1 else float("nan")
    return (f"{name}: {len(gained)} episodes of random actions\n"
            f"return {gained.mean():.2f} ± {error:.2f}, {long.mean():.0f} steps, "
            f"{100 * terminations / len(gained):.0f} % terminated"
            + (f", {100 * float(np.mean(successes)):.1f} % successes\n" if successes else "\n") +
            f"{steps / seconds:,.0f} steps per second")


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(prog="python -m fulbito.envs", description=__doc__)
    parser.add_argument("id", help="such as fulbito/VSS-v0")
    parser.add_argument("--episodes", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--settings", type=json.loads, default={}, help='JSON, such as {"opponents": "chaser"}')
    given = parser.parse_args()
    print(play(given.id, given.episodes, given.seed, given.settings))


if __name__ == "__main__":
    main()
