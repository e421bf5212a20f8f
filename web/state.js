// What the viewer shows, and how that is written into the address (`#alt=15000&planet=mars`).
// No page and no renderer in here.

export const ALTITUDE = { min: 2, max: 30_000_000 };

/** The quality in which a mode draws by itself: a preset, or '' for by the usual samples. */
export const modeQuality = (mode) =>
  ['sky-dome', 'atmosphere-post', 'planet'].includes(mode) ? '' : 'medium';

/**
 * Every setting, once: its name in the address (`key`), its usual value, the control that shows it (in the
 * fieldset `group`, under `label`), and the method of the viewer that takes it (`set`), along with the others
 * of that method in this order. A number has a range, a step and a unit; a choice has its `options` (value:
 * text), or none here where the wasm module knows them.
 */
export const SETTINGS = [
  {
    key: 'planet',
    usual: 'earth',
    group: 'View',
    label: 'Planet',
    set: 'set_planet',
    options: {
      earth: 'Earth',
      mars: 'Mars',
      venus: 'Venus',
      'earth-like': 'Earth-like (plain)',
      rayleigh: 'Rayleigh only',
    },
  },
  // Metres above the ground.
  {
    key: 'alt',
    usual: 100,
    group: 'View',
    label: 'Altitude',
    set: 'set_camera',
    scale: 'log',
    ...ALTITUDE,
    step: 'any',
  },
  {
    key: 'pitch',
    usual: 12,
    group: 'View',
    label: 'Pitch',
    set: 'set_camera',
    unit: '°',
    min: -90,
    max: 90,
    step: 0.5,
  },
  {
    key: 'heading',
    usual: 0,
    group: 'View',
    label: 'Heading',
    set: 'set_camera',
    unit: '°',
    min: 0,
    max: 360,
    step: 0.5,
  },
  // Vertical.
  {
    key: 'fov',
    usual: 60,
    group: 'View',
    label: 'Field of view',
    set: 'set_camera',
    unit: '°',
    min: 10,
    max: 120,
    step: 1,
  },
  {
    key: 'sunElevation',
    usual: 25,
    group: 'Sun',
    label: 'Elevation',
    set: 'set_sun',
    unit: '°',
    min: -90,
    max: 90,
    step: 0.1,
  },
  {
    key: 'sunAzimuth',
    usual: 40,
    group: 'Sun',
    label: 'Azimuth',
    set: 'set_sun',
    unit: '°',
    min: 0,
    max: 360,
    step: 0.5,
  },
  {
    key: 'exposure',
    usual: 1,
    group: 'Picture',
    label: 'Exposure',
    set: 'set_exposure',
    scale: 'stops',
    min: -10,
    max: 10,
    step: 0.1,
  },
  {
    key: 'toneMap',
    usual: 'aces',
    group: 'Picture',
    label: 'Tone map',
    set: 'set_tone_map',
    options: { aces: 'ACES', agx: 'AgX', neutral: 'Neutral' },
  },
  // Which passes draw.
  { key: 'mode', usual: 'lut', group: 'Picture', label: 'Mode', set: 'set_mode', options: {} },
  // A preset's name, or '' for single scattering by samples.
  {
    key: 'quality',
    usual: 'medium',
    group: 'Picture',
    label: 'Quality',
    set: 'quality',
    options: { '': 'By samples' },
  },
  {
    key: 'samples',
    usual: 24,
    group: 'Picture',
    label: 'View samples',
    set: 'quality',
    min: 8,
    max: 64,
    step: 1,
  },
  {
    key: 'lightSamples',
    usual: 8,
    group: 'Picture',
    label: 'Light samples',
    set: 'quality',
    min: 2,
    max: 32,
    step: 1,
  },
  { key: 'sky', usual: true, group: 'Picture', label: 'Sky', set: 'set_enabled' },
  { key: 'terrain', usual: true, group: 'Picture', label: 'Terrain', set: 'set_terrain' },
  { key: 'airglow', usual: true, group: 'Picture', label: 'Airglow', set: 'set_airglow' },
  { key: 'half', usual: false, group: 'Picture', label: 'Half resolution', set: 'quality' },
];

export const defaults = Object.freeze(Object.fromEntries(SETTINGS.map(({ key, usual }) => [key, usual])));

export const clamp = (x, lo, hi) => Math.min(hi, Math.max(lo, x));

/** `x` degrees in 0 up to 360. */
export const wrapDegrees = (x) => ((x % 360) + 360) % 360;

/** The altitude after turning the wheel by `pixels` (down is up and away). */
export const climb = (altitude, pixels) =>
  clamp(altitude * Math.exp(pixels * 0.0015), ALTITUDE.min, ALTITUDE.max);

/** An altitude for people. */
export function altitudeText(metres) {
  if (metres < 1000) return `${metres < 10 ? metres.toFixed(1) : metres.toFixed(0)} m`;
  const km = metres / 1000;
  return `${km < 100 ? km.toFixed(1) : Math.round(km).toLocaleString('en')} km`;
}

const short = (x) => String(Number(x.toPrecision(6)));

const SAMPLES = ['samples', 'lightSamples'];

/**
 * The part of the address after `#`: only what differs from the defaults. The quality is there if it is
 * not the mode's own; samples are there, if they count, and say that they do.
 */
export function formatHash(state) {
  const out = new URLSearchParams();
  const bySamples = state.quality === '';
  const own = modeQuality(state.mode);
  for (const [key, usual] of Object.entries(defaults)) {
    const value = state[key];
    if (key === 'quality' ? bySamples || value === own : SAMPLES.includes(key) && !bySamples) continue;
    if (value === usual && key !== 'quality' && !(key === 'samples' && own)) continue;
    out.set(
      key,
      typeof usual === 'boolean' ? (value ? 'on' : 'off') : typeof usual === 'number' ? short(value) : value,
    );
  }
  return out.toString();
}

/**
 * Read what `formatHash` wrote, or what somebody typed.
 * Returns a whole state (defaults for what is absent or refused) and one
 * sentence for each thing that was refused. Ranges other than the altitude's
 * are the renderer's to judge.
 */
export function parseHash(text) {
  const state = { ...defaults };
  const problems = [];
  const given = new URLSearchParams(text.replace(/^#/, ''));
  for (const [key, value] of given) {
    const usual = Object.hasOwn(defaults, key) ? defaults[key] : undefined;
    const refuse = (allowed) => problems.push(`${key} = ${value} is not allowed: must be ${allowed}`);
    if (usual === undefined) {
      problems.push(`${key} is not a setting: there are ${Object.keys(defaults).join(', ')}`);
    } else if (typeof usual === 'boolean') {
      if (value === 'on' || value === 'off') state[key] = value === 'on';
      else refuse('on or off');
    } else if (typeof usual === 'number') {
      const number = value.trim() === '' ? NaN : Number(value);
      if (!Number.isFinite(number)) refuse('a number');
      else if (key === 'alt' && (number < ALTITUDE.min || number > ALTITUDE.max))
        refuse(`from ${ALTITUDE.min} to ${ALTITUDE.max} metres`);
      else state[key] = number;
    } else {
      state[key] = value;
    }
  }
  // A mode by itself stands for its own quality, samples for drawing by them.
  if (!given.has('quality')) {
    if (SAMPLES.some((key) => given.has(key))) state.quality = '';
    else if (given.has('mode')) state.quality = modeQuality(state.mode);
  }
  return { state, problems };
}

/**
 * Read a number from the query part of the address (`?scale=1.5`).
 * Throws with field, value and range if it is there and not usable.
 */
export function queryNumber(query, key, { min, max, integer = false }) {
  const text = query.get(key);
  if (text === null) return undefined;
  const value = text.trim() === '' ? NaN : Number(text);
  if (!(value >= min && value <= max) || (integer && !Number.isInteger(value))) {
    throw new Error(
      `${key} = ${text} is not allowed: must be ${integer ? 'a whole number ' : ''}from ${min} to ${max}`,
    );
  }
  return value;
}
