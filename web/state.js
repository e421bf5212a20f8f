// What the viewer shows, and how that is written into the address (`#alt=15000&planet=mars`).
// No page and no renderer in here.

export const ALTITUDE = { min: 2, max: 30_000_000 };

/** The quality in which a mode draws by itself: a preset, or '' for by the usual samples. */
export const modeQuality = (mode) => (['sky-dome', 'atmosphere-post', 'planet'].includes(mode) ? '' : 'medium');

export const defaults = Object.freeze({
  planet: 'earth',
  alt: 100, // metres
  pitch: 12, // degrees, up is positive
  heading: 0, // degrees
  fov: 60, // degrees, vertical
  sunElevation: 25, // degrees
  sunAzimuth: 40, // degrees
  exposure: 1,
  toneMap: 'aces',
  mode: 'lut', // which passes draw
  quality: 'medium', // a preset's name, or '' for single scattering by samples
  samples: 24,
  lightSamples: 8,
  sky: true,
  terrain: true,
  half: false,
});

export const clamp = (x, lo, hi) => Math.min(hi, Math.max(lo, x));

/** `x` degrees in 0 up to 360. */
export const wrapDegrees = (x) => ((x % 360) + 360) % 360;

/** The altitude after turning the wheel by `pixels` (down is up and away). */
export const climb = (altitude, pixels) => clamp(altitude * Math.exp(pixels * 0.0015), ALTITUDE.min, ALTITUDE.max);

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
    out.set(key, typeof usual === 'boolean' ? (value ? 'on' : 'off') : typeof usual === 'number' ? short(value) : value);
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
      else if (key === 'alt' && (number < ALTITUDE.min || number > ALTITUDE.max)) refuse(`from ${ALTITUDE.min} to ${ALTITUDE.max} metres`);
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
    throw new Error(`${key} = ${text} is not allowed: must be ${integer ? 'a whole number ' : ''}from ${min} to ${max}`);
  }
  return value;
}
