// SPDX-License-Identifier: MIT
// Turns a field on a canvas, for pages of `lumi view` and for <lumi-view>: runs the module (platform/wasm/viewer.cpp), which
// holds the field and the eye, and moves the eye by fingers, mouse and keys.
'use strict';

const TURN = 2 ** 32, DISPLAY_STEPS = 1024;  // a finger's steps across the display: see kTurnPerStep
const SPIN = TURN / 14000;                   // a turn in 14 seconds
const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
const KEY_SPEED = 0.55, FARTHEST_STEP = 30000;  // steps a millisecond; what the module takes

function bytesOf(base64) {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return bytes;
}

class Turner {
  constructor(canvas, settings) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', settings);
    this.finger = {down: false, x: 0, y: 0};  // a real one, or that of the keys
    this.pointers = new Map();                // all that touch the picture
    this.held = new Set();                    // arrow keys
    this.pinch = 0;                           // distance of two fingers, 0: no pinch
    this.isDirty = true;
    this.spins = false;
    this.onTouch = () => {};
  }

  // `zipped`: the module, compressed by gzip. Throws what is wrong with the field.
  async open(zipped, field, home) {
    const code = new Blob([zipped]).stream().pipeThrough(new DecompressionStream('gzip'));
    const {instance} = await WebAssembly.instantiate(await new Response(code).arrayBuffer());
    const module = this.module = instance.exports;
    const address = module.field_memory(field.length);
    if (!address) throw new Error('the browser has no memory for this field');
    new Uint8Array(module.memory.buffer, address, field.length).set(field);
    this.check(module.open_field());
    module.set_home(home.azimuth, home.elevation, home.distance);
  }

  check(error) {
    if (!error) return;
    const bytes = new Uint8Array(this.module.memory.buffer, this.module.describe(error));
    throw new Error(new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0))));
  }

  useScreen(width, height) {
    const address = this.module.set_screen(width, height);
    if (!address) throw new Error('the browser has no memory for this screen');
    this.canvas.width = width;
    this.canvas.height = height;
    this.pixels = new ImageData(
      new Uint8ClampedArray(this.module.memory.buffer, address >>> 0, 4 * width * height), width, height);
    this.isDirty = true;
  }

  draw(mode, format, background) {
    this.isDirty = false;
    this.check(this.module.draw_frame(mode, format, background));
    this.context.putImageData(this.pixels, 0, 0);
  }

  setPart(number, part, value) {
    this.module.set_part(number, Math.round(value * (part.slides ? 2 ** 20 : TURN / 360)) | 0);
    this.isDirty = true;
  }

  // Shares of its full light: red, green, blue.
  setState(number, weights) {
    this.module.set_state(number, ...weights.map(weight => Math.round(4096 * weight)));
    this.isDirty = true;
  }

  // The arrow keys are a finger that goes on and on.
  moveByKeys(elapsed) {
    const {finger, held} = this;
    if (this.pointers.size) return;
    finger.down = held.size > 0 && Math.max(Math.abs(finger.x), Math.abs(finger.y)) < FARTHEST_STEP;
    if (!finger.down) finger.x = finger.y = 0;
    for (const key of held) {
      finger.x += Math.round(ARROWS[key][0] * KEY_SPEED * elapsed);
      finger.y += Math.round(ARROWS[key][1] * KEY_SPEED * elapsed);
    }
  }

  advance(elapsed) {
    const {finger, module} = this;
    this.moveByKeys(elapsed);
    if (module.advance(finger.down && !this.pinch, finger.x, finger.y, Math.round(elapsed))) this.isDirty = true;
    if (this.spins && !finger.down) {
      module.turn(Math.round(SPIN * elapsed) >>> 0);
      this.isDirty = true;
    }
  }

  degrees(turns) { return Math.round((turns | 0) / TURN * 360); }

  seenFrom() {
    return {azimuth: (this.degrees(this.module.azimuth()) + 360) % 360, elevation: this.degrees(this.module.elevation())};
  }

  touched() {
    this.spins = false;
    this.onTouch();
  }

  hold(key) {
    this.held.add(key);
    this.touched();
  }

  zoom(factor) {
    this.module.scale_distance(Math.round(65536 * Math.min(Math.max(factor, 0.25), 4)));
    this.isDirty = true;
  }

  goHome() {
    this.module.go_home();
    this.isDirty = true;
  }

  onPointer(event) {
    const {canvas, finger, pointers} = this;
    if (event.type === 'pointerdown') canvas.setPointerCapture(event.pointerId);
    else if (!pointers.has(event.pointerId)) return;
    if (event.type === 'pointerup' || event.type === 'pointercancel') pointers.delete(event.pointerId);
    else pointers.set(event.pointerId, event);
    this.touched();
    const [first, second] = pointers.values();
    if (second) {
      const now = Math.hypot(first.clientX - second.clientX, first.clientY - second.clientY);
      if (this.pinch) this.zoom(this.pinch / now);
      this.pinch = now;
    } else if (!first) {
      this.pinch = 0;
      finger.down = false;
      return;
    }
    const scale = DISPLAY_STEPS / Math.min(canvas.clientWidth, canvas.clientHeight);
    [finger.x, finger.y] = [Math.round(first.clientX * scale), Math.round(first.clientY * scale)];
    finger.down = true;
  }

  onWheel(event) {
    event.preventDefault();
    this.touched();
    this.zoom(2 ** (event.deltaY * [1, 20, 400][event.deltaMode] / 600));
  }

  listen() {
    for (const type of ['pointerdown', 'pointermove', 'pointerup', 'pointercancel'])
      this.canvas.addEventListener(type, event => this.onPointer(event));
    this.canvas.addEventListener('wheel', event => this.onWheel(event), {passive: false});
    this.canvas.addEventListener('dblclick', () => this.goHome());
  }
}
