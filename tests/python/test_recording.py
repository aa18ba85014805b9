"""Recordings as arrays, pages and pictures."""

from pathlib import Path

import numpy as np
import pytest

import fulbito
from fulbito import MatchResult, Recording


def test_it_says_what_it_is(recording: Recording, short_match: MatchResult) -> None:
    assert recording.teams == ["libero", "idle"]
    assert recording.bodies == ["blue 0", "blue 1", "blue 2", "yellow 0", "yellow 1", "yellow 2", "ball"]
    assert recording.score == short_match.score
    assert recording.seconds == pytest.approx(short_match.data["simulated_s"])
    assert recording.header["kind"] == "match"
    blue, yellow = short_match.score
    assert f"libero {blue} : {yellow} idle" in repr(recording)


def test_its_calls_are_those_of_the_match(recording: Recording, short_match: MatchResult) -> None:
    calls = [event for event in short_match.events if event.event != "restart"]
    assert [(e.tick, e.event, e.team) for e in recording.events] == [(e.tick, e.event, e.team) for e in calls]
    assert recording.event_table()["event"].tolist() == [e.event for e in calls]


def test_samples_are_rounded_states(recording: Recording) -> None:
    samples, states = recording.samples(), recording.states()
    rows = samples.ticks[samples.ticks > 0] - 1
    exact = states.pose[rows]
    seen = samples.poses[samples.ticks > 0]
    assert seen.shape == exact.shape == (len(rows), 7, 3)
    # At the tick where play stops, a sample may show the next placement.
    near = np.abs(seen[..., :2] - exact[..., :2]).max(axis=(1, 2)) < 5e-4
    assert near.mean() > 0.99
    assert states.ticks.tolist() == list(range(1, recording.ticks + 1))
    assert np.isnan(states.pose[:, 6, 2]).all() and np.isfinite(states.pose[:, :6]).all()
    assert states.wheels.shape == states.commands.shape == (recording.ticks, 6, 2)
    assert samples.score[-1].tolist() == list(recording.score or ())
    assert samples.playing.dtype == np.bool_ and samples.playing.any()


def test_velocity_is_the_change_of_place(recording: Recording) -> None:
    states = recording.states()
    moved = np.diff(states.pose[200:400, 1, :2], axis=0) * recording.header["control_rate"]
    # At a restart, robots jump to their places in one tick, faster than any robot drives [m/s].
    jumps = np.abs(moved).max(axis=1) > 3.0
    assert jumps.sum() <= 2
    velocity = states.velocity[200:400, 1, :2]
    differences = np.abs(moved - velocity[1:]).max(axis=1)[~jumps]
    # In a tick of a hit the velocity changes between two steps of the physics.
    changes = np.abs(np.diff(velocity, axis=0)).max(axis=1)[~jumps]
    assert (differences - changes).max() < 0.1
    assert np.quantile(differences, 0.9) < 0.1


def test_one_body(recording: Recording) -> None:
    ball = recording.path("ball")
    assert ball.shape == (len(recording.samples().ticks), 3)
    with pytest.raises(fulbito.UsageError, match="there is no body 'ball 2': blue 0"):
        recording.path("ball 2")


def test_a_page_and_its_frame(recording: Recording, tmp_path: Path) -> None:
    page = recording.to_html(tmp_path / "match.html")
    assert page.startswith("<!DOCTYPE html>") or page.startswith("<!doctype html>")
    assert (tmp_path / "match.html").read_text(encoding="utf-8") == page
    shown = recording._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and "<script" not in shown


def test_frames_are_pictures(recording: Recording) -> None:
    frames = list(recording.frames(fps=2, start=3, stop=5, width=320))
    assert len(frames) == 4
    assert all(f.shape == frames[0].shape and f.dtype == np.uint8 and f.shape[1:] == (320, 3) for f in frames)
    assert not (frames[0] == frames[3]).all()
    assert (recording.frame(3, width=320) == frames[0]).all()
    assert (recording.frame(3, width=320, theme="light") != frames[0]).any()
    assert recording.png(3, width=320).startswith(b"\x89PNG")


def test_verification(recording: Recording) -> None:
    verified = recording.verify()
    assert verified and verified.difference == "" and verified.finished and verified.same_build
    assert verified.ticks == recording.ticks
    assert f"{verified.final_hash:016x}" == f"{recording.header['final_hash']:016x}"


def test_files_and_recipes(recording: Recording, tmp_path: Path) -> None:
    recording.save(tmp_path / "whole.fbr")
    whole = Recording.open(tmp_path / "whole.fbr")
    recipe = fulbito.play("libero", "idle", seed=5, half_seconds=20, record=tmp_path / "recipe.fbr",
                          recipe=True).recording
    assert recipe is not None and recipe.header["level"] == "recipe"
    assert recipe.header["bytes"] < whole.header["bytes"]
    assert np.array_equal(recipe.samples().poses, whole.samples().poses, equal_nan=True)
    assert recipe.verify()


def test_damage_is_an_error_or_salvaged(recording: Recording, tmp_path: Path) -> None:
    recording.save(tmp_path / "whole.fbr")
    data = bytearray((tmp_path / "whole.fbr").read_bytes())
    data[len(data) // 2] ^= 0xFF
    with pytest.raises(fulbito.InputError):
        Recording.parse(bytes(data))
    assert 0 < Recording.parse(bytes(data), salvage=True).ticks < recording.ticks
    half = Recording.parse(bytes(data[:len(data) // 3]))
    assert not half.header["finished"] and half.score is None
