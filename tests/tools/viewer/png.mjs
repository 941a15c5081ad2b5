// SPDX-License-Identifier: MIT
// Reads the PNG files that `lumi render` writes: 8 bits a channel, red, green and blue, not interlaced.
import fs from 'node:fs';
import zlib from 'node:zlib';

const SIGNATURE_BYTES = 8, CHANNELS = 3;

function* chunksOf(bytes) {
  for (let at = SIGNATURE_BYTES; at < bytes.length;) {
    const size = bytes.readUInt32BE(at);
    yield [bytes.toString('latin1', at + 4, at + 8), bytes.subarray(at + 8, at + 8 + size)];
    at += size + 12;
  }
}

// The neighbour that a, b and c predict, by the PNG specification.
function paeth(a, b, c) {
  const p = a + b - c, pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

const PREDICTORS = [() => 0, a => a, (a, b) => b, (a, b) => (a + b) >> 1, paeth];

export function readPng(path) {
  let width = 0, height = 0;
  const packed = [];
  for (const [type, content] of chunksOf(fs.readFileSync(path))) {
    if (type === 'IHDR') {
      [width, height] = [content.readUInt32BE(0), content.readUInt32BE(4)];
      if (content[8] !== 8 || content[9] !== 2) throw new Error(`${path} is no picture of three channels`);
    } else if (type === 'IDAT') {
      packed.push(content);
    }
  }
  const rows = zlib.inflateSync(Buffer.concat(packed)), stride = CHANNELS * width;
  const pixels = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) {
    const predict = PREDICTORS[rows[y * (stride + 1)]];
    for (let x = 0; x < stride; ++x) {
      const at = y * stride + x;
      const left = x >= CHANNELS ? pixels[at - CHANNELS] : 0, above = y ? pixels[at - stride] : 0;
      const corner = x >= CHANNELS && y ? pixels[at - stride - CHANNELS] : 0;
      pixels[at] = rows[y * (stride + 1) + 1 + x] + predict(left, above, corner);
    }
  }
  return {width, height, pixels};
}
