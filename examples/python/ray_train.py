"""Trains a policy by evolution strategies on a Ray cluster (Salimans et al. 2017).

    python examples/python/ray_train.py fulbito/Drill-v0 --set drill=3 --set frame_skip=3 --workers 8 --rounds 300 --out drill3-es

Each worker is a Ray actor with a vector of environments of its own, anywhere in the cluster. In a round it plays some directions
in the space of the policy's weights, each of them forward and backward; the driver goes where the reward rises. Only seeds and
rewards travel. A worker that dies is started again and its part of the round is played again. The same seed gives the same
policy, whatever the number of workers.
"""

import argparse
import json
import sys
import time
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import ray
from numpy.typing import NDArray

from fulbito.policy import PolicyMaker, save_policy

Weights = NDArray[np.float32]


class Network:
    """Dense layers with tanh between them, whose weights are one array."""

    def __init__(self, sizes: list[int]) -> None:
        self.shapes = list(zip(sizes[1:], sizes[:-1]))
        self.count = sum(out * (into + 1) for out, into in self.shapes)

    def first(self, seed: int) -> Weights:
        """Weights at the start; the last layer's are small, so that first actions are."""
        chance = np.random.default_rng(seed)
        parts = []
        for i, (out, into) in enumerate(self.shapes):
            scale = (0.1 if i + 1 == len(self.shapes) else 1.0) / np.sqrt(into)
            parts += [chance.normal(0.0, scale, out * into), np.zeros(out)]
        return np.concatenate(parts).astype(np.float32)

    def layers(self, weights: Weights) -> list[tuple[Weights, Weights]]:
        """Pairs of weights and biases."""
        found, at = [], 0
        for out, into in self.shapes:
            found.append((weights[at:at + out * into].reshape(out, into), weights[at + out * into:at + out * (into + 1)]))
            at += out * (into + 1)
        return found

    def act(self, layers: list[tuple[Weights, Weights]], observations: Weights) -> Weights:
        """Actions of a batch of observations."""
        values = observations
        for i, (weights, biases) in enumerate(layers):
            values = values @ weights.T + biases
            if i + 1 < len(layers):
                values = np.tanh(values)
        return np.clip(values, -1.0, 1.0)


@ray.remote(max_restarts=-1, max_task_retries=-1)
class Worker:
    """Plays directions of the search."""

    def __init__(self, environment: str, options: dict[str, Any], hidden: list[int], episodes: int) -> None:
        import fulbito.envs  # noqa: F401  registers the environments

        self._envs = gymnasium.make_vec(environment, episodes, autoreset_mode="Disabled", threads=1, **options)
        self._network = network_of(self._envs, hidden)

    def play(self, weights: Weights, sigma: float, round_seed: int, directions: list[int]) -> list[tuple[int, float, float]]:
        """The mean reward of each direction, forward and backward, on the same episodes."""
        found = []
        for direction in directions:
            noise = noise_of(round_seed, direction, weights.size)
            found.append((direction, self._reward(weights + sigma * noise, round_seed), self._reward(weights - sigma * noise, round_seed)))
        return found

    def _reward(self, weights: Weights, seed: int) -> float:
        layers = self._network.layers(weights)
        observations, _ = self._envs.reset(seed=seed)
        going = np.ones(self._envs.num_envs, dtype=bool)
        total = 0.0
        while going.any():
            observations, rewards, terminated, truncated, _ = self._envs.step(self._network.act(layers, observations).astype(np.float32))
            total += float(rewards[going].sum())
            ended = terminated | truncated
            going &= ~ended
            if ended.any() and going.any():
                self._envs.reset(options={"reset_mask": ended})  # goes on idly until all are done
        return total / self._envs.num_envs


def noise_of(round_seed: int, direction: int, count: int) -> Weights:
    """The direction, from its seed: driver and workers draw the same."""
    return np.random.default_rng([round_seed, direction]).normal(size=count).astype(np.float32)


def network_of(envs: Any, hidden: list[int]) -> Network:
    return Network([envs.single_observation_space.shape[0], *hidden, envs.single_action_space.shape[0]])


def step_of(rewards: dict[int, tuple[float, float]], round_seed: int, count: int, sigma: float) -> Weights:
    """The gradient of the mean reward, from ranks, so that single large rewards do not rule."""
    order = sorted(rewards)
    values = np.array([rewards[direction] for direction in order]).ravel()
    ranks = np.empty(values.size)
    ranks[values.argsort(kind="stable")] = np.arange(values.size)
    shaped = (ranks / (values.size - 1) - 0.5).reshape(-1, 2)
    gradient = np.zeros(count, dtype=np.float32)
    for direction, (forward, backward) in zip(order, shaped):
        gradient += np.float32(forward - backward) * noise_of(round_seed, direction, count)
    return gradient / np.float32(2 * len(order) * sigma)


class Adam:
    """Kingma & Ba 2015, upward."""

    def __init__(self, count: int, rate: float) -> None:
        self.rate, self.steps = rate, 0
        self.mean, self.square = np.zeros(count, np.float32), np.zeros(count, np.float32)

    def step(self, gradient: Weights) -> Weights:
        self.steps += 1
        self.mean = np.float32(0.9) * self.mean + np.float32(0.1) * gradient
        self.square = np.float32(0.999) * self.square + np.float32(0.001) * gradient * gradient
        mean, square = self.mean / np.float32(1 - 0.9**self.steps), self.square / np.float32(1 - 0.999**self.steps)
        return np.float32(self.rate) * mean / (np.sqrt(square) + np.float32(1e-8))


def play_round(workers: list[Any], weights: Weights, known: argparse.Namespace, number: int) -> dict[int, tuple[float, float]]:
    """The rewards of all directions of a round. Small parts, so that fast workers take more of them."""
    shared, seed = ray.put(weights), known.seed * 1_000_003 + number
    parts = [list(range(known.directions))[i:i + 2] for i in range(0, known.directions, 2)]
    running: dict[Any, int] = {}
    rewards: dict[int, tuple[float, float]] = {}

    def start(worker: int) -> None:
        running[workers[worker].play.remote(shared, known.sigma, seed, parts.pop())] = worker

    for worker in range(min(len(workers), len(parts))):
        start(worker)
    while running:
        done, _ = ray.wait(list(running), num_returns=1)
        worker = running.pop(done[0])
        rewards.update({direction: (forward, backward) for direction, forward, backward in ray.get(done[0])})
        if parts:
            start(worker)
    return rewards


def train(known: argparse.Namespace) -> float:
    """Trains, writes the policy, and returns the last round's mean reward."""
    import fulbito.envs  # noqa: F401  registers the environments

    options = {name: json.loads(value) if value[:1] in '0123456789-[{"tf' else value
               for name, _, value in (change.partition("=") for change in known.set)}
    workers = [Worker.remote(known.environment, options, known.hidden, known.episodes) for _ in range(known.workers)]
    envs = gymnasium.make_vec(known.environment, 1, **options)
    network = network_of(envs, known.hidden)
    envs.close()
    weights, adam = network.first(known.seed), Adam(network.count, known.rate)
    began, mean = time.monotonic(), 0.0
    for number in range(known.rounds):
        rewards = play_round(workers, weights, known, number)
        mean = float(np.mean(list(rewards.values())))
        weights = weights + adam.step(step_of(rewards, known.seed * 1_000_003 + number, network.count, known.sigma))
        if number % 10 == 9 or number + 1 == known.rounds:
            print(f"round {number + 1}: mean reward {mean:.2f}, {time.monotonic() - began:.0f} s", file=sys.stderr, flush=True)
    known.out.mkdir(parents=True, exist_ok=True)
    made = f"evolution strategies, {known.rounds} rounds of {known.directions} directions, seed {known.seed}"
    save_policy(known.out / "policy.onnx", network.layers(weights), PolicyMaker(known.environment, options, made))
    print(f"{known.out / 'policy.onnx'}: {made}, mean reward {mean:.2f}")
    return mean


def main(words: list[str] | None = None) -> float:
    parser = argparse.ArgumentParser(description="Trains a policy by evolution strategies on a Ray cluster.")
    parser.add_argument("environment", help="identifier, such as fulbito/Drill-v0")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="an argument of the environment")
    parser.add_argument("--out", type=Path, required=True, metavar="FOLDER", help="gets policy.onnx")
    parser.add_argument("--address", help="of a running cluster; auto: this machine's (default: start one here)")
    parser.add_argument("--workers", type=int, default=2, help="actors (default: 2)")
    parser.add_argument("--rounds", type=int, default=300, help="updates (default: 300)")
    parser.add_argument("--directions", type=int, default=32, help="per round (default: 32)")
    parser.add_argument("--episodes", type=int, default=16, help="that each direction plays (default: 16)")
    parser.add_argument("--sigma", type=float, default=0.05, help="length of a direction, per weight (default: 0.05)")
    parser.add_argument("--rate", type=float, default=0.02, help="of learning (default: 0.02)")
    parser.add_argument("--hidden", type=int, nargs="*", default=[32, 32], help="sizes of the hidden layers (default: 32 32)")
    parser.add_argument("--seed", type=int, default=1, help="of training (default: 1)")
    known = parser.parse_args(words)
    started = not ray.is_initialized()
    if started:
        ray.init(address=known.address, log_to_driver=False, configure_logging=False)
    try:
        return train(known)
    finally:
        if started:
            ray.shutdown()


if __name__ == "__main__":
    main()
