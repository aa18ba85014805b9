// Everyone can use it: audits, sizes of screens, keyboard, motion, print.
import test from 'node:test';
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import { open, press, settled, shots, view } from './viewer.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

async function violations(page) {
  await page.evaluate(axe);
  return page.evaluate(async () => {
    const { violations } = await window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] });
    return violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target).join(' | ')}`);
  });
}

for (const name of ['long', 'ghost', 'races', 'trial', 'drawings', 'hostile']) {
  for (const colorScheme of ['light', 'dark']) {
    test(`${name} in ${colorScheme}: no accessibility violation`, async () => {
      const page = await open(name, { at: '#t=3', colorScheme });
      assert.deepEqual(await violations(page), []);
      await press(page, '?');
      assert.deepEqual(await violations(page), []);
      await page.quiet();
    });
  }
}

for (const width of [320, 360, 540, 900, 1024, 1920, 3840]) {
  test(`${width} px: nothing is cut off and buttons are large enough`, async () => {
    for (const name of ['long', 'ghost', 'races', 'hostile']) {
      const height = Math.max(640, Math.round(width * 0.5625));
      const page = await open(name, { at: '#t=2.1', viewport: { width, height }, colorScheme: width % 200 ? 'light' : 'dark' });
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, name);
      const small = await page.$$eval('button, select, input', (all) => all.filter((e) => e.offsetParent && (e.offsetWidth < 44 ||
        e.offsetHeight < 43.5)).map((e) => `${e.dataset.do || e.textContent} ${e.offsetWidth}x${e.offsetHeight}`));
      assert.deepEqual(small, [], name);
      const field = await page.locator('#field').boundingBox();
      assert.ok(field.width >= Math.min(width * 0.6, 500) && field.height >= 140, `${name} ${field.width}x${field.height}`);
      if (width >= 1024) {
        const tools = await page.locator('#tools').boundingBox();
        assert.ok(tools.y + tools.height <= height, `${name}: the buttons are below the window's edge`);
      }
      await page.screenshot({ path: `${shots}/${name}-${width}.png` });
      await page.quiet();
    }
  });
}

test('the canvas has the screen\'s points', async () => {
  const page = await open('short', { deviceScaleFactor: 2 });
  const [points, size] = await page.evaluate(() => [fulbitoViewer.canvas.width, fulbitoViewer.canvas.getBoundingClientRect().width]);
  assert.ok(Math.abs(points - 2 * size) <= 1);
  await page.quiet();
});

test('the keyboard reaches everything and is never trapped', async () => {
  const page = await open('short');
  const reached = new Set();
  for (let i = 0; i < 200; ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => {
      const e = document.activeElement;
      if (!e || e === document.body) return null;
      const style = getComputedStyle(e);
      return [e.dataset.do || e.id || e.className || e.textContent, style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2];
    });
    if (!at) break;
    assert.ok(at[1], `no visible focus on ${at[0]}`);
    reached.add(at[0]);
  }
  for (const name of ['seek', 'start', 'toggle', 'trails', 'help', 'save', 'goalsOnly', 'card']) assert.ok(reached.has(name), name);
  await page.focus('[data-do="vectors"]');
  await press(page, ' ');
  assert.equal(await page.getAttribute('[data-do="vectors"]', 'aria-pressed'), 'true');
  assert.equal(await view(page, 'v.playing'), false);
  await page.focus('#tools [data-do="help"]');
  await press(page, 'Enter');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'help');
  await press(page, 'Escape');
  assert.equal(await page.evaluate(() => document.activeElement.dataset.do), 'help');
  await page.quiet();
});

test('reduced motion starts paused', async () => {
  const page = await open('short', { at: '', reducedMotion: 'reduce' });
  assert.equal(await view(page, 'v.playing'), false);
  assert.equal(await view(page, 'v.time'), 0);
  await page.quiet();
});

test('the events are a table with headers, the field has a name, goals have a polite region', async () => {
  const page = await open('long');
  assert.equal(await page.locator('#events table caption').count(), 1);
  assert.equal(await page.locator('#events th[scope="col"]').count(), 3);
  assert.equal(await page.getAttribute('#field', 'role'), 'img');
  assert.equal(await page.getAttribute('#live', 'aria-live'), 'polite');
  await page.quiet();
});

test('the panels take the room beside the field: events need few lines, and the field stays as high as it can be', async () => {
  for (const [width, height] of [[1280, 800], [1366, 768], [1600, 900]]) {
    const page = await open('calls', { viewport: { width, height } });
    const lines = await page.$$eval('#events tbody tr', (rows) => rows.map((row) => {
      const text = document.createRange();
      text.selectNodeContents(row.children[1]);
      return new Set([...text.getClientRects()].map(({ top }) => Math.round(top))).size;
    }));
    assert.ok(lines.length > 30);
    assert.ok(Math.max(...lines) <= 4, `${Math.max(...lines)} lines at ${width} px`);
    const [high, most] = await page.$eval('#stage', (stage) => [stage.clientHeight, parseFloat(getComputedStyle(stage).maxHeight)]);
    assert.ok(high >= most - 1, `the field is ${high} px high, ${most} have room`);
    await page.quiet();
  }
});

test('print: light, all events, no buttons', async () => {
  const page = await open('short', { colorScheme: 'dark' });
  await page.emulateMedia({ media: 'print' });
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  await settled(page);
  assert.equal(await page.getAttribute('html', 'data-theme'), 'light');
  assert.ok(!(await page.isVisible('#transport')) && !(await page.isVisible('#tools')));
  const cut = await page.$eval('#events .scroll', (box) => box.scrollHeight - box.clientHeight);
  assert.ok(cut <= 1, `${cut} px of the events are cut off`);
  await page.screenshot({ path: `${shots}/print.png` });
  await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  assert.equal(await page.getAttribute('html', 'data-theme'), 'dark');
  await page.quiet();
});

test('the same moment is the same picture', async () => {
  const pictures = [];
  for (let i = 0; i < 2; ++i) {
    const page = await open('short', { at: '#t=20.57' });
    await settled(page);
    pictures.push(await page.evaluate(() => fulbitoViewer.canvas.toDataURL()));
    await page.quiet();
  }
  assert.equal(pictures[0], pictures[1]);
});
