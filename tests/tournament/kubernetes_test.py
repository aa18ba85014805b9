"""Runs the containers' commands of the Kubernetes manifests, one pod after the other, with the variables and mounts that a
cluster gives them: kubernetes_test.py PROJECT INSTALLED. INSTALLED is a prefix with bin/fulbito."""

import filecmp
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import yaml

PROJECT, INSTALLED = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
EXAMPLES = PROJECT / "examples/tournaments"


def jobs(file):
    return [part for part in yaml.safe_load_all((EXAMPLES / file).read_text()) if part["kind"] == "Job"]


def run_pod(container, index, mounts):
    """Runs the command of a container; its mounted folders are those of `mounts`."""
    def word(text):
        text = text.replace("$(JOB_COMPLETION_INDEX)", str(index))
        for mount in container["volumeMounts"]:
            text = re.sub(rf"(?<![\w.]){re.escape(mount['mountPath'])}(?![\w-])", str(mounts[mount["name"]]), text)
        return text

    environment = {**os.environ, "JOB_COMPLETION_INDEX": str(index), "PATH": f"{INSTALLED / 'bin'}:{os.environ['PATH']}"}
    done = subprocess.run([word(text) for text in container["command"] + container["args"]], env=environment, text=True,
                          capture_output=True, check=False)
    if done.returncode != 0:
        sys.exit(f"kubernetes_test.py: pod {index} of {container['name']}: exit code {done.returncode}\n{done.stderr}")
    return done.stderr


def main():
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        mounts = {"plan": work / "plan", "results": work / "results"}
        for folder in mounts.values():
            folder.mkdir()
        (mounts["plan"] / "plan.toml").write_bytes((EXAMPLES / "plan.toml").read_bytes())
        for job in jobs("kubernetes.yaml") + jobs("kubernetes-merge.yaml"):
            container = job["spec"]["template"]["spec"]["containers"][0]
            for index in range(job["spec"].get("completions", 1)):
                run_pod(container, index, mounts)
                # A pod that is started again, as after the loss of its node, plays nothing again.
                again = run_pod(container, index, mounts)
                if "tournament run" in " ".join(container["command"]) and "\n0 matches played" not in again:
                    sys.exit(f"kubernetes_test.py: pod {index} played matches again\n{again}")
        files = ("report.html", "matches.csv", "report.md")
        subprocess.run([INSTALLED / "bin/fulbito", "tournament", "run", EXAMPLES / "plan.toml", "--out", "whole", "--html",
                        files[0], "--csv", files[1], "--markdown", files[2]], cwd=work, check=True, capture_output=True)
        for file in files:
            if not filecmp.cmp(work / file, mounts["results"] / file, shallow=False):
                sys.exit(f"kubernetes_test.py: {file} is not that of one run")
    print("kubernetes_test.py: an indexed job of 3 and its merge give the reports of one run")


main()
