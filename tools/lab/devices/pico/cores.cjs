// SPDX-License-Identifier: MIT
// The second core of the RP2040, which rp2040js lacks: its registers, its divider, the FIFO between the cores, and what its
// boot ROM waits for (datasheet, 2.8.2). A core runs until it is half a microsecond ahead of the other. Interrupts go to
// core 0; memory banks and the bus take both cores at once.
'use strict';

const kCpuId = 0x00, kStatus = 0x50, kWrite = 0x54, kRead = 0x58, kDepth = 8, kHasWord = 1, kHasRoom = 2;
const kForceOff = 0x04, kCore1Power = 1 << 16, kMostAheadNanos = 500;
const kOwn = ['divDividend', 'divDivisor', 'divQuotient', 'divRemainder', 'divCSR', 'interp0', 'interp1'];

class Cores {
  constructor(chip) {
    this.chip = chip;
    this.cores = [chip.core, new chip.core.constructor(chip)];
    const Interpolator = chip.sio.interp0.constructor;
    this.parked = { divDividend: 0, divDivisor: 1, divQuotient: 0, divRemainder: 0, divCSR: 0,
      interp0: new Interpolator(0), interp1: new Interpolator(1) };
    this.current = 0;
    this.nanos = [0, 0];
    this.inbox = [[], []];  // words on their way to a core
    this.heard = [];        // these came so far of the six words that start core 1
    this.isLaunched = false;
    this.hookFifo(chip.sio);
    this.hookPower(chip.peripherals[0x40010]);
  }
  hookFifo(sio) {
    const read = sio.readUint32.bind(sio), write = sio.writeUint32.bind(sio);
    sio.readUint32 = (offset) => {
      const mine = this.inbox[this.current], others = this.inbox[1 - this.current];
      if (offset === kCpuId) return this.current;
      if (offset === kStatus) return (mine.length > 0 ? kHasWord : 0) | (others.length < kDepth ? kHasRoom : 0);
      return offset === kRead ? mine.shift() : read(offset);
    };
    sio.writeUint32 = (offset, value) => {
      if (offset === kStatus) return;  // clears flags of errors
      if (offset !== kWrite) write(offset, value);
      else if (this.current === 0 && !this.isLaunched) this.hear(value >>> 0);
      else this.inbox[1 - this.current].push(value >>> 0);
    };
  }
  // Core 1's boot ROM answers each word by itself; a wrong one begins anew.
  hear(word) {
    const begin = [0, 0, 1], at = this.heard.length;
    this.inbox[0].push(word);
    if (at < begin.length && word !== begin[at]) this.heard = [];
    else this.heard.push(word);
    if (this.heard.length < 6) return;
    const [, , , table, stack, entry] = this.heard, core = this.cores[1];
    core.VTOR = table;
    core.SP = stack;
    core.PC = (entry & ~1) >>> 0;
    this.nanos[1] = this.nanos[0];
    this.isLaunched = true;
  }
  hookPower(psm) {
    const write = psm.writeUint32.bind(psm);
    psm.writeUint32 = (offset, value) => {
      const wasOff = psm.frceOff & kCore1Power;
      write(offset, value);
      if (offset !== kForceOff) return;
      if (psm.frceOff & kCore1Power) {
        this.isLaunched = false;
        this.heard = [];
        this.inbox = [[], []];
      } else if (wasOff) {
        this.inbox[0].push(0);  // its ROM is there again
      }
    };
  }
  change() {
    const { sio } = this.chip, { parked } = this;
    for (const name of kOwn) {
      const value = sio[name];
      sio[name] = parked[name];
      parked[name] = value;
    }
    this.current = 1 - this.current;
    this.chip.core = this.cores[this.current];
  }
  // Runs one instruction by execute(core, nanos), which tells its time. Returns what both cores have reached.
  step(execute) {
    const k = this.current, { nanos } = this;
    nanos[k] += execute(this.cores[k], nanos[k]);
    if (!this.isLaunched) return nanos[0];
    if (nanos[k] > nanos[1 - k] + kMostAheadNanos) this.change();
    return nanos[0] < nanos[1] ? nanos[0] : nanos[1];
  }
}

module.exports = { Cores };
