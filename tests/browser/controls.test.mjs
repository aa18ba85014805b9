// Every key and every button.
import test from 'node:test';
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { near, open, press, settled, view } from './viewer.mjs';

const time = (page) => view(page, 'v.time');
const button = (page, action) => page.locator(`[data-do="${action}"]`).first();

test('keys move in time', async () => {
  const page = await open('short', { at: '#t=20' });
  near(await time(page), 20, 1e-9);
  for (const [key, to] of [['ArrowRight', 21], ['ArrowLeft', 20], ['Shift+ArrowRight', 30], ['Shift+ArrowLeft', 20], ['PageUp', 30],
    ['PageDown', 20], ['Home', 0], ['ArrowLeft', 0]]) {
    await press(page, key);
    near(await time(page), to, 1e-9, key);
  }
  await press(page, 'End');
  near(await time(page), await view(page, 'v.scene.seconds'), 1e-9);
  await press(page, 'ArrowRight');
  near(await time(page), await view(page, 'v.scene.seconds'), 1e-9);
  await page.evaluate(() => fulbitoViewer.seek(20));
  const frame = await view(page, 'v.scene.tickOf[v.scene.rowAt(20) + 1] / v.scene.rate');
  await press(page, '.');
  near(await time(page), frame, 1e-9);
  await press(page, ',');
  assert.ok((await time(page)) < frame);
  await page.quiet();
});

test('keys play, pause and set the speed', async () => {
  const page = await open('short', { at: '#t=5' });
  for (const key of [' ', 'k', 'K']) {
    await press(page, key);
    assert.equal(await view(page, 'v.playing'), true, key);
    assert.equal(await page.getAttribute('#play', 'aria-label'), 'Pause');
    await page.waitForFunction((t) => fulbitoViewer.time > t, await time(page));
    await press(page, key);
    assert.equal(await view(page, 'v.playing'), false, key);
  }
  for (const speed of ['2×', '4×', '8×', '16×', '16×']) {
    await press(page, '+');
    assert.equal(await page.textContent('#speed'), speed);
  }
  for (const speed of ['8×', '4×', '2×', '1×', '½×', '¼×', '¼×']) {
    await press(page, '-');
    assert.equal(await page.textContent('#speed'), speed);
  }
  await page.quiet();
});

test('playing stops at the end and begins again from the start', async () => {
  const page = await open('short');
  await page.evaluate(() => fulbitoViewer.seek(fulbitoViewer.scene.seconds - 0.1));
  await press(page, ' ');
  await page.waitForFunction(() => !fulbitoViewer.playing);
  near(await time(page), await view(page, 'v.scene.seconds'), 1e-9);
  await press(page, ' ');
  assert.ok((await time(page)) < 2);
  await page.quiet();
});

test('keys switch what is shown, and the picture changes', async () => {
  // In the first play of both matches, where all are moving: in a jam there is no velocity to show.
  const page = await open('ghost', { at: '#t=4' });
  const picture = () => page.evaluate(() => fulbitoViewer.canvas.toDataURL());
  for (const [key, action, before] of [['t', 'trails', 'true'], ['v', 'vectors', 'false'], ['i', 'ids', 'true'], ['g', 'ghost', 'true'],
    ['f', 'flip', 'false'], ['h', 'heat', 'false']]) {
    const first = await picture();
    assert.equal(await button(page, action).getAttribute('aria-pressed'), before, action);
    await press(page, key);
    assert.equal(await button(page, action).getAttribute('aria-pressed'), String(before !== 'true'), action);
    assert.notEqual(await picture(), first, action);
  }
  await press(page, 'h');
  assert.equal(await page.textContent('#heatkind'), 'blue');
  await press(page, 'h');
  assert.equal(await page.textContent('#heatkind'), 'yellow');
  await press(page, 'h');
  assert.equal(await page.textContent('#heatkind'), 'map');
  await page.quiet();
});

test('overlays: drawings are shown, can be hidden, and reach the robots\' cards', async () => {
  const page = await open('drawings', { at: '#t=5' });
  const picture = () => page.evaluate(() => fulbitoViewer.canvas.toDataURL());
  const drawn = await picture();
  await press(page, 'o');
  assert.equal(await button(page, 'overlays').getAttribute('aria-pressed'), 'false');
  assert.notEqual(await picture(), drawn);
  assert.match(await page.textContent('.card >> nth=0'), /“at 300”/);
  assert.match(await page.textContent('.card >> nth=3'), /not on the field/);
  await page.quiet();
});

test('theme, help and full screen', async () => {
  const page = await open('short');
  assert.equal(await page.getAttribute('html', 'data-theme'), 'light');
  await press(page, 'd');
  assert.equal(await page.getAttribute('html', 'data-theme'), 'dark');
  await press(page, '?');
  assert.ok(await page.isVisible('#help'));
  for (const key of ['Space', 'Home', 'T', 'X']) assert.ok((await page.textContent('#help dl')).includes(key));
  await press(page, 'Escape');
  assert.ok(!(await page.isVisible('#help')));
  await press(page, 'x');
  await page.waitForFunction(() => document.fullscreenElement || document.querySelector('#toast').textContent);
  await page.quiet();
});

test('a link leads back to its moment', async () => {
  const page = await open('short', { permissions: ['clipboard-read', 'clipboard-write'] });
  await page.evaluate(() => fulbitoViewer.seek(23.456));
  await press(page, 'c');
  await page.waitForFunction(() => document.querySelector('#toast').textContent === 'Link copied');
  assert.ok(page.url().endsWith('#t=23.46'));
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), page.url());
  await page.evaluate(() => (location.hash = '#t=7.5'));
  await page.waitForFunction(() => fulbitoViewer.time === 7.5);
  await page.evaluate(() => (location.hash = '#t=nonsense'));
  await settled(page);
  near(await time(page), 7.5, 1e-9);
  await page.quiet();
  const again = await open('short', { at: '#t=23.46' });
  near(await time(again), 23.46, 1e-9);
  assert.equal(await view(again, 'v.playing'), false);
  await again.quiet();
});

test('a picture is saved', async () => {
  const page = await open('short', { at: '#t=12' });
  const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press('s')]);
  assert.equal(download.suggestedFilename(), 'fulbito-libero-classic-12.0s.png');
  const bytes = readFileSync(await download.path());
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  assert.equal(bytes.readUInt32BE(16), 1600);
  assert.ok(bytes.length > 20000);
  await page.quiet();
});

test('every button does what its key does', async () => {
  const page = await open('short', { at: '#t=20' });
  for (const [action, to] of [['end', await view(page, 'v.scene.seconds')], ['start', 0]]) {
    await button(page, action).click();
    near(await time(page), to, 1e-9, action);
  }
  await button(page, 'nextEvent').click();
  const event = await time(page);
  assert.ok(event > 0);
  await button(page, 'frameForward').click();
  assert.ok((await time(page)) > event);
  await button(page, 'frameBack').click();
  await button(page, 'previousEvent').click();
  assert.ok((await time(page)) < event + 0.1);
  await button(page, 'faster').click();
  assert.equal(await page.textContent('#speed'), '2×');
  await button(page, 'slower').click();
  await button(page, 'toggle').click();
  assert.equal(await view(page, 'v.playing'), true);
  await button(page, 'toggle').click();
  for (const action of ['trails', 'vectors', 'ids', 'heat', 'flip', 'theme', 'goalsOnly']) {
    const was = await button(page, action).getAttribute('aria-pressed');
    await button(page, action).click();
    assert.notEqual(await button(page, action).getAttribute('aria-pressed'), was, action);
  }
  await page.locator('#tools [data-do="help"]').click();
  assert.ok(await page.isVisible('#help'));
  await page.locator('#help [data-do="help"]').click();
  assert.ok(!(await page.isVisible('#help')));
  await Promise.all([page.waitForEvent('download'), button(page, 'save').click()]);
  await button(page, 'link').click();
  await button(page, 'screen').click();
  const names = await page.$$eval('[data-do]', (all) => all.map((element) => element.dataset.do));
  const tried = ['end', 'start', 'nextEvent', 'previousEvent', 'frameForward', 'frameBack', 'faster', 'slower', 'toggle', 'trails',
    'vectors', 'ids', 'heat', 'flip', 'theme', 'goalsOnly', 'help', 'save', 'link', 'screen'];
  const elsewhere = ['overlays', 'ghost', 'split', 'previousScene', 'nextScene', 'part'];
  assert.deepEqual([...new Set(names)].sort(), [...tried, ...elsewhere].sort());
  await page.quiet();
});

test('the slider is time, and a robot is chosen by its card or on the field', async () => {
  const page = await open('short', { at: '#t=10' });
  await page.locator('#seek').fill('25.5');
  near(await time(page), 25.5, 1e-9);
  await settled(page);
  assert.match(await page.getAttribute('#seek', 'aria-valuetext'), /^25 s, \d+–\d+$/);
  await page.locator('#seek').press('ArrowRight');
  near(await time(page), 26.5, 1e-9);
  await page.locator('.card').nth(2).click();
  assert.equal(await view(page, 'v.selected'), 2);
  await press(page, 'Escape');
  assert.equal(await view(page, 'v.selected'), -1);
  const [x, y] = await page.evaluate(() => {
    const v = fulbitoViewer, box = v.canvas.getBoundingClientRect(), ratio = v.canvas.width / box.width;
    return [box.left + v.view.x(v.moment.x[4]) / ratio, box.top + v.view.y(v.moment.y[4]) / ratio];
  });
  await page.mouse.click(x, y);
  assert.equal(await view(page, 'v.selected'), 4);
  await page.quiet();
});

test('keys are left alone in a form field and with a modifier', async () => {
  const page = await open('races');
  const before = await page.getAttribute('html', 'data-theme');
  await page.focus('#scene');
  await press(page, 'd');
  await page.locator('body').press('Control+d');
  assert.equal(await page.getAttribute('html', 'data-theme'), before);
  await page.quiet();
});

test('races: layouts, side by side or over each other, chosen runs', async () => {
  const page = await open('races');
  assert.equal(await page.locator('#scene option').count(), 4);
  assert.equal(await page.locator('#runs tbody tr').count(), await view(page, 'v.scene.runs.length'));
  for (const [key, index] of [[']', 1], ['[', 0], ['[', 3], [']', 0]]) {
    await press(page, key);
    assert.equal(await view(page, 'v.index'), index, key);
    assert.equal(await page.inputValue('#scene'), String(index));
  }
  await button(page, 'nextScene').click();
  assert.equal(await view(page, 'v.index'), 1);
  await button(page, 'previousScene').click();
  await page.selectOption('#scene', '2');
  assert.equal(await view(page, 'v.index'), 2);
  const picture = () => page.evaluate(() => fulbitoViewer.canvas.toDataURL());
  await press(page, 'End');
  const split = await picture();
  await press(page, 'm');
  assert.equal(await button(page, 'split').getAttribute('aria-pressed'), 'false');
  assert.notEqual(await picture(), split);
  await page.locator('#runs tbody button').first().click();
  assert.ok((await view(page, 'v.selected')) >= 0);
  const states = await page.$$eval('#runs tbody tr td:nth-child(3)', (cells) => cells.map((cell) => cell.textContent));
  assert.ok(states.some((state) => /^\d+\.\d\d s$/.test(state)) && !states.includes('driving'), states.join());
  await press(page, 'c');
  assert.ok(page.url().endsWith('&scene=2'));
  await page.quiet();
});

test('ghosts: where two replays part', async () => {
  const page = await open('ghost');
  assert.match(await page.textContent('#difference p'), /First difference at/);
  await button(page, 'end').click();
  await button(page, 'part').click();
  near(await time(page), await view(page, 'v.parting'), 1e-9);
  await page.quiet();
  const same = await open('same');
  assert.match(await same.textContent('#difference p'), /are identical/);
  await same.quiet();
});

test('goals only, and goals are announced while playing', async () => {
  const page = await open('long');
  await button(page, 'goalsOnly').click();
  assert.equal(await page.locator('#events tbody tr:visible').count(), await page.locator('#events tbody tr.goal').count());
  const goal = await view(page, 'v.scene.marks.find((event) => event.goal).seconds');
  await page.evaluate((t) => fulbitoViewer.seek(t - 0.2), goal);
  await press(page, 'k');
  await page.waitForFunction(() => /^Goal for (blue|yellow), \d to \d$/.test(document.querySelector('#live').textContent));
  await page.quiet();
});
