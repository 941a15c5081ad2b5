// SPDX-License-Identifier: MIT
// A program finds this in the RP2040's boot ROM (datasheet, 2.8.3): the table of functions, and those of them that the
// Pico SDK calls for memory and bits, done by JavaScript. A call takes as long as its bytes (assumed: one clock a byte).
'use strict';

const kTable = 0x20, kLookup = 0x18, kVersion = 0x10, kFunctions = 0x100, kBytesEach = 4;
const kBreak = 0xbe00, kReturn = 0x4770;

const code = (letters) => letters.charCodeAt(0) | letters.charCodeAt(1) << 8;

function fill(chip, r) {
  for (let k = 0; k < r[2]; ++k) chip.writeUint8(r[0] + k, r[1] & 0xff);
  chip.core.cycles += r[2];
}

function copy(chip, r) {
  for (let k = 0; k < r[2]; ++k) chip.writeUint8(r[0] + k, chip.readUint8(r[1] + k));
  chip.core.cycles += r[2];
}

const bits = (value) => (value >>> 0).toString(2).padStart(32, '0');
const kNames = ['', 'MS', 'S4', 'MC', 'C4', 'P3', 'L3', 'T3', 'R3'];
const kActions = [
  (chip, r) => void (r[0] = addressOf(r[1])),
  fill, fill, copy, copy,
  (chip, r) => void (r[0] = bits(r[0]).replace(/0/g, '').length),
  (chip, r) => void (r[0] = Math.clz32(r[0])),
  (chip, r) => void (r[0] = r[0] === 0 ? 32 : 31 - Math.clz32(r[0] & -r[0])),
  (chip, r) => void (r[0] = parseInt([...bits(r[0])].reverse().join(''), 2)),
];

// 0 for a function that is not here.
function addressOf(wanted) {
  const index = kNames.findIndex((name) => name !== '' && code(name) === wanted);
  return index < 0 ? 0 : kFunctions + index * kBytesEach | 1;
}

function addBootRom(chip) {
  const rom = new DataView(chip.bootrom.buffer);
  rom.setUint32(kVersion, 0x02 << 24 | 0x01 << 16 | code('Mu'), true);
  rom.setUint16(kLookup - 4, kTable, true);
  rom.setUint16(kLookup - 2, kTable, true);
  rom.setUint16(kLookup, kFunctions | 1, true);
  kActions.forEach((_, index) => {
    rom.setUint16(kFunctions + index * kBytesEach, kBreak | index, true);
    rom.setUint16(kFunctions + index * kBytesEach + 2, kReturn, true);
  });
  chip.onBreak = (index) => {
    if (!kActions[index]) throw new Error(`a breakpoint, ${index}: the program gave up`);
    kActions[index](chip, chip.core.registers);
  };
}

module.exports = { addBootRom };
