import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  ALTITUDE,
  altitudeText,
  climb,
  defaults,
  formatHash,
  modeQuality,
  parseHash,
  queryNumber,
  wrapDegrees,
} from '../state.js';

test('the default view has an empty hash', () => {
  assert.equal(formatHash(defaults), '');
  assert.deepEqual(parseHash(''), { state: { ...defaults }, problems: [] });
});

test('a view survives the address', () => {
  const view = {
    ...defaults,
    planet: 'mars',
    alt: 123456,
    pitch: -12.5,
    heading: 359.5,
    sunElevation: -3.25,
    exposure: 0.125,
    sky: false,
    terrain: false,
  };
  assert.deepEqual(parseHash(`#${formatHash(view)}`), { state: view, problems: [] });
});

test('modes, qualities and samples survive the address, each in its shortest form', () => {
  for (const [changes, hash] of [
    [{ mode: 'planet', quality: '' }, 'mode=planet'],
    [{ mode: 'planet', quality: '', lightSamples: 4 }, 'mode=planet&lightSamples=4'],
    [{ mode: 'sky-dome', quality: 'medium' }, 'mode=sky-dome&quality=medium'],
    [{ quality: 'high' }, 'quality=high'],
    [{ quality: '' }, 'samples=24'],
    [{ quality: '', samples: 9, lightSamples: 7 }, 'samples=9&lightSamples=7'],
  ]) {
    const view = { ...defaults, ...changes };
    assert.equal(formatHash(view), hash);
    assert.deepEqual(parseHash(`#${hash}`), { state: view, problems: [] });
  }
  assert.equal(defaults.quality, modeQuality(defaults.mode));
  assert.equal(formatHash({ ...defaults, samples: 9 }), '', 'samples that do not count stay out');
  assert.equal(parseHash('#lightSamples=4').state.quality, '', 'samples count where no quality is given');
  assert.equal(parseHash('#mode=planet&quality=low&samples=9').state.quality, 'low');
  assert.equal(
    parseHash('#mode=nonsense').state.quality,
    'medium',
    'which the renderer refuses, and its quality goes unharmed',
  );
});

test('what the hash may not hold is named with field, value and range', () => {
  const { state, problems } = parseHash('#alt=1&pitch=up&sky=maybe&colour=red&heading=&toString=1');
  assert.deepEqual(state, { ...defaults });
  assert.deepEqual(problems.slice(0, 3), [
    'alt = 1 is not allowed: must be from 2 to 30000000 metres',
    'pitch = up is not allowed: must be a number',
    'sky = maybe is not allowed: must be on or off',
  ]);
  assert.match(problems[3], /^colour is not a setting: there are planet, alt, /);
  assert.equal(problems[4], 'heading =  is not allowed: must be a number');
  assert.match(problems[5], /^toString is not a setting/);
});

test('the wheel climbs by a factor and stays within limits', () => {
  assert.ok(climb(100, 120) > 100 && climb(100, -120) < 100);
  assert.ok(Math.abs(climb(climb(100, 120), -120) - 100) < 1e-9);
  assert.ok(Math.abs(climb(1000, 300) / 1000 - climb(1e6, 300) / 1e6) < 1e-9, 'the same factor everywhere');
  assert.equal(climb(100, 1e9), ALTITUDE.max);
  assert.equal(climb(100, -1e9), ALTITUDE.min);
});

test('headings wrap, altitudes read well', () => {
  assert.deepEqual([-10, 0, 360, 725].map(wrapDegrees), [350, 0, 0, 5]);
  assert.deepEqual([2, 100, 15000, 3e7].map(altitudeText), ['2.0 m', '100 m', '15.0 km', '30,000 km']);
});

test('numbers in the query are checked', () => {
  const read = (text) => queryNumber(new URLSearchParams(text), 'scale', { min: 0.1, max: 8 });
  assert.equal(read(''), undefined);
  assert.equal(read('scale=1.5'), 1.5);
  for (const bad of ['0', '9', 'big', '', 'NaN']) {
    assert.throws(() => read(`scale=${bad}`), {
      message: `scale = ${bad} is not allowed: must be from 0.1 to 8`,
    });
  }
});
