// A browser and a server for the page tests. Whatever is missing is a failure, never a skip.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { dirname, extname, join, normalize, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

export const web = join(dirname(fileURLToPath(import.meta.url)), '..');
export const artifacts = join(web, '..', 'target', 'artifacts');
mkdirSync(artifacts, { recursive: true });

export const SIZE = { width: 320, height: 200 };

export const BACKENDS = ['webgl2', 'webgpu'];

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
};

/** Serve a folder on a free port of this machine. */
async function serve(folder) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname)).replace(
      /[/\\]$/,
      '/index.html',
    );
    const file = join(folder, path);
    try {
      if (!file.startsWith(folder + sep)) throw new Error('outside');
      const body = await readFile(file);
      response.writeHead(200, {
        'content-type': TYPES[extname(file)] ?? 'application/octet-stream',
        'cache-control': 'no-store',
      });
      response.end(body);
    } catch {
      response.writeHead(404).end('not found');
    }
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  return server;
}

function chromiumPath() {
  if (process.env.CHROMIUM) return process.env.CHROMIUM;
  for (const name of ['chromium', 'chromium-browser', 'google-chrome']) {
    try {
      return execFileSync('sh', ['-c', `command -v ${name}`], { encoding: 'utf8' }).trim();
    } catch {
      /* next */
    }
  }
  throw new Error('no Chromium: run scripts/setup, or set CHROMIUM');
}

// Software rendering for both backends. Without the three that name SwiftShader for Vulkan and ANGLE,
// presenting a WebGPU canvas loses the device.
const FLAGS = [
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--enable-unsafe-webgpu',
  '--use-webgpu-adapter=swiftshader',
  '--enable-unsafe-swiftshader',
  '--enable-features=Vulkan',
  '--use-vulkan=swiftshader',
  '--use-angle=swiftshader',
];

/** The files of the module that the page downloads for a backend. */
export const moduleFiles = (backend) =>
  ['welkin.js', 'welkin_bg.wasm'].map((file) => join(web, 'pkg', backend, file));

/**
 * A running browser, its `version`, with `open` for pages of the viewer. Call `close` at the end. `folders`
 * are served beside web/, each at a place of its own.
 */
export async function launch({ folders = [] } = {}) {
  const missing = BACKENDS.flatMap(moduleFiles).filter((file) => !existsSync(file));
  if (missing.length) throw new Error(`${missing.join(', ')}: not built, run scripts/build-web`);
  const servers = await Promise.all([web, ...folders].map(serve));
  const browser = await chromium.launch({
    executablePath: chromiumPath(),
    args: FLAGS,
    chromiumSandbox: process.getuid?.() !== 0, // Chromium's sandbox does not start as root
  });
  const bases = new Map(
    [web, ...folders].map((folder, i) => [folder, `http://localhost:${servers[i].address().port}/`]),
  );

  /**
   * Open the viewer, or another page by its `path`, of web/ or one of the `folders`. `page.lines` holds every
   * console line as {type, text}, `page.problems` what went wrong in it: uncaught errors and console errors,
   * `page.downloads` the paths that it asked the server for.
   */
  async function open({
    folder = web,
    path = '',
    backend,
    hash = '',
    query = {},
    prepare,
    ready = true,
    context: settings = {},
  } = {}) {
    const context = await browser.newContext({ viewport: { width: 900, height: 600 }, ...settings });
    const page = await context.newPage();
    page.lines = [];
    page.problems = [];
    page.downloads = [];
    page.on('request', (r) => page.downloads.push(new URL(r.url()).pathname));
    page.on('console', (m) => {
      page.lines.push({ type: m.type(), text: m.text() });
      if (m.type() === 'error') page.problems.push(m.text());
    });
    page.on('pageerror', (e) => page.problems.push(String(e)));
    if (prepare) await page.addInitScript(prepare);
    const search = new URLSearchParams({ ...SIZE, ...(backend ? { backend } : {}), ...query });
    for (const key of [...search.keys()]) if (search.get(key) === '') search.delete(key);
    await page.goto(`${bases.get(folder)}${path}?${search}${hash ? `#${hash}` : ''}`);
    if (ready) await waitForLine(page, 'Sky renderer initialized');
    return page;
  }

  async function close() {
    await browser.close();
    await Promise.all(servers.map((server) => new Promise((closed) => server.close(closed))));
  }
  return { open, close, version: browser.version() };
}

/** Wait until the page has written a console line that is, or matches, `wanted`. */
export async function waitForLine(page, wanted, { seconds = 60, from = 0 } = {}) {
  const fits = ({ text }) => (wanted instanceof RegExp ? wanted.test(text) : text === wanted);
  const end = Date.now() + seconds * 1000;
  for (;;) {
    const line = page.lines.slice(from).find(fits);
    if (line) return line;
    if (Date.now() > end) {
      const said = page.lines.map((l) => `  ${l.type}: ${l.text}`).join('\n');
      throw new Error(
        `no console line ${wanted} in ${seconds} s; the page said:\n` +
          `${said || '  nothing'}\n${page.problems.join('\n')}`,
      );
    }
    await new Promise((done) => setTimeout(done, 50));
  }
}

// In the page: bytes as text, which comes back far faster than a list of numbers.
const asText = () => {
  window.asText_ ??= (bytes) => {
    let out = '';
    for (let i = 0; i < bytes.length; i += 32768) out += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(out);
  };
};

/** Change settings, draw, and return the radiance of every pixel: rows from the top, r g b a. */
export async function pixels(page, changes = {}) {
  await page.evaluate(asText);
  const text = await page.evaluate(async (changes) => {
    Object.assign(welkin.state, changes);
    await welkin.redraw();
    const floats = await welkin.readPixels();
    return asText_(new Uint8Array(floats.buffer, floats.byteOffset, floats.byteLength));
  }, changes);
  const bytes = Buffer.from(text, 'base64');
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
}

/** What the page shows in the canvas's place, as bytes r g b a, rows from the top. Slow. */
export async function shown(page) {
  const png = await page
    .locator('#stage canvas')
    .screenshot({ animations: 'disabled', style: '#panel, #readout, #messages { display: none }' });
  return decode(page, png);
}

/** Change settings, draw, and return what the canvas then holds: bytes r g b a, rows from the top. */
export async function canvas(page, changes = {}) {
  await page.evaluate(asText);
  const { text, ...size } = await page.evaluate(async (changes) => {
    Object.assign(welkin.state, changes);
    await welkin.redraw();
    // A canvas can be copied only in the task that drew into it.
    welkin.viewer.render();
    const canvas = document.querySelector('#stage canvas');
    const { width, height } = canvas;
    const paper = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    paper.drawImage(canvas, 0, 0);
    return { text: asText_(paper.getImageData(0, 0, width, height).data), width, height };
  }, changes);
  return { ...size, data: Buffer.from(text, 'base64') };
}

/** A PNG's pixels, decoded by the page: bytes r g b a, rows from the top. */
export async function decode(page, png) {
  await page.evaluate(asText);
  const { text, ...size } = await page.evaluate(async (base64) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const { width, height } = image;
    const paper = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
    paper.drawImage(image, 0, 0);
    return { text: asText_(paper.getImageData(0, 0, width, height).data), width, height };
  }, png.toString('base64'));
  return { ...size, data: Buffer.from(text, 'base64') };
}

/** Mean r, g, b of the rows from fraction `top` to fraction `bottom` of a picture. */
export function mean(data, top = 0, bottom = 1, { width, height } = SIZE) {
  const sum = [0, 0, 0];
  let n = 0;
  for (let y = Math.round(top * height); y < Math.round(bottom * height); y++) {
    for (let x = 0; x < width; x++, n++) {
      for (let c = 0; c < 3; c++) sum[c] += data[4 * (y * width + x) + c];
    }
  }
  return sum.map((s) => s / n);
}

export const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** Largest and mean absolute difference of two pictures. */
export function difference(a, b) {
  if (a.length !== b.length)
    throw new Error(`pictures of different size: ${a.length} and ${b.length} values`);
  let max = 0;
  let sum = 0;
  for (let i = 0; i < a.length; i++) {
    const d = Math.abs(a[i] - b[i]);
    if (!(d <= max)) max = d; // also takes a NaN
    sum += d;
  }
  return { max, mean: sum / a.length };
}

/**
 * Largest difference of two pictures as a share of the value it is in. Values far darker than the
 * picture is elsewhere count as a hundredth of its usual level, which the sun's disk does not raise.
 */
export function relativeDifference(a, b) {
  const colour = Array.from(a.filter((_, i) => i % 4 !== 3)).sort((x, y) => x - y);
  const usual =
    colour.slice(0, Math.floor(colour.length * 0.99)).reduce((s, x) => s + x, 0) / (colour.length * 0.99);
  let worst = 0;
  for (let i = 0; i < a.length; i++) {
    const share = Math.abs(a[i] - b[i]) / Math.max(Math.abs(a[i]), Math.abs(b[i]), 0.01 * usual);
    if (!(share <= worst)) worst = share;
  }
  return worst;
}
