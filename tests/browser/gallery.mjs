// Pictures of pages for the documentation: node gallery.mjs PAGE.html OUT.png WIDTH HEIGHT light|dark SECONDS [KEYS]
import { chromium } from 'playwright-core';

const [page, out, width, height, colorScheme, seconds, keys = ''] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: process.env.FULBITO_CHROMIUM || '/usr/bin/chromium-headless-shell',
  args: ['--headless', '--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-background-networking', '--disable-sync'] });
const tab = await browser.newPage({ viewport: { width: Number(width), height: Number(height) }, colorScheme });
await tab.goto(`file://${page}#t=${seconds}`);
await tab.waitForSelector('body[data-ready]');
for (const key of keys) await tab.keyboard.press(key);
await tab.waitForTimeout(300);
await tab.screenshot({ path: out });
await browser.close();
