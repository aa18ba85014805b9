// The viewer shows what the C++ reader reads.
import test from 'node:test';
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { near, open, pages, settled, view } from './viewer.mjs';

const kHalfPlace = 0.5e-3 / 2 + 1e-9, kHalfHeading = 5e-3 / 2 + 1e-9;

for (const name of ['long', 'short', 'trial']) {
  test(`${name}: positions, clock and score at random times`, async () => {
    const page = await open(name);
    const lines = readFileSync(`${pages}/${name}.positions`, 'utf8').trim().split('\n').map((line) => JSON.parse(line));
    assert.equal(lines.length, 50);
    for (const wanted of lines) {
      const shown = await page.evaluate((seconds) => {
        const { scene } = fulbitoViewer;
        const m = scene.at(seconds, fulbitoViewer.moment);
        const turned = scene.bodies.map((body) => !!body.size);
        return { turned, clock: scene.clock(m), playing: scene.playing(m), period: scene.plays[m.play].period, score: scene.score(m.tick),
          bodies: [...m.x].map((x, i) => (m.present[i] ? [x, m.y[i], m.heading[i]] : null)) };
      }, wanted.seconds);
      assert.deepEqual(shown.score, wanted.score, `score at ${wanted.seconds}`);
      assert.equal(shown.period, wanted.period);
      assert.equal(shown.playing, wanted.playing, `playing at ${wanted.seconds}`);
      near(shown.clock, wanted.clock, 1e-6, `clock at ${wanted.seconds}:`);
      assert.equal(shown.bodies.length, wanted.bodies.length);
      wanted.bodies.forEach((body, i) => {
        const what = `body ${i} at ${wanted.seconds}:`;
        if (!body) return assert.equal(shown.bodies[i], null, what);
        near(shown.bodies[i][0], body[0], kHalfPlace, what);
        near(shown.bodies[i][1], body[1], kHalfPlace, what);
        const turn = shown.bodies[i][2] - body[2];
        if (shown.turned[i]) near(Math.atan2(Math.sin(turn), Math.cos(turn)), 0, kHalfHeading, what);
      });
    }
    await page.quiet();
  });
}

test('every event can be sought, by its button and by stepping', async () => {
  const page = await open('short');
  const times = await view(page, 'v.scene.marks.map((event) => event.seconds)');
  assert.ok(times.length > 5);
  const buttons = await page.locator('#events tbody button').all();
  assert.equal(buttons.length, times.length);
  for (const [i, button] of buttons.entries()) {
    await button.click();
    near(await view(page, 'v.time'), times[i], 1e-9);
  }
  await settled(page);
  await page.keyboard.press('Home');
  const later = [...new Set(times)].filter((time) => time > 1e-3);
  for (const time of later) {
    await page.keyboard.press('n');
    near(await view(page, 'v.time'), time, 1e-9, 'next:');
  }
  for (const time of later.slice(0, -1).reverse()) {
    await page.keyboard.press('p');
    near(await view(page, 'v.time'), time, 1e-9, 'previous:');
  }
  await page.quiet();
});

test('the score at the playhead is the one of the events', async () => {
  const page = await open('long');
  const goals = await view(page, "v.scene.marks.filter((event) => event.goal).map((event) => [event.seconds, event.team])");
  assert.ok(goals.length > 3);
  const score = [0, 0];
  for (const [seconds, team] of goals) {
    await page.evaluate((t) => fulbitoViewer.seek(t - 0.02), seconds);
    await settled(page);
    assert.equal(await page.textContent('#score'), score.join('–'));
    score[team] += 1;
    await page.evaluate((t) => fulbitoViewer.seek(t), seconds);
    await settled(page);
    assert.equal(await page.textContent('#score'), score.join('–'));
    assert.match(await page.textContent('#banner'), /^Goal for/);
  }
  assert.equal(await page.locator('#marks .mark').count(), goals.length);
  await page.quiet();
});

test('possession and thirds are those of the match summary', async () => {
  const { stats } = JSON.parse(readFileSync(`${pages}/long.json`, 'utf8'));
  const page = await open('long');
  const [held, third] = await view(page, '[v.share.held, v.share.third].map((sums) => sums.map((sum) => sum[v.scene.rows - 1]))');
  const shares = (sums) => sums.map((sum) => sum / sums.reduce((a, b) => a + b, 0));
  const { blue, yellow } = stats;
  [blue.possession_share, yellow.possession_share].forEach((share, i) => near(shares(held)[i], share, 0.01, 'possession:'));
  [blue.own_third_share, blue.middle_third_share, yellow.own_third_share].forEach((share, i) => near(shares(third)[i], share, 0.01, 'third:'));
  await page.quiet();
});

test('calls have the words and the colour that pictures give them', async () => {
  const page = await open('calls');
  const banners = readFileSync(`${pages}/calls.banners`, 'utf8').trim().split('\n').map((line) => JSON.parse(line));
  assert.ok(banners.length > 30);
  const rows = await page.locator('#events tbody tr:not(.restart)').all();
  assert.equal(rows.length, banners.length);
  for (const [i, banner] of banners.entries()) {
    await page.evaluate((t) => fulbitoViewer.seek(t + 0.5), banner.seconds);
    await settled(page);
    const team = banner.team === null ? null : String(banner.team);
    assert.equal(await page.getAttribute('#banner', 'data-team'), team, `${banner.title} ${banner.detail}`);
    assert.equal(await rows[i].getAttribute('data-team'), team, `${banner.title} ${banner.detail} in the list`);
    const shown = await page.textContent('#banner');
    if (shown.startsWith('Goal for')) continue;  // the page names the colour, the picture the team
    assert.ok(shown.startsWith(banner.title) && shown.endsWith(banner.detail), `${shown}: ${banner.title}, ${banner.detail}`);
  }
  const charged = banners.findIndex((banner) => banner.detail === 'keeper charged');
  assert.match(await rows[charged].textContent(), /against blue robot 1 · law 8 · pressed with 0\.12 N s \(limit 0\.02 N s\)/);
  await page.quiet();
});

test('clocks are cut as in pictures and summaries', async () => {
  const page = await open('short');
  const texts = await page.evaluate('[14.05, 14.0999, 59.99, 417.95, 163.05, 14 - 1e-9].map((t) => clockText(t))');
  assert.deepEqual(texts, ['0:14.0', '0:14.0', '0:59.9', '6:57.9', '2:43.0', '0:14.0']);
  await page.quiet();
});
