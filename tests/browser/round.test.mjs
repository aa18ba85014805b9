// A round robot has no size, but a heading. The page's own scripts read the page's data, without a browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import vm from 'node:vm';

const kScripts = new URL('../../replays/html/page/', import.meta.url);
const page = readFileSync(join(process.env.FULBITO_PAGES, 'round.html'), 'utf8');

const textOf = (id) => page.match(new RegExp(`<script[^>]*id="?${id}"?[^>]*>([^<]*)<`))[1];

function scripts(...names) {
  const context = vm.createContext({ document: { getElementById: (id) => ({ textContent: textOf(id) }) },
    atob, Blob, DecompressionStream, Uint8Array });
  vm.runInContext(names.map((name) => readFileSync(new URL(name, kScripts), 'utf8')).join('\n'), context);
  return (code) => vm.runInContext(code, context);
}

test('a page with round robots is whole, and its robots turn', async () => {
  const run = scripts('decode.js', 'transport.js', 'scene.js');
  const scene = await run(`(async () => {
    const meta = readMeta(), bytes = await readPayload(meta.payload);
    return new Scene(meta.scenes[0], bytes, meta.steps);
  })()`);
  for (const body of scene.bodies) {
    assert.equal(body.size, undefined);
    assert.equal(body.heading !== null, body.kind === 'robot');
  }
  const robot = scene.bodies[1], last = robot.heading.length - 1;
  assert.ok(Math.abs(robot.heading[last] - robot.heading[0] - 6) < 0.01);
});
