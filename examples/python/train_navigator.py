"""Trains a navigator on fulbito/Navigate-v0 by proximal policy optimisation, in NumPy alone.

    python examples/python/train_navigator.py --out weights.inc

It writes the weights of a small network: from what a robot sees to a direction and a speed. Training layouts have seeds
that `fulbito compare` never uses. Equal arguments give the same weights on the same machine.
"""

import argparse
import itertools
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from gymnasium.vector import AutoresetMode
from numpy.typing import NDArray

from fulbito.envs import EpisodeVectorEnv, NavigateEnv, NavigateSettings

Floats = NDArray[np.float32]

#: Suites to train on, each at several top speeds [m/s].
SUITES = ("corner", "short", "clutter")
SPEEDS = (0.6, 1.0, 2.6)
HIDDEN = 48
GAMMA, LAMBDA, CLIP = 0.99, 0.95, 0.2
STEPS, EPOCHS, BATCHES = 64, 5, 8
#: The greatest deviation from the direction of the goal that counts as one unit of the network [rad].
UNIT = np.float32(1.0 / np.pi)
#: The sonars are the last numbers of an observation. The network does without them.
NAMES = [number.name for number in NavigateEnv.observation_table() if not number.name.startswith("sonar")]
SEEN = len(NAMES)
#: Distances along rays matter where they are short.
CENTRE = np.array([0.4 if name.startswith("ray") else 1.4 if name == "top-speed" else 0.0 for name in NAMES], np.float32)
SCALE = np.array([2.5 if name.startswith("ray") else 1.0 for name in NAMES], np.float32)


class Network:
    """Two hidden layers with tanh."""

    def __init__(self, outputs: int, gain: float, random: np.random.Generator) -> None:
        self.layers: list[Floats] = []
        for inputs, size, scale in ((SEEN, HIDDEN, 1.4), (HIDDEN, HIDDEN, 1.4), (HIDDEN, outputs, gain)):
            left, _, right = np.linalg.svd(random.normal(size=(inputs, size)), full_matrices=False)
            self.layers += [(scale * left @ right).astype(np.float32), np.zeros(size, np.float32)]

    def __call__(self, seen: Floats) -> tuple[Floats, Floats, Floats]:
        """The activations of both hidden layers, and the output."""
        w1, b1, w2, b2, w3, b3 = self.layers
        first = np.tanh(seen @ w1 + b1)
        second = np.tanh(first @ w2 + b2)
        return first, second, second @ w3 + b3

    def gradient(self, seen: Floats, first: Floats, second: Floats, output: Floats) -> list[Floats]:
        """Gradients of the layers from that of the output."""
        inner = (output @ self.layers[4].T) * (1 - second * second)
        outer = (inner @ self.layers[2].T) * (1 - first * first)
        return [seen.T @ outer, outer.sum(0), first.T @ inner, inner.sum(0), second.T @ output, output.sum(0)]


class Adam:
    """The optimiser, with gradients limited to a norm of 0.5."""

    def __init__(self, values: list[Floats]) -> None:
        self.values, self.steps = values, 0
        self.means = [np.zeros_like(value) for value in values]
        self.squares = [np.zeros_like(value) for value in values]

    def step(self, gradients: list[Floats], rate: float) -> None:
        self.steps += 1
        norm = float(np.sqrt(sum(float((gradient * gradient).sum()) for gradient in gradients)))
        scale = min(1.0, 0.5 / (norm + 1e-8))
        for value, gradient, mean, square in zip(self.values, gradients, self.means, self.squares):
            mean += 0.1 * (gradient * scale - mean)
            square += 0.001 * ((gradient * scale) ** 2 - square)
            step = mean / (1 - 0.9**self.steps) / (np.sqrt(square / (1 - 0.999**self.steps)) + 1e-5)
            value -= (rate * step).astype(np.float32)


@dataclass
class Rollout:
    """What the environments told in STEPS steps, and what the networks said."""

    seen: Floats
    actions: Floats
    likelihoods: Floats
    advantages: Floats
    returns: Floats
    successes: list[float]


class Trainer:
    """Policy, critic and environments."""

    def __init__(self, envs: int, seed: int, suites: Sequence[str]) -> None:
        self.random = np.random.default_rng(seed)
        self.policy = Network(2, 0.01, self.random)
        self.critic = Network(1, 1.0, self.random)
        self.spread = np.full(2, -1.0, np.float32)  # logarithms of the standard deviations
        self.policy_step = Adam([*self.policy.layers, self.spread])
        self.critic_step = Adam(self.critic.layers)
        tasks = itertools.cycle([NavigateSettings(suite=suite, speed=speed, action="heading", frame_skip=2,
                                                  ends_at_contact=True) for suite in suites for speed in SPEEDS])
        self.envs = EpisodeVectorEnv(lambda: next(tasks).source(), envs, autoreset_mode=AutoresetMode.SAME_STEP)
        self.seen = scaled(self.envs.reset(seed=seed)[0])
        self.scale, self.gains = 1.0, np.zeros(envs)  # of returns

    def rollout(self) -> Rollout:
        """Plays STEPS steps."""
        shape = (STEPS, self.envs.num_envs)
        seen, actions = np.zeros((*shape, SEEN), np.float32), np.zeros((*shape, 2), np.float32)
        likelihoods, values = np.zeros(shape, np.float32), np.zeros((STEPS + 1, shape[1]), np.float32)
        rewards, over = np.zeros(shape), np.zeros(shape)
        successes: list[float] = []
        for t in range(STEPS):
            noise = self.random.normal(size=(shape[1], 2)).astype(np.float32)
            seen[t], values[t] = self.seen, self.critic(self.seen)[2][:, 0]
            actions[t] = self.policy(self.seen)[2] + np.exp(self.spread) * noise
            likelihoods[t] = (-0.5 * noise**2 - self.spread).sum(1)
            told, rewards[t], terminated, truncated, infos = self.envs.step(to_action(actions[t]))
            self.seen = scaled(told)
            over[t] = terminated | truncated
            if truncated.any():
                rest = self.critic(scaled(infos["final_obs"][truncated]))[2][:, 0]
                rewards[t, truncated] += GAMMA * rest * np.sqrt(self.scale)
            if over[t].any():
                successes += infos["final_info"]["success"][over[t] > 0].tolist()
            self.gains = self.gains * GAMMA * (1 - over[t - 1] if t else 1) + rewards[t]
            self.scale += 0.0005 * (float((self.gains**2).mean()) - self.scale)
        values[STEPS] = self.critic(self.seen)[2][:, 0]
        advantages, last = np.zeros(shape, np.float32), np.zeros(shape[1])
        for t in reversed(range(STEPS)):
            goes_on = 1 - over[t]
            error = rewards[t] / np.sqrt(self.scale) + GAMMA * values[t + 1] * goes_on - values[t]
            last = error + GAMMA * LAMBDA * goes_on * last
            advantages[t] = last
        flat = advantages.ravel()
        return Rollout(seen.reshape(-1, SEEN), actions.reshape(-1, 2), likelihoods.ravel(),
                       (flat - flat.mean()) / (flat.std() + 1e-8), flat + values[:STEPS].ravel(), successes)

    def learn(self, data: Rollout, rate: float) -> None:
        """Improves both networks."""
        for _ in range(EPOCHS):
            for batch in np.array_split(self.random.permutation(len(data.seen)), BATCHES):
                seen, count = data.seen[batch], np.float32(len(batch))
                first, second, mean = self.policy(seen)
                away = (data.actions[batch] - mean) / np.exp(self.spread)
                ratio = np.exp((-0.5 * away**2 - self.spread).sum(1) - data.likelihoods[batch])
                gain = data.advantages[batch]
                counts = np.where(gain > 0, ratio < 1 + CLIP, ratio > 1 - CLIP)
                slope = (-gain * ratio * counts / count)[:, None].astype(np.float32)
                output = (slope * away / np.exp(self.spread)).astype(np.float32)
                spread = ((slope * (away**2 - 1)).sum(0) - 0.001).astype(np.float32)
                self.policy_step.step([*self.policy.gradient(seen, first, second, output), spread], rate)
                first, second, value = self.critic(seen)
                error = ((value[:, 0] - data.returns[batch]) / count)[:, None].astype(np.float32)
                self.critic_step.step(self.critic.gradient(seen, first, second, error), rate)


def scaled(observations: Floats) -> Floats:
    """What the networks get."""
    return (observations[:, :SEEN] - CENTRE) * SCALE


def to_action(output: Floats) -> Floats:
    """Actions from outputs of the network: full speed straight to the goal at 0."""
    return np.stack([np.clip(output[:, 0] * UNIT, -1, 1), np.clip(output[:, 1] + 1, -1, 1)], axis=1)


def save(policy: Network, file: Path) -> None:
    """Writes the layers, each as weights of shape (inputs, outputs), row by row, and biases. They take observations as they
    are and give actions."""
    layers = [layer.copy() for layer in policy.layers]
    layers[1] -= (CENTRE * SCALE) @ layers[0]
    layers[0] *= SCALE[:, None]
    layers[4][:, 0] *= UNIT
    layers[5][0] *= UNIT
    layers[5][1] += 1
    numbers = [f"{number:.5g}f" if "." in f"{number:.5g}" or "e" in f"{number:.5g}" else f"{number:.5g}.0f"
               for layer in layers for number in layer.ravel().tolist()]
    lines = [",".join(numbers[i:i + 16]) for i in range(0, len(numbers), 16)]
    file.write_text(f"// Written by examples/python/train_navigator.py: {SEEN} x {HIDDEN} x {HIDDEN} x 2.\n"
                    + ",\n".join(lines) + "\n")


def main() -> None:
    parser = argparse.ArgumentParser(description="Trains a navigator on fulbito/Navigate-v0.")
    parser.add_argument("--out", type=Path, required=True, help="file for the weights")
    parser.add_argument("--rounds", type=int, default=800, help="rollouts of 64 steps per environment (default: 800)")
    parser.add_argument("--envs", type=int, default=108, help="environments (default: 108)")
    parser.add_argument("--seed", type=int, default=1, help="seed of training (default: 1)")
    parser.add_argument("--suites", nargs="+", default=SUITES, help=f"suites to train on (default: {' '.join(SUITES)})")
    options = parser.parse_args()
    trainer, began = Trainer(options.envs, options.seed, options.suites), time.monotonic()
    successes: list[float] = []
    for round_number in range(1, options.rounds + 1):
        data = trainer.rollout()
        successes = (successes + data.successes)[-2000:]
        trainer.learn(data, 4e-4 * (1 - round_number / (options.rounds + 1)))
        if round_number % 50 == 0 or round_number == options.rounds:
            print(f"round {round_number}, {time.monotonic() - began:.0f} s: success {np.mean(successes):.3f} in training, "
                  f"spread {np.exp(trainer.spread).round(2)}", flush=True)
            save(trainer.policy, options.out)


if __name__ == "__main__":
    main()
