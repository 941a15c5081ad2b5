// SPDX-License-Identifier: MIT
// A page of `lumi view`, read as a browser would: its texts, and the module that it runs, with its field open.
import fs from 'node:fs';
import zlib from 'node:zlib';

// The content of <script id="ID">.
function scriptOf(html, id) {
  return html.match(new RegExp(`<script[^>]* id="${id}">([^<]*)</script>`))[1];
}

export async function openPage(path) {
  const html = fs.readFileSync(path, 'utf8');
  const data = JSON.parse(scriptOf(html, 'data'));
  const field = Buffer.from(scriptOf(html, 'field'), 'base64');
  const code = zlib.gunzipSync(Buffer.from(scriptOf(html, 'module'), 'base64'));
  const {instance} = await WebAssembly.instantiate(code);
  const module = instance.exports, address = module.field_memory(field.length);
  new Uint8Array(module.memory.buffer, address, field.length).set(field);
  return {html, data, module, code, field, error: module.open_field()};
}

// Red, green and blue of a frame from where the module's eye is.
export function drawn(module, width, height, mode, format, background) {
  const address = module.set_screen(width, height);
  const error = module.draw_frame(mode, format, background);
  if (error) throw new Error(`draw_frame gives ${error}`);
  const rgba = Buffer.from(module.memory.buffer, address, 4 * width * height);
  return Buffer.from(rgba.filter((_, k) => k % 4 !== 3));
}
