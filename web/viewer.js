// The planet viewer: a page around `Viewer` of a wasm module. There is one module a backend in pkg/; the page
// chooses the backend and then downloads that one's.
//
// Query:  ?backend=webgl2|webgpu   the one to use; without it the best that works
//         ?scale=1.5               most canvas pixels per CSS pixel (default 2)
//         ?width=320&height=200    a canvas of exactly that many pixels
// Hash:   the view (see state.js)
import {
  ALTITUDE,
  SETTINGS,
  altitudeText,
  clamp,
  climb,
  defaults,
  formatHash,
  modeQuality,
  parseHash,
  queryNumber,
  wrapDegrees,
} from './state.js';

const BACKENDS = ['webgpu', 'webgl2']; // best first
const $ = (id) => document.getElementById(id);
const stage = $('stage');
const controls = $('controls');
const sleep = (ms) => new Promise((done) => setTimeout(done, ms));
const text = (error) => String(error?.message ?? error);

const state = { ...defaults };
let viewer = null; // null while there is none to draw with
let canvas = null;
let options = {}; // from the query
let applied = {}; // the settings `viewer` has taken
let announced = false;

// ---------------------------------------------------------------- messages

/** Show a line on the page and in the console; a line with the same `id` replaces the one before. */
function say(kind, line, { id = line, seconds = 0, button } = {}) {
  console[kind](line);
  dismiss(id);
  const p = document.createElement('p');
  p.className = `message ${kind}`;
  p.dataset.id = id;
  const words = document.createElement('span');
  words.textContent = line;
  p.append(words);
  const add = (label, action) => {
    const b = document.createElement('button');
    b.textContent = label;
    b.addEventListener('click', () => {
      p.remove();
      action?.();
    });
    p.append(b);
  };
  if (button) add(button.label, button.action);
  add('Dismiss');
  $('messages').append(p);
  if (seconds) setTimeout(() => p.remove(), seconds * 1000);
}

function dismiss(id) {
  for (const p of $('messages').querySelectorAll('.message')) if (p.dataset.id === id) p.remove();
}

// ---------------------------------------------------------------- drawing

// Work that holds the renderer across an `await` is queued here; frames wait for it.
let idle = Promise.resolve();
function exclusive(work) {
  const done = idle.then(work);
  idle = done.catch(() => {});
  return done;
}

let frame = null;
/** Draw soon, once, however often this is called before. Resolves when it is drawn. */
function redraw() {
  frame ??= new Promise(requestAnimationFrame).then(() =>
    exclusive(() => {
      frame = null;
      draw();
    }),
  );
  return frame;
}

// What a method of the viewer takes: the settings that name it, in their order.
const GROUPS = [...new Set(SETTINGS.map(({ set }) => set))].map((method) => ({
  method,
  keys: SETTINGS.filter(({ set }) => set === method).map(({ key }) => key),
}));

/** The one group that is no single method. */
function setQuality({ quality, samples, lightSamples, half }) {
  if (quality) viewer.set_quality(quality);
  else viewer.set_samples(samples, lightSamples);
  if (half) viewer.set_render_scale(0.5);
  else if (!quality) viewer.set_render_scale(1);
}

/** Hand the renderer what changed. What it refuses goes back to what it was; returns what it said. */
function apply(wanted = state) {
  const refused = [];
  for (const { method, keys } of GROUPS) {
    if (keys.every((k) => wanted[k] === applied[k])) continue;
    try {
      if (method === 'quality') setQuality(wanted);
      else viewer[method](...keys.map((k) => wanted[k]));
      for (const k of keys) applied[k] = wanted[k];
    } catch (error) {
      refused.push(text(error));
      for (const k of keys) wanted[k] = applied[k] ?? defaults[k];
    }
  }
  return refused;
}

function canvasSize() {
  if (options.width) return [options.width, options.height];
  const ratio = Math.min(devicePixelRatio || 1, options.scale);
  return [
    Math.max(1, Math.round(stage.clientWidth * ratio)),
    Math.max(1, Math.round(stage.clientHeight * ratio)),
  ];
}

function fit() {
  const [w, h] = canvasSize();
  if (applied.width === w && applied.height === h) return;
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== h) canvas.height = h;
  viewer.resize(w, h);
  applied.width = w;
  applied.height = h;
}

let asked = false;
/**
 * What other views call for is made while there is nothing else to do, so that flying there does not stutter.
 */
function makeAhead() {
  if (asked || !viewer) return;
  asked = true;
  (window.requestIdleCallback ?? setTimeout)(() =>
    exclusive(() => {
      asked = false;
      try {
        if (viewer?.warm_up()) makeAhead();
      } catch (error) {
        const lost = viewer.lost();
        if (lost === undefined) console.warn(`Nothing is made ahead: ${text(error)}`);
        else recover(lost);
      }
    }),
  );
}

let lastFrame = -Infinity;
function draw() {
  if (!viewer) return;
  try {
    fit();
    const refused = apply();
    if (refused.length) apply(); // what it took back counts now
    const start = performance.now();
    viewer.render();
    const end = performance.now();
    if (refused.length) say('warn', refused.join('; '), { id: 'refused', seconds: 15 });
    const apart = start - lastFrame;
    lastFrame = start;
    $('read-frame').textContent =
      `${(end - start).toFixed(1)} ms to issue${apart < 500 ? `, ${apart.toFixed(0)} ms apart` : ''}, ` +
      `${canvas.width} × ${canvas.height}`;
  } catch (error) {
    const lost = viewer.lost();
    if (lost === undefined) say('error', `Drawing failed: ${text(error)}`, { id: 'draw' });
    else recover(lost);
    return;
  }
  showState();
  if (!announced) {
    announced = true;
    console.log('Sky renderer initialized');
  }
  makeAhead();
}

// ---------------------------------------------------------------- the renderer's life

function newCanvas() {
  // A canvas keeps the kind of context it was first given, so each try gets its own.
  const fresh = document.createElement('canvas');
  fresh.setAttribute('aria-hidden', 'true');
  canvas?.remove();
  canvas = fresh;
  stage.prepend(fresh);
  [fresh.width, fresh.height] = canvasSize();
}

/** Why a backend cannot work here, as far as can be told without its module. */
async function obstacle(backend) {
  if (backend !== 'webgpu') return undefined;
  if (!navigator.gpu)
    return isSecureContext ? 'this browser has no WebGPU' : 'there is no WebGPU without https';
  try {
    return (await navigator.gpu.requestAdapter()) ? undefined : 'the browser offers no adapter';
  } catch (error) {
    return text(error);
  }
}

const modules = {};
/** The `Viewer` of a backend's module, which is downloaded when it is first asked for. */
function load(backend) {
  modules[backend] ??= import(`./pkg/${backend}/welkin.js`).then(async ({ default: init, Viewer }) => {
    await init();
    return Viewer;
  });
  modules[backend].catch(() => {
    delete modules[backend];
  });
  return modules[backend];
}

/** What the module knows by name, for the lists on the page. */
function fillLists(Viewer) {
  for (const [id, names] of [
    ['mode', Viewer.modes()],
    ['quality', Viewer.qualities()],
  ]) {
    const there = new Set([...$(id).options].map(({ value }) => value));
    for (const name of names) if (!there.has(name)) $(id).add(new Option(name, name));
  }
}

/** Make a renderer with the first of `backends` that works; say which and why. */
async function start(backends, because) {
  const tried = [];
  for (const backend of backends) {
    try {
      const why = await obstacle(backend);
      if (why) throw new Error(why);
      const Viewer = await load(backend);
      fillLists(Viewer);
      newCanvas();
      viewer = await Viewer.create(canvas, backend);
    } catch (error) {
      const why = text(error);
      tried.push(why.includes(backend) ? why : `${backend}: ${why}`);
      continue;
    }
    applied = {};
    // A lost WebGL context also says so itself; the check below covers both backends.
    canvas.addEventListener('webglcontextlost', checkLoss);
    const reason = tried.length ? `not available: ${tried.join('; ')}` : because;
    const line = `Backend ${viewer.backend}: ${reason}`;
    if (tried.length) say('warn', line, { id: 'backend', seconds: 12 });
    else console.info(line);
    console.info(viewer.describe());
    $('read-backend').textContent = viewer.backend;
    $('read-adapter').textContent = viewer.describe();
    $('why').textContent = line;
    dismiss('start');
    draw();
    return true;
  }
  $('read-backend').textContent = 'none';
  $('read-adapter').textContent = '–';
  $('why').textContent = `No backend: ${tried.join('; ')}`;
  throw new Error(tried.join('; '));
}

function firstStart() {
  const { backend } = options;
  const candidates = backend ? [backend] : BACKENDS;
  const because = backend ? `asked for with ?backend=${backend}` : 'the best that works here';
  return exclusive(() => start(candidates, because)).catch((error) => {
    say('error', `No sky can be drawn here. ${text(error)}`, {
      id: 'start',
      button: { label: 'Try again', action: firstStart },
    });
  });
}

function checkLoss() {
  exclusive(() => {
    const lost = viewer?.lost();
    if (lost !== undefined) recover(lost);
  });
}

/** The device or the context is gone: make a new renderer and give it the same view. */
function recover(why) {
  if (!viewer) return;
  const { backend } = viewer;
  viewer.free();
  viewer = null;
  say('warn', `The graphics device was lost (${why}). Starting ${backend} again…`, { id: 'loss' });
  const others = options.backend ? [] : BACKENDS.filter((b) => b !== backend);
  exclusive(async () => {
    let problem;
    for (const wait of [0, 500, 2000]) {
      await sleep(wait);
      try {
        await start([backend], 'started again after the device was lost');
        break;
      } catch (error) {
        problem = error;
      }
    }
    if (!viewer && others.length)
      await start(others, `instead of ${backend}, which would not start again: ${text(problem)}`);
    if (!viewer) throw problem;
    say('info', `Recovered: drawing with ${viewer.backend} again, same view`, { id: 'loss', seconds: 8 });
  }).catch((error) => {
    say('error', `The graphics device was lost and could not be started again. ${text(error)}`, {
      id: 'loss',
      button: { label: 'Try again', action: firstStart },
    });
  });
}

// ---------------------------------------------------------------- controls and readout

const scales = {
  log: { to: Math.log, from: (x) => clamp(Math.exp(x), ALTITUDE.min, ALTITUDE.max) },
  stops: { to: Math.log2, from: (x) => 2 ** x },
};

const element = (name, properties, ...children) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};

/** The control of a setting, in its fieldset, with a label and, for numbers, what it says. */
function addControl({ key, usual, group, label, options, scale, unit = '', min, max, step }) {
  const fieldset = controls.querySelector(`fieldset[data-group="${group}"]`);
  const of = { htmlFor: key };
  let input;
  if (typeof usual === 'boolean') {
    input = element('input', { id: key, type: 'checkbox' });
    let checks = fieldset.querySelector('.checks');
    if (!checks) fieldset.append((checks = element('div', { className: 'checks' })));
    checks.append(element('label', of, input, ` ${label}`));
  } else if (options) {
    input = element(
      'select',
      { id: key },
      ...Object.entries(options).map(([value, words]) => new Option(words, value)),
    );
    fieldset.append(element('label', of, label), input);
  } else {
    const range = { min, max, step };
    if (scale === 'log') for (const end of ['min', 'max']) range[end] = Math.log(range[end]);
    input = element('input', { id: key, type: 'range', ...range });
    const output = element('output', {});
    output.htmlFor.add(key);
    fieldset.append(element('label', of, `${label} `, output), input);
  }
  Object.assign(input.dataset, { key, unit, ...(scale ? { scale } : {}) });
  return input;
}
const inputs = SETTINGS.map(addControl);

function showState() {
  for (const input of inputs) {
    const { key, scale, unit = '' } = input.dataset;
    const value = state[key];
    if (input.type === 'checkbox') {
      input.checked = value;
      continue;
    }
    input.value = scale ? scales[scale].to(value) : value;
    let shown = typeof value === 'number' ? `${Number(value.toFixed(1))}${unit}` : value;
    if (key === 'alt') shown = altitudeText(value);
    if (key === 'exposure')
      shown = `${Math.log2(value) < 0 ? '−' : '+'}${Math.abs(Math.log2(value)).toFixed(1)} stops`;
    const output = controls.querySelector(`output[for="${input.id}"]`);
    if (output) output.textContent = shown;
    if (scale) input.setAttribute('aria-valuetext', shown);
  }
  $('read-altitude').textContent =
    `${altitudeText(state.alt)}, pitch ${state.pitch.toFixed(1)}°, heading ${state.heading.toFixed(1)}°`;
  $('read-sky').textContent =
    `${state.mode}, ${state.quality || 'by samples'} ` +
    `(${viewer.method}${state.half ? ', half resolution' : ''})${state.sky ? '' : ', off'}`;
  showPlan();
  rememberSoon();
}

/** What the view calls for, while somebody looks at the list. */
function showPlan() {
  if (!$('effects').open || !viewer) return;
  const words = viewer.plan();
  const rows = [];
  for (let i = 0; i < words.length; i += 3) {
    const [name, state, reason] = words.slice(i, i + 3);
    const row = document.createElement('div');
    row.className = state;
    row.append(
      Object.assign(document.createElement('dt'), { textContent: `${name}: ${state}` }),
      Object.assign(document.createElement('dd'), { textContent: reason }),
    );
    rows.push(row);
  }
  $('plan').replaceChildren(...rows);
}
$('effects').addEventListener('toggle', showPlan);

controls.addEventListener('submit', (event) => event.preventDefault());
controls.addEventListener('input', ({ target }) => {
  const { key, scale } = target.dataset;
  if (!key) return;
  if (target.type === 'checkbox') state[key] = target.checked;
  else if (target.type === 'range')
    state[key] = scale ? scales[scale].from(target.valueAsNumber) : target.valueAsNumber;
  else state[key] = target.value;
  if (key === 'mode') state.quality = modeQuality(state.mode);
  if (key === 'samples' || key === 'lightSamples') state.quality = '';
  redraw();
});
$('backend').addEventListener('change', ({ target }) => {
  remember();
  const url = new URL(location.href);
  if (target.value) url.searchParams.set('backend', target.value);
  else url.searchParams.delete('backend');
  location.href = url;
});

// The address keeps the view, so that copying it shares the view.
let rememberTimer = 0;
function remember() {
  clearTimeout(rememberTimer);
  rememberTimer = 0;
  const hash = formatHash(state);
  if (location.hash.replace(/^#/, '') !== hash) {
    history.replaceState(null, '', `${location.pathname}${location.search}${hash ? `#${hash}` : ''}`);
  }
}
function rememberSoon() {
  if (!rememberTimer) rememberTimer = setTimeout(remember, 250);
}
function takeHash() {
  clearTimeout(rememberTimer);
  rememberTimer = 0;
  const { state: read, problems } = parseHash(location.hash);
  Object.assign(state, read);
  for (const line of problems) say('warn', line);
  redraw();
}

// ---------------------------------------------------------------- pointer, wheel, keys

const pointers = new Map();
const spread = () => {
  const [a, b] = [...pointers.values()];
  return Math.hypot(a.x - b.x, a.y - b.y);
};
function look(headingBy, pitchBy) {
  state.heading = wrapDegrees(state.heading + headingBy);
  state.pitch = clamp(state.pitch + pitchBy, -90, 90);
  redraw();
}
stage.addEventListener('pointerdown', (event) => {
  if (event.pointerType === 'mouse' && event.button !== 0) return;
  stage.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  stage.classList.add('dragging');
});
stage.addEventListener('pointermove', (event) => {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  const apart = pointers.size === 2 ? spread() : 0;
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  if (pointers.size === 1) {
    // The point under the finger stays under it, near the middle of the picture.
    const perPixel = state.fov / stage.clientHeight;
    look((before.x - event.clientX) * perPixel, (event.clientY - before.y) * perPixel);
  } else if (pointers.size === 2 && apart > 0 && spread() > 0) {
    state.alt = clamp(state.alt * (apart / spread()) ** 2, ALTITUDE.min, ALTITUDE.max);
    redraw();
  }
});
for (const type of ['pointerup', 'pointercancel', 'lostpointercapture']) {
  stage.addEventListener(type, (event) => {
    pointers.delete(event.pointerId);
    stage.classList.toggle('dragging', pointers.size > 0);
  });
}
stage.addEventListener(
  'wheel',
  (event) => {
    event.preventDefault();
    const pixels = event.deltaY * [1, 16, stage.clientHeight][event.deltaMode];
    state.alt = climb(state.alt, pixels);
    redraw();
  },
  { passive: false },
);
stage.addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const step = event.shiftKey ? 10 : 2;
  const action = {
    ArrowLeft: () => look(-step, 0),
    ArrowRight: () => look(step, 0),
    ArrowUp: () => look(0, step),
    ArrowDown: () => look(0, -step),
    Home: () => look(0, -state.pitch),
    PageUp: () => {
      state.alt = climb(state.alt, 150);
      redraw();
    },
    PageDown: () => {
      state.alt = climb(state.alt, -150);
      redraw();
    },
  }[event.key];
  if (!action) return;
  event.preventDefault();
  action();
});

// ---------------------------------------------------------------- hooks for the console and for tests

function need() {
  if (!viewer) throw new Error('there is no renderer to ask: see the message on the page');
  return viewer;
}

const SCENARIOS = [
  { name: 'Surface looking up', alt: 100, pitch: 90 },
  { name: 'Surface at horizon', alt: 100, pitch: 0 },
  { name: 'High altitude up', alt: 5000, pitch: 90 },
  { name: 'Very high altitude', alt: 15000, pitch: 90 },
];

/** Draw four known views; resolves to the mean radiance of each and whether every pixel was finite. */
window.testSky = () =>
  exclusive(async () => {
    need();
    const results = [];
    try {
      fit();
      for (const { name, alt, pitch } of SCENARIOS) {
        const refused = apply({ ...state, alt, pitch });
        if (refused.length) throw new Error(refused.join('; '));
        viewer.render();
        const pixels = await viewer.read_pixels();
        const mean = [0, 0, 0];
        let finite = pixels.length > 0;
        for (let i = 0; i < pixels.length; i += 4) {
          for (let c = 0; c < 4; c++) finite &&= Number.isFinite(pixels[i + c]);
          for (let c = 0; c < 3; c++) mean[c] += pixels[i + c];
        }
        for (let c = 0; c < 3; c++) mean[c] /= pixels.length / 4;
        results.push({ name, alt, pitch, mean, finite });
        console.log(
          `${name}: mean radiance ${mean.map((x) => x.toPrecision(3)).join(' ')}, ` +
            `${finite ? 'all finite' : 'NOT FINITE'}`,
        );
      }
    } finally {
      draw(); // the view from before, or recovery
    }
    return results;
  });

/** Switch the sky off or on; returns whether it is on now. */
window.toggleSky = () => {
  state.sky = !state.sky;
  console.log(`Sky: ${state.sky}`);
  redraw();
  return state.sky;
};

/**
 * Set the quality by a preset's name, or the number of samples along each view ray.
 * Throws what the renderer says to a bad name or number.
 */
window.setSkyQuality = (quality) => {
  const named = typeof quality === 'string' && Number.isNaN(Number(quality));
  const wanted = named ? { ...state, quality } : { ...state, quality: '', samples: Number(quality) };
  need();
  const refused = apply(wanted);
  if (refused.length) throw new Error(refused.join('; '));
  Object.assign(state, wanted);
  console.log(named ? `Sky quality: ${quality}` : `Sky samples: ${wanted.samples}`);
  redraw();
};

/** Draw as a mode does, in its own quality, by its name. Throws what the renderer says to a bad one. */
window.setSkyMode = (mode) => {
  need().set_mode(String(mode));
  const { samples, lightSamples } = defaults;
  Object.assign(state, { mode: String(mode), quality: modeQuality(mode), samples, lightSamples });
  console.log(`Sky mode: ${mode}`);
  redraw();
};

window.welkin = {
  state,
  redraw,
  /** Radiance of the last frame; no frame is drawn while it is read. */
  readPixels: () => exclusive(() => need().read_pixels()),
  get viewer() {
    return viewer;
  },
};

// ---------------------------------------------------------------- start

function readOptions() {
  const query = new URLSearchParams(location.search);
  const backend = query.get('backend') || undefined;
  if (backend && !BACKENDS.includes(backend)) {
    throw new Error(`backend = ${backend} is not allowed: must be webgl2 or webgpu`);
  }
  const scale = queryNumber(query, 'scale', { min: 0.1, max: 8 }) ?? 2;
  const width = queryNumber(query, 'width', { min: 1, max: 8192, integer: true });
  const height = queryNumber(query, 'height', { min: 1, max: 8192, integer: true });
  if ((width === undefined) !== (height === undefined))
    throw new Error('width and height go together: give both or none');
  return { backend, scale, width, height };
}

async function main() {
  try {
    options = readOptions();
  } catch (error) {
    say('error', `The viewer cannot start. ${text(error)}`, { id: 'start' });
    return;
  }
  stage.classList.toggle('fixed', options.width !== undefined);
  $('backend').value = options.backend ?? '';
  if (matchMedia('(max-width: 640px)').matches) $('panel').open = false;
  takeHash();
  window.addEventListener('hashchange', takeHash);
  await firstStart();
  new ResizeObserver(redraw).observe(stage);
  window.addEventListener('resize', redraw); // also when the pixel ratio changes
  document.addEventListener('visibilitychange', redraw);
  setInterval(checkLoss, 1000);
}
main();
