// SPDX-License-Identifier: MIT
// node paper.cjs FOLDER TRADEOFF.md
// What tools/lab/paper.sh left in FOLDER, as a page on stdout. What a Cortex-M4 does is from the page TRADEOFF.md.
'use strict';
const fs = require('fs');
const path = require('path');

const [folder, tradeoff] = process.argv.slice(2);
const PAPER_SPP = 1024;  // light paths a pixel of the paper's references

const read = name => fs.readFileSync(path.join(folder, name), 'utf8');
const table = (head, rows) =>
  [head, head.map((_, k) => k ? '---:' : '---'), ...rows].map(row => '| ' + row.join(' | ') + ' |').join('\n');
const cells = line => line.split('|').slice(1, -1).map(cell => cell.trim());
const bytesText = bytes => bytes >= 1e6 ? (bytes / 1e6).toFixed(1) + ' MB' : Math.round(bytes / 1e3) + ' kB';

const scenes = fs.readdirSync(folder).filter(name => name.endsWith('.draw.json')).map(name => name.split('.')[0]).sort();
const data = scenes.map(scene => ({
  scene, bake: JSON.parse(read(scene + '.bake.json')), report: JSON.parse(read(scene + '.report.json')),
  draw: JSON.parse(read(scene + '.draw.json')), background: JSON.parse(read(scene + '.background.json')),
  reference_s: Number(read(scene + '.reference_s'))}));

const modeText = word => {
  const [mode, span] = word.split('/');
  const name = {nearest: 'nearest', linear: '3×3 (ours)'}[mode] || mode.replace('paper', '') + '×' + mode.replace('paper', '');
  return name + (span ? `, spans of ${span}` : '');
};

const mean = values => values.reduce((sum, v) => sum + v, 0) / values.length;

// Every ray of such a view enters through the upper half of the sphere.
const withinHalf = view => view.elevation_deg >= Math.acos(1 / view.distance) * 180 / Math.PI;
const countWithin = report => report.views.filter(withinHalf).length;

function likenessRows({scene, report}) {
  const of = (m, key, keep) => mean(m.views.filter((_, k) => keep(report.views[k])).map(v => v[key]));
  const figures = m => [['psnr_db', 2], ['ssim', 3], ['cw_ssim', 3], ['flip', 3]].map(([key, digits]) =>
    [withinHalf, () => true].map(keep => of(m, key, keep).toFixed(digits)).join(' / '));
  const chord = report.variants.filter(v => /^(nearest|linear|paper)/.test(v.layout));
  const surface = report.fields[1];
  return [
    ...chord.map(v => [scene, 'chord, ' + modeText(v.layout), bytesText(v.flash_bytes), ...figures(v)]),
    [scene, 'surface field, 2×2 samples', bytesText(surface.flash_bytes), ...figures(surface)]];
}

function backgroundRows({scene, background}) {
  return background.map(b => [
    scene, b.share, b.PSNR.toFixed(2), b.SSIM.toFixed(3), b['CW-SSIM'].toFixed(3), b.FLIP.toFixed(3)]);
}

function timeRows({scene, report, reference_s}) {
  const chord = report.variants.filter(v => ['nearest', 'paper5', 'paper9', 'paper5/8'].includes(v.layout));
  return chord.map(v => [
    scene, modeText(v.layout), reference_s.toFixed(1), (v.draw_ms / 1e3).toFixed(3),
    Math.round(reference_s * 1e3 / v.draw_ms),
    Math.round(reference_s * 1e3 * PAPER_SPP / report.reference_samples / v.draw_ms)]);
}

function eyeRows({scene, draw}) {
  return draw.map(r => [
    scene, modeText(r.mode + (r.span ? '/' + r.span : '')), (1e3 / r.frame_ms).toFixed(2), (5e2 / r.frame_ms).toFixed(2),
    r.unread_frame_ms ? Math.round(100 * (1 - r.unread_frame_ms / r.frame_ms)) + ' %' : '–']);
}

// Share of the time in texel reads on an STM32F407, from what `lumi bench` counted and its model of that part.
function m4Rows() {
  const lines = fs.readFileSync(tradeoff, 'utf8').split('\n');
  const part = cells(lines.find(line => line.startsWith('| STM32F407 | m4')));
  const [, , mhz, clocks, , ns] = part.map(cell => parseFloat(cell));
  const head = lines.findIndex(line => line.startsWith('| renderer, S = 16 | RP2040'));
  const costs = lines.findIndex(line => line.startsWith('| renderer | m0plus exact'));
  const column = cells(lines[costs]).indexOf('m4 S16'), stm = cells(lines[head]).findIndex(cell => cell.startsWith('STM32F407'));
  const row = (from, name) => cells(lines.slice(from).find(line => line.startsWith(`| ${name} |`)));
  return ['nearest rgb565', 'linear rgb565', 'paper rgb565'].map(name => {
    const misses = Number(row(head, name)[stm].split(',')[1]), instructions = Number(row(costs, name)[column]) * 42272;
    const reading = misses * ns * 1e-9, computing = instructions * clocks / (mhz * 1e6);
    return [name, (1e3 * computing).toFixed(1), (1e3 * reading).toFixed(1), Math.round(100 * reading / (reading + computing)) + ' %'];
  });
}

// A network that maps both hits of a ray to a colour: two hidden layers, one 16-bit product a clock cycle and weight.
// An estimate: nothing of it is built.
function networkEstimate() {
  const inputs = 6, hidden = 32, outputs = 3, pixels = 42272, hz = 168e6;
  const products = inputs * hidden + hidden * hidden + hidden * outputs;
  return {hidden, products, fps: (hz / (products * pixels)).toFixed(1)};
}

// Pixels between neighbours of 12,288 points on a sphere of 240 pixels, each with an equal area to itself.
const nearPoints = (120 * Math.sqrt(4 * Math.PI / 12288)).toFixed(1);
const network = networkEstimate();
const minutes = d => Math.round(d.bake.processor_s / 60);
const bakes = data.map(d => `${d.scene}: ${d.bake.spp} light path${d.bake.spp === 1 ? '' : 's'} a ray, ${minutes(d)} minutes`);
const first = data[0];
process.stdout.write(`# The paper's evaluation, at its size

\`tools/lab/paper.sh --docs --minutes ${first.bake.minutes}\` measures everything anew and writes this page.

**Configuration.** The paper counts 0.5 · 12288 · 23576 · 4 bytes: M = 12,288 origins, of which the upper half is kept. With
N = 23,576 that is 552.6 MiB, with N = 24,576 exactly the 576 MiB that it states, so 23,576 is probably a slip. Baked as
\`--origins 12288 --cap 50% --directions 24576 --texel rgb565 --beam ${first.bake.beam}\`: two bytes a texel where the paper has four.
${bakes.join('; ')}.
Paths are the most that a ray gets (from 16 on fewer where the mean is known well enough), minutes those of one core, ${data.reduce((sum, d) => sum + minutes(d), 0)} together.

## Likeness

${first.report.views.length} held-out views of the upper half, 240 × 240 pixels, references of ${first.report.reference_samples} light paths a pixel; 8-bit RGB. The upper
half of the origins shows an object whole only to eyes whose rays all enter there, from the elevation acos(1/distance) up; to
others its lower part is missing. So: the mean where that holds (views: ${countWithin(first.report)}) / of all.

${table(['scene', 'drawn', 'flash', 'PSNR dB', 'SSIM', 'CW-SSIM', 'FLIP'], [
  ['the paper, its scenes, as printed', '5×5', '576 MB', '–', '0.975', '0.998', '–'],
  ['the paper, with its filter', '5×5', '576 MB', '–', '0.972', '0.997', '–'],
  ...data.flatMap(likenessRows)])}

Spans reach this size: they end at 65,536 points a lattice. By spans the kernel has at most five points a side.

The paper does not say how much of its pictures is background. One view of 1268 × 720 pixels, the eye 6 radii away, drawn with
5×5:

${table(['scene', 'the sphere fills of the height', 'PSNR dB', 'SSIM', 'CW-SSIM', 'FLIP'], data.flatMap(backgroundRows))}

## A reference against a drawing

Processor seconds of one core for one view of 240 × 240 pixels.

${table(['scene', 'drawn', `reference of ${first.report.reference_samples} paths, s`, 'drawing, s', 'times faster', `scaled to the paper's ${PAPER_SPP} paths`],
  data.flatMap(timeRows))}

## Two eyes

1268 × 720 pixels an eye, the sphere filling the height, one core of this machine, no GPU. The paper: 5.2 to 9.1 frames a
second for both eyes on a HoloLens, 33 % of the time in texture reads. Texel reads: what a frame gains if every texel is made
of its address in place of read; a few per cent either way are noise.

${table(['scene', 'drawn', 'frames/s, one eye', 'frames/s, two eyes', 'texel reads'], data.flatMap(eyeRows))}

On an STM32F407 (Cortex-M4), 240 × 240 pixels, spans of 16, a field of 1024 × 2048, in the model of
[tradeoff.md](tradeoff.md#frame-rates-of-named-parts-modelled):

${table(['drawn', 'computing, ms', 'waiting for flash, ms', 'share'], m4Rows())}

## Where ours and theirs differ

- **Light paths.** As many as the time allowed. What noise they leave counts in full in PSNR and SSIM.
- **Scenes and views.** Ours are the project's. SSIM depends on how much of a picture is background (the table above): a
  smaller object scores higher.
- **Resolution.** ${nearPoints} pixels lie between neighbouring origins of this lattice where the sphere fills 240 pixels. Patterns
  finer than that blur.
- **CW-SSIM.** 16 orientations and up to 6 levels, as many as a picture has room for; the paper has 8 levels. K and windows
  are those of Sampat et al.
- **Kernel.** The radius is the paper's, r² = 4π/n; that weights fall off as (1 − d²/r²)² is ours. That radius holds five
  points at most, so K above 5 changes nothing.
- **Beam.** The paper names a direction for each texel, read as a parallel beam. Converging rays show more
  ([measured](baker.md#footprint)) and are the default of \`lumi bake\`.
- **Machine.** A processor core draws here, the HoloLens's GPU there.

## What the paper names as future work

- **Parallax correction**: surface fields look radiance up where a ray meets the object; their rows stand above.
- **Volumes**: [scenes.md](../scenes.md).
- **Sampling that is not uniform**: measured and left out. Heights of the points warped by error, or by the object's
  shape, gain 0.4 to 1.3 dB at equal flash, and 1 dB on one scene of four ([table](chord.md#non-uniform-sampling)).
- **A network that reads the field**, estimated, not built: two hidden layers of ${network.hidden} units from both hits to a colour are ${network.products}
  products a pixel; at one a clock a Cortex-M4 of 168 MHz draws 42,272 pixels ${network.fps} times a second, before it has read a weight
  from flash.
`);
