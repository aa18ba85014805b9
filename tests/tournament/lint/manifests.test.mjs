// Checks that the Kubernetes manifests have only fields of the API with allowed values. Types come from the API's published
// schema, and from TypeScript for unknown fields; rules between fields come from its documentation.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Job } from "kubernetes-models/batch/v1";
import { PersistentVolumeClaim } from "kubernetes-models/v1";
import ts from "typescript";
import { parseAllDocuments } from "yaml";

const folder = new URL("../../../examples/tournaments/", import.meta.url);
const kinds = { Job: ["batch/v1", Job], PersistentVolumeClaim: ["v1", PersistentVolumeClaim] };
const textOf = (name) => readFileSync(new URL(name, folder), "utf8");
const documentsOf = (text) => parseAllDocuments(text, { strict: true }).map((document) => {
  assert.deepEqual(document.errors, []);
  return document.toJS();
});

/** Errors of the schema about values. */
function wrongValues(manifest) {
  const [version, Kind] = kinds[manifest.kind] ?? assert.fail(`unknown kind ${manifest.kind}`);
  if (manifest.apiVersion !== version) return [`apiVersion ${manifest.apiVersion}`];
  try {
    new Kind(manifest).validate();
    return [];
  } catch (error) {
    return [error.message];
  }
}

/** Errors of the compiler about unknown fields and types. */
function wrongFields(manifests) {
  const lines = manifests.map((manifest, i) => {
    const [version] = kinds[manifest.kind];
    return `import type { I${manifest.kind} as T${i} } from "kubernetes-models/${version}";
const m${i}: Omit<T${i}, never> = ${JSON.stringify(manifest)};`;
  });
  const file = new URL("manifests.ts", import.meta.url).pathname;
  const options = { module: ts.ModuleKind.NodeNext, moduleResolution: ts.ModuleResolutionKind.NodeNext, noEmit: true,
    skipLibCheck: true, strict: true, target: ts.ScriptTarget.ES2022, types: [] };
  const host = ts.createCompilerHost(options);
  const { fileExists, getSourceFile, readFile } = host;
  host.fileExists = (name) => name === file || fileExists.call(host, name);
  host.readFile = (name) => name === file ? lines.join("\n") : readFile.call(host, name);
  host.getSourceFile = (name, ...rest) =>
    name === file ? ts.createSourceFile(name, lines.join("\n"), options.target) : getSourceFile.call(host, name, ...rest);
  return ts.getPreEmitDiagnostics(ts.createProgram([file], options, host))
    .map((found) => ts.flattenDiagnosticMessageText(found.messageText, " "));
}

/** Violated rules between the fields of a job. */
function brokenRules({ kind, spec }) {
  if (kind !== "Job") return [];
  const { containers, restartPolicy, volumes } = spec.template.spec;
  const names = containers.map((container) => container.name);
  const rules = spec.podFailurePolicy?.rules ?? [];
  const mounts = containers.flatMap((container) => container.volumeMounts.map((mount) => mount.name));
  const shards = containers.flatMap((c) => c.args).map((word) => /^auto\/(\d+)$/.exec(word)?.[1]).filter(Boolean);
  const known = {
    "podFailurePolicy needs restartPolicy Never": !rules.length || restartPolicy === "Never",
    "podFailurePolicy needs podReplacementPolicy Failed": !rules.length || (spec.podReplacementPolicy ?? "Failed") === "Failed",
    "a rule has either exit codes or conditions": rules.every((rule) => !rule.onExitCodes !== !rule.onPodConditions),
    "a rule names a container": rules.every((r) => !r.onExitCodes?.containerName || names.includes(r.onExitCodes.containerName)),
    "exit codes are sorted, without 0 for In": rules.every(({ onExitCodes: on }) => !on ||
      (on.values.join() === [...new Set(on.values)].sort((a, b) => a - b).join() && !(on.operator === "In" && on.values.includes(0)))),
    "backoffLimitPerIndex needs an indexed job": spec.backoffLimitPerIndex === undefined || spec.completionMode === "Indexed",
    "maxFailedIndexes needs backoffLimitPerIndex": spec.maxFailedIndexes === undefined || spec.backoffLimitPerIndex !== undefined,
    "action FailIndex needs backoffLimitPerIndex":
      spec.backoffLimitPerIndex !== undefined || rules.every((rule) => rule.action !== "FailIndex"),
    "mounts have volumes": mounts.every((name) => volumes.some((volume) => volume.name === name)),
    "the shards are the completions": shards.every((count) => Number(count) === spec.completions),
    "7 ends the job": rules.some((rule) => rule.action === "FailJob" && rule.onExitCodes?.values.includes(7)),
  };
  return Object.keys(known).filter((rule) => !known[rule]);
}

const complaints = (text) => {
  const manifests = documentsOf(text);
  return [...manifests.flatMap(wrongValues), ...manifests.flatMap(brokenRules), ...wrongFields(manifests)];
};

for (const name of ["kubernetes.yaml", "kubernetes-merge.yaml"]) {
  test(`${name} is valid`, () => assert.deepEqual(complaints(textOf(name)), []));
}

const faults = {
  "an unknown field": ["backoffLimitPerIndex", "backofLimitPerIndex"],
  "an unknown field of a pod": ["automountServiceAccountToken", "automountServiceAcountToken"],
  "a value that is none": ["completionMode: Indexed", "completionMode: Index"],
  "a text for a number": ["values: [2, 3, 7]", 'values: ["7"]'],
  "a code that is tried again": ["values: [2, 3, 7]", "values: [2, 3]"],
  "another number of shards": ["--shard, auto/3", "--shard, auto/4"],
  "a container that does not exist": ["containerName: shard", "containerName: shards"],
  "a pod that starts again": ["restartPolicy: Never", "restartPolicy: OnFailure"],
  "a missing value": ["claimName: fulbito-results", "readOnly: true"],
};
for (const [what, [right, wrong]] of Object.entries(faults)) {
  test(`the check finds ${what}`, () => {
    const text = textOf("kubernetes.yaml");
    assert.ok(text.includes(right));
    assert.notDeepEqual(complaints(text.replace(right, wrong)), []);
  });
}
