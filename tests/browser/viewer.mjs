// Opens pages of the viewer and watches what they ask for and complain about.
import { readFileSync } from 'node:fs';
import { after, before } from 'node:test';
import assert from 'node:assert/strict';
import { chromium } from 'playwright-core';

export const pages = process.env.FULBITO_PAGES;
export const shots = process.env.FULBITO_SHOTS;
const flags = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync'];

let browser;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env.FULBITO_CHROMIUM, args: flags });
});
after(() => browser.close());

export const fileOf = (name) => `${pages}/${name}.html`;
export const textOf = (name) => readFileSync(fileOf(name), 'utf8');

/** A page of its own; `quiet` closes it and demands that it asked for nothing and complained of nothing. */
export async function open(name, { at = '#t=0', ready = true, ...context } = {}) {
  const own = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true, ...context });
  const page = await own.newPage();
  const requests = [], complaints = [];
  page.on('request', (request) => requests.push(request.url()));
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto(`file://${name.startsWith('/') ? name : fileOf(name)}${at}`);
  if (ready) await page.waitForSelector('body[data-ready]', { timeout: 10000 });
  page.quiet = async () => {
    assert.deepEqual(requests.filter((url) => !/^(file|data|blob):/.test(url)), []);
    assert.equal(requests.filter((url) => url.startsWith('file:')).length, 1);
    assert.deepEqual(complaints, []);
    await own.close();
  };
  return page;
}

export const view = (page, expression) => page.evaluate(`(() => { const v = fulbitoViewer; return ${expression}; })()`);
/** After the next frame, so that all texts are those of the moment. */
export const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
export const press = async (page, key) => {
  await page.keyboard.press(key);
  await settled(page);
};
export const near = (actual, expected, tolerance, what = '') =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what} ${actual} is not ${expected} +- ${tolerance}`);
