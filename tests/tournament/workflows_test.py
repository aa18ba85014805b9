"""Plays the workflows of .github/workflows with the program: workflows_test.py PROJECT INSTALLED

INSTALLED is a prefix with bin/fulbito and its helpers. `cmake` does nothing here: the simulator counts as built."""

import filecmp
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from workflow_runner import Runner

PROJECT, INSTALLED = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
FULBITO = INSTALLED / "bin/fulbito"


def expect(condition, what, runner=None):
    if not condition:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: not so: {what}\n{runner.log if runner else ''}")


def fulbito(*arguments, folder):
    subprocess.run([FULBITO, *arguments], cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def simulator(work):
    """A checkout of the simulator in which everything is built."""
    folder = work / "simulator"
    for part in ("scripts", "examples"):
        shutil.copytree(PROJECT / part, folder / part)
    shutil.copytree(INSTALLED, folder / "installed")
    return folder


def shards(work):
    """The matrix workflow gives the reports of an undisturbed run."""
    plan = "examples/tournaments/plan.toml"
    (work / "shards").mkdir()
    runner = Runner(PROJECT / ".github/workflows/tournament.yml", work / "shards", {".": simulator(work)},
                    {"inputs": {"plan": plan}}, work / "caches")
    expect(runner.run() == ["build", "shard", "merge"], "all jobs of tournament.yml pass", runner)
    fulbito("tournament", "run", PROJECT / plan, "--out", "whole", "--html", "report.html", "--csv", "matches.csv",
            "--markdown", "report.md", folder=work)
    for file in ("report.html", "matches.csv", "report.md"):
        expect(filecmp.cmp(work / file, runner.artifacts / "report" / file, shallow=False), f"{file} is that of one run")
    expect(runner.summary.read_text() == (work / "report.md").read_text(), "the summary is the report")


def team_folders(work):
    """Two versions of a team: the starter, and one in which only the keeper plays."""
    fulbito("new-team", "cpp", "strong", folder=work)
    shutil.copytree(work / "strong", work / "weak")
    source = work / "weak/team.cpp"
    source.write_text(source.read_text().replace("} else if (i == attacker) {", "} else if (i == 99) {"))
    return work / "strong", work / "weak"


def team(work, name, new, base):
    folder = work / name
    folder.mkdir()
    given = {"TEST": "--half-seconds 5 --pairs 12 --bounds -100,100", "CHECKS": "--quick"}
    runner = Runner(PROJECT / ".github/workflows/team.yml", folder,
                    {"new": new, "base": base, "fulbito": work / "simulator"},
                    {"github": {"base_ref": "main", "run_id": name, "run_attempt": 1}, "given": given,
                     "runner": {"os": "Linux", "arch": "X64"}}, work / "caches")
    return runner, runner.run() == ["test"]


def pull_requests(work):
    strong, weak = team_folders(work)
    better, passed = team(work, "better", strong, weak)
    expect(passed, "a better team passes", better)
    report = better.artifacts / "report"
    expect(": pass, " in better.summary.read_text(), "the summary tells the verdict", better)
    for file in ("report.html", "check-team.xml", "sprt.xml", "results/plan.json"):
        expect((report / file).exists(), f"{file} is kept", better)
    for link in re.findall(r'href="\./([^"]*)"', (report / "report.html").read_text()):
        expect((report / link).exists(), f"{link} of the report is kept")

    again, passed = team(work, "again", strong, weak)
    expect(passed and "\n0 matches played" in again.log, "no match is played twice", again)
    expect((again.artifacts / "report/results/matches.jsonl").exists(), "results of the cache are kept")

    worse, passed = team(work, "worse", weak, strong)
    expect(not passed and "exit code 1\n" in worse.log, "a worse team fails", worse)
    expect(": fail, " in worse.summary.read_text(), "the summary tells the verdict", worse)
    expect("::error" in worse.log, "there is an annotation", worse)
    expect((worse.artifacts / "report/report.html").exists(), "the report of a worse team is kept")


def main():
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        (work / "caches").mkdir()
        (work / "bin").mkdir()
        (work / "bin/cmake").write_text("#!/bin/sh\n")
        (work / "bin/cmake").chmod(0o755)
        os.environ["PATH"] = f"{work / 'bin'}{os.pathsep}{os.environ['PATH']}"
        shards(work)
        pull_requests(work)
    print("workflows_test.py: shards, a better team, the same again and a worse one end as they must")


main()
