// SPDX-License-Identifier: MIT
// node write_skull.cjs CRANIUM.inv3 OUT
// A scene of a human skull from CT: the bone's mesh in the example of Debian's package invesalius-examples (a packed
// tar of VTK files), as polished bone. OUT gets OBJ, MTL and a scene file. The same bytes on every run.
'use strict';
const fs = require('fs');
const path = require('path');
const zlib = require('zlib');

const MESH = 'surface_0.vtp';  // bone; the other one is skin
const TAR_BLOCK = 512, INT_BYTES = 4;

// The file of that name in a tar.
function untar(bytes, name) {
  for (let at = 0; at + TAR_BLOCK <= bytes.length && bytes[at] !== 0;) {
    const text = (from, to) => bytes.toString('latin1', at + from, at + to).split('\0')[0];
    const size = parseInt(text(124, 136), 8), begin = at + TAR_BLOCK;
    if (path.basename(text(0, 100)) === name) return bytes.subarray(begin, begin + size);
    at = begin + Math.ceil(size / TAR_BLOCK) * TAR_BLOCK;
  }
  throw new Error(`no ${name} in the project; is it Cranium.inv3?`);
}

// A binary DataArray: counts of blocks and bytes, then blocks of zlib, each part in base64 of its own.
function arrayBytes(text) {
  const base64 = text.trim();
  const blocks = Buffer.from(base64.slice(0, 8), 'base64').readUInt32LE(0);
  const headChars = Math.ceil(INT_BYTES * (3 + blocks) / 3) * 4;
  const head = Buffer.from(base64.slice(0, headChars), 'base64'), body = Buffer.from(base64.slice(headChars), 'base64');
  const parts = [];
  for (let k = 0, at = 0; k < blocks; ++k) {
    const size = head.readUInt32LE(INT_BYTES * (3 + k));
    parts.push(zlib.inflateSync(body.subarray(at, at + size)));
    at += size;
  }
  return Buffer.concat(parts);
}

function numbers(bytes, isFloat) {
  const values = new Array(bytes.length / INT_BYTES);
  for (let k = 0; k < values.length; ++k)
    values[k] = isFloat ? bytes.readFloatLE(INT_BYTES * k) : bytes.readInt32LE(INT_BYTES * k);
  return values;
}

// The array `name` in the element `part`.
function arrayOf(xml, part, name, isFloat) {
  const inside = xml.slice(xml.indexOf(`<${part}`), xml.indexOf(`</${part}>`));
  const begin = inside.indexOf('>', inside.indexOf(`Name="${name}"`)) + 1;
  return numbers(arrayBytes(inside.slice(begin, inside.indexOf('<', begin))), isFloat);
}

// Triangles of strips: every other one is turned.
function triangles(connectivity, ends) {
  const all = [];
  let begin = 0;
  for (const end of ends) {
    for (let k = begin; k + 2 < end; ++k) {
      const [a, b, c] = connectivity.slice(k, k + 3);
      all.push((k - begin) % 2 ? [b, a, c] : [a, b, c]);
    }
    begin = end;
  }
  return all;
}

function records(kind, values, places) {
  const lines = [];
  for (let k = 0; k < values.length; k += 3)
    lines.push(kind + values.slice(k, k + 3).map(v => ' ' + +v.toFixed(places)).join(''));
  return lines;
}

function main(project, out) {
  const xml = untar(zlib.gunzipSync(fs.readFileSync(project)), MESH).toString('latin1');
  const points = arrayOf(xml, 'Points', 'Points', true), normals = arrayOf(xml, 'PointData', 'Normals', true);
  const faces = triangles(arrayOf(xml, 'Strips', 'connectivity'), arrayOf(xml, 'Strips', 'offsets'));
  fs.mkdirSync(out, {recursive: true});
  const write = (name, content) => fs.writeFileSync(path.join(out, name), content);
  write('skull.obj', ['mtllib skull.mtl', ...records('v', points, 3), ...records('vn', normals, 4), 'usemtl bone',
                      ...faces.map(f => 'f' + f.map(k => ` ${k + 1}//${k + 1}`).join('')), ''].join('\n'));
  write('skull.mtl', 'newmtl bone\nKd 0.72 0.66 0.54\nKs 0.04 0.04 0.04\nNi 1.5\nPr 0.35\n');
  write('skull.json', JSON.stringify({objects: [{obj: 'skull.obj'}], up: 'z'}, null, 2) + '\n');
}

main(...process.argv.slice(2).map(name => path.resolve(name)));
