// SPDX-License-Identifier: MIT
// node module_test.mjs LUMI FIELD [frames]: the page that `lumi view` writes of a field. It needs no network; its module draws what
// `lumi render` draws, bit by bit, in every mode and format; its eye follows a finger, runs on, and comes back. With `frames`, its frames alone.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import {test as run} from 'node:test';

import {drawn, openPage} from './page.mjs';
import {readPng} from './png.mjs';

const [lumi, field, only] = process.argv.slice(2);
const test = (name, body) => { if (!only || name.startsWith(only)) run(name, body); };
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'lumi-view-test-'));
process.on('exit', () => fs.rmSync(folder, {recursive: true}));

const FORMATS = ['rgb888', 'rgb565', 'grey8'];  // by number: platform/wasm/drawing.h
const GRADIENT = 2 ** 24;  // platform/wasm/viewer.cpp
const BACKGROUND = '204060', ORBIT = '211.5,-41,3';

async function pageOfField() {
  const output = path.join(folder, 'page.html');
  if (!fs.existsSync(output))
    execFileSync(lumi, ['view', field, '-o', output, '--orbit', ORBIT, '--background', BACKGROUND]);
  const page = await openPage(output);
  assert.equal(page.error, 0);
  page.module.set_home(page.data.home.azimuth, page.data.home.elevation, page.data.home.distance);
  return page;
}

// The tool draws these from that orbit and from the other side.
function rendered(size, mode, format, layout, background, more = []) {
  const output = path.join(folder, 'picture.png');
  const span = layout === 'chord' && mode !== 'paper' ? ['--span', '8'] : [];
  execFileSync(lumi, ['render', field, '-o', output, '--size', size, '--orbit', ORBIT, '--background', background,
    '--mode', mode, '--pixel', format, '--turntable', '2', ...span, ...more]);
  return ['000', '001'].map(number => readPng(path.join(folder, `picture-${number}.png`)));
}

test('the page needs nothing but itself', async () => {
  const {html} = await pageOfField();
  assert.match(html, /^<!DOCTYPE html>/);
  assert.match(html, /Content-Security-Policy"\s+content="default-src 'none'/);
  assert.doesNotMatch(html, /https?:|<link|<iframe|@import|url\(|fetch\(|import\(|XMLHttpRequest/);
  assert.deepEqual([...html.matchAll(/\bsrc="([^"]*)"/g)], []);
});

test('frames are those of lumi render, in every mode and format', async () => {
  const width = 97, height = 80;
  const {data, module} = await pageOfField();
  for (const mode of data.modes) {
    for (const [number, format] of FORMATS.entries()) {
      for (const [background, code] of [[BACKGROUND, parseInt(BACKGROUND, 16)], ['gradient', GRADIENT]]) {
        module.go_home();
        for (const truth of rendered(`${width}x${height}`, mode.name, format, data.layout, background)) {
          const frame = drawn(module, width, height, mode.number, number, code);
          assert.ok(frame.equals(truth.pixels), `${mode.name} ${format} ${background}`);
          assert.ok(new Set(frame).size > 4, 'the picture shows something');
          module.turn(2 ** 31);
        }
      }
    }
  }
});

test('frames show parts where lumi render has them', async () => {
  const {data, module} = await pageOfField();
  const number = data.parts.findIndex(part => !part.slides), pose = 70;
  if (number < 0) return;
  const [rest] = rendered('97x80', 'one-sample', 'rgb888', data.layout, BACKGROUND);
  const [truth] = rendered('97x80', 'one-sample', 'rgb888', data.layout, BACKGROUND,
    ['--part', `${data.parts[number].name}=${pose}`]);
  assert.ok(!truth.pixels.equals(rest.pixels));
  for (const [value, picture] of [[pose, truth], [0, rest]]) {
    module.set_part(number, Math.round(value * 2 ** 32 / 360) | 0);
    assert.ok(drawn(module, 97, 80, 0, 0, parseInt(BACKGROUND, 16)).equals(picture.pixels));
  }
});

test('frames show lights as lumi render weighs them', async () => {
  const {data, module} = await pageOfField();
  if (!data.states.length) return;
  const of = more => rendered('97x80', 'one-sample', 'rgb888', data.layout, BACKGROUND, more)[0].pixels;
  const frame = () => drawn(module, 97, 80, 0, 0, parseInt(BACKGROUND, 16));
  assert.ok(frame().equals(of([])));
  module.set_state(1, 1024, 2048, 4096);
  assert.ok(frame().equals(of(['--state', `${data.states[1].name}=0.25,0.5,1`])));
});

test('the eye follows a finger, runs on, and comes back', async () => {
  const {module} = await pageOfField();
  const first = module.azimuth();
  module.advance(true, 0, 0, 16);
  module.advance(true, 100, 0, 16);
  const followed = module.azimuth();
  assert.ok((first - followed | 0) > 0, 'the eye goes to the left of a finger that goes right');
  assert.ok(module.advance(false, 100, 0, 16));
  assert.ok((followed - module.azimuth() | 0) > 0, 'it runs on');
  let frames = 0;
  while (module.advance(false, 100, 0, 16)) assert.ok(++frames < 1000, 'it comes to rest');
  module.go_home();
  assert.equal(module.azimuth(), first);
});

test('zooming stays within reach', async () => {
  const {module} = await pageOfField();
  const settle = () => { while (module.advance(false, 0, 0, 16)); };
  for (const [factor, radii] of [[0.5, 1.5], [0.5, 1.25], [100, 8]]) {
    module.scale_distance(factor * 65536);
    settle();
    assert.equal(module.distance(), radii * 2 ** 20);
  }
});

test('the memory of a firmware grows with screen and mode, and the field stays open', async () => {
  const {data, module} = await pageOfField();
  const ram = data.modes.map(mode => {
    module.set_screen(240, 240);
    const small = module.device_ram(mode.number, 1);
    module.set_screen(480, 480);
    assert.ok(module.device_ram(mode.number, 1) > small);
    return small;
  });
  assert.ok(ram.at(-1) >= ram[0]);
  const {ram_bytes: told} = JSON.parse(execFileSync(lumi, ['inspect', field, '--screen', '240x240', '--json']));
  data.modes.forEach(({name}, k) => {
    if (told[name]) assert.equal(told[name].view + told[name].stripe, ram[k]);
  });
  assert.equal(module.set_screen(0, 240), 0);
  assert.notEqual(module.draw_frame(0, 0, 0), 0);
  assert.notEqual(module.set_screen(2048, 2048), 0);
  assert.equal(module.draw_frame(data.modes[0].number, 0, 0), 0);
});

test('a damaged field is refused', async () => {
  const {module, field: bytes} = await pageOfField();
  const address = module.field_memory(bytes.length);
  new Uint8Array(module.memory.buffer, address, bytes.length).set(bytes.map(b => b ^ 1));
  const error = module.open_field();
  assert.notEqual(error, 0);
  const text = new Uint8Array(module.memory.buffer, module.describe(error));
  assert.ok(text[0] > 32);
});
