#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// run_pico.cjs PROGRAM.bin FOLDER [--flash-misses]
// Runs platform/pico_st7789 in rp2040js, an emulator of the RP2040 in JavaScript, from the second stage of its boot on.
// The display is a model of the ST7789 behind SPI0. Prints the lines of UART0 and writes what the panel shows at each
// that says "frame ...", FOLDER/frame-0.raw, ..., 240 x 240 pixels of 16 bits, high byte first. --flash-misses adds the
// flash's cache, which the emulator lacks: 16 kB, 2 ways, lines of 8 bytes, 400 ns a miss (assumed, as in
// tools/src/bench/chips.cpp). Ends with the program's "exit" code, or 1 after 20 seconds of the board's time.
'use strict';
const fs = require('fs');
const path = require('path');

function load(name) {
  try {
    return require(name);
  } catch (error) {
    console.error(`run_pico.cjs: ${name} is missing: npm install ${name}, and name its folder in NODE_PATH`);
    process.exit(1);
  }
}
const { RP2040 } = load('rp2040js');

const kFlash = 0x10000000, kFlashEnd = 0x11000000, kBootRam = 0x20041f00, kBootBytes = 256;
const kHz = 125e6, kMissNanos = 400, kMostNanos = 20e9;

// Polynomial 04C11DB7, most significant bit first, begun with ones, not inverted: as the boot ROM checks it.
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte << 24;
    for (let k = 0; k < 8; ++k) crc = crc & 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
  }
  return crc >>> 0;
}

class FlashCache {
  constructor() {
    this.sets = 1024;
    this.tags = new Int32Array(this.sets * 2).fill(-1);
    this.last = new Uint8Array(this.sets);
    this.misses = 0;
  }
  read(address) {
    const line = (address - kFlash) >>> 3, set = line % this.sets;
    for (let way = 0; way < 2; ++way) {
      if (this.tags[2 * set + way] === line) {
        this.last[set] = way;
        return;
      }
    }
    const way = 1 - this.last[set];
    this.tags[2 * set + way] = line;
    this.last[set] = way;
    ++this.misses;
  }
}

// What the controller does with the commands that a picture takes.
class St7789 {
  constructor(isData) {
    this.isData = isData;
    this.memory = Buffer.alloc(240 * 240 * 2);
    this.range = { 0x2a: [0, 239], 0x2b: [0, 239] };
    this.command = 0;
    this.values = [];
    this.isOn = this.isAwake = this.has16Bits = false;
  }
  take(byte) {
    if (!this.isData()) {
      this.command = byte;
      this.values = [];
      if (byte === 0x11) this.isAwake = true;
      if (byte === 0x29) this.isOn = true;
      if (byte === 0x2c) this.x = this.range[0x2a][0], this.y = this.range[0x2b][0];
    } else if (this.command === 0x2c) {
      this.takePixelByte(byte);
    } else {
      this.values.push(byte);
      if (this.command === 0x3a) this.has16Bits = byte === 0x55;
      const v = this.values;
      if (this.range[this.command] && v.length === 4) this.range[this.command] = [v[0] << 8 | v[1], v[2] << 8 | v[3]];
    }
  }
  takePixelByte(byte) {
    const [left, right] = this.range[0x2a], [top, bottom] = this.range[0x2b];
    this.values.push(byte);
    if (this.values.length < 2) return;
    if (this.x < 240 && this.y < 240) this.memory.set(this.values, (this.y * 240 + this.x) * 2);
    this.values = [];
    if (++this.x > right) {
      this.x = left;
      if (++this.y > bottom) this.y = top;
    }
  }
  picture() {
    return this.isAwake && this.isOn && this.has16Bits ? this.memory : Buffer.alloc(this.memory.length);
  }
}

function watchFlash(chip, cache) {
  for (const name of ['readUint8', 'readUint16', 'readUint32']) {
    const read = chip[name].bind(chip);
    chip[name] = (address) => {
      if (address >= kFlash && address < kFlashEnd) cache.read(address);
      return read(address);
    };
  }
}

// The emulator has one core: there is room for words to the other one, and it never answers.
function silenceCore1(chip) {
  const kStatus = 0x50, kWrite = 0x54, kHasRoom = 2;
  const { sio } = chip, read = sio.readUint32.bind(sio), write = sio.writeUint32.bind(sio);
  sio.readUint32 = (offset) => (offset === kStatus ? kHasRoom : read(offset));
  sio.writeUint32 = (offset, value) => void (offset === kWrite || write(offset, value));
}

function boot(chip, program) {
  if (program.length < kBootBytes || crc32(program.subarray(0, 252)) !== program.readUInt32LE(252)) {
    console.error('run_pico.cjs: the boot ROM would not start this program: the CRC of its first 256 bytes is wrong');
    process.exit(1);
  }
  chip.flash.set(program);
  chip.sram.set(program.subarray(0, kBootBytes), kBootRam - 0x20000000);
  chip.core.SP = 0x20042000;
  chip.core.PC = kBootRam;
}

function main() {
  const [file, folder, option] = process.argv.slice(2);
  if (!folder || (option && option !== '--flash-misses')) {
    console.error('run_pico.cjs PROGRAM.bin FOLDER [--flash-misses]');
    process.exit(2);
  }
  const chip = new RP2040(), clock = chip.clock, cache = new FlashCache();
  chip.logger = { debug() {}, info() {}, warn() {}, error(name, text) { console.error(`${name}: ${text}`); } };
  if (!fs.existsSync(file)) {
    console.error(`run_pico.cjs: ${file}: no such file`);
    process.exit(2);
  }
  boot(chip, fs.readFileSync(file));
  if (option) watchFlash(chip, cache);

  silenceCore1(chip);

  const panel = new St7789(() => chip.gpio[20].outputValue);
  const spi = chip.spi[0];
  let byte = 0;
  const sent = clock.createAlarm(() => {
    panel.take(byte);
    spi.completeTransmit(0);
  });
  spi.onTransmit = (value) => {
    byte = value;
    sent.schedule(8e9 / spi.clockFrequency);
  };

  let line = '', code, missesBefore = 0;
  chip.uart[0].onByte = (value) => {
    if (value !== 10) return void (line += String.fromCharCode(value));
    const words = line.split(' ');
    if (words[0] === 'exit') code = Number(words[1]);
    if (words[0] === 'frame') {
      fs.writeFileSync(path.join(folder, `frame-${words[1]}.raw`), panel.picture());
      console.log(line + (option ? ` misses ${cache.misses - missesBefore}` : ''));
      missesBefore = cache.misses;
    }
    line = '';
  };
  const core = chip.core, nanosPerCycle = 1e9 / kHz;
  let missed = 0;
  while (code === undefined && clock.nanos < kMostNanos) {
    const cycles = core.executeInstruction();
    clock.tick(cycles * nanosPerCycle + (cache.misses - missed) * kMissNanos);
    missed = cache.misses;
  }
  process.exit(code === undefined ? 1 : code);
}

main();
