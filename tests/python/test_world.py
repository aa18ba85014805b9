"""Worlds without rules."""

import threading

import numpy as np
import pytest

import fulbito
from fulbito import World


def two_robots() -> World:
    return World(robots=[[-0.3, 0.0, 0.0], [0.3, 0.2, 1.0]], balls=[[0.0, 0.0]])


def test_a_world_begins_as_it_was_made() -> None:
    world = World(robots=[[0.1, 0.2, 0.5, 0.3, -0.4, 1.5]], balls=[[0.3, 0.1, 1.0, 0.5]], discs=[[-0.3, 0.1, 0.05]])
    assert world.robots[0, :6] == pytest.approx([0.1, 0.2, 0.5, 0.3, -0.4, 1.5])
    assert world.balls[0] == pytest.approx([0.3, 0.1, 1.0, 0.5, 1.0, 0.5])
    assert world.obstacles[0] == pytest.approx([-0.3, 0.1, 0, 0, 0])
    assert world.tick == 0 and world.dt == pytest.approx(1 / 60)
    assert world.contacts == []


def test_steps_move_bodies() -> None:
    world = two_robots()
    world.step([[20.0, 20.0], [0.0, 0.0]], ticks=60)
    assert world.tick == 60
    assert world.robots[0, 0] > -0.2
    assert world.balls[0, 0] > 0.0


def test_a_run_is_its_steps() -> None:
    commands = np.random.default_rng(1).uniform(-30, 30, (120, 2, 2))
    one, other = two_robots(), two_robots()
    robots, balls = one.run(commands)
    for tick in range(120):
        other.step(commands[tick])
        assert np.array_equal(robots[tick], other.robots) and np.array_equal(balls[tick], other.balls)
    assert one.state_hash() == other.state_hash()


def test_contacts() -> None:
    world = World(robots=[[-0.12, 0.0, 0.0]], balls=[[0.0, 0.0]])
    touched = []
    for _ in range(60):
        world.step([[20.0, 20.0]])
        touched += [(c.a[0], c.b[0]) for c in world.contacts if c.began]
    assert ("robot", "ball") in touched


def test_arrays_are_copies() -> None:
    world = two_robots()
    before = world.robots
    before[:] = 7.0
    assert world.robots[0, 0] == pytest.approx(-0.3)


def test_a_second_thread_is_an_error_not_a_crash() -> None:
    world, errors = two_robots(), []

    def run() -> None:
        try:
            world.step(np.zeros((2, 2)), ticks=200_000)
        except fulbito.StateError as error:
            errors.append(str(error))

    threads = [threading.Thread(target=run) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors == ["the world is in use by another thread"]
    assert world.tick == 200_000


def test_no_bodies() -> None:
    world = World()
    world.step(np.zeros((0, 2)), ticks=3)
    assert world.robots.shape == (0, 8) and world.balls.shape == (0, 6) and world.tick == 3
