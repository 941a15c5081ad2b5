// SPDX-License-Identifier: MIT
// The cache of the RP2040's flash, which rp2040js lacks: 16 kB, 2 ways, lines of 8 bytes. A miss takes 400 ns (assumed, as
// in tools/src/bench/chips.cpp); two cores share cache and flash, so one waits for the other's.
'use strict';

const kFlash = 0x10000000, kFlashEnd = 0x11000000, kMissNanos = 400, kSets = 1024;

class FlashCache {
  constructor() {
    this.tags = new Int32Array(kSets * 2).fill(-1);
    this.last = new Uint8Array(kSets);
    this.misses = 0;
    this.busyUntil = 0;
    this.stalls = 0;  // of the instruction that runs
    this.nanos = 0;   // when it began
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
    const begin = now < this.busyUntil - kMissNanos ? now : Math.max(now, this.busyUntil);
    this.busyUntil = Math.max(this.busyUntil, begin + kMissNanos);
    this.stalls = begin + kMissNanos - this.nanos;
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
