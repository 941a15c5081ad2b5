
// The page's settings. What fingers, mouse and keys say goes to the turner (turner.js), which draws.

const data = JSON.parse(document.getElementById('data').textContent);
const $ = id => document.getElementById(id);
const canvas = $('picture');
const turner = new Turner(canvas, {alpha: false});

const FORMATS = [  // by the module's numbers
  {name: 'RGB565', bits: '16 bits a pixel', number: 1},
  {name: 'RGB888', bits: '24 bits a pixel', number: 0},
  {name: 'Grey', bits: '8 bits a pixel', number: 2},
];
const SCREENS = [
  {name: '240 × 240', width: 240, height: 240},
  {name: '240 × 240, round', width: 240, height: 240, round: true},
  {name: '320 × 240', width: 320, height: 240},
  {name: '128 × 128', width: 128, height: 128},
  {name: '160 × 80', width: 160, height: 80},
  {name: '170 × 320', width: 170, height: 320},
  {name: '466 × 466, round', width: 466, height: 466, round: true},
  {name: '480 × 480', width: 480, height: 480},
  {name: '480 × 320', width: 480, height: 320},
  {name: '800 × 480', width: 800, height: 480},
];
const GRADIENT = 2 ** 24;  // in place of a colour behind the object
const RATED_PIXELS = 240 * 240;
const STILL = matchMedia('(prefers-reduced-motion: reduce)').matches;

const state = {
  mode: data.firstMode, format: 0, screen: 0, chip: 1, paced: false, comparing: false,
  get spinning() { return turner.spins; }, set spinning(spins) { turner.spins = spins; },
  gradient: data.background === 'gradient',
};
let module;  // the module's exports

// ---- Small things

// "123 kB": units of 1000, as the command prints them.
function byteText(bytes) {
  const [value, unit] = bytes < 1e6 ? [bytes / 1e3, 'kB'] : [bytes / 1e6, 'MB'];
  return `${value < 10 ? value.toFixed(2) : value < 100 ? value.toFixed(1) : Math.round(value)} ${unit}`;
}

function say(text) { $('news').textContent = text; }

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

// ---- The module

async function startModule() {
  const field = bytesOf($('field').textContent);
  await turner.open(bytesOf($('module').textContent), field, data.home);
  module = turner.module;
  return field.length;
}

let cost = 0;  // milliseconds a frame, the mean of the last ones

function drawFrame() {
  const begin = performance.now();
  turner.draw(data.modes[state.mode].number, FORMATS[state.format].number,
    state.gradient ? GRADIENT : parseInt($('background').value.slice(1), 16));
  const took = performance.now() - begin;
  cost = cost ? 0.9 * cost + 0.1 * took : took;
}

// ---- Parts that move

// What a clock's hands show, in degrees from twelve o'clock.
const HANDS = [
  [/second/i, time => 6 * time.getSeconds()],
  [/minute/i, time => 6 * time.getMinutes() + time.getSeconds() / 10],
  [/hour/i, time => 30 * time.getHours() + time.getMinutes() / 2],
];
const handOf = part => part.slides ? undefined : HANDS.find(([name]) => name.test(part.name));
let shownSecond = -1;

function movePart(k, value) {
  turner.setPart(k, data.parts[k], value);
  $(`part-${k}`).value = value;
}

function buildParts() {
  $('parts').hidden = !data.parts.length;
  const hands = data.parts.filter(handOf);
  data.parts.forEach((part, k) => {
    const slider = element('input', {type: 'range', id: `part-${k}`, min: part.from, max: part.to,
      step: (part.to - part.from) / 720, value: 0});
    slider.addEventListener('input', () => { $('time').checked = false; movePart(k, Number(slider.value)); });
    $('parts').append(element('label', {}, element('span', {textContent: part.name}), slider));
  });
  $('time-row').hidden = !hands.length;
  $('time').checked = hands.length > 1;
}

function showTime() {
  const time = new Date();
  if (!$('time').checked || time.getSeconds() === shownSecond) return;
  shownSecond = time.getSeconds();
  data.parts.forEach((part, k) => { if (handOf(part)) movePart(k, handOf(part)[1](time) % 360); });
}

// Between linear light and #rrggbb (IEC 61966-2-1).
function hexOf(light) {
  const level = v => Math.round(255 * (v > 0.0031308 ? 1.055 * v ** (1 / 2.4) - 0.055 : 12.92 * v));
  return '#' + light.map(v => level(v).toString(16).padStart(2, '0')).join('');
}
function linearOf(hex) {
  const levels = [1, 3, 5].map(at => parseInt(hex.slice(at, at + 2), 16) / 255);
  return levels.map(v => v > 0.04045 ? ((v + 0.055) / 1.055) ** 2.4 : v / 12.92);
}

function buildStates() {
  $('states').hidden = !data.states.length;
  data.states.forEach((state, k) => {
    const input = state.tint
      ? element('input', {type: 'color', value: hexOf(state.weight)})
      : element('input', {type: 'range', min: 0, max: 1, step: 1 / 256, value: 1});
    const weights = () => state.tint ? linearOf(input.value) : Array(3).fill(Number(input.value));
    input.addEventListener('input', () => turner.setState(k, weights()));
    $('states').append(element('label', {}, element('span', {textContent: state.name}), input));
  });
}

// ---- Motion

let lastTick = 0, lastFrame = 0;

// While two pictures are compared, the eye stands where a reference was traced.
function showReference() {
  const count = data.references.length, from = data.home.azimuth;
  const number = Math.round(((module.azimuth() >>> 0) - from + TURN) / TURN * count) % count;
  $('reference').src = 'data:image/png;base64,' + data.references[number];
  return [(from + Math.round(number * TURN / count)) >>> 0, data.home.elevation];
}

function drawCompared() {
  const free = [module.azimuth(), module.elevation()];
  const distance = module.distance();
  module.place_eye(...showReference(), data.home.distance);
  drawFrame();
  showStatus();
  module.place_eye(...free, distance);
}

function drawSeen() {
  drawFrame();
  showStatus();
}

function frameIsDue(now) {
  const rate = isPaced() ? rateOf(data.chips[state.chip]) : 0;
  if (!rate) return true;
  if (now - lastFrame < 1000 / rate - 4) return false;  // 4 ms: ticks come at the display's own rate
  lastFrame = Math.max(lastFrame + 1000 / rate, now - 1000 / rate);
  return true;
}

function tick(now) {
  turner.advance(Math.min(now - lastTick, 250));
  lastTick = now;
  showTime();
  if (turner.isDirty && frameIsDue(now)) {
    if (state.comparing) drawCompared(); else drawSeen();
  }
  requestAnimationFrame(tick);
}

// ---- Settings

function rateOf(chip) {
  const rate = data.modes[state.mode].rates[chip.key];
  return rate ? rate.mean : 0;
}

function rateText(chip) {
  const rate = rateOf(chip);
  return rate ? `${Math.round(rate)} frames a second` : 'not modelled';
}

function screenNow() { return SCREENS[state.screen]; }
function isRated() { return screenNow().width * screenNow().height === RATED_PIXELS; }
function isPaced() { return state.paced && isRated() && rateOf(data.chips[state.chip]) > 0; }

function radios(box, name, items, choose) {
  items.forEach((item, k) => {
    const input = element('input', {type: 'radio', name, value: k});
    input.addEventListener('change', () => choose(k));
    box.append(element('label', {title: item.hint || ''}, input, ...item.parts));
  });
}

function check(name, k) { document.querySelector(`input[name=${name}][value="${k}"]`).checked = true; }

function buildSettings(fieldBytes) {
  radios($('chips'), 'chip', data.chips.map(chip => ({
    hint: `${chip.mhz} MHz, ${chip.remark}`,
    parts: [element('span', {textContent: chip.title}),
      element('span', {className: 'bar', ariaHidden: 'true'}, element('i', {})), element('b', {})],
  })), k => set({chip: k}));
  radios($('modes'), 'mode', data.modes.map(mode => ({parts: [mode.title], hint: mode.remark})), k => set({mode: k}));
  radios($('formats'), 'format', FORMATS.map(f => ({parts: [f.name], hint: f.bits})), k => set({format: k}));
  $('screen').append(...SCREENS.map((s, k) => element('option', {value: k, textContent: s.name})));
  $('screen').addEventListener('change', event => set({screen: Number(event.target.value)}));
  $('pace').addEventListener('change', event => set({paced: event.target.checked}));
  $('compare').addEventListener('change', event => set({comparing: event.target.checked}));
  $('background').value = state.gradient ? '#000000' : data.background;
  $('background').addEventListener('input', () => set({gradient: false}));
  $('gradient').addEventListener('change', event => set({gradient: event.target.checked}));
  $('compare-row').hidden = !data.references.length;
  const kind = data.layout === 'surface' ? 'surface field' : 'chord field';
  $('facts').textContent = `A ${kind} of ${byteText(fieldBytes)}, drawn here by the same integer code as on the chip.`;
  $('flash-text').textContent = `${byteText(fieldBytes)} for the field`;
}

function set(changes) {
  Object.assign(state, changes);
  if ('screen' in changes || 'comparing' in changes) fitScreen();
  showSettings();
  turner.isDirty = true;
  cost = 0;
}

function showRates() {
  const fastest = Math.max(30, ...data.chips.flatMap(chip =>
    data.modes.map(mode => mode.rates[chip.key] ? mode.rates[chip.key].mean : 0)));
  data.chips.forEach((chip, k) => {
    const row = $('chips').querySelectorAll('label')[k], rate = rateOf(chip);
    row.querySelector('b').textContent = rate ? Math.round(rate) : '—';
    row.querySelector('input').ariaLabel = `${chip.title}, ${rateText(chip)}`;
    row.querySelector('i').style.width = `${100 * rate / fastest}%`;
  });
}

function showRam() {
  const chip = data.chips[state.chip];
  const ram = module.device_ram(data.modes[state.mode].number, FORMATS[state.format].number);
  $('ram').max = chip.ram;
  $('ram').value = Math.min(ram, chip.ram);
  $('ram-text').textContent = `${byteText(ram)} of ${byteText(chip.ram)}`;
  $('ram-text').className = ram > chip.ram ? 'bad' : '';
}

function showSettings() {
  check('chip', state.chip);
  check('mode', state.mode);
  check('format', state.format);
  $('screen').value = state.screen;
  $('pace').checked = state.paced;
  $('pace').disabled = !isRated() || !rateOf(data.chips[state.chip]);
  $('compare').checked = state.comparing;
  $('gradient').checked = state.gradient;
  $('screen').disabled = state.comparing;
  $('truth').hidden = !state.comparing;
  $('mode-remark').textContent = data.modes[state.mode].remark;
  showRates();
  showRam();
}

function showStatus() {
  const {azimuth, elevation} = turner.seenFrom();
  $('status').textContent = `Seen from ${azimuth}°, ${elevation}° up. ` +
    `This browser draws a frame in ${cost.toFixed(1)} ms.`;
  canvas.setAttribute('aria-label', `${data.title}, seen from ${azimuth} degrees around, ${elevation} degrees up`);
}

// ---- Layout

// As large as the stage lets it, in whole pixels of the display where that is not much smaller.
function fitScreen() {
  const compared = state.comparing && $('reference').naturalWidth;
  const size = compared ? {width: $('reference').naturalWidth, height: $('reference').naturalHeight} : screenNow();
  turner.useScreen(size.width, size.height);
  layOut();
}

function layOut() {
  const stage = document.querySelector('.stage'), isLow = innerHeight <= 520;
  const isPhone = matchMedia('(max-width: 860px) and (orientation: portrait)').matches;
  const bezel = isPhone || isLow ? 8 : 14, panes = state.comparing ? 2 : 1;
  const width = (stage.clientWidth - (isPhone ? 32 : 48)) / panes - 2 * bezel - (panes - 1) * 12;
  const height = (isPhone ? innerHeight * 0.52 : stage.clientHeight - (isLow ? 28 : 140)) - 2 * bezel;
  const ratio = devicePixelRatio || 1;
  let scale = Math.min(width / canvas.width, height / canvas.height, 720 / Math.max(canvas.width, canvas.height));
  const whole = Math.floor(scale * ratio) / ratio;
  if (whole > 0.8 * scale) scale = whole;
  const isRound = !state.comparing && screenNow().round;
  for (const figure of [$('device'), $('truth')]) {
    figure.style.setProperty('--bezel', `${bezel}px`);
    figure.classList.toggle('round', Boolean(isRound));
    const picture = figure.querySelector('canvas, img');
    picture.style.width = `${canvas.width * scale + 2 * bezel}px`;
    picture.style.height = `${canvas.height * scale + 2 * bezel}px`;
  }
  canvas.style.imageRendering = scale * ratio >= 4 ? 'pixelated' : '';
  turner.isDirty = true;
}

// ---- Keys

function next(name, count) { set({[name]: (state[name] + 1) % count}); }

function onLetter(key) {
  if (/^[1-9]$/.test(key) && data.modes[key - 1]) set({mode: key - 1});
  else if (key === 'm') next('mode', data.modes.length);
  else if (key === 'p') next('format', FORMATS.length);
  else if (key === 's' && !state.comparing) next('screen', SCREENS.length);
  else if (key === 'c') next('chip', data.chips.length);
  else if (key === 'v') set({paced: !state.paced});
  else if (key === 'b') set({gradient: !state.gradient});
  else if (key === 't' && data.references.length) set({comparing: !state.comparing});
  else if (key === '0') turner.goHome();
  else if (key === '+' || key === '=') turner.zoom(0.85);
  else if (key === '-') turner.zoom(1 / 0.85);
  else return;
  say(`${data.modes[state.mode].title}, ${FORMATS[state.format].name}, ${screenNow().name}, ` +
    `${data.chips[state.chip].title}: ${rateText(data.chips[state.chip])}`);
}

function onKeyDown(event) {
  const isControl = event.target.matches('input, select, summary');
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (ARROWS[event.key] && !isControl) {
    turner.hold(event.key);
  } else if (event.key === ' ' && !isControl) {
    state.spinning = !state.spinning;
  } else {
    if (!event.target.matches('select')) onLetter(event.key.toLowerCase());
    return;
  }
  event.preventDefault();
}

// ---- Begin

function listen() {
  turner.onTouch = () => { $('hint').style.visibility = 'hidden'; };
  turner.listen();
  addEventListener('keydown', onKeyDown);
  addEventListener('keyup', event => turner.held.delete(event.key));
  addEventListener('blur', () => turner.held.clear());
  addEventListener('resize', layOut);
  $('reference').addEventListener('load', () => { if (canvas.width !== $('reference').naturalWidth) fitScreen(); });
}

async function start() {
  try {
    const fieldBytes = await startModule();
    state.spinning = !STILL;
    buildSettings(fieldBytes);
    buildParts();
    buildStates();
    listen();
    fitScreen();
    showSettings();
    requestAnimationFrame(now => { lastTick = now; tick(now); });
  } catch (error) {
    document.querySelector('main').replaceChildren(
      element('p', {className: 'failed', textContent: `${data.title} cannot be shown: ${error.message}.`}));
  }
}

start();
