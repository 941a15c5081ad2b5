// SPDX-License-Identifier: MIT
// node turns.mjs MODULES CHROMIUM PAGE PICTURE: opens a page of `lumi view` without a window and ends with 0 once its
// picture has turned by itself. MODULES: a folder whose node_modules has puppeteer-core. PICTURE: the screenshot.
import {createRequire} from 'node:module';
import path from 'node:path';

const [modules, chromium, page, picture] = process.argv.slice(2);
const puppeteer = createRequire(path.resolve(modules, 'x.js'))('puppeteer-core');
const browser = await puppeteer.launch({executablePath: chromium, args: ['--no-sandbox']});
try {
  const tab = await browser.newPage();
  await tab.goto('file://' + path.resolve(page));
  const frame = () => tab.evaluate(() => document.getElementById('picture').toDataURL());
  await tab.waitForFunction(() => document.getElementById('status').textContent !== '');
  const first = await frame();
  await tab.waitForFunction(before => document.getElementById('picture').toDataURL() !== before, {timeout: 5000}, first);
  await tab.screenshot({path: picture});
} finally {
  await browser.close();
}
