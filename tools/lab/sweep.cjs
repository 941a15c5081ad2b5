// SPDX-License-Identifier: MIT
// node sweep.cjs FOLDER TRADEOFF.md --markdown|--plot
// What tools/lab/sweep.sh left in FOLDER, as a page or as the data of a plot, on stdout. Instructions a pixel are those that
// `lumi bench` counted, from the page TRADEOFF.md.
'use strict';
const fs = require('fs');
const path = require('path');

const [folder, tradeoff, style] = process.argv.slice(2);
const SPAN = 16;  // of the spans that instructions are told for

const readJson = name => JSON.parse(fs.readFileSync(path.join(folder, name), 'utf8'));
const filesLike = pattern => fs.readdirSync(folder).filter(name => pattern.test(name)).sort();
const mean = values => values.reduce((sum, v) => sum + v, 0) / values.length;
const bytesText = bytes => bytes >= 1e6 ? (bytes / 1e6).toFixed(2) + ' MB' : Math.round(bytes / 1e3) + ' kB';
const table = (head, rows) =>
  [head, head.map((_, k) => k ? '---:' : '---'), ...rows].map(row => '| ' + row.join(' | ') + ' |').join('\n');

// {"linear palette8": instructions a pixel on M4 with spans}, from the page's table.
function readCosts() {
  const lines = fs.readFileSync(tradeoff, 'utf8').split('\n');
  const cells = line => line.split('|').slice(1, -1).map(cell => cell.trim());
  const begin = lines.findIndex((line, k) => line.startsWith('| renderer | m0plus exact') && lines[k + 1].startsWith('|--'));
  const column = cells(lines[begin]).indexOf(`m4 S${SPAN}`);
  const costs = {};
  for (let k = begin + 2; lines[k].startsWith('|'); ++k) costs[cells(lines[k])[0]] = Number(cells(lines[k])[column]);
  const surface = lines.findIndex(line => line.startsWith('| renderer | m0plus | m3 | m4 |'));
  for (let k = surface + 2; lines[k].startsWith('|'); ++k)
    costs['surface ' + cells(lines[k])[0]] = Math.round(Number(cells(lines[k])[cells(lines[surface]).indexOf('m4')]));
  return costs;
}

// Fields in every mode: [{scene, kind, lattice, texel, mode, bytes, instructions, psnr_db, ssim}].
function readRows(costs) {
  const rows = [];
  for (const file of filesLike(/\.report\.json$/)) {
    const report = readJson(file), name = file.replace('.report.json', ''), [scene, lattice, texel] = name.split('-');
    const add = (kind, mode, m, instructions) => rows.push({
      scene, kind, lattice, texel: texel || '', mode, bytes: m.flash_bytes, psnr_db: m.psnr_db, ssim: m.ssim,
      instructions: instructions ?? null, samples: report.reference_samples, views: report.views.length});
    if (!texel) {
      add('surface', '2x2', report.fields[0], costs['surface 2x2 rgb565']);
      for (const v of report.variants) add('surface', v.layout, v, costs[`surface ${v.layout.replace(' ', '-')} rgb565`]);
      continue;
    }
    add('chord', 'linear', report.fields[0], costs[`linear ${texel}`]);
    for (const v of report.variants) add('chord', v.layout, v, costs[`${v.layout.replace(/5$/, '')} ${texel}`]);
  }
  return rows;
}

// The same field of every scene, as one row with means.
function meansOf(rows) {
  const scenes = [...new Set(rows.map(r => r.scene))], groups = new Map();
  for (const r of rows) {
    const key = [r.kind, r.lattice, r.texel, r.mode].join(' ');
    groups.set(key, [...(groups.get(key) || []), r]);
  }
  return [...groups.values()].filter(g => g.length === scenes.length).map(g => ({
    ...g[0], scenes: g, bytes: Math.round(mean(g.map(r => r.bytes))), psnr_db: mean(g.map(r => r.psnr_db)),
    ssim: mean(g.map(r => r.ssim))})).sort((a, b) => a.bytes - b.bytes || a.instructions - b.instructions);
}

// No other of its kind takes at most its bytes and its instructions and shows more.
function markFront(rows) {
  for (const r of rows)
    r.front = !rows.some(o => o !== r && o.kind === r.kind && o.bytes <= r.bytes && o.instructions <= r.instructions &&
      o.psnr_db >= r.psnr_db && (o.bytes < r.bytes || o.instructions < r.instructions || o.psnr_db > r.psnr_db));
}

function tradeTable(rows) {
  const scenes = rows.length ? rows[0].scenes.map(r => r.scene) : [];
  return table(
    ['field', 'mode', 'flash', 'instructions a pixel, M4', 'dB', 'SSIM', ...scenes.map(s => s + ', dB / SSIM'), 'front'],
    rows.map(r => [
      r.kind === 'surface' ? `surface, ${r.lattice}` : `${r.lattice.replace('x', ' × ')} ${r.texel}`, r.mode,
      bytesText(r.bytes), r.instructions ?? '–', r.psnr_db.toFixed(2), r.ssim.toFixed(4),
      ...r.scenes.map(s => `${s.psnr_db.toFixed(2)} / ${s.ssim.toFixed(3)}`), r.front ? '●' : '']));
}

function kernelTable() {
  const files = filesLike(/\.kernel\.json$/), reports = files.map(readJson);
  if (!reports.length) return '';
  const names = files.map(f => f.split('.')[0]);
  const rows = reports[0].variants.map((v, k) => {
    const all = reports.map(r => r.variants[k]);
    return [v.layout.replace('paper', ''), mean(all.map(m => m.psnr_db)).toFixed(2), mean(all.map(m => m.ssim)).toFixed(4),
      ...all.map(m => `${m.psnr_db.toFixed(2)} / ${m.ssim.toFixed(3)}`),
      mean(all.map(m => m.draw_ms)).toFixed(0)];
  });
  return table(['K', 'dB', 'SSIM', ...names.map(n => n + ', dB / SSIM'), 'ms a picture, host'], rows);
}

// What the table of K says in words.
function kernelVerdict() {
  const reports = filesLike(/\.kernel\.json$/).map(readJson);
  if (!reports.length) return '';
  const db = reports[0].variants.map((_, k) => mean(reports.map(r => r.variants[k].psnr_db)));
  const enough = db.findIndex(v => db[db.length - 1] - v < 0.05) + 1;
  return `"Five suffice" is the paper's claim: from K = ${enough} on nothing gains 0.05 dB; from 1 to ${enough} ` +
    `it is ${(db[enough - 1] - db[0]).toFixed(2)} dB.`;
}

function costTable() {
  const rows = filesLike(/\.cost\.json$/).map(file => {
    const [m, n] = file.split('.')[0].split('x').map(Number), found = readJson(file);
    const cost = (mode, span) => found.find(r => r.mode === mode && r.span === span)?.instructions_per_pixel.toFixed(0) ?? '–';
    return {m, n, cells: [m, n, cost('nearest', 0), cost('nearest', SPAN), cost('linear', 0), cost('linear', SPAN)]};
  }).sort((a, b) => (a.m >= a.n) === (b.m >= b.n) ? a.m - b.m || a.n - b.n : a.m >= a.n ? -1 : 1);
  if (!rows.length) return '';
  return table(['M', 'N', 'nearest, exact', `nearest, S = ${SPAN}`, 'linear, exact', `linear, S = ${SPAN}`], rows.map(r => r.cells));
}

function page(rows) {
  const first = rows[0]?.scenes[0];
  return `# The trade of a chord field, against path-traced references

\`tools/lab/sweep.sh --docs\` measures everything anew and writes this page.

## Bytes, instructions, dB

Means over ${first?.views ?? 0} held-out views around the sphere of 240 × 240 pixels and over the scenes, against references of ${first?.samples ?? 0}
light paths a pixel; chord fields of 8 light paths a ray, drawn exactly. Instructions: a covered pixel on a Cortex-M4 by
spans of ${SPAN} (chord) or as drawn (surface, the desk clock), from [tradeoff.md](tradeoff.md). ●: no other of its kind with at most
these bytes and instructions shows more.

${tradeTable(rows)}

![Bytes and dB](../img/sweep.svg)

## The paper's K

${kernelTable()}

${kernelVerdict()} Weights (1 − d²/r²)² over the paper's radius, r² = 4π/n, which holds five points at most. Exact renderer, RGB888, processor time of one core.

## Cost over M and N

Instructions a covered pixel on a Cortex-M4, generic view, palette8. Constant is the paper's claim.

${costTable()}
`;
}

function plot(rows) {
  const series = (name, keep, label = () => '') => ({
    name, points: rows.filter(keep).map(r => [r.bytes / 1e3, r.psnr_db, label(r)])});
  const square = r => r.kind === 'chord' && new Set(r.lattice.split('x')).size === 1;
  const chord = ['nearest', 'linear', 'paper5'].map(mode =>
    series(`${mode} palette8, M = N`, r => square(r) && r.texel === 'palette8' && r.mode === mode));
  const formats = ['luma8', 'rgb565', 'rgb888'].map(texel =>
    series(`linear ${texel}, M = N`, r => square(r) && r.texel === texel && r.mode === 'linear'));
  const shapes = [['N = 4 M', (m, n) => n === 4 * m], ['M = 4 N', (m, n) => m === 4 * n]].map(([name, is]) =>
    series(`linear palette8, ${name}`, r => r.kind === 'chord' && r.mode === 'linear' && is(...r.lattice.split('x').map(Number))));
  const all = rows.filter(r => r.kind === 'chord');
  const best = all.filter(r => !all.some(o => o.bytes <= r.bytes && o.psnr_db > r.psnr_db));  // whatever they cost to draw
  const front = {name: 'front of chord fields', points: best.map(r => [r.bytes / 1e3, r.psnr_db, ''])};
  const surface = ['2x2', 'antialiased', 'one sample'].map(mode =>
    series(`surface, ${mode}`, r => r.kind === 'surface' && r.mode === mode));
  return {
    title: 'Bytes and PSNR against path-traced references, means over the scenes', x_title: 'kB', y_title: 'PSNR, dB',
    series: [...chord, ...formats, ...shapes, front, ...surface].filter(s => s.points.length)};
}

const rows = meansOf(readRows(readCosts()));
markFront(rows);
process.stdout.write(style === '--plot' ? JSON.stringify(plot(rows)) + '\n' : page(rows));
