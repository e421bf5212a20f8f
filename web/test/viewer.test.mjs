// The planet viewer in a real browser: the same tests for both backends.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { after, before, describe, it } from 'node:test';
import { promisify } from 'node:util';
import {
  BACKENDS,
  SIZE,
  artifacts,
  canvas,
  decode,
  difference,
  launch,
  luminance,
  mean,
  moduleFiles,
  pixels,
  relativeDifference,
  shown,
  waitForLine,
  web,
} from './browser.mjs';
import { parseHash } from '../state.js';

// One each: compiling is one thread's work in a browser, and what one waits for leaves time for the other.
const browsers = {};
before(async () => {
  for (const backend of BACKENDS) browsers[backend] = await launch();
});
after(async () => {
  await Promise.all(Object.values(browsers).map((browser) => browser.close()));
});

/** The same tests on both backends beside each other, those of a backend one after another. */
function onBoth(name, tests) {
  describe(name, { concurrency: true }, () => {
    for (const backend of BACKENDS) describe(backend, { concurrency: 1 }, () => tests(backend));
  });
}

/** Open the viewer for one test; the page is closed after it, and must not have complained. */
async function use(t, options, { complaints = false } = {}) {
  const page = await browsers[options.backend === 'webgl2' ? 'webgl2' : 'webgpu'].open(options);
  t.after(async () => {
    await page.context().close();
    if (!complaints) assert.deepEqual(page.problems, [], 'the page reported errors');
  });
  return page;
}

const run = promisify(execFile);

const kept = new Map();

// For tests that would find the same by any quality: with the quickest LUTs, and without any, whose programs
// alone take the software renderer seconds.
const LOW = 'quality=low';
const MARCH = 'samples=4&lightSamples=2';

const PLANETS = ['mars', 'venus', 'earth-like'];

/**
 * The viewer in a page that tests share, as the last one left it: as it opens for those that stand before all
 * others. It must not have complained.
 */
async function opened(t, backend) {
  if (!kept.has(backend)) kept.set(backend, await browsers[backend].open({ backend }));
  const page = kept.get(backend);
  // Taken out, so that the next test is not blamed; what comes too late for this one, it gets.
  t.after(() => assert.deepEqual(page.problems.splice(0), [], 'the page reported errors'));
  return page;
}

/**
 * The same page with the settings of an address. A page of one's own compiles all of its shaders anew, which
 * takes seconds: `use` is for what needs one.
 */
async function share(t, backend, hash = LOW) {
  const page = await opened(t, backend);
  page.lines.length = 0;
  await page.evaluate(async (state) => {
    Object.assign(welkin.state, state);
    await welkin.redraw();
  }, parseHash(hash).state);
  return page;
}

const finite = (data) => data.every(Number.isFinite);

onBoth('the viewer', (backend) => {
  it('downloads the module of this backend alone, and it is small', async (t) => {
    const page = await opened(t, backend);
    assert.deepEqual(page.downloads.filter((path) => path.startsWith('/pkg/')).sort(), [
      `/pkg/${backend}/welkin.js`,
      `/pkg/${backend}/welkin_bg.wasm`,
    ]);
    const [glue, wasm] = moduleFiles(backend).map(
      (file) => gzipSync(readFileSync(file), { level: 9 }).length,
    );
    t.diagnostic(`${wasm} bytes of wasm and ${glue} of JavaScript, gzipped`);
    assert.ok(wasm <= 120_000, `the module has ${wasm} bytes gzipped`);
  });

  it('loads, says so, and names the backend', async (t) => {
    const page = await opened(t, backend);
    assert.equal(page.lines.filter((l) => l.text === 'Sky renderer initialized').length, 1);
    assert.equal(await page.textContent('#read-backend'), backend);
    const adapter = await page.textContent('#read-adapter');
    assert.match(adapter, new RegExp(`^${backend}: .+`));
    assert.equal(await page.evaluate(() => welkin.viewer.backend), backend);
    assert.ok(page.lines.some((l) => l.text === `Backend ${backend}: asked for with ?backend=${backend}`));
    t.diagnostic(adapter);
    const data = await pixels(page);
    assert.equal(data.length, SIZE.width * SIZE.height * 4);
    assert.ok(finite(data), 'every pixel is finite');
    assert.ok(luminance(mean(data)) > 0, 'the sky is not black');
    await page.setViewportSize({ width: 1000, height: 640 });
    await page.screenshot({ path: join(artifacts, `viewer-${backend}.png`) });
    await page.setViewportSize({ width: 900, height: 600 });
  });

  it('draws from LUTs by default, and says so', async (t) => {
    // What a page opens with: not one that was set to it.
    const page = await opened(t, backend);
    assert.equal(await page.textContent('#read-sky'), 'lut, medium (lut 100 × 100 × 32)');
    assert.deepEqual(await page.evaluate(() => [welkin.state.mode, welkin.state.quality]), [
      'lut',
      'medium',
    ]);
    assert.deepEqual(
      await page.evaluate(() => [...document.querySelectorAll('#mode, #quality')].map((c) => c.value)),
      ['lut', 'medium'],
    );
    const byDefault = await pixels(page);
    await page.evaluate(() => {
      setSkyQuality('single-ultra');
    });
    assert.ok(
      luminance(mean(await pixels(page))) < luminance(mean(byDefault)),
      'single scattering is darker',
    );
    await page.evaluate(() => {
      setSkyQuality('medium');
    });
    assert.equal(difference(byDefault, await pixels(page)).max, 0);
  });

  it('fills the window and follows its size', async (t) => {
    const page = await use(t, { backend, hash: MARCH, query: { width: '', height: '', scale: '0.25' } });
    const size = () =>
      page.evaluate(() => {
        const c = document.querySelector('#stage canvas');
        return [c.width, c.height];
      });
    assert.deepEqual(await size(), [225, 150]);
    await page.setViewportSize({ width: 400, height: 300 });
    await page.waitForFunction(() => document.querySelector('#stage canvas').width === 100);
    assert.deepEqual(await size(), [100, 75]);
    assert.equal((await pixels(page)).length, 100 * 75 * 4);
  });

  it('draws only when something changed', async (t) => {
    const page = await share(t, backend, MARCH);
    await page.evaluate(async () => {
      await welkin.redraw();
      const { viewer } = welkin;
      window.frames_ = 0;
      const render = viewer.render;
      viewer.render = function () {
        window.frames_++;
        return render.call(this);
      };
    });
    // A page that gets no time draws nothing either: it must also have had as many chances to.
    await page.evaluate(async () => {
      const end = performance.now() + 1500;
      for (let i = 0; i < 60 || performance.now() < end; i++) await new Promise(requestAnimationFrame);
    });
    assert.equal(await page.evaluate(() => window.frames_), 0, 'frames without a change');
    await page.evaluate(async () => {
      welkin.redraw();
      welkin.redraw();
      await welkin.redraw();
    });
    assert.equal(await page.evaluate(() => window.frames_), 1, 'one frame for three requests');
    await page.evaluate(() => delete welkin.viewer.render);
  });

  it('testSky draws the four scenarios', async (t) => {
    const page = await share(t, backend, `alt=2000&pitch=7&${LOW}`);
    const before = await pixels(page);
    const results = await page.evaluate(() => window.testSky());
    assert.deepEqual(
      results.map(({ name, alt, pitch }) => [name, alt, pitch]),
      [
        ['Surface looking up', 100, 90],
        ['Surface at horizon', 100, 0],
        ['High altitude up', 5000, 90],
        ['Very high altitude', 15000, 90],
      ],
    );
    for (const {
      name,
      mean: [r, g, b],
      finite,
    } of results) {
      assert.equal(finite, true, `${name}: every pixel is finite`);
      assert.ok(r >= 0 && g >= 0 && b >= 0 && r + g + b > 0, `${name}: ${[r, g, b]}`);
      assert.ok(
        page.lines.some((l) => l.text.startsWith(`${name}: `)),
        `${name} is logged`,
      );
      t.diagnostic(`${name}: ${[r, g, b].map((x) => x.toPrecision(3)).join(' ')}`);
    }
    const [up, , higher, highest] = results.map((r) => r.mean);
    assert.ok(up[2] > up[0], 'the zenith is blue');
    assert.ok(
      luminance(higher) < luminance(up) && luminance(highest) < luminance(higher),
      'the zenith darkens with altitude',
    );
    const state = await page.evaluate(() => welkin.state);
    assert.deepEqual([state.alt, state.pitch], [2000, 7]);
    assert.equal(difference(before, await pixels(page)).max, 0, 'the view from before is back');
  });

  it('toggleSky takes the sky away and brings it back', async (t) => {
    const page = await share(t, backend, `pitch=40&${LOW}`);
    const on = await pixels(page);
    const from = page.lines.length;
    assert.equal(await page.evaluate(() => window.toggleSky()), false);
    await waitForLine(page, 'Sky: false', { from });
    const off = await pixels(page);
    assert.equal(await page.evaluate(() => welkin.viewer.enabled), false);
    assert.ok(luminance(mean(off)) < 0.01 * luminance(mean(on)), `${mean(off)} against ${mean(on)}`);
    assert.equal(await page.evaluate(() => window.toggleSky()), true);
    await waitForLine(page, 'Sky: true', { from });
    assert.equal(difference(on, await pixels(page)).max, 0);
  });

  it('setSkyQuality changes the samples, and refuses nonsense by name', async (t) => {
    const page = await share(t, backend, 'sunElevation=3&sunAzimuth=0&pitch=5');
    const set = (n) =>
      page.evaluate(async (n) => {
        setSkyQuality(n);
        await welkin.redraw();
        return welkin.state.samples;
      }, n);
    assert.equal(await set(8), 8);
    await waitForLine(page, 'Sky samples: 8');
    const coarse = await pixels(page);
    assert.equal(await set(32), 32);
    await waitForLine(page, 'Sky samples: 32');
    const fine = await pixels(page);
    assert.ok(difference(coarse, fine).mean > 0, 'more samples give another picture');
    const relative = Math.abs(luminance(mean(coarse)) / luminance(mean(fine)) - 1);
    assert.ok(relative < 0.2, `the same sky all the same: ${relative}`);
    for (const bad of [0, -3, 1e9]) {
      const message = await page.evaluate((n) => {
        try {
          setSkyQuality(n);
        } catch (e) {
          return e.message;
        }
      }, bad);
      assert.match(message ?? 'nothing was thrown', /samples.* is not allowed: must be /, String(bad));
    }
    assert.equal(await page.evaluate(() => welkin.state.samples), 32, 'a refused number changes nothing');
    assert.equal(difference(fine, await pixels(page)).max, 0);
    assert.equal(page.lines.filter((l) => l.text.startsWith('Sky samples')).length, 2);
  });

  it('setSkyQuality takes the name of a preset, as the list on the page does', async (t) => {
    const page = await share(t, backend, 'sunElevation=3&sunAzimuth=0&pitch=5&lightSamples=8');
    const set = (q) =>
      page.evaluate(async (q) => {
        setSkyQuality(q);
        await welkin.redraw();
        return welkin.state.quality;
      }, q);
    assert.equal(await set(16), '');
    const bySamples = await pixels(page);
    assert.equal(await set('single-medium'), 'single-medium');
    await waitForLine(page, 'Sky quality: single-medium');
    assert.equal(difference(bySamples, await pixels(page)).max, 0, 'single-medium is 16 × 8 samples');
    assert.equal(await set('single-low'), 'single-low');
    const low = await pixels(page);
    assert.ok(difference(bySamples, low).mean > 0, 'another preset gives another picture');
    const luts = {};
    // The largest LUTs take the software renderer as long as all else here.
    const high = process.env.WELKIN_ALL;
    const finest = high ? 'high' : 'medium';
    for (const name of ['low', 'medium', ...(high ? ['high'] : [])]) {
      assert.equal(await set(name), name);
      luts[name] = luminance(mean(await pixels(page)));
      assert.match(
        await page.textContent('#read-sky'),
        new RegExp(`^lut, ${name} \\(lut \\d+ × \\d+ × \\d+\\)$`),
      );
      assert.ok(
        luts[name] > luminance(mean(bySamples)),
        `${name} holds light that was scattered more than once`,
      );
    }
    const [worse, better] = high ? ['medium', 'high'] : ['low', 'medium'];
    const apart = Math.abs(luts[worse] / luts[better] - 1);
    t.diagnostic(`${worse} and ${better} lie ${(100 * apart).toFixed(3)} % apart`);
    assert.ok(apart < 0.02, `${worse} is near ${better}: ${luts[worse]} and ${luts[better]}`);
    const message = await page.evaluate(() => {
      try {
        setSkyQuality('best');
      } catch (e) {
        return e.message;
      }
    });
    assert.match(
      message ?? 'nothing was thrown',
      /quality = "best" is not allowed: must be one of low, medium/,
    );
    assert.equal(await page.evaluate(() => welkin.state.quality), finest, 'a refused name changes nothing');
    const names = await page.evaluate(() =>
      [...document.querySelectorAll('#quality option')].map((o) => o.value),
    );
    assert.deepEqual(names.slice(0, 4), ['', 'low', 'medium', 'high']);
    await page.selectOption('#quality', 'single-medium');
    await page.evaluate(() => welkin.redraw());
    assert.equal(difference(bySamples, await pixels(page)).max, 0);
    await page.locator('#samples').fill('24');
    assert.equal(
      await page.evaluate(() => welkin.state.quality),
      '',
      'moving the samples leaves the preset',
    );
  });

  it('setSkyMode takes the four modes, as the list on the page and the address do', async (t) => {
    const page = await share(t, backend, 'pitch=10&sunElevation=20');
    const modes = ['sky-dome', 'atmosphere-post', 'planet', 'lut'];
    assert.deepEqual(
      await page.evaluate(() => [...document.querySelectorAll('#mode option')].map((o) => o.value)),
      modes,
    );
    const said = { lut: 'lut, medium (lut 100 × 100 × 32)' };
    const seen = {};
    for (const mode of modes) {
      await page.evaluate(async (mode) => {
        setSkyMode(mode);
        await welkin.redraw();
      }, mode);
      await waitForLine(page, `Sky mode: ${mode}`);
      assert.equal(
        await page.textContent('#read-sky'),
        said[mode] ?? `${mode}, by samples (single 24 × 8)`,
      );
      assert.equal(await page.inputValue('#mode'), mode);
      seen[mode] = await pixels(page);
      assert.ok(finite(seen[mode]) && luminance(mean(seen[mode])) > 0, mode);
      for (const other of modes.slice(0, modes.indexOf(mode))) {
        assert.ok(difference(seen[mode], seen[other]).mean > 0, `${mode} draws otherwise than ${other}`);
      }
    }
    for (const mode of modes) {
      await page.selectOption('#mode', mode);
      assert.equal(difference(seen[mode], await pixels(page)).max, 0, `${mode} from the list`);
    }
    await page.evaluate(() => {
      location.hash = '#pitch=10&sunElevation=20&mode=planet';
    });
    await page.waitForFunction(() => welkin.state.mode === 'planet');
    assert.equal(difference(seen.planet, await pixels(page)).max, 0, 'from the address');
    for (const bad of ['Planet', '', 'toString', 7, null]) {
      const message = await page.evaluate((bad) => {
        try {
          setSkyMode(bad);
        } catch (e) {
          return e.message;
        }
      }, bad);
      assert.equal(
        message ?? 'nothing was thrown',
        `mode = "${bad}" is not allowed: must be one of ${modes.join(', ')}`,
      );
    }
    assert.deepEqual(await page.evaluate(() => [welkin.state.mode, welkin.state.quality]), ['planet', '']);
    assert.equal(difference(seen.planet, await pixels(page)).max, 0, 'a refused name changes nothing');
    await page.evaluate(() => {
      location.hash = '#pitch=10&sunElevation=20&mode=dome';
    });
    await page.waitForFunction(() =>
      /mode = "dome" is not allowed: must be one of sky-dome/.test(
        document.querySelector('#messages').textContent,
      ),
    );
    assert.ok(finite(await pixels(page)));
  });

  it('draws the sky behind the terrain', async (t) => {
    const page = await share(t, backend, `pitch=0&sunElevation=35&${LOW}`);
    const bare = await pixels(page, { terrain: false });
    const terrain = await pixels(page, { terrain: true });
    assert.ok(finite(terrain));
    const change = (top, bottom) => {
      const [a, b] = [bare, terrain].map((d) => mean(d, top, bottom));
      return Math.abs(luminance(a) - luminance(b)) / Math.max(luminance(a), luminance(b));
    };
    assert.ok(change(0, 0.2) < 0.02, `the upper rows stay sky: ${change(0, 0.2)}`);
    assert.ok(change(0.8, 1) > 0.1, `the lower rows are terrain: ${change(0.8, 1)}`);
    await page.locator('#stage canvas').screenshot({
      path: join(artifacts, `terrain-${backend}.png`),
      style: '#panel, #readout, #messages { display: none }',
    });
  });

  it('shows on the page what it computed, the right way up', async (t) => {
    const page = await share(t, backend, `pitch=0&terrain=on&${LOW}`);
    const radiance = await pixels(page);
    const picture = await shown(page);
    assert.deepEqual([picture.width, picture.height], [SIZE.width, SIZE.height]);
    // Other tests read the canvas: the page shows nothing else.
    const held = await canvas(page);
    const { max } = difference(picture.data, held.data);
    assert.ok(max <= 1, `the page shows the canvas, at most ${max}/255 apart`);
    const rows = 10;
    const profile = (data) =>
      Array.from({ length: rows }, (_, i) => luminance(mean(data, i / rows, (i + 1) / rows)));
    const [light, screen] = [profile(radiance), profile(picture.data)];
    // Brighter radiance must never be shown darker.
    for (let i = 0; i < rows; i++) {
      for (let j = 0; j < rows; j++) {
        if (light[i] > light[j] * 1.1)
          assert.ok(screen[i] >= screen[j], `rows ${i} and ${j}: ${light} shown as ${screen}`);
      }
    }
    assert.ok(Math.max(...screen) - Math.min(...screen) > 5, `the picture has contrast: ${screen}`);
  });

  it('climbs with the wheel, within limits', async (t) => {
    const page = await share(t, backend);
    const altitude = () =>
      page.evaluate(async () => {
        await welkin.redraw();
        return welkin.state.alt;
      });
    await page.mouse.move(300, 300);
    const start = await altitude();
    await page.mouse.wheel(0, 240);
    await page.waitForFunction((a) => welkin.state.alt > a, start);
    const higher = await altitude();
    await page.mouse.wheel(0, -480);
    await page.waitForFunction((a) => welkin.state.alt < a, higher);
    assert.ok((await altitude()) < start);
    const far = await pixels(page, { alt: 2.9e7, pitch: -90 });
    assert.ok(finite(far));
    for (const [turn, limit] of [
      [40000, 3e7],
      [-60000, 2],
    ]) {
      await page.mouse.wheel(0, turn);
      await page.waitForFunction((a) => welkin.state.alt === a, limit);
      assert.ok(finite(await pixels(page)), `finite at ${limit} m`);
    }
  });

  it('looks around by dragging and by keys', async (t) => {
    const page = await share(t, backend);
    const look = () => page.evaluate(() => [welkin.state.heading, welkin.state.pitch]);
    const [heading, pitch] = await look();
    await page.mouse.move(400, 300);
    await page.mouse.down();
    await page.mouse.move(350, 340, { steps: 3 });
    await page.mouse.up();
    const [h1, p1] = await look();
    assert.ok(
      Math.abs(h1 - heading - 5) < 1e-6 && Math.abs(p1 - pitch - 4) < 1e-6,
      `50 left and 40 down: ${h1} ${p1}`,
    );
    await page.focus('#stage');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowUp');
    const [h2, p2] = await look();
    assert.ok(Math.abs(h2 - h1 - 2) < 1e-6 && Math.abs(p2 - p1 - 10) < 1e-6);
    for (let i = 0; i < 12; i++) await page.keyboard.press('Shift+ArrowUp');
    assert.equal((await look())[1], 90, 'pitch stops at the zenith');
    await page.keyboard.press('Home');
    assert.equal((await look())[1], 0);
  });

  it('pinches to change altitude on a touch screen', async (t) => {
    const page = await share(t, backend, MARCH);
    const touch = await page.context().newCDPSession(page);
    const send = (type, ...points) =>
      touch.send('Input.dispatchTouchEvent', {
        type,
        touchPoints: points.map(([x, y], id) => ({ x, y, id })),
      });
    const start = await page.evaluate(() => welkin.state.alt);
    await send('touchStart', [250, 300]);
    await send('touchStart', [250, 300], [350, 300]);
    await send('touchMove', [200, 300], [400, 300]);
    await send('touchEnd');
    await page.waitForFunction((a) => welkin.state.alt < a * 0.5, start);
  });

  it('switches planets, and back to the identical picture', async (t) => {
    // The LUTs of one more medium show a stale one; those of Venus take the software renderer seconds.
    for (const [how, planets] of [
      [LOW, process.env.WELKIN_ALL ? PLANETS : ['mars']],
      [MARCH, PLANETS],
    ]) {
      const page = await share(t, backend, `pitch=20&${how}`);
      const earth = await pixels(page);
      for (const planet of planets) {
        const other = await pixels(page, { planet });
        assert.ok(finite(other), `${planet}, ${how}`);
        assert.ok(difference(earth, other).mean > 1e-4, `${planet}, ${how}: looks different`);
      }
      assert.equal(difference(earth, await pixels(page, { planet: 'earth' })).max, 0, how);
    }
  });

  it('lists what the view calls for, and why', async (t) => {
    const page = await share(t, backend, `pitch=20&sunElevation=30&${LOW}`);
    await page.evaluate(() => {
      document.getElementById('effects').open = true;
    });
    const listed = async (name) =>
      page.evaluate((wanted) => {
        const rows = [...document.querySelectorAll('#plan > div')];
        const row = rows.find((r) => r.querySelector('dt').textContent.startsWith(`${wanted}:`));
        return [row.className, row.querySelector('dd').textContent];
      }, name);
    const when = (name, state) =>
      page.waitForFunction(
        ([n, s]) =>
          [...document.querySelectorAll('#plan > div')].some(
            (r) => r.className === s && r.querySelector('dt').textContent === `${n}: ${s}`,
          ),
        [name, state],
      );
    await when('sunlight', 'on');
    assert.equal((await listed('eclipse'))[1], 'the scene has no moon');
    assert.equal((await listed('multiple scattering'))[0], 'on');
    await pixels(page, { sunElevation: -60 });
    await when('sunlight', 'off');
    assert.match((await listed('sunlight'))[1], /^night/);
    await pixels(page, { alt: 4e5, pitch: 60 });
    await when('atmosphere', 'off');
    assert.equal((await listed('atmosphere'))[1], 'outside the picture');
  });

  it('darkens when the sun sets', async (t) => {
    const page = await share(t, backend, `pitch=60&${LOW}`);
    const levels = [];
    for (const sunElevation of [50, 5, -4, -18])
      levels.push(luminance(mean(await pixels(page, { sunElevation }))));
    assert.ok(
      levels.every((x, i) => i === 0 || x < levels[i - 1]),
      levels.join(' > '),
    );
    assert.ok(levels[3] < 1e-3 * levels[0], `night against day: ${levels[3] / levels[0]}`);
  });

  it('says what is wrong with bad input and keeps the last good value', async (t) => {
    const page = await use(t, { backend, hash: `planet=pluto&alt=nowhere&toneMap=sepia&${MARCH}` });
    const messages = await page.locator('.message span').allTextContents();
    assert.ok(
      messages.some((m) => m.includes('alt = nowhere is not allowed: must be a number')),
      messages.join('\n'),
    );
    assert.ok(
      messages.some((m) => /pluto.* is not allowed: must be .*mars/.test(m)),
      messages.join('\n'),
    );
    assert.ok(
      messages.some((m) => /sepia.* is not allowed: must be .*agx/.test(m)),
      messages.join('\n'),
    );
    const state = await page.evaluate(() => welkin.state);
    assert.deepEqual([state.planet, state.alt, state.toneMap], ['earth', 100, 'aces']);
    const refused = await page.evaluate(() => {
      const { viewer } = welkin;
      const tries = {
        planet: () => viewer.set_planet('Earth '),
        camera: () => viewer.set_camera(NaN, 0, 0, 60),
        fov: () => viewer.set_camera(100, 0, 0, 0),
        sun: () => viewer.set_sun(Infinity, 0),
        exposure: () => viewer.set_exposure(-1),
        tone: () => viewer.set_tone_map('none of these'),
        scale: () => viewer.set_render_scale(7),
        size: () => viewer.resize(0, 0),
      };
      return Object.entries(tries).map(([name, attempt]) => {
        try {
          attempt();
        } catch (e) {
          return [name, e.message];
        }
        return [name, 'nothing was thrown'];
      });
    });
    for (const [name, message] of refused)
      assert.match(message, /^\S.* = .* is not allowed: must be /, name);
    assert.ok(finite(await pixels(page)), 'and it still draws');
  });

  it('says what is wrong with a value of a wrong type, whatever it is', async (t) => {
    const page = await share(t, backend);
    const before = await pixels(page);
    const messages = await page.evaluate(async () => {
      const { viewer } = welkin;
      const { constructor: Viewer } = viewer;
      // What each method takes; each argument in turn is replaced by what it is not.
      const right = {
        set_planet: ['earth'],
        set_camera: [100, 0, 0, 60],
        set_sun: [20, 0],
        set_mode: ['lut'],
        set_quality: ['medium'],
        set_samples: [24, 8],
        set_exposure: [1],
        set_tone_map: ['aces'],
        set_render_scale: [1],
        set_enabled: [true],
        set_terrain: [true],
        set_airglow: [true],
        resize: [320, 200],
      };
      const wrong = [5, 'five', true, null, undefined, {}, [], Symbol('s'), 5n, () => 5, NaN];
      const out = [];
      const note = (name, value, says) =>
        out.push([`${name} of ${String(Array.isArray(value) ? '[]' : value)}`, says]);
      for (const [name, args] of Object.entries(right)) {
        for (let i = 0; i < args.length; i++) {
          for (const value of wrong) {
            if (typeof value === typeof args[i] && typeof value !== 'string' && !Number.isNaN(value))
              continue;
            try {
              viewer[name](...args.with(i, value));
              note(name, value, 'nothing was thrown');
            } catch (e) {
              note(name, value, e.message);
            }
          }
        }
      }
      for (const value of [null, 5, document.body, document.createElement('canvas')]) {
        const backend = value instanceof HTMLCanvasElement ? 5 : viewer.backend;
        await Viewer.create(value, backend).then(
          () => note('create', value, 'nothing was thrown'),
          (e) => note('create', value, e.message),
        );
      }
      return out;
    });
    for (const [call, message] of messages)
      assert.match(message, /^\S+ = \S.* is not allowed: must be \S/, call);
    assert.ok(messages.length > 100, `${messages.length} calls`);
    assert.equal(difference(before, await pixels(page)).max, 0, 'and it still draws, as before');
  });

  it('recovers when the device is lost', async (t) => {
    const page = await use(t, { backend, hash: `planet=mars&pitch=33&sunElevation=12&${MARCH}` });
    const before = await pixels(page);
    for (let round = 1; round <= 2; round++) {
      const from = page.lines.length;
      await page.evaluate(() => welkin.viewer.lose());
      await waitForLine(page, /^The graphics device was lost \(.+\)\. Starting .+ again…$/, { from });
      await waitForLine(page, `Recovered: drawing with ${backend} again, same view`, { from });
      assert.match(await page.textContent('#messages'), /Recovered/);
      assert.equal(difference(before, await pixels(page)).max, 0, `the same picture after loss ${round}`);
    }
    assert.equal(page.lines.filter((l) => l.text === 'Sky renderer initialized').length, 1);
  });

  it('holds no more after a thousand sizes than after a few', async (t) => {
    // What exists: made less deleted. WebGPU's objects go with JavaScript's garbage instead.
    const prepare = () => {
      window.live_ = {};
      for (const kind of [
        'Texture',
        'Framebuffer',
        'Buffer',
        'Program',
        'Shader',
        'Sampler',
        'VertexArray',
        'Query',
      ]) {
        const gl = WebGL2RenderingContext.prototype;
        for (const [verb, step] of [
          ['create', 1],
          ['delete', -1],
        ]) {
          const plain = gl[verb + kind];
          gl[verb + kind] = function (...given) {
            if (verb === 'create' || given[0]) window.live_[kind] = (window.live_[kind] ?? 0) + step;
            return plain.apply(this, given);
          };
        }
      }
    };
    const page = await use(t, { backend, prepare, hash: 'samples=2&lightSamples=1&terrain=off' });
    const before = await pixels(page);
    const live = await page.evaluate(async () => {
      const { viewer } = welkin;
      const draw = async (count) => {
        for (let i = 0; i < count; i++) {
          viewer.resize(1 + (i % 13), 1 + (i % 7));
          viewer.set_render_scale(i % 2 ? 1 : 0.5);
          viewer.render();
          if (i % 50 === 0) await new Promise(requestAnimationFrame);
        }
        return { ...window.live_ };
      };
      const seen = [await draw(91 * 2), await draw(91 * 12)];
      viewer.set_render_scale(1);
      return seen;
    });
    assert.deepEqual(live[1], live[0]);
    assert.equal((live[0].Texture ?? 0) > 0, backend === 'webgl2', 'counted what there is');
    t.diagnostic(JSON.stringify(live[1]));
    await page.evaluate(([w, h]) => welkin.viewer.resize(w, h), [SIZE.width, SIZE.height]);
    assert.equal(difference(before, await pixels(page)).max, 0, 'the same picture as before');
  });

  it('keeps the view in the address', async (t) => {
    const page = await use(t, { backend, hash: MARCH });
    await page.evaluate(async () => {
      Object.assign(welkin.state, { alt: 42000, planet: 'mars' });
      await welkin.redraw();
    });
    await page.waitForFunction(() => location.hash === '#planet=mars&alt=42000&samples=4&lightSamples=2');
    const picture = await pixels(page);
    await page.reload();
    await page.waitForFunction(() => window.welkin?.viewer);
    assert.equal(difference(picture, await pixels(page)).max, 0);
    await page.evaluate(() => {
      location.hash = '#pitch=-20&samples=4&lightSamples=2';
    });
    await page.waitForFunction(() => welkin.state.pitch === -20 && welkin.state.planet === 'earth');
  });
});

describe('errors of the device', () => {
  it('are told by the next frame on WebGPU, with kind and message', async (t) => {
    const page = await use(t, {
      backend: 'webgpu',
      hash: MARCH,
      prepare: () => {
        const made = GPUAdapter.prototype.requestDevice;
        GPUAdapter.prototype.requestDevice = async function (...options) {
          return (window.device_ = await made.apply(this, options));
        };
      },
    });
    const said = await page.evaluate(async () => {
      const told = new Promise((done) => window.device_.addEventListener('uncapturederror', done));
      window.device_.createBuffer({ label: 'without a use', size: 4, usage: 0 });
      await told;
      const frame = () => {
        try {
          welkin.viewer.render();
          return 'drawn';
        } catch (error) {
          return error.message;
        }
      };
      return [frame(), frame()];
    });
    assert.match(said[0], /^webgpu: device: GPUValidationError: .*without a use/s);
    assert.equal(said[1], 'drawn');
  });
});

describe('both backends', () => {
  it('give the same pixels', async (t) => {
    const pages = await Promise.all(['webgl2', 'webgpu'].map((backend) => share(t, backend, '')));
    const views = {
      'ground, noon': { pitch: 15, sunElevation: 50, terrain: false },
      'ground, sunset': { pitch: 3, sunElevation: 0.5, sunAzimuth: 0, terrain: false },
      'ground, terrain': { pitch: 0, sunElevation: 30, sunAzimuth: 40, terrain: true },
      '15 km': { alt: 15000, pitch: 0, terrain: false },
      'limb from 400 km': { alt: 4e5, pitch: -18, sunElevation: 5 },
      'whole planet': { alt: 1.5e7, pitch: -90, sunElevation: 45 },
      Mars: { planet: 'mars', alt: 100, pitch: 10, sunElevation: 20 },
    };
    for (const [name, view] of Object.entries(views)) {
      const [a, b] = await Promise.all(pages.map((page) => pixels(page, view)));
      const { max, mean: average } = difference(a, b);
      const relative = relativeDifference(a, b);
      t.diagnostic(
        `${name}: difference at most ${max.toPrecision(3)}, mean ${average.toPrecision(3)}, ` +
          `at most ${(100 * relative).toPrecision(3)} % of a value`,
      );
      assert.ok(luminance(mean(a)) > 1e-4, `${name}: there is something to compare`);
      assert.ok(relative <= 0.02, `${name}: at most ${100 * relative} % apart`);
    }
  });
});

onBoth('the browser draws what the native program draws', (backend) => {
  const program = join(process.env.CARGO_TARGET_DIR ?? join(web, '..', 'target'), 'debug', 'welkin');
  const views = {
    noon: { alt: 100, pitch: 15, heading: 180, sunElevation: 50, sunAzimuth: 150 },
    sunset: { alt: 100, pitch: 8, heading: 270, sunElevation: 2, sunAzimuth: 265 },
    '30 km': { alt: 30000, pitch: -5, heading: 180, sunElevation: 30, sunAzimuth: 240 },
    limb: { alt: 4e5, pitch: -18, heading: 0, sunElevation: 25, sunAzimuth: 60 },
    planet: { alt: 1.5e7, pitch: -90, heading: 0, sunElevation: 45, sunAzimuth: 60 },
  };
  // Where the passes differ most; all of them by default, and in every way with `scripts/test --all`.
  const FEW = ['sunset', 'limb', 'planet'];
  const draws = [
    { how: 'by default', options: {} },
    {
      how: 'single scattering',
      few: !process.env.WELKIN_ALL,
      changes: { quality: '', samples: 24, lightSamples: 8 },
      options: { samples: 24, 'light-samples': 8 },
    },
    ...['sky-dome', 'atmosphere-post', 'planet'].map((mode) => ({
      how: mode,
      few: !process.env.WELKIN_ALL,
      changes: { mode, quality: '' },
      options: { mode },
    })),
  ];
  for (const { how, changes = {}, options, few = false } of draws)
    it(`on ${backend}, ${how}`, async (t) => {
      const page = await share(t, backend, '');
      for (const [name, view] of Object.entries(views)) {
        if (few && !FEW.includes(name)) continue;
        const fixed = { planet: 'earth', fov: 60, exposure: 1, toneMap: 'aces', terrain: true, ...changes };
        const file = join(artifacts, `native-${backend}.png`);
        const values = {
          backend,
          size: `${SIZE.width}x${SIZE.height}`,
          altitude: view.alt,
          pitch: view.pitch,
          heading: view.heading,
          fov: fixed.fov,
          'sun-elevation': view.sunElevation,
          'sun-azimuth': view.sunAzimuth,
          exposure: fixed.exposure,
          ...options,
        };
        const given = Object.entries(values).flatMap(([name, value]) => [`--${name}`, `${value}`]);
        const [here] = await Promise.all([
          canvas(page, { ...fixed, ...view }),
          run(program, ['render', ...given, '-o', file]),
        ]);
        const native = await decode(page, readFileSync(file));
        assert.deepEqual([here.width, here.height], [native.width, native.height]);
        const { max, mean: average } = difference(here.data, native.data);
        const beyond =
          here.data.filter((v, i) => Math.abs(v - native.data[i]) > 2).length / here.data.length;
        t.diagnostic(
          `${name}: at most ${max}/255 apart, mean ${average.toFixed(4)}, ` +
            `${(100 * beyond).toFixed(3)} % of the values by more than 2`,
        );
        // Edges of the terrain's triangles may fall on either side of a pixel's centre; nothing else may
        // differ.
        assert.ok(beyond < 0.002, `${name}: ${100 * beyond} % of the values differ`);
      }
    });
});

describe('choosing a backend', () => {
  it('takes the best one and says so', async (t) => {
    const page = await use(t, { hash: MARCH });
    assert.equal(await page.textContent('#read-backend'), 'webgpu');
    assert.equal(await page.textContent('#why'), 'Backend webgpu: the best that works here');
  });

  it('says why when it takes the second best', async (t) => {
    const page = await use(t, {
      hash: MARCH,
      prepare: () => {
        Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
      },
    });
    assert.equal(await page.textContent('#read-backend'), 'webgl2');
    assert.match(await page.textContent('#why'), /^Backend webgl2: not available: webgpu: ./);
    assert.ok(
      page.lines.some(
        (l) => l.type === 'warning' && /^Backend webgl2: not available: webgpu: ./.test(l.text),
      ),
    );
  });

  it('never takes another than the one asked for', async (t) => {
    const page = await use(
      t,
      {
        backend: 'webgpu',
        ready: false,
        prepare: () => {
          Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
        },
      },
      { complaints: true },
    );
    await waitForLine(page, /^No sky can be drawn here\. webgpu: ./);
    assert.equal(await page.textContent('#read-backend'), 'none');
    assert.match(await page.textContent('#messages'), /No sky can be drawn here\. webgpu: /);
  });

  it('says what is missing when nothing works', async (t) => {
    const page = await use(
      t,
      {
        ready: false,
        prepare: () => {
          Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
          HTMLCanvasElement.prototype.getContext = () => null;
        },
      },
      { complaints: true },
    );
    const { text } = await waitForLine(page, /^No sky can be drawn here\./);
    assert.match(text, /webgpu: .+; webgl2: ./);
  });

  for (const [query, message] of [
    [{ backend: 'metal' }, 'backend = metal is not allowed: must be webgl2 or webgpu'],
    [{ scale: '99' }, 'scale = 99 is not allowed: must be from 0.1 to 8'],
    [{ width: '12.5' }, 'width = 12.5 is not allowed: must be a whole number from 1 to 8192'],
    [{ height: '' }, 'width and height go together: give both or none'],
  ]) {
    it(`refuses ?${new URLSearchParams(query)}`, async (t) => {
      const page = await use(t, { query, ready: false }, { complaints: true });
      await waitForLine(page, `The viewer cannot start. ${message}`);
      assert.match(await page.textContent('#messages'), /cannot start/);
    });
  }
});

describe('controls', () => {
  it('every control has a name and moves the state', async (t) => {
    const page = await use(t, { hash: MARCH });
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('#controls input, #controls select')]
        .filter((c) => c.labels.length === 0)
        .map((c) => c.id),
    );
    assert.deepEqual(nameless, []);
    await page.selectOption('#planet', 'mars');
    await page.fill('#sunElevation', '12.5');
    await page.check('#terrain');
    await page.uncheck('#sky');
    await page.check('#half');
    await page.selectOption('#toneMap', 'agx');
    await page.selectOption('#mode', 'planet');
    const state = await page.evaluate(async () => {
      await welkin.redraw();
      return welkin.state;
    });
    assert.deepEqual(
      [state.planet, state.sunElevation, state.terrain, state.sky, state.half, state.toneMap, state.mode],
      ['mars', 12.5, true, false, true, 'agx', 'planet'],
    );
    assert.equal(
      await page.evaluate(() => document.querySelector('output[for=sunElevation]').textContent),
      '12.5°',
    );
  });
});
