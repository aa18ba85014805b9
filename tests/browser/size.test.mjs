// What a page weighs, and how long it takes; times are printed, not judged.
import test from 'node:test';
import assert from 'node:assert/strict';
import { open, press, textOf } from './viewer.mjs';

test('the viewer is at most 60 kB, a match of ten minutes at most 450 kB', (t) => {
  const html = textOf('long');
  const viewer = Buffer.byteLength(html.slice(0, html.indexOf('<script type="application/json"')));
  t.diagnostic(`viewer ${viewer} bytes, match of ten minutes ${Buffer.byteLength(html)} bytes`);
  assert.ok(viewer <= 60000, `${viewer} bytes`);
  assert.ok(Buffer.byteLength(html) <= 450000);
});

test('times', async (t) => {
  for (const name of ['long', 'races']) {
    const page = await open(name, { at: '#t=60' });
    const ready = await page.getAttribute('body', 'data-ready');
    for (const key of ['v', 'h']) await press(page, key);
    const frames = await page.evaluate(async () => {
      const v = fulbitoViewer;
      v.select(1);
      v.seek(1);
      v.frames.length = 0;
      v.setPlaying(true);
      await new Promise((done) => setTimeout(done, 2500));
      v.setPlaying(false);
      return v.frames.sort((a, b) => a - b);
    });
    const middle = frames[frames.length >> 1], late = frames[Math.floor(frames.length * 0.95)];
    t.diagnostic(`${name}: ready after ${ready} ms; a frame with everything on takes ${middle.toFixed(2)} ms (95 %: ${late.toFixed(2)} ms, ${frames.length} frames)`);
    assert.ok(frames.length > 10);
    await page.quiet();
  }
});
