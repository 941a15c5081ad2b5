// SPDX-License-Identifier: MIT
// node browser_test.mjs LUMI FIELD MODULES CHROMIUM [PICTURES]: the page of `lumi view` in a browser without a window, moved
// by events of mouse, fingers and keys that the browser makes itself. MODULES: a folder whose node_modules has
// puppeteer-core. PICTURES: a folder for screenshots, wide, narrow and low, light and dark.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';
import {after, test} from 'node:test';

const [lumi, field, modules, chromium, pictures] = process.argv.slice(2);
const puppeteer = createRequire(path.resolve(modules, 'x.js'))('puppeteer-core');

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'lumi-browser-test-'));
const page = path.join(folder, 'page.html'), compared = path.join(folder, 'compared.html');
execFileSync(lumi, ['render', field, '-o', path.join(folder, 'truth.png'), '--turntable', '4', '--background', 'black']);
execFileSync(lumi, ['view', field, '-o', page]);
execFileSync(lumi, ['view', field, '-o', compared, '--reference', folder]);

const browser = await puppeteer.launch({executablePath: chromium, args: ['--no-sandbox']});
after(async () => {
  await browser.close();
  fs.rmSync(folder, {recursive: true});
});

const WIDE = {width: 1400, height: 900};
const NARROW = {width: 390, height: 844, deviceScaleFactor: 2, isMobile: true, hasTouch: true};
const LOW = {...NARROW, width: 844, height: 390, isLandscape: true};

// A tab that shows the page, still unless `motion`. It fails on any error, and on any request but that of the page.
async function opened({view = WIDE, scheme = 'light', motion = false, file = page} = {}) {
  const tab = await browser.newPage();
  tab.errors = [];
  tab.on('pageerror', error => tab.errors.push(error.message));
  tab.on('console', message => { if (message.type() === 'error') tab.errors.push(message.text()); });
  tab.on('request', request => {
    if (!/^(data:|file:.*\.html$)/.test(request.url())) tab.errors.push(request.url());
  });
  await tab.emulateMediaFeatures([{name: 'prefers-color-scheme', value: scheme},
    {name: 'prefers-reduced-motion', value: motion ? 'no-preference' : 'reduce'}]);
  await tab.setViewport(view);
  await tab.goto('file://' + file);
  await tab.waitForFunction(() => document.getElementById('status').textContent !== '');
  return tab;
}

async function close(tab) {
  assert.deepEqual(tab.errors, []);
  await tab.close();
}

const eyeOf = tab => tab.evaluate(() => [module.azimuth() | 0, module.elevation(), module.distance()]);
const frameOf = tab => tab.evaluate(() => document.getElementById('picture').toDataURL());
const settled = tab => tab.waitForFunction(() => !module.advance(false, 0, 0, 16) && !turner.isDirty);

async function middleOf(tab) {
  const box = await (await tab.$('#picture')).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

test('the object turns by itself until somebody touches it', async () => {
  const tab = await opened({motion: true});
  const [first] = await eyeOf(tab);
  await tab.waitForFunction(azimuth => (module.azimuth() | 0) !== azimuth, {}, first);
  await tab.mouse.click(...await middleOf(tab));
  await settled(tab);
  const [rest] = await eyeOf(tab);
  await new Promise(done => setTimeout(done, 200));
  assert.equal((await eyeOf(tab))[0], rest);
  await close(tab);
});

test('a mouse turns it, and it runs on', async () => {
  const tab = await opened();
  const [x, y] = await middleOf(tab), [first] = await eyeOf(tab), frame = await frameOf(tab);
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  for (let k = 1; k <= 8; ++k) {
    await tab.mouse.move(x + 15 * k, y + 5 * k);
    await tab.evaluate(() => new Promise(requestAnimationFrame));
  }
  const [dragged, raised] = await eyeOf(tab);
  await tab.mouse.up();
  assert.ok((first - dragged | 0) > 0);
  assert.ok(raised > 0);
  await settled(tab);
  assert.ok((dragged - (await eyeOf(tab))[0] | 0) > 0, 'it runs on');
  assert.notEqual(await frameOf(tab), frame);
  await close(tab);
});

test('a wheel zooms, and a double click shows the first view again', async () => {
  const tab = await opened();
  const first = await eyeOf(tab);
  await tab.mouse.move(...await middleOf(tab));
  await tab.mouse.wheel({deltaY: -300});
  await tab.waitForFunction(distance => module.distance() < 0.8 * distance, {}, first[2]);
  await tab.mouse.click(...await middleOf(tab), {count: 2});
  assert.deepEqual(await eyeOf(tab), first);
  await close(tab);
});

test('a finger turns it, two zoom', async () => {
  const tab = await opened({view: NARROW});
  const [x, y] = await middleOf(tab), first = await eyeOf(tab);
  await tab.touchscreen.touchStart(x, y);
  for (let k = 1; k <= 5; ++k) {
    await tab.touchscreen.touchMove(x - 12 * k, y);
    await tab.evaluate(() => new Promise(requestAnimationFrame));
  }
  await tab.touchscreen.touchEnd();
  await settled(tab);
  const turned = await eyeOf(tab);
  assert.ok((turned[0] - first[0] | 0) > 0);
  const a = await tab.touchscreen.touchStart(x - 30, y), b = await tab.touchscreen.touchStart(x + 30, y);
  await a.move(x - 70, y);
  await b.move(x + 70, y);
  await a.end();
  await b.end();
  await tab.waitForFunction(distance => module.distance() < 0.7 * distance, {}, turned[2]);
  await close(tab);
});

test('keys turn, zoom, and choose', async () => {
  const tab = await opened();
  const first = await eyeOf(tab);
  await tab.keyboard.down('ArrowLeft');
  await tab.waitForFunction(azimuth => module.azimuth() - azimuth > 2 ** 27, {}, first[0]);
  await tab.keyboard.up('ArrowLeft');
  await settled(tab);
  await tab.keyboard.press('+');
  await tab.waitForFunction(distance => module.distance() < distance, {}, first[2]);
  await tab.keyboard.press('0');
  assert.deepEqual(await eyeOf(tab), first);

  const chosen = () => tab.evaluate(() => ({...state}));
  for (const [key, name, value] of [['2', 'mode', 1], ['1', 'mode', 0], ['m', 'mode', 1], ['p', 'format', 1],
    ['s', 'screen', 1], ['c', 'chip', 2], ['v', 'paced', true], [' ', 'spinning', true]]) {
    await tab.keyboard.press(key);
    assert.equal((await chosen())[name], value, key);
  }
  assert.match(await tab.$eval('#news', element => element.textContent), /frames a second/);
  await close(tab);
});

test('controls are found by their names, and change the picture', async () => {
  const tab = await opened();
  const namesIn = node => [node.name, ...(node.children ?? []).flatMap(namesIn)];
  const names = namesIn(await tab.accessibility.snapshot());
  for (const name of ['RP2040, ', 'frames a second', 'RGB565', 'Move at this chip’s speed'])
    assert.ok(names.some(known => known?.includes(name)), name);
  const before = await frameOf(tab);
  await tab.click('#formats label:nth-of-type(3)');
  await tab.select('#screen', '7');
  await tab.waitForFunction(() => document.getElementById('picture').width === 480 && !turner.isDirty);
  assert.notEqual(await frameOf(tab), before);
  await close(tab);
});

test('at a chip’s speed fewer frames are drawn', async () => {
  const tab = await opened({motion: true});
  const frames = () => tab.evaluate(async () => {
    const context = document.getElementById('picture').getContext('2d'), draw = context.putImageData;
    let count = 0;
    context.putImageData = function (...rest) { ++count; return draw.apply(this, rest); };
    await new Promise(done => setTimeout(done, 1500));
    context.putImageData = draw;
    return count / 1.5;
  });
  await tab.click('#chips label');
  await tab.click('#modes label:last-of-type');
  const free = await frames();
  await tab.click('#pace');
  const paced = await frames(), rate = await tab.evaluate(() => rateOf(data.chips[state.chip]));
  assert.ok(paced < 0.7 * free && Math.abs(paced - rate) < 0.25 * rate + 1, `${free}, ${paced} of ${rate}`);
  await close(tab);
});

test('beside a reference the eye stands where that was traced', async () => {
  const tab = await opened({file: compared});
  await tab.keyboard.press('t');
  await tab.waitForFunction(() => document.getElementById('reference').naturalWidth === 240 && !turner.isDirty);
  const difference = await tab.evaluate(() => {  // the references are the module's own frames, in RGB888
    set({format: 1, mode: data.modes.length - 1});
    drawCompared();
    const taken = document.createElement('canvas');
    [taken.width, taken.height] = [240, 240];
    const paper = taken.getContext('2d');
    paper.drawImage(document.getElementById('reference'), 0, 0);
    const a = paper.getImageData(0, 0, 240, 240).data, b = turner.pixels.data;
    return a.reduce((sum, value, k) => sum + Math.abs(value - b[k]), 0);
  });
  assert.equal(difference, 0);
  await close(tab);
});

test('nothing is cut off, wide, narrow or low', async () => {
  for (const [name, view] of [['wide', WIDE], ['narrow', NARROW], ['low', LOW]]) {
    for (const [file, key] of [[page, '0'], [compared, 't']]) {
      for (const scheme of ['light', 'dark']) {
        const tab = await opened({view, scheme, file});
        await tab.keyboard.press(key);
        await new Promise(done => setTimeout(done, 300));
        assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name} ${key}`);
        if (pictures) {
          fs.mkdirSync(pictures, {recursive: true});
          await tab.screenshot({path: path.join(pictures, `${name}-${scheme}-${key}.png`), fullPage: true});
        }
        await close(tab);
      }
    }
  }
});
