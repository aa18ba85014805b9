"""Plays a tournament on a Ray cluster: one task per shard, merged here.

    python -m fulbito.ray_tournament plan.toml --shards 16 --out results --html report.html

A task whose worker or node dies is played again, and so is a shard whose machine lacked resources. Rounds that depend on
results (knock-out, Swiss, ladder) are as many passes. Needs `pip install "fulbito[ray]"` on each node, with the same
version of Fulbito.
"""

import argparse
import io
import subprocess
import sys
import tarfile
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Callable, Optional, Sequence, Union

from fulbito.errors import FileError, MachineError, UsageError
from fulbito.program import program_path

__all__ = ["ShardResult", "main", "play_shard", "play_tournament"]

_TRY_AGAIN = {5, 6, 129, 130, 143}  # exit codes of a shard whose machine failed, not its plan: docs/tournaments.md
_INCOMPLETE = 6  # exit code of `merge` while matches are missing
_MERGE_FLAGS = ["--json", "--force", "--annotations"]
_MERGE_FILES = ["--html", "--csv", "--markdown", "--junit"]


@dataclass(frozen=True)
class ShardResult:
    """What a task gives back."""

    code: int
    """Exit code of `fulbito tournament run --shard`."""
    error: str
    """What it printed to standard error."""
    folder: bytes
    """Its folder of results, as a tar archive."""


def _packed(folder: Path) -> bytes:
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w:gz") as archive:
        archive.add(folder, arcname=".")
    return data.getvalue()


def _unpack(data: bytes, folder: Path) -> None:
    with tarfile.open(fileobj=io.BytesIO(data), mode="r:gz") as archive:
        archive.extractall(folder, filter="data")


def _run(words: Sequence[Union[str, Path]]) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([str(program_path()), "tournament", *map(str, words)], capture_output=True, text=True, check=False)


def play_shard(plan: Union[str, Sequence[str]], shard: str, options: Sequence[str], before: Optional[bytes]) -> ShardResult:
    """Plays one shard in a folder of its own. It is the body of a Ray task, and needs no Ray itself.

    `plan`: the text of a plan file, or the teams; `shard`: such as "2/8"; `options`: of `fulbito tournament run`;
    `before`: an archive of results that the shard need not play again, or None.
    """
    with tempfile.TemporaryDirectory(prefix="fulbito-shard-") as name:
        folder = Path(name) / "results"
        if before is not None:
            _unpack(before, folder)
        words: list[Union[str, Path]] = []
        if isinstance(plan, str):
            file = Path(name) / "plan.toml"
            file.write_text(plan, encoding="utf-8")
            words.append(file)
        else:
            words.extend(plan)
        done = _run(["run", *words, "--shard", shard, "--out", folder, "--jobs", "1", *options])
        code = done.returncode if done.returncode >= 0 else 128 - done.returncode
        return ShardResult(code, done.stderr, _packed(folder) if folder.is_dir() else b"")


def _to_stderr(line: str) -> None:
    print(line, file=sys.stderr, flush=True)


class _Shards:
    """The shards of one pass, as Ray tasks. A shard is tried again while its machine is at fault."""

    def __init__(self, plan: Union[str, Sequence[str]], count: int, options: Sequence[str], tries: int,
                 say: Callable[[str], None]) -> None:
        import ray

        self._ray = ray
        # Ray itself starts a task again whose worker or node died.
        self._task = ray.remote(num_cpus=1, max_retries=tries)(play_shard)
        self._plan, self._count, self._options, self._tries, self._say = plan, count, list(options), tries, say

    def _start(self, shard: int, before: Any) -> Any:
        return self._task.remote(self._plan, f"{shard}/{self._count}", self._options, before)

    def play(self, before: Optional[bytes], keep: Callable[[int, bytes], None]) -> int:
        """Plays all shards; `keep(shard, archive)` gets each result. Returns 0, or the exit code of a shard that no try mends."""
        shared = self._ray.put(before) if before is not None else None
        waiting = {self._start(shard, shared): shard for shard in range(1, self._count + 1)}
        tries = dict.fromkeys(range(1, self._count + 1), 1)
        done = 0
        while waiting:
            ready, _ = self._ray.wait(list(waiting), num_returns=1)
            shard = waiting.pop(ready[0])
            try:
                result: ShardResult = self._ray.get(ready[0])
            except self._ray.exceptions.RayError as error:
                result = ShardResult(_INCOMPLETE, str(error), b"")
            if result.code in _TRY_AGAIN and tries[shard] < self._tries:
                tries[shard] += 1
                self._say(f"shard {shard}/{self._count}: exit code {result.code}, played again (try {tries[shard]})")
                waiting[self._start(shard, shared)] = shard
                continue
            # A shard ends with 1 if the plan's test fails, and with 4 if a team failed: its results are there.
            if result.code not in (0, 1, 4, _INCOMPLETE):
                for task in waiting:
                    self._ray.cancel(task, force=True)
                self._say(f"shard {shard}/{self._count}: exit code {result.code}\n{result.error.strip()}")
                return result.code
            if result.folder:
                keep(shard, result.folder)
            done += 1
            self._say(f"{done} of {self._count} shards done")
        return 0


def _matches(folder: Path) -> int:
    return sum(1 for log in folder.rglob("*.jsonl") for _ in log.open("rb"))


def play_tournament(plan: Union[str, Path, Sequence[str]], *, shards: int, out: Union[str, Path],
                    options: Sequence[str] = (), report: Sequence[str] = (), tries: int = 5,
                    say: Callable[[str], None] = _to_stderr) -> int:
    """Plays a tournament on the Ray cluster to which this process is connected (`ray.init`), or which Ray then starts.

    `plan`: a plan file, or a list of teams. Files that it names must lie on each node, under the same absolute path, or be
    shipped by Ray's `working_dir`. `shards`: tasks per pass. `out`: a folder; it gets `shard-1`, `shard-2` ... and
    `merged`, and continues what it holds. `options`: of `fulbito tournament run`; `report`: of `fulbito tournament merge`.
    `tries`: of each shard.

    Returns the exit code of `fulbito tournament merge`, or of a shard that no try mends. Raises UsageError, FileError,
    and MachineError if passes bring no new matches.
    """
    if shards < 1:
        raise UsageError(f"shards = {shards} must be at least 1")
    if tries < 1:
        raise UsageError(f"tries = {tries} must be at least 1")
    known: Union[str, Sequence[str]] = plan if not isinstance(plan, (str, Path)) else ""
    if isinstance(plan, (str, Path)):
        try:
            known = Path(plan).read_text(encoding="utf-8")
        except OSError as error:
            raise FileError(f"{plan}: {error.strerror}") from error
    folder = Path(out)
    folder.mkdir(parents=True, exist_ok=True)

    def keep(shard: int, data: bytes) -> None:
        place = folder / f"shard-{shard}"
        place.mkdir(exist_ok=True)
        _unpack(data, place)

    merged = folder / "merged"
    passes = _Shards(known, shards, options, tries, say)
    while True:
        before = _packed(merged) if merged.is_dir() else None
        count = _matches(merged)
        if (code := passes.play(before, keep)) != 0:
            return code
        parts = sorted(folder.glob("shard-*"))
        done = _run(["merge", *parts, *([merged] if merged.is_dir() else []), "--out", merged, *report])
        if done.returncode != _INCOMPLETE:
            sys.stdout.write(done.stdout)
            if done.stderr:
                say(done.stderr.strip())
            return done.returncode
        if _matches(merged) == count:
            raise MachineError(f"matches are missing, and another pass brings none: {done.stderr.strip()}")
        say("the next round")


def _arguments(words: Optional[Sequence[str]]) -> tuple[argparse.Namespace, list[str]]:
    parser = argparse.ArgumentParser(
        prog="python -m fulbito.ray_tournament", description="Plays a tournament on a Ray cluster, a task per shard.",
        epilog="Other options are those of `fulbito tournament run`, such as --pairs 10. "
               "Example: python -m fulbito.ray_tournament plan.toml --shards 16 --out results --html report.html")
    parser.add_argument("plan", nargs="+", help="a plan file (TOML), or teams in the order of their seeding")
    parser.add_argument("--shards", type=int, default=0, metavar="N", help="tasks (default: one per processor of the cluster)")
    parser.add_argument("--out", required=True, metavar="FOLDER", help="folder of the results; the same command continues it")
    parser.add_argument("--address", default=None, metavar="HOST:PORT",
                        help="of a running cluster; auto: the one of this machine (default: start one here)")
    parser.add_argument("--ship", default=None, metavar="FOLDER", help="folder that Ray copies to each node; tasks run in it")
    parser.add_argument("--tries", type=int, default=5, metavar="N", help="tries of a shard whose machine fails (default: 5)")
    for flag in _MERGE_FLAGS:
        parser.add_argument(flag, action="store_true", help="of the report, as in `fulbito tournament merge`")
    for flag in _MERGE_FILES:
        parser.add_argument(flag, metavar="FILE", help="of the report, as in `fulbito tournament merge`")
    return parser.parse_known_args(words)


def main(words: Optional[Sequence[str]] = None) -> int:
    """The command `python -m fulbito.ray_tournament`. Returns its exit code."""
    known, options = _arguments(words)
    try:
        import ray
    except ImportError:
        print('fulbito.ray_tournament: Ray is missing: pip install "fulbito[ray]"', file=sys.stderr)
        return 2
    report: list[str] = [flag for flag in _MERGE_FLAGS if getattr(known, flag[2:])]
    for flag in _MERGE_FILES:
        if getattr(known, flag[2:]) is not None:
            report += [flag, getattr(known, flag[2:])]
    runtime = {"working_dir": known.ship} if known.ship else None
    ray.init(address=known.address, runtime_env=runtime, log_to_driver=False, configure_logging=False)
    try:
        shards = known.shards or max(1, int(ray.cluster_resources().get("CPU", 1)))
        plan: Union[str, list[str]] = known.plan[0] if len(known.plan) == 1 else known.plan
        began = time.monotonic()
        code = play_tournament(plan, shards=shards, out=known.out, options=options, report=report, tries=known.tries)
        _to_stderr(f"{time.monotonic() - began:.0f} s")
        return code
    except (UsageError, FileError, MachineError) as error:
        print(f"fulbito.ray_tournament: {error}", file=sys.stderr)
        return 2 if isinstance(error, UsageError) else 5 if isinstance(error, FileError) else _INCOMPLETE
    finally:
        ray.shutdown()


if __name__ == "__main__":
    sys.exit(main())
