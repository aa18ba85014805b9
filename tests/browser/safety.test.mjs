// Names from anywhere, damaged files, and nothing asked from the network.
import test from 'node:test';
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { writeFileSync } from 'node:fs';
import { open, pages, press, textOf, view } from './viewer.mjs';

test('hostile names are text', async () => {
  const page = await open('hostile', { at: '#t=5' });
  for (const key of ['n', 'n', 'p', 'h', 'v', 't', 'f', 'End', 'd']) await press(page, key);
  assert.equal(await page.evaluate(() => window.broken), undefined);
  assert.equal(await page.locator('img').count(), 0);
  assert.equal(await page.locator('#events b').count(), 0);
  const names = await page.$$eval('#board .team', (all) => all.map((team) => team.title));
  assert.ok(names[0].startsWith('</script><script>window.broken=1</script>') && names[0].endsWith('WWW'));
  assert.ok(names[1].includes('الفريق'));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth), 0);
  await Promise.all([page.waitForEvent('download'), page.keyboard.press('s')]);
  await page.quiet();
});

test('no text of the page ends its element', () => {
  const html = textOf('hostile');
  const meta = html.slice(html.indexOf('id="meta">') + 10);
  const json = meta.slice(0, meta.indexOf('</script>'));
  assert.doesNotMatch(json, /[<>&\u0080-\uffff]/);
  assert.equal(JSON.parse(json).scenes[0].teams[0].slice(0, 9), '</script>');
});

test('scripts that someone put into the file do not run', async () => {
  const file = `${pages}/injected.html`;
  writeFileSync(file, textOf('short').replace('<body>', '<body onload="window.broken=1"><script>window.broken=1</script><img src="http://127.0.0.1:9/x.png">'));
  const page = await open(file, { ready: true });
  assert.equal(await page.evaluate(() => window.broken), undefined);
});

test('a file cut anywhere says so', async () => {
  const html = textOf('short');
  const starts = ['<main', '<script>', 'id="viewer"', 'id="meta"', 'id="data"'].map((mark) => html.indexOf(mark));
  const cuts = [...starts.map((at) => at + 400), html.indexOf('id="data"') + 12, html.length - 1000, html.length - 40];
  for (const cut of cuts) {
    const file = `${pages}/cut.html`;
    writeFileSync(file, html.slice(0, cut));
    const page = await open(file, { ready: false });
    if (cut > html.indexOf('id="viewer"')) await page.waitForSelector('body[data-failed]', { timeout: 5000 });
    const text = await page.textContent('#message');
    assert.match(text, /incomplete/, `cut at ${cut}`);
    assert.ok(await page.isVisible('#message'));
    await page.context().close();
  }
});

test('damage in the data or the description is found', async () => {
  const html = textOf('short');
  const data = html.indexOf('id="data">') + 10, meta = html.indexOf('id="meta">') + 10;
  const swapped = (at, to) => html.slice(0, at) + (html[at] === to ? 'B' : to) + html.slice(at + 1);
  const damaged = [swapped(data + 300, 'A'), swapped(data + 9001, 'A'), swapped(data + 20, '!'), swapped(meta + 5, '}'),
    html.replace(/"raw":\d+/, '"raw":99999999999'), html.replace(/"rows":\d+/, '"rows":4000000000'), html.replace(/"rows":\d+/, '"rows":7'),
    html.replace('"format":1', '"format":2'), html.replace(/"scenes":\[/, '"scenes":[],"x":[')];
  for (const [i, text] of damaged.entries()) {
    const file = `${pages}/damaged.html`;
    writeFileSync(file, text);
    const page = await open(file, { ready: false });
    await page.waitForSelector('body[data-failed], body[data-ready]', { timeout: 5000 });
    assert.equal(await page.getAttribute('body', 'data-failed'), 'true', `damage ${i}`);
    assert.match(await page.textContent('#message'), /\w{3} .*\w{3}/, `damage ${i}`);
    await page.context().close();
  }
});

test('a browser that cannot inflate says so and shows what was recorded', async () => {
  const file = `${pages}/old.html`;
  writeFileSync(file, textOf('short'));
  const page = await open('races');
  await page.addInitScript(() => delete window.DecompressionStream);
  await page.goto(`file://${file}`);
  await page.waitForSelector('pre');
  assert.match(await page.textContent('#message'), /too old/);
  assert.match(await page.textContent('pre'), /"teams":\["libero","classic"\]/);
  await page.context().close();
});

test('opened from disk it plays and asks for nothing', async () => {
  const page = await open('long', { at: '' });
  await page.waitForFunction(() => fulbitoViewer.time > 0.3);
  assert.equal(await view(page, 'v.playing'), true);
  await page.quiet();
});

test('opened from a server it asks for nothing but itself', async () => {
  const asked = [];
  const server = createServer((request, response) => {
    asked.push(request.url);
    response.setHeader('content-type', 'text/html');
    response.end(textOf('short'));
  }).listen(0, '127.0.0.1');
  await new Promise((done) => server.once('listening', done));
  const page = await open('races');
  await page.goto(`http://127.0.0.1:${server.address().port}/match#t=3`);
  await page.waitForSelector('body[data-ready]');
  assert.equal(await view(page, 'v.time'), 3);
  assert.deepEqual(asked, ['/match']);
  await page.context().close();
  server.close();
});
