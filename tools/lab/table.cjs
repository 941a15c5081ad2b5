// SPDX-License-Identifier: MIT
// node table.cjs SCENE.report.json SCENE.others.json SCENE.ring.json ... --markdown|--json
// Rows of the quality benchmark: fields, what is of the same size as one of them, both on a turntable; for people or for
// programs, on stdout. What the bench counted of a field's frames lies beside the field, in FIELD.bench.json.
// node table.cjs --into PAGE.md TABLE.md
// Puts a table between the page's two marker comments.
'use strict';
const fs = require('fs');
const path = require('path');

const BEGIN = '<!-- quality table: begin (tools/lab/bench_quality.sh) -->';
const END = '<!-- quality table: end -->';
const MODES = {surface: '2x2', antialiased: 'antialiased', 'one sample': 'one-sample'};  // by what a row shows
const ORDER = ['surface', 'antialiased', 'one sample', 'mean alone', 'chord', 'sprites', 'JPEG sprites', 'one ray'];
const MOST_BELOW_MEAN_DB = 2;  // of the worst view

const readJson = file => JSON.parse(fs.readFileSync(file, 'utf8'));

// Of a frame of this file in RGB565; null where it was not counted.
function instructions(m, core) {
  const counts = m.name + '.bench.json';
  if (!MODES[m.layout] || !fs.existsSync(counts)) return null;
  const row = readJson(counts).find(r => r.core === core && r.mode === MODES[m.layout] && r.pixel === 'rgb565');
  return row ? Math.round(row.instructions_per_pixel) : null;
}

function rowsOf(report) {
  const ring = report.view_set === 'ring';
  const others = [...report.baselines, ...(report.one_ray ? [report.one_ray] : [])];
  const all = others.length && !ring ? others : [...report.fields, ...report.variants, ...others];
  return all.map(({name, sections, views, ...m}) => ({
    scene: path.parse(report.scene).name, views: report.view_set, reference_samples: report.reference_samples, ...m,
    instructions_per_pixel: ring ? null : instructions({name, ...m}, 'm4'),
    instructions_per_pixel_m0plus: ring ? null : instructions({name, ...m}, 'm0plus')
  })).sort((a, b) => ORDER.indexOf(a.layout) - ORDER.indexOf(b.layout) || a.flash_bytes - b.flash_bytes);
}

const flashText = bytes => bytes === 0 ? '–' : bytes >= 1e6 ? (bytes / 1e6).toFixed(2) + ' MB' : Math.round(bytes / 1e3) + ' kB';
const orDash = value => value === null || value === undefined ? '–' : String(value);
const blockText = b => `${b.psnr_db.toFixed(1)} (${b.view + 1}: ${b.x}, ${b.y})`;
const viewText = v => `${v.psnr_db.toFixed(1)} (${v.view + 1})`;

const line = r => '| ' + [
  r.scene, r.layout + (r.views === 'ring' ? ', turntable' : ''), flashText(r.flash_bytes), orDash(r.triangles),
  r.psnr_db.toFixed(2), r.ssim.toFixed(4), r.cw_ssim.toFixed(4), r.flip.toFixed(4), r.mask_psnr_db.toFixed(2),
  viewText(r.worst_view), blockText(r.worst_block),
  `${orDash(r.instructions_per_pixel)} · ${orDash(r.instructions_per_pixel_m0plus)}`
].join(' | ') + ' |';

function markdown(rows) {
  const samples = set => rows.find(r => r.views === set)?.reference_samples;
  const low = rows.filter(r => r.layout in MODES && r.worst_view.psnr_db < r.psnr_db - MOST_BELOW_MEAN_DB);
  const named = r => `${r.scene}, ${r.layout}, ${flashText(r.flash_bytes)} (${(r.worst_view.psnr_db - r.psnr_db).toFixed(1)} dB)`;
  return [
    '| scene | layout | flash | triangles | PSNR dB | SSIM | CW-SSIM | FLIP | mask PSNR | worst view | worst block | instructions a pixel, M4 · M0+ |',
    '|---|---|---|---|---|---|---|---|---|---|---|---|',
    ...rows.map(line), '',
    `Means over 12 views of 240×240; references with ${samples('all')} light paths a pixel, on the turntable ` +
    `${samples('ring')}. Beside the worst view stands its number, beside the worst block of 16×16 pixels view, x and y.`,
    `Rows whose worst view lies more than ${MOST_BELOW_MEAN_DB} dB below the mean: ` +
    (low.length ? low.map(named).join('; ') : 'none') + '.', ''
  ].join('\n');
}

function putInto(page, table) {
  const text = fs.readFileSync(page, 'utf8');
  const begin = text.indexOf(BEGIN), end = text.indexOf(END);
  if (begin < 0 || end < begin) throw new Error(`${page} has lost the table's markers: put back "${BEGIN}" and "${END}"`);
  const content = fs.readFileSync(table, 'utf8').trim();
  fs.writeFileSync(page, text.slice(0, begin + BEGIN.length) + '\n' + content + '\n' + text.slice(end));
}

const words = process.argv.slice(2);
if (words[0] === '--into') {
  putInto(words[1], words[2]);
} else {
  const style = words.pop(), rows = words.map(readJson).flatMap(rowsOf);
  process.stdout.write(style === '--json' ? JSON.stringify(rows, null, 1) + '\n' : markdown(rows));
}
