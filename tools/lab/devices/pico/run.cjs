#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// run.cjs PROGRAM.bin FOLDER [--flash-misses] [--json LINES] [--frames COUNT]
// Runs platform/pico_st7789 in rp2040js, an emulator of the RP2040 in JavaScript, from the second stage of its boot on.
// The emulator lacks three things, which lie beside this file: the second core, the boot ROM's functions, and the
// display behind SPI0.
// Prints the lines of UART0 and writes what the panel shows at each that says "frame ...", FOLDER/frame-0.raw, ...,
// 240 x 240 pixels of 16 bits, high byte first. --flash-misses adds the flash's cache. Ends with the program's "exit"
// code, with 0 after so many frames, or lines of JSON, which it prints, or with 1 after 20 seconds of the board's time.
'use strict';
const fs = require('fs');
const path = require('path');

function load(name) {
  try {
    return require(name);
  } catch (error) {
    console.error(`run.cjs: ${name} is missing: npm install ${name}, and name its folder in NODE_PATH`);
    process.exit(1);
  }
}
const { RP2040 } = load('rp2040js');
const { addBootRom } = require('./boot_rom.cjs');
const { Cores } = require('./cores.cjs');
const { FlashCache } = require('./flash_cache.cjs');
const { St7789 } = require('./st7789.cjs');

const kBootRam = 0x20041f00, kBootBytes = 256, kHz = 125e6, kMostNanos = 20e9;

// Polynomial 04C11DB7, most significant bit first, begun with ones, not inverted: as the boot ROM checks it.
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte << 24;
    for (let k = 0; k < 8; ++k) crc = crc & 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
  }
  return crc >>> 0;
}

function boot(chip, program) {
  if (program.length < kBootBytes || crc32(program.subarray(0, 252)) !== program.readUInt32LE(252)) {
    console.error('run.cjs: the boot ROM would not start this program: the CRC of its first 256 bytes is wrong');
    process.exit(1);
  }
  chip.flash.set(program);
  chip.sram.set(program.subarray(0, kBootBytes), kBootRam - 0x20000000);
  chip.core.SP = kBootRam;
  chip.core.registers[14] = 0;  // return address, as the boot ROM leaves it: no caller
  chip.core.PC = kBootRam;
}

function main() {
  const [file, folder, ...options] = process.argv.slice(2);
  const count = (name) => {
    const at = options.indexOf(name);
    return at < 0 ? 0 : Number(options.splice(at, 2)[1]);
  };
  const wanted = count('--json'), frames = count('--frames');
  if (!folder || Number.isNaN(wanted + frames) || options.some((option) => option !== '--flash-misses')) {
    console.error('run.cjs PROGRAM.bin FOLDER [--flash-misses] [--json LINES] [--frames COUNT]');
    process.exit(2);
  }
  const hasMisses = options.length > 0;
  const chip = new RP2040(), clock = chip.clock, cache = new FlashCache(chip, kHz);
  chip.logger = { debug() {}, info() {}, warn() {}, error(name, text) { console.error(`${name}: ${text}`); } };
  if (!fs.existsSync(file)) {
    console.error(`run.cjs: ${file}: no such file`);
    process.exit(2);
  }
  addBootRom(chip);
  boot(chip, fs.readFileSync(file));
  if (hasMisses) cache.watch(chip);

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

  let line = '', code, missesBefore = 0, told = 0;
  chip.uart[0].onByte = (value) => {
    if (value !== 10) return void (line += String.fromCharCode(value));
    const words = line.split(' ');
    if (line[0] === '{' && wanted) {
      console.log(line);
      if (++told === wanted) code = 0;
    }
    if (words[0] === 'exit') code = Number(words[1]);
    if (words[0] === 'frame') {
      fs.writeFileSync(path.join(folder, `frame-${words[1]}.raw`), panel.picture());
      console.log(line + (hasMisses ? ` misses ${cache.misses - missesBefore}` : ''));
      missesBefore = cache.misses;
      if (Number(words[1]) + 1 === frames) code = 0;
    }
    line = '';
  };
  const cores = new Cores(chip);
  const execute = (core, nanos) => {
    const before = core.cycles;
    cache.nanos = nanos;
    cache.stalls = 0;
    core.executeInstruction();
    return (core.cycles - before) * 1e9 / kHz + cache.stalls;
  };
  while (code === undefined && clock.nanos < kMostNanos) clock.tick(cores.step(execute) - clock.nanos);
  process.exit(code === undefined ? 1 : code);
}

main();
