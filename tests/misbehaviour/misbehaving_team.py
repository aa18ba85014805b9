"""A Python team that misbehaves in one way at a decision: misbehaving_team.py KIND [DECISION, from 1]."""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Callable, Dict

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "sdk" / "python"))

from fulbito_team import Commands, Observation, Team, run  # noqa: E402


def throw() -> Commands:
    raise RuntimeError("this team has a fault")


def leave() -> Commands:
    sys.exit(5)


def nothing() -> Commands:
    return None  # type: ignore[return-value]


def recurse() -> Commands:
    return recurse()


def no_number() -> Commands:
    commands = Commands()
    commands.wheels(0, float("nan"), float("inf"))
    return commands


def words() -> Commands:
    commands = Commands()
    commands.wheels(0, "fast", "faster")  # type: ignore[arg-type]
    return commands


def unknown_robot() -> Commands:
    commands = Commands()
    commands.wheels(99, 1.0, 1.0)
    return commands


def prints() -> Commands:
    print("a line for standard output")
    os.write(1, b"bytes for standard output\n")
    return Commands()


def interrupts_itself() -> Commands:
    os.kill(os.getpid(), signal.SIGINT)
    return Commands()


def sleeps() -> Commands:
    time.sleep(3600)
    return Commands()


def spins() -> Commands:
    def turn() -> None:
        while True:
            pass

    for _ in range(4):
        threading.Thread(target=turn).start()
    return Commands()


def leaves_child() -> Commands:
    subprocess.Popen([sys.executable, "-c", "import time; time.sleep(3600)"] + sys.argv[1:], start_new_session=True)
    return Commands()


def takes_memory() -> Commands:
    taken = []
    while len(taken) < 200:  # a bound of its own: 3.1 GiB
        taken.append(bytearray(1 << 24))
    raise RuntimeError("GOT THROUGH")


KINDS: Dict[str, Callable[[], Commands]] = {
    "exception": throw, "exit": leave, "no-answer": nothing, "recursion": recurse, "nan": no_number,
    "words": words, "unknown-robot": unknown_robot, "prints": prints, "interrupt": interrupts_itself,
    "sleep": sleeps, "busy-threads": spins, "leaves-child": leaves_child, "memory": takes_memory}


class Misbehaving(Team):
    name = "misbehaving"

    def __init__(self, kind: str, at: int) -> None:
        super().__init__()
        self.kind = kind
        self.at = at
        self.decisions = 0

    def decide(self, seen: Observation) -> Commands:
        self.decisions += 1
        return KINDS[self.kind]() if self.decisions == self.at else Commands()


if __name__ == "__main__":
    run(Misbehaving(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1))
