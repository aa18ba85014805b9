"""Plays episodes of a policy's environment and prints how it does.

    python examples/python/evaluate.py drill3/policy.onnx --episodes 1000
    python examples/python/evaluate.py striker/policy.onnx --set opponents=libero --random

A drill draws its trials from seeds that training never uses (split "test"). --random plays random actions instead.
"""

import argparse
import json
from typing import Any

import gymnasium
import numpy as np

import fulbito.envs  # noqa: F401  registers the environments
from fulbito.policy import Policy

ENVIRONMENTS = 64


def wilson(successes: int, count: int) -> tuple[float, float]:
    """The 95 % interval of a rate."""
    z, rate = 1.96, successes / count
    centre, spread = rate + z * z / (2 * count), z * np.sqrt(rate * (1 - rate) / count + z * z / (4 * count * count))
    return (centre - spread) / (1 + z * z / count), (centre + spread) / (1 + z * z / count)


def options_of(policy: Policy, changes: list[str]) -> dict[str, Any]:
    """Arguments of the environment: the policy's, with the test's trials, and the changes."""
    options = dict(policy.maker.options)
    if "drill" in options:
        options["split"] = "test"
    for change in changes:
        name, _, value = change.partition("=")
        try:
            options[name] = json.loads(value)
        except ValueError:
            options[name] = value
    return options


def play(policy: Policy, options: dict[str, Any], episodes: int, seed: int, at_random: bool) -> tuple[list[float], list[dict[str, float]]]:
    """Rewards and last infos of the first episodes of each environment: short ones are not preferred."""
    envs = gymnasium.make_vec(policy.maker.environment, ENVIRONMENTS, autoreset_mode="SameStep", **options)
    chance = np.random.default_rng(seed)
    observations, _ = envs.reset(seed=seed)
    rewards, sums, left = [], np.zeros(ENVIRONMENTS), np.full(ENVIRONMENTS, -(-episodes // ENVIRONMENTS))
    finals: list[dict[str, float]] = []
    while left.any():
        actions = chance.uniform(-1, 1, envs.action_space.shape).astype(np.float32) if at_random else policy(observations)
        observations, reward, terminated, truncated, infos = envs.step(actions)
        sums += reward
        for i in np.flatnonzero((terminated | truncated) & (left > 0)):
            finals.append({key: float(values[i]) for key, values in infos["final_info"].items() if np.ndim(values) == 1})
            rewards.append(float(sums[i]))
        ended = terminated | truncated
        sums[ended] = 0.0
        left[ended & (left > 0)] -= 1
    envs.close()
    return rewards, finals


def main() -> None:
    parser = argparse.ArgumentParser(description="Plays episodes of a policy's environment and prints how it does.")
    parser.add_argument("policy", help="an ONNX file of fulbito.policy.save_policy")
    parser.add_argument("--episodes", type=int, default=1000, help="number of episodes (default: 1000)")
    parser.add_argument("--seed", type=int, default=1, help="of the episodes (default: 1)")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="another argument of the environment")
    parser.add_argument("--random", action="store_true", help="random actions instead of the policy's")
    known = parser.parse_args()
    policy = Policy.load(known.policy)
    options = options_of(policy, known.set)
    rewards, finals = play(policy, options, known.episodes, known.seed, known.random)
    count = len(finals)
    print(f"{policy.maker.environment} {json.dumps(options)}: {'random actions' if known.random else policy.maker.note}")
    print(f"{count} episodes, mean reward {np.mean(rewards):.2f}")
    if "success" in finals[0]:
        successes = [f for f in finals if f["success"] > 0]
        low, high = wilson(len(successes), count)
        print(f"success {100 * len(successes) / count:.1f} % (95 % interval {100 * low:.1f} ... {100 * high:.1f} %)")
        if successes:
            ideal = np.median([f["ideal"] for f in successes])  # 0: the drill knows no bound
            print(f"time to success: median {np.median([f['time'] for f in successes]):.2f} s" + (f", least possible {ideal:.2f} s" if ideal > 0 else ""))
    else:
        own, against = sum(f["blue_goals"] for f in finals), sum(f["yellow_goals"] for f in finals)
        print(f"goals {own:.0f} : {against:.0f}")


if __name__ == "__main__":
    main()
