// SPDX-License-Identifier: MIT
'use strict';

// Does what the controller does with the commands that a picture takes.
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

module.exports = { St7789 };
