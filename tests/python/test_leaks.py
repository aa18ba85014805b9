"""Environments keep no memory: resets, steps, vectors made and dropped. `FULBITO_LEAK_SCALE=1000` plays the long form:
a million resets and a hundred million steps."""

import gc
import os
from pathlib import Path

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium")

import fulbito.envs
import fulbito.envs.vss

SCALE = int(os.environ.get("FULBITO_LEAK_SCALE", "1"))
ALLOWED = 12.0  # [MiB] that fragments of freed memory may take


def resident() -> float:
    """[MiB] of this process."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def test_resets_keep_no_memory() -> None:
    env = gymnasium.make("fulbito/VSS-v0", opponents="chaser").unwrapped
    for seed in range(300):
        env.reset(seed=seed)
    before = resident()
    for seed in range(1000 * SCALE):
        env.reset(seed=seed)
    assert resident() - before < ALLOWED


def test_steps_keep_no_memory() -> None:
    vector = gymnasium.make_vec("fulbito/VSS-v0", 64, threads=2, time_limit=2.0)
    vector.reset(seed=1)
    actions = np.random.default_rng(0).uniform(-1, 1, (16, 64, 2)).astype(np.float32)
    for i in range(400):
        vector.step(actions[i % 16])
    before = resident()
    for i in range(1563 * SCALE):
        vector.step(actions[i % 16])
    assert resident() - before < ALLOWED


def test_environments_that_are_dropped_keep_no_memory() -> None:
    def make() -> None:
        vector = fulbito.envs.vss.VSSVectorEnv(8, threads=2)
        vector.reset(seed=1)
        vector.step(np.zeros((8, 2), np.float32))
        env = fulbito.envs.vss.VSSEnv()
        env.reset(seed=1)
        env.copy().step(np.zeros(2, np.float32))

    for _ in range(10):
        make()
    before = resident()
    for _ in range(20 * min(SCALE, 50)):
        make()
    assert resident() - before < ALLOWED
