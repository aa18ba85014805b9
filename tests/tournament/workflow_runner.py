"""Plays a GitHub workflow on this machine: the scripts of its steps for real, each job in a folder of its own. Of the actions
it knows checkout, cache, upload-artifact and download-artifact, as far as the workflows of this project use them."""

import fnmatch
import glob
import os
import pathlib
import re
import shutil
import subprocess

import yaml

WORD = re.compile(r"'[^']*'|hashFiles\('[^']*'\)|cancelled\(\)|[A-Za-z_][\w.-]*|&&|\|\||!=|==|!")


class Runner:
    """One start of a workflow. `checkouts` maps the paths of checkout steps to folders of this machine."""

    def __init__(self, workflow, work, checkouts, context, caches):
        self.workflow = yaml.safe_load(pathlib.Path(workflow).read_text())
        self.work, self.checkouts, self.caches = pathlib.Path(work), checkouts, pathlib.Path(caches)
        self.context, self.artifacts = context, self.work / "artifacts"
        self.summary = self.work / "summary.md"
        self.summary.touch()
        self.log = ""

    def run(self):
        """All jobs in their order. Returns the names of those that succeeded."""
        passed = []
        for name, job in self.workflow["jobs"].items():
            needs = job.get("needs", [])
            if any(need not in passed for need in ([needs] if isinstance(needs, str) else needs)):
                continue
            matrix = job.get("strategy", {}).get("matrix", {})
            cells = [{key: value} for key, values in matrix.items() for value in values] or [{}]
            if all([self.job(f"{name}-{i}", job, cell) for i, cell in enumerate(cells)]):
                passed.append(name)
        return passed

    def job(self, name, job, matrix):
        folder = self.work / name
        folder.mkdir()
        scope = {**self.context, "matrix": matrix, "steps": {}, "env": {}, "folder": folder, "path": [], "after": []}
        for level in (self.workflow, job):
            scope["env"].update({key: self.text(value, scope) for key, value in level.get("env", {}).items()})
        scope["env"].update(self.context.get("given", {}))
        passed = True
        for step in job["steps"]:
            condition = str(step.get("if", "")).removeprefix("${{").removesuffix("}}")
            if not (self.value(condition, scope) if condition else True) or not (passed or "cancelled()" in condition):
                continue
            passed = self.step(step, scope) and passed
        for last in scope["after"]:
            last()
        return passed

    def step(self, step, scope):
        if "run" in step:
            return self.script(step, scope)
        action = step["uses"].split("@")[0].removeprefix("actions/").replace("-", "_")
        inputs = {key: self.text(value, scope) for key, value in step.get("with", {}).items()}
        getattr(self, action)(inputs, scope, scope["steps"].setdefault(step.get("id"), {"outputs": {}})["outputs"])
        return True

    def script(self, step, scope):
        paths = scope["folder"].parent / "path"
        paths.write_text("")
        search = os.pathsep.join([*reversed(scope["path"]), os.environ["PATH"]])
        environment = {**os.environ, **scope["env"], "GITHUB_STEP_SUMMARY": str(self.summary), "PATH": search,
                       "GITHUB_PATH": str(paths), "GITHUB_ACTIONS": "true"}
        done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", self.text(step["run"], scope)],
                              cwd=scope["folder"] / step.get("working-directory", "."), env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
        self.log += f"--- {step.get('name')}: exit code {done.returncode}\n{done.stdout}"
        scope["path"] += paths.read_text().split()
        return done.returncode == 0

    def checkout(self, inputs, scope, outputs):
        path = inputs.get("path", ".")
        shutil.copytree(self.checkouts[path], scope["folder"] / path, dirs_exist_ok=True)
        outputs["commit"] = "0123abc"

    def cache(self, inputs, scope, outputs):
        place, exact = scope["folder"] / inputs["path"], self.caches / inputs["key"]
        older = [folder for key in inputs.get("restore-keys", "").split()
                 for folder in sorted(self.caches.glob(key + "*"), key=os.path.getmtime)]
        for found in [exact] if exact.exists() else older[-1:]:
            shutil.copytree(found, place, dirs_exist_ok=True)
        outputs["cache-hit"] = "true" if exact.exists() else "false"
        if not exact.exists():
            scope["after"].append(lambda: place.exists() and shutil.copytree(place, exact))

    def upload_artifact(self, inputs, scope, _):
        paths = [scope["folder"] / path for path in inputs["path"].split()]
        target = self.artifacts / inputs["name"]
        for path in paths:
            if path.is_file():
                target.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, target)
            elif path.is_dir():
                shutil.copytree(path, target if len(paths) == 1 else target / path.name)
        for file in target.rglob("*"):
            if file.is_file():
                file.chmod(0o644)

    def download_artifact(self, inputs, scope, _):
        place = scope["folder"] / inputs.get("path", ".")
        if "name" in inputs:
            shutil.copytree(self.artifacts / inputs["name"], place, dirs_exist_ok=True)
        for folder in self.artifacts.iterdir():
            if fnmatch.fnmatch(folder.name, inputs.get("pattern", "")):
                shutil.copytree(folder, place / folder.name)

    def text(self, text, scope):
        """The text with its expressions filled in."""
        return re.sub(r"\$\{\{(.*?)\}\}", lambda found: str(self.value(found[1], scope)), str(text))

    def value(self, expression, scope):
        """The value of an expression of names, texts in quotes, and the operators of `WORD`."""
        words = {"&&": " and ", "||": " or ", "!": " not ", "cancelled()": "False"}

        def translated(found):
            word = found[0]
            if word.startswith("hashFiles"):
                return repr("hash" if glob.glob(word[11:-2], root_dir=scope["folder"]) else "")
            return words.get(word) or (word if word[0] in "'!=" else repr(self.named(word, scope)))

        return eval(WORD.sub(translated, expression.strip()))  # pylint: disable=eval-used

    @staticmethod
    def named(name, scope):
        value = scope
        for part in name.split("."):
            value = value[part]
        return value
