// SPDX-License-Identifier: MIT
// node table.cjs BENCH.json REPORT.json... --markdown|--json
// Rows of the quality benchmark, for people or for programs, on stdout.
// node table.cjs --into PAGE.md TABLE.md
// Puts a table between the page's two marker comments.
'use strict';
const fs = require('fs');
const path = require('path');

const BEGIN = '<!-- quality table: begin (tools/bench_quality.sh) -->';
const END = '<!-- quality table: end -->';

const readJson = file => JSON.parse(fs.readFileSync(file, 'utf8'));

// What a layout's usual mode costs, on the generic view of the bench's own scene; null where it was not counted.
function instructions(bench, layout, core) {
  const wanted = {
    surface: {mode: '2x2'},
    chord: {mode: 'linear', texel: 'rgb565', span: 16}
  }[layout];
  const row = wanted && bench.find(r => r.core === core && r.view === 'generic' &&
                                        Object.entries(wanted).every(([key, value]) => r[key] === value));
  return row ? Math.round(row.instructions_per_pixel) : null;
}

function rowOf(scene, bench, m) {
  const {layout, flash_bytes, psnr_db, ssim, cw_ssim, flip, mask_psnr_db, mask_ssim} = m;
  return {
    scene, flash_bytes, layout, psnr_db, ssim, cw_ssim, flip, mask_psnr_db, mask_ssim,
    instructions_per_pixel: instructions(bench, layout, 'm4'),
    instructions_per_pixel_m0plus: instructions(bench, layout, 'm0plus')
  };
}

function rowsOf(bench, report) {
  const scene = path.parse(report.scene).name;
  const all = [...report.fields, ...report.baselines, ...(report.one_ray ? [report.one_ray] : [])];
  return all.map(m => rowOf(scene, bench, m))
      .sort((a, b) => a.layout.localeCompare(b.layout) || a.flash_bytes - b.flash_bytes);
}

const flashText = bytes => bytes === 0 ? '–' : bytes >= 1e6 ? (bytes / 1e6).toFixed(2) + ' MB' : Math.round(bytes / 1e3) + ' kB';
const orDash = value => value === null ? '–' : String(value);

function markdown(rows, samples) {
  const lines = [
    '| scene | layout | flash | PSNR dB | SSIM | CW-SSIM | FLIP | mask PSNR | mask SSIM | instructions a pixel, M4 · M0+ |',
    '|---|---|---|---|---|---|---|---|---|---|'
  ];
  for (const r of rows)
    lines.push(`| ${r.scene} | ${r.layout} | ${flashText(r.flash_bytes)} | ${r.psnr_db.toFixed(2)} | ${r.ssim.toFixed(4)} | ` +
               `${r.cw_ssim.toFixed(4)} | ${r.flip.toFixed(4)} | ${r.mask_psnr_db.toFixed(2)} | ${r.mask_ssim.toFixed(4)} | ` +
               `${orDash(r.instructions_per_pixel)} · ${orDash(r.instructions_per_pixel_m0plus)} |`);
  return [...lines, '', `Means over 12 views of 240×240; references with ${samples} light paths a pixel.`, ''].join('\n');
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
  const style = words.pop(), bench = readJson(words.shift()), reports = words.map(readJson);
  const rows = reports.flatMap(report => rowsOf(bench, report));
  if (style === '--json')
    process.stdout.write(JSON.stringify(rows, null, 1) + '\n');
  else
    process.stdout.write(markdown(rows, reports[0].reference_samples));
}
