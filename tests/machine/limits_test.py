#!/usr/bin/env python3
"""Plays matches of sound teams under random limits: limits_test.py FULBITO LIBRARY PROGRAM COUNT [SEED]

LIBRARY is a team of a shared library, PROGRAM one of the line protocol. Each combination of open files,
processes, address space, stack and room for temporary files either lets a match be whole, or the match is named
as not played with exit code 6. No team forfeits or crashes, and neither does the program. Exit code 77: this is
not root, or the system lacks what sets limits.
"""

import json
import os
import random
import shutil
import subprocess
import sys
import tempfile

FILES = [8, 12, 16, 18, 20, 24, 28, 32, 36, 40, 48, 64, 100, 256, None]
PROCESSES = [3, 10, 30, 60, 70, 80, 100, 150, 250, None, None]
ADDRESS_SPACE = [40_000, 60_000, 80_000, 100_000, 150_000, 300_000, 1_100_000, 1_500_000, 4_000_000, None, None]  # [KiB]
STACK = [64, 128, 1024, 4096, 8192, None, None, None]  # [KiB]
PLACES = ["size=4k", "size=64k", "nr_inodes=1", "nr_inodes=2", "nr_inodes=3", "nr_inodes=6", "", "", ""]
MEMORY = [64, 256, 1024]  # [MiB] of a team


class Play:
    """A copy of the program and its teams that every user can read."""

    def __init__(self, folder, program, library, team):
        self.folder = folder
        os.chmod(folder, 0o755)
        for file in (program, os.path.join(os.path.dirname(program), "fulbito-team-host")):
            shutil.copy(file, folder)
        os.mkdir(f"{folder}/teams")
        self.library = shutil.copy(library, f"{folder}/teams")
        self.team = shutil.copy(team, f"{folder}/teams")
        os.mkdir(f"{folder}/temporary")
        self.runs = 0

    def arguments(self, draw):
        teams = [self.library, f"cmd:{self.team}", "idle"]
        draw.shuffle(teams)
        play = ["--half-seconds", "0.5", "--json", "--seed", str(draw.randrange(1000)), "--team-memory", str(draw.choice(MEMORY))]
        jobs = ["--jobs", str(draw.choice([1, 2, 4, 16]))]
        kind = draw.randrange(3)
        if kind == 0:
            return ["match", *teams[:2], *play]
        if kind == 1:
            return ["match", *teams[:2], *play, *jobs, "-n", "2"]
        self.runs += 1
        out = f"{self.folder}/out-{self.runs}"
        os.mkdir(out)
        os.chmod(out, 0o777)
        return ["tournament", "run", *teams, *play, *jobs, "--pairs", "1", "--out", out]

    def command(self, draw):
        limits = {"-n": draw.choice(FILES), "-u": draw.choice(PROCESSES), "-s": draw.choice(STACK), "-v": draw.choice(ADDRESS_SPACE)}
        # Mostly one shortage at a time, or nothing would ever be played.
        for flag in draw.sample(list(limits), draw.choice([0, 2, 3, 3])):
            limits[flag] = None
        place = draw.choice(PLACES)
        user = draw.choice(["", "setpriv --reuid=65534 --regid=65534 --clear-groups"])
        shell = " && ".join(f"ulimit {flag} {most}" for flag, most in limits.items() if most is not None) or "true"
        mount = f"mount -t tmpfs -o {place + ',' if place else ''}mode=1777 none {self.folder}/temporary"
        inner = f"{shell} && exec \"$@\""
        return (["unshare", "-m", "--propagation", "private", "bash", "-c",
                 f"{mount} && exec {user} bash -c '{inner}' bash \"$@\"", "bash"],
                f"{shell}; {place or 'room'}; {'nobody' if user else 'root'}")


def faults(report):
    """Matches in the report that a team failed in."""
    if "entrants" in report:
        return sum(e["faults"]["forfeit"] + e["faults"]["crash"] for e in report["entrants"])
    if "matches" in report:
        return sum(abs(m["goals_a"] - m["goals_b"]) >= 10 for m in report["matches"])
    return sum(report["stats"][team]["commands"].get("failures", 0) for team in ("blue", "yellow")) if "stats" in report else 0


def check(ran, arguments):
    """What is wrong with a run; empty: nothing. And whether it was whole."""
    if ran.returncode not in (0, 6):
        return f"exit code {ran.returncode}", False
    report = json.loads(ran.stdout) if ran.stdout else {}
    if faults(report) or "forfeit" in ran.stderr or "failed" in ran.stderr.replace("the machine failed", "").replace("attempts failed", ""):
        return "a team is blamed", False
    whole = report.get("complete", report.get("finished", report.get("score", {}).get("complete", False)))
    if ran.returncode == 0:
        return "" if whole else "not whole", True
    named = report.get("unplayed") or report.get("abandoned") or ran.stderr
    return "" if named and not whole else "not named", False


def main():
    program, library, team, count = sys.argv[1:5]
    if os.geteuid() != 0 or not (shutil.which("setpriv") and shutil.which("unshare")):
        return 77
    draw = random.Random(int(sys.argv[5]) if len(sys.argv) > 5 else 1)
    wrong = whole = 0
    with tempfile.TemporaryDirectory() as folder:
        play = Play(folder, program, library, team)
        for number in range(int(count)):
            prefix, limits = play.command(draw)
            arguments = play.arguments(draw)
            ran = subprocess.run([*prefix, f"{folder}/fulbito", *arguments], text=True, timeout=120, check=False,
                                 stdin=subprocess.DEVNULL, capture_output=True,
                                 env={"PATH": "/usr/bin:/bin", "TMPDIR": f"{folder}/temporary", "HOME": folder})
            why, complete = check(ran, arguments)
            whole += complete
            if why or "--verbose" in sys.argv:
                print(f"{number}: {limits}: {' '.join(arguments)}\n  {why or ran.returncode}: {ran.stdout[-300:]} {ran.stderr[-300:]}")
            wrong += bool(why)
    print(f"{count} combinations: {whole} whole, {wrong} wrong, the others named as not played")
    return 1 if wrong or not whole else 0


if __name__ == "__main__":
    sys.exit(main())
