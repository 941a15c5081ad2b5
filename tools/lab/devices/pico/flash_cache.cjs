// SPDX-License-Identifier: MIT
// The cache of the RP2040's flash, which rp2040js lacks: 16 kB, 2 ways, lines of 8 bytes. A miss takes as long as the flash
// needs to send a line, in the way that the program's boot stage set in the SSI's registers (datasheet, 4.10.13): serial
// reads at 31 MHz take 3.1 us, quad reads at 62.5 MHz 0.45 us. Two cores share cache and flash, so one waits for the other's.
'use strict';

const kFlash = 0x10000000, kFlashEnd = 0x11000000, kSets = 1024, kLineBits = 64;
const kSsi = 0x18000, kControl = 0x00, kDivider = 0x14, kSpiControl = 0xf4;

// Nanoseconds a line, by registers of the SSI.
function lineNanos(registers, hz) {
  const control = registers[kControl] || 0, spi = registers[kSpiControl] || 0, lanes = 1 << (control >>> 21 & 3);
  const type = spi & 3;  // 0: command and address by one lane, 1: address by all, 2: both
  const commandBits = [0, 4, 8, 16][spi >>> 8 & 3], addressBits = 4 * (spi >>> 2 & 15), wait = spi >>> 11 & 31;
  const clocks = commandBits / (type === 2 ? lanes : 1) + addressBits / (type === 0 ? 1 : lanes) + wait + kLineBits / lanes;
  return clocks * (registers[kDivider] || 1) * 1e9 / hz;
}

class FlashCache {
  // The chip's CPU has `hz` clocks a second, and its boot stage has not run yet.
  constructor(chip, hz) {
    this.hz = hz;
    this.registers = {};
    this.missNanos = 0;
    const ssi = chip.peripherals[kSsi], write = ssi.writeUint32.bind(ssi);
    ssi.writeUint32 = (offset, value) => {
      this.registers[offset] = value >>> 0;
      this.missNanos = lineNanos(this.registers, hz);
      write(offset, value);
    };
    this.tags = new Int32Array(kSets * 2).fill(-1);
    this.last = new Uint8Array(kSets);
    this.misses = 0;
    this.busyUntil = 0;
    this.stalls = 0;  // nanoseconds that the running instruction waits
    this.nanos = 0;   // when that instruction began
  }
  read(address) {
    const line = (address - kFlash) >>> 3, set = line % kSets;
    for (let way = 0; way < 2; ++way) {
      if (this.tags[2 * set + way] === line) {
        this.last[set] = way;
        return;
      }
    }
    const way = 1 - this.last[set], now = this.nanos + this.stalls;
    this.tags[2 * set + way] = line;
    this.last[set] = way;
    ++this.misses;
    const begin = now < this.busyUntil - this.missNanos ? now : Math.max(now, this.busyUntil);
    this.busyUntil = Math.max(this.busyUntil, begin + this.missNanos);
    this.stalls = begin + this.missNanos - this.nanos;
  }
  // From here on reads of the chip's flash go through the cache.
  watch(chip) {
    for (const name of ['readUint8', 'readUint16', 'readUint32']) {
      const read = chip[name].bind(chip);
      chip[name] = (address) => {
        if (address >= kFlash && address < kFlashEnd) this.read(address);
        return read(address);
      };
    }
  }
}

module.exports = { FlashCache };
