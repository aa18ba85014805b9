"""Stable-Baselines3 and Ray use the environments. These packages weigh gigabytes: scripts/check-training.sh installs them."""

import importlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import fulbito
from fulbito.ray_tournament import play_shard

gymnasium = pytest.importorskip("gymnasium")
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def vector(**options: Any) -> Any:
    """A small vector for Stable-Baselines3."""
    pytest.importorskip("stable_baselines3")
    import fulbito.envs  # noqa: F401  registers the environments
    from fulbito.stable_baselines import StableBaselinesVector

    return StableBaselinesVector(gymnasium.make_vec("fulbito/Drill-v0", 8, drill=3, autoreset_mode="SameStep", **options))


def test_stable_baselines_sees_where_episodes_end() -> None:
    envs = vector(frame_skip=60)
    envs.seed(3)
    first = envs.reset()
    envs.seed(3)
    assert np.array_equal(first, envs.reset())
    ends = 0
    for _ in range(12):
        observations, rewards, done, infos = envs.step(np.zeros((8, 2), dtype=np.float32))
        assert observations.shape == first.shape and rewards.dtype == np.float32
        for i, info in enumerate(infos):
            assert ("terminal_observation" in info) == bool(done[i])
            if done[i]:
                ends += 1
                assert info["TimeLimit.truncated"]
                assert info["final"]["success"] == 0.0
                assert info["episode"]["l"] == 10
                assert not np.array_equal(info["terminal_observation"], observations[i])
    assert ends == 8


def test_ppo_learns_from_the_vector() -> None:
    stable_baselines3 = pytest.importorskip("stable_baselines3")
    model = stable_baselines3.PPO("MlpPolicy", vector(frame_skip=6), n_steps=32, batch_size=64, seed=1, device="cpu")
    before = model.policy.action_net.weight.detach().clone()
    model.learn(512)
    assert model.num_timesteps == 512
    assert not np.allclose(before.numpy(), model.policy.action_net.weight.detach().numpy())


def test_other_modes_are_refused() -> None:
    pytest.importorskip("stable_baselines3")
    from fulbito.stable_baselines import StableBaselinesVector

    with pytest.raises(fulbito.UsageError, match="SAME_STEP"):
        StableBaselinesVector(gymnasium.make_vec("fulbito/Drill-v0", 2, drill=3))


@pytest.mark.parametrize("name", ["fulbito/VSS-v0", "fulbito/VSSCompat-v0", "fulbito/Drill-v0", "fulbito/Navigate-v0"])
def test_stable_baselines_own_check(name: str) -> None:
    pytest.importorskip("stable_baselines3")
    from stable_baselines3.common.env_checker import check_env

    import fulbito.envs  # noqa: F401  registers the environments

    check_env(gymnasium.make(name).unwrapped, warn=True)


PLAN = '[tournament]\nname = "ray"\nformat = "{format}"\npairs = 2\n\n[match]\nhalf_seconds = 5\n' + "".join(
    f'\n[[team]]\nteam = "{team}"\n' for team in ("classic", "chaser", "random", "idle"))


@pytest.fixture(scope="module")
def cluster() -> Any:
    """Two nodes on this machine, each with one processor."""
    pytest.importorskip("ray")
    from ray.cluster_utils import Cluster

    os.environ["PYTHONPATH"] = os.pathsep.join(path for path in sys.path if path)
    nodes = Cluster(initialize_head=True, head_node_args={"num_cpus": 1})
    nodes.add_node(num_cpus=1)
    nodes.connect()
    yield nodes
    importlib.import_module("ray").shutdown()
    nodes.shutdown()


def undisturbed(plan: Path, out: Path) -> str:
    """The report of one run without Ray."""
    done = subprocess.run([sys.executable, "-m", "fulbito", "tournament", "run", str(plan), "--out", str(out), "--csv", "-"],
                          capture_output=True, text=True, check=True)
    return done.stdout


@pytest.mark.parametrize("format_", ["round-robin", "swiss"])
def test_a_tournament_on_two_nodes_is_that_of_one_run(cluster: Any, tmp_path: Path, format_: str) -> None:
    from fulbito.ray_tournament import play_tournament

    plan = tmp_path / "plan.toml"
    plan.write_text(PLAN.format(format=format_))
    said: list[str] = []
    code = play_tournament(plan, shards=3, out=tmp_path / "out", report=["--csv", str(tmp_path / "found.csv")], say=said.append)
    assert code == 0, said
    assert (tmp_path / "found.csv").read_text() == undisturbed(plan, tmp_path / "alone")
    assert ("the next round" in said) == (format_ == "swiss")
    # The same command again plays nothing, and reports the same.
    assert play_tournament(plan, shards=2, out=tmp_path / "out", report=["--csv", str(tmp_path / "again.csv")], say=said.append) == 0
    assert (tmp_path / "again.csv").read_text() == (tmp_path / "found.csv").read_text()


def test_shards_of_killed_workers_are_played_again(cluster: Any, tmp_path: Path) -> None:
    from concurrent.futures import ThreadPoolExecutor

    from fulbito.ray_tournament import play_tournament

    plan = tmp_path / "plan.toml"
    plan.write_text(PLAN.format(format="round-robin").replace("half_seconds = 5", "half_seconds = 40"))
    with ThreadPoolExecutor(1) as pool:
        playing = pool.submit(play_tournament, plan, shards=4, out=tmp_path / "out", report=["--csv", str(tmp_path / "found.csv")],
                              say=lambda line: None)
        killed = 0
        while killed < 2 and not playing.done():
            for worker in workers():
                os.kill(worker, signal.SIGKILL)
                killed += 1
                time.sleep(1.0)
            time.sleep(0.05)
        assert playing.result() == 0
    assert killed >= 2
    assert (tmp_path / "found.csv").read_text() == undisturbed(plan, tmp_path / "alone")


def workers() -> list[int]:
    """Processes of Ray that play a shard now."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                if (entry / "cmdline").read_bytes().startswith(b"ray::play_shard"):
                    found.append(int(entry.name))
            except OSError:
                pass
    return found


def test_a_wrong_plan_ends_at_once_with_the_program_s_words(cluster: Any, tmp_path: Path) -> None:
    from fulbito.ray_tournament import play_tournament

    plan = tmp_path / "plan.toml"
    plan.write_text(PLAN.format(format="round-robin").replace("chaser", "nobody"))
    said: list[str] = []
    assert play_tournament(plan, shards=2, out=tmp_path / "out", say=said.append) == 2
    assert "nobody" in said[-1]


def test_evolution_on_two_nodes_does_not_depend_on_the_workers(cluster: Any, tmp_path: Path) -> None:
    command = [sys.executable, str(EXAMPLES / "python" / "ray_train.py"), "fulbito/Drill-v0", "--set", "drill=1", "--set", "frame_skip=20",
               "--address", cluster.address, "--rounds", "3", "--directions", "6", "--episodes", "4"]
    for count in ("1", "2"):
        subprocess.run([*command, "--workers", count, "--out", str(tmp_path / count)], check=True)
    assert (tmp_path / "1" / "policy.onnx").read_bytes() == (tmp_path / "2" / "policy.onnx").read_bytes()


@pytest.mark.skipif(not fulbito.program_path().is_file(), reason="built without the program")
def test_a_shard_needs_no_ray(tmp_path: Path) -> None:
    done = play_shard(["classic", "idle"], "1/1", ["--half-seconds", "5"], None)
    assert done.code == 0
    again = play_shard(["classic", "idle"], "1/1", ["--half-seconds", "5"], done.folder)
    assert again.code == 0
    assert play_shard(["classic", "nobody"], "1/1", [], None).code == 2
