// SPDX-License-Identifier: MIT
// node element_test.mjs LUMI FIELD MODULES CHROMIUM PACKAGE [PICTURES]: the npm package of <lumi-view>, which npm.py wrote into
// PACKAGE, packed by npm and used by a page in a browser without a window. The rest: browser_test.mjs.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import {after, test} from 'node:test';
import zlib from 'node:zlib';

import {readPng} from './png.mjs';

const [lumi, field, modules, chromium, made, pictures] = process.argv.slice(2);
const puppeteer = createRequire(path.resolve(modules, 'x.js'))('puppeteer-core');
const MOST_BYTES = 40000;  // of the component, compressed

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'lumi-element-test-'));
const [packed] = JSON.parse(execFileSync('npm', ['pack', '--json', '--pack-destination', folder], {cwd: made}));
execFileSync('tar', ['-xzf', path.join(folder, packed.filename), '-C', folder]);
const PAGE = more => `<!DOCTYPE html><html lang="en"><meta charset="utf-8"><meta name="color-scheme" content="light dark">
<title>A page</title><link rel="icon" href="data:,"><meta http-equiv="Content-Security-Policy" content="default-src 'self';
script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; img-src data:">
<body style="font: 16px sans-serif"><p>An object of the page:</p>
<script>window.told = [];</script><lumi-view id="it" alt="Desk clock" style="width: 240px; height: 240px" ${more}></lumi-view>
<script>for (const type of ['load', 'error', 'turn']) it.addEventListener(type, e => told.push([type, e.detail]));</script>
<script type="module" src="/package/lumi-view.js"></script>`;

const server = http.createServer((request, response) => {
  const {pathname, searchParams} = new URL(request.url, 'http://x');
  const content = pathname === '/' ? PAGE(searchParams.get('with')) : pathname === '/field.lumi' ? fs.readFileSync(field)
    : pathname === '/package/lumi-view.js' ? fs.readFileSync(path.join(folder, pathname)) : null;
  response.writeHead(content ? 200 : 404, {'content-type': pathname.endsWith('.js') ? 'text/javascript' : 'text/html'});
  response.end(content ?? '');
});
await new Promise(done => server.listen(0, '127.0.0.1', done));
const browser = await puppeteer.launch({executablePath: chromium, args: ['--no-sandbox']});
after(async () => {
  await browser.close();
  server.close();
  fs.rmSync(folder, {recursive: true});
});

async function opened(attributes, {scheme = 'light', motion = false, last = 'load'} = {}) {
  const tab = await browser.newPage();
  tab.requests = [];
  tab.errors = [];
  tab.on('request', request => {
    if (!request.url().startsWith('data:')) tab.requests.push(new URL(request.url()).pathname);
  });
  tab.on('pageerror', error => tab.errors.push(error.message));
  await tab.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme},
    {name: 'prefers-reduced-motion', value: motion ? 'no-preference' : 'reduce'}]);
  await tab.goto(`http://127.0.0.1:${server.address().port}/?with=${encodeURIComponent(attributes)}`);
  await tab.waitForFunction(type => told.some(([kind]) => kind === type), {}, last);
  return tab;
}

const labelOf = tab => tab.evaluate(() => it.shadowRoot.querySelector('canvas').getAttribute('aria-label'));
const settled = tab => tab.waitForFunction(() => {
  const count = told.length;
  return new Promise(done => setTimeout(() => done(told.length === count && count > 1), 150));
});
const pixelsOf = tab => tab.evaluate(() => {
  const canvas = it.shadowRoot.querySelector('canvas');
  return [...canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data];
});
async function close(tab) {
  assert.deepEqual(tab.errors, []);
  await tab.close();
}

test('the package holds the component, its types and its licence, and is small', () => {
  assert.deepEqual(packed.files.map(file => file.path).sort(),
    ['LICENSE', 'README.md', 'lumi-view.d.ts', 'lumi-view.js', 'package.json']);
  const bytes = zlib.gzipSync(fs.readFileSync(path.join(folder, 'package/lumi-view.js')), {level: 9}).length;
  assert.ok(bytes <= MOST_BYTES, `${bytes} bytes`);
});

test('it draws what lumi render draws, over nothing, and loads nothing but its source', async () => {
  const png = path.join(folder, 'truth.png');
  execFileSync(lumi, ['render', field, '-o', png, '--orbit', '50,10,4', '--mode', '2x2', '--background', 'black']);
  const tab = await opened('src="/field.lumi" mode="2x2" orbit="50,10,4"');
  await settled(tab);
  const drawn = await pixelsOf(tab), truth = readPng(png).pixels;
  let solid = 0, clear = 0;
  for (let k = 0; k < 240 * 240; ++k) {
    if (drawn[4 * k + 3] === 0) ++clear;
    if (drawn[4 * k + 3] !== 255) continue;
    ++solid;
    for (let c = 0; c < 3; ++c) assert.equal(drawn[4 * k + c], truth[3 * k + c], `pixel ${k}`);
  }
  assert.ok(solid > 5000 && clear > 5000, `${solid} pixels of the object, ${clear} of the page`);
  assert.deepEqual(tab.requests, ['/', '/package/lumi-view.js', '/field.lumi']);
  assert.equal(await labelOf(tab), 'Desk clock, seen from 50 degrees around, 10 degrees up');
  await close(tab);
});

test('it spins until it is touched, and not where motion is unwanted', async () => {
  const turning = await opened('src="/field.lumi" spin', {motion: true});
  await turning.waitForFunction(() => told.filter(([type]) => type === 'turn').length > 10);
  await turning.click('#it');
  await settled(turning);
  await close(turning);
  const still = await opened('src="/field.lumi" spin');
  await settled(still);
  assert.match(await labelOf(still), /from 30 degrees/);
  await close(still);
});

test('keys turn it, and a screen reader finds it by its name', async () => {
  const tab = await opened('src="/field.lumi"');
  await tab.keyboard.press('Tab');
  await tab.keyboard.down('ArrowLeft');
  await tab.waitForFunction(() => told.some(([type, detail]) => type === 'turn' && detail.azimuth > 45));
  await tab.keyboard.up('ArrowLeft');
  await settled(tab);
  assert.doesNotMatch(await labelOf(tab), /from 30 degrees/);
  await tab.keyboard.press('0');
  await tab.waitForFunction(() => /from 30 degrees/.test(it.shadowRoot.querySelector('canvas').getAttribute('aria-label')));
  const names = node => [node.name, ...(node.children ?? []).flatMap(names)];
  assert.ok(names(await tab.accessibility.snapshot()).some(name => name?.startsWith('Desk clock, seen from')));
  await close(tab);
});

test('parts are told by name, and an unknown one is refused', async () => {
  const tab = await opened('src="/field.lumi"');
  await settled(tab);
  const before = await pixelsOf(tab);
  if (await tab.evaluate(() => it.parts.length > 0 && it.setPart(it.parts[0], 70) === undefined)) {
    await settled(tab);
    assert.notDeepEqual(await pixelsOf(tab), before);
  }
  assert.match(await tab.evaluate(() => { try { it.setPart('?', 1); } catch (e) { return e.message; } }), /the name \?/);
  await close(tab);
});

test('what cannot be shown is told', async () => {
  for (const [src, message] of [['/none.lumi', /404/], ['/package/lumi-view.js', /field/]]) {
    const tab = await opened(`src="${src}"`, {last: 'error'});
    assert.match(await tab.evaluate(() => told.at(-1)[1].message), message);
    assert.equal(await labelOf(tab), 'Desk clock cannot be shown');
    await close(tab);
  }
});

test('it lies on a light page and on a dark one', async () => {
  for (const scheme of ['light', 'dark']) {
    const tab = await opened('src="/field.lumi"', {scheme});
    await settled(tab);
    if (pictures) {
      fs.mkdirSync(pictures, {recursive: true});
      await tab.screenshot({path: path.join(pictures, `element-${scheme}.png`), clip: {x: 0, y: 0, width: 400, height: 330}});
    }
    await close(tab);
  }
});
