
// <lumi-view src="clock.lumi" spin>: an object that people turn, drawn by the code that firmware links.
const MODULE = '{{module}}';
const MODES = ['one-sample', 'antialiased', '2x2'];
const MOST_PIXELS = 800;  // a side
const SHADOW = `<style>
:host { display: inline-block; width: 240px; height: 240px; }
:host([hidden]) { display: none; }
canvas { display: block; width: 100%; height: 100%; cursor: grab; touch-action: none; outline-offset: 2px; }
canvas:active { cursor: grabbing; }
</style><canvas part="picture" tabindex="0" role="application" aria-roledescription="object that you can turn"></canvas>`;
const still = matchMedia('(prefers-reduced-motion: reduce)');

export class LumiView extends HTMLElement {
  static observedAttributes = ['src', 'spin', 'mode', 'orbit', 'parts', 'alt'];
  #turner; #parts = []; #last = 0; #request = 0; #label = ''; #loads = 0; #wasMoving = false;

  constructor() {
    super();
    this.attachShadow({mode: 'open'}).innerHTML = SHADOW;
    const canvas = this.shadowRoot.querySelector('canvas');
    this.#turner = new Turner(canvas, {});
    this.#turner.listen();
    canvas.addEventListener('keydown', event => this.#onKey(event));
    canvas.addEventListener('keyup', event => this.#turner.held.delete(event.key));
    canvas.addEventListener('blur', () => this.#turner.held.clear());
    new ResizeObserver(() => this.#fit()).observe(this);
    still.addEventListener('change', () => this.#spin());
  }

  connectedCallback() { this.#request ||= requestAnimationFrame(now => this.#tick(now)); }

  disconnectedCallback() {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
  }

  attributeChangedCallback(name) {
    if (name === 'src') this.#load();
    else if (name === 'spin') this.#spin();
    else if (name === 'orbit') this.goHome();
    else if (name === 'parts') this.#setParts();
    this.#turner.isDirty = true;
    this.#label = '';
  }

  // Names of the parts that move.
  get parts() { return this.#parts.map(part => part.name); }

  // Degrees, or radii of a part that slides.
  setPart(name, value) {
    const k = this.#parts.findIndex(part => part.name === name);
    if (k < 0) throw new RangeError(`no part moves by the name ${name}: ${this.parts.join(', ') || 'none does'}`);
    this.#turner.setPart(k, this.#parts[k], value);
  }

  goHome() {
    if (!this.#turner.module) return;
    const home = this.#home();
    this.#turner.module.set_home(home.azimuth, home.elevation, home.distance);
    this.#fit();
  }

  #home() {
    const given = (this.getAttribute('orbit') ?? '').split(',').map(Number);
    const [azimuth, elevation, distance] = given.length === 3 && given.every(Number.isFinite) ? given : [30, 20, 3];
    return {azimuth: Math.round(azimuth * TURN / 360) | 0, elevation: Math.round(elevation * TURN / 360) | 0,
      distance: Math.round(distance * 2 ** 20)};
  }

  #tell(type, detail) { this.dispatchEvent(new CustomEvent(type, {detail})); }

  async #load() {
    const load = ++this.#loads, src = this.getAttribute('src');
    this.#turner.module = undefined;
    if (!src) return;
    try {
      const answer = await fetch(src);
      if (!answer.ok) throw new Error(`${src}: ${answer.status} ${answer.statusText}`);
      const field = new Uint8Array(await answer.arrayBuffer());
      if (load !== this.#loads) return;
      await this.#turner.open(bytesOf(MODULE), field, this.#home());
      if (load !== this.#loads) return this.#load();
      this.#findParts();
      this.#setParts();
      this.#fit();
      this.#spin();
      this.#tell('load', {bytes: field.length});
    } catch (error) {
      if (load !== this.#loads) return;
      this.#turner.module = undefined;
      this.#canvas.setAttribute('aria-label', `${this.#name()} cannot be shown`);
      this.#tell('error', {message: error.message});
    }
  }

  get #canvas() { return this.#turner.canvas; }

  #name() { return this.getAttribute('alt') || 'object'; }

  #findParts() {
    const {module} = this.#turner;
    this.#parts = [];
    for (let k = 0; module.part_name_bytes(k) > 0; ++k)
      this.#parts.push({slides: module.part_slides(k) !== 0, name: new TextDecoder().decode(
        new Uint8Array(module.memory.buffer, module.part_name(k), module.part_name_bytes(k)))});
  }

  // parts="second_hand=90 knob=10"
  #setParts() {
    const values = Object.fromEntries((this.getAttribute('parts') ?? '').split(/\s+/).map(word => word.split('=')));
    this.#parts.forEach((part, k) => this.#turner.setPart(k, part, Number(values[part.name]) || 0));
  }

  #spin() { this.#turner.spins = this.hasAttribute('spin') && !still.matches; }

  #fit() {
    const {clientWidth: width, clientHeight: height} = this;
    if (!this.#turner.module || !width || !height) return;
    const scale = Math.min(devicePixelRatio || 1, MOST_PIXELS / Math.max(width, height));
    this.#turner.useScreen(Math.max(1, Math.round(width * scale)), Math.max(1, Math.round(height * scale)));
  }

  #onKey(event) {
    const turner = this.#turner;
    if (event.ctrlKey || event.metaKey || event.altKey || !turner.module) return;
    if (ARROWS[event.key]) turner.hold(event.key);
    else if (event.key === ' ') turner.spins = !turner.spins;
    else if (event.key === '0' || event.key === 'Home') turner.goHome();
    else if (event.key === '+' || event.key === '=') turner.zoom(0.85);
    else if (event.key === '-') turner.zoom(1 / 0.85);
    else return;
    event.preventDefault();
  }

  #tick(now) {
    this.#request = requestAnimationFrame(next => this.#tick(next));
    const turner = this.#turner, elapsed = Math.min(now - this.#last, 250);
    this.#last = now;
    if (!turner.module || !turner.pixels) return;
    turner.advance(elapsed);
    const moves = turner.isDirty;
    if (moves) {
      turner.draw(Math.max(0, MODES.indexOf(this.getAttribute('mode') ?? 'antialiased')), 0, 0);
      this.#tell('turn', turner.seenFrom());
    }
    if (!moves && (this.#wasMoving || !this.#label)) this.#describe();  // at rest: a reader is not told each frame
    this.#wasMoving = moves;
  }

  #describe() {
    const {azimuth, elevation} = this.#turner.seenFrom();
    this.#label = `${this.#name()}, seen from ${azimuth} degrees around, ${elevation} degrees up`;
    this.#canvas.setAttribute('aria-label', this.#label);
  }
}

if (!customElements.get('lumi-view')) customElements.define('lumi-view', LumiView);
