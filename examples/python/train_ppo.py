"""Trains a policy by PPO (Stable-Baselines3) and writes it as ONNX.

    python examples/python/train_ppo.py drill 3 --minutes 12 --out drill3
    python examples/python/train_ppo.py vss --opponent classic --from drill3 --minutes 30 --out striker

OUT/model.zip goes on in Stable-Baselines3; OUT/policy.onnx is what `fulbito.policy_team` plays. The same seed and number of
steps give the same policy on the same machine; --minutes stops by the clock.
"""

import argparse
import sys
import time
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import BaseCallback

import fulbito.envs  # noqa: F401  registers the environments
from fulbito.policy import PolicyMaker, save_policy
from fulbito.stable_baselines import StableBaselinesVector

ENVIRONMENTS = 128
STEPS = 128  # of each environment between two updates
HIDDEN = [64, 64]


class Progress(BaseCallback):
    """Prints success and reward of the newest episodes, and stops by the clock."""

    def __init__(self, minutes: float) -> None:
        super().__init__()
        self.limit = 60.0 * minutes
        self.began = self.last = time.monotonic()
        self.rewards: list[float] = []
        self.successes: list[float] = []

    def _on_step(self) -> bool:
        for info in self.locals["infos"]:
            if "episode" in info:
                self.rewards.append(info["episode"]["r"])
                self.successes.append(self.success_of(info["final"]))
        now = time.monotonic()
        if now - self.last > 15.0:
            self.last = now
            count = min(len(self.rewards), 1000)
            print(f"{(now - self.began) / 60:5.1f} min  {self.num_timesteps:>10,} steps  success {np.mean(self.successes[-count:] or [0]):.2f}"
                  f"  reward {np.mean(self.rewards[-count:] or [0]):7.2f}", file=sys.stderr, flush=True)
        return now - self.began < self.limit

    @staticmethod
    def success_of(final: dict[str, Any]) -> float:
        """Of a drill, its own verdict; of a match, a goal of the team."""
        if "success" in final:
            return float(final["success"])
        return float(final["blue_goals"] > final["yellow_goals"])


def layers_of(model: PPO) -> list[tuple[np.ndarray, np.ndarray]]:
    """Weights and biases of the policy's dense layers."""
    policy = model.policy
    dense = [part for part in [*policy.mlp_extractor.policy_net, policy.action_net] if isinstance(part, torch.nn.Linear)]
    return [(part.weight.detach().numpy(), part.bias.detach().numpy()) for part in dense]


def task_of(known: argparse.Namespace) -> tuple[str, dict[str, Any]]:
    """Identifier and arguments of the environment."""
    options: dict[str, Any] = {"action": known.action, "frame_skip": known.frame_skip}
    if known.task == "drill":
        return "fulbito/Drill-v0", {"drill": known.drill, "split": "train", **options}
    return "fulbito/VSS-v0", {"opponents": known.opponent, "mates": known.mates, "robot": 1, "observation": "egocentric",
                              "start": known.start_of_play, "end": known.end, "time_limit": known.seconds, **options}


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Trains a policy by PPO and writes it as ONNX.")
    tasks = parser.add_subparsers(dest="task", required=True)
    drill = tasks.add_parser("drill", help="a drill: fulbito/Drill-v0")
    drill.add_argument("drill", type=int, help="its number")
    vss = tasks.add_parser("vss", help="matches: fulbito/VSS-v0")
    vss.add_argument("--opponent", default="classic", help="team specification (default: classic)")
    vss.add_argument("--mates", default="classic", help="team that drives the other robots (default: classic)")
    vss.add_argument("--start", dest="start_of_play", default="random", help="random or kick-off (default: random)")
    vss.add_argument("--end", default="goal", help="goal, or match: play goes on after goals (default: goal)")
    vss.add_argument("--seconds", type=float, default=20.0, help="longest episode [s] (default: 20)")
    for task in (drill, vss):
        task.add_argument("--out", type=Path, required=True, help="folder for model.zip and policy.onnx")
        task.add_argument("--from", dest="before", type=Path, help="folder of a trained policy to go on from")
        task.add_argument("--minutes", type=float, default=12.0, help="time limit (default: 12)")
        task.add_argument("--steps", type=int, default=50_000_000, help="largest number of steps")
        task.add_argument("--frame-skip", type=int, default=3, help="control ticks per action (default: 3)")
        task.add_argument("--action", default="wheels", help="form of actions: wheels or twist (default: wheels)")
        task.add_argument("--seed", type=int, default=1, help="of training (default: 1)")
    return parser.parse_args()


def main() -> None:
    known = arguments()
    torch.set_num_threads(1)  # threads of torch wait for each other wherever other programs run
    name, options = task_of(known)
    envs = StableBaselinesVector(gymnasium.make_vec(name, ENVIRONMENTS, autoreset_mode="SameStep", **options))
    settings: dict[str, Any] = dict(n_steps=STEPS, batch_size=4096, n_epochs=5, gamma=0.99, gae_lambda=0.95, ent_coef=0.0,
                                    learning_rate=7e-4, clip_range=0.2, device="cpu", seed=known.seed)
    if known.before:
        model = PPO.load(known.before / "model.zip", env=envs, **settings)
    else:
        model = PPO("MlpPolicy", envs, policy_kwargs={"net_arch": HIDDEN, "activation_fn": torch.nn.Tanh, "log_std_init": -0.5}, **settings)
    progress = Progress(known.minutes)
    model.learn(known.steps, callback=progress)
    known.out.mkdir(parents=True, exist_ok=True)
    model.save(known.out / "model.zip")
    minutes = (time.monotonic() - progress.began) / 60
    made = f"PPO, {model.num_timesteps:,} steps, seed {known.seed}"
    save_policy(known.out / "policy.onnx", layers_of(model), PolicyMaker(name, options, made))
    print(f"{known.out / 'policy.onnx'}: {made}, {minutes:.1f} min")


if __name__ == "__main__":
    main()
