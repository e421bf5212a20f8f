// How long a frame takes in a browser, from the first call to the last pixel: prints Markdown tables.
//
// Usage: node web/bench.mjs [--backend webgl2|webgpu] [--only TEXT] [--rounds N] [--seconds S] [--old DIR]
//
//   --backend NAME   only this one
//   --rounds N       how often all is timed, in turn; the best frame of all rounds counts (default 3)
//   --only TEXT      only the cases whose name begins with it: --only 'sky alone'
//   --seconds S      at most so long for each measurement in a round, but two frames at least (default 1)
//   --old DIR        also times the page in DIR, the folder web/ of an earlier checkout with its module
//                    built, in turn with this one (each begins every other round), and prints what it
//                    takes, and of the rounds' ratios of this page's time to it the middle one and the range
//
// Headless Chromium draws with its software GPU, 1280 × 720, Earth, the sun 20° high. Run scripts/build-web
// before.
//
// Beside the viewer, and on canvases of the same size, it times a full-screen triangle that copies a
// half-float texture, and three.js's Sky (Preetham, Shirley & Smits 1999), tone-mapped with ACES: Sky on
// WebGL2, SkyMesh on WebGPU.
import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { BACKENDS, launch } from './test/browser.mjs';

const SIZE = { width: 1280, height: 720 };
const VIEWS = [
  { name: '500 m', alt: 500, pitch: 12 },
  { name: '400 km', alt: 4e5, pitch: -17 },
  { name: '12,000 km', alt: 1.2e7, pitch: -90 },
];
const LUTS = { quality: 'medium' };
const SINGLE = { samples: [24, 8] };
const CASES = [
  { name: 'sky alone, LUTs', mode: 'sky-dome', terrain: false, ...LUTS },
  { name: 'sky alone, LUTs, moving sun', mode: 'sky-dome', terrain: false, ...LUTS, change: 'sun' },
  { name: 'sky alone, single scattering', mode: 'sky-dome', terrain: false, ...SINGLE },
  { name: 'sky and air, LUTs', mode: 'lut', terrain: false, ...LUTS },
  { name: 'sky and air, LUTs, moving sun', mode: 'lut', terrain: false, ...LUTS, change: 'sun' },
  { name: 'sky and air, single scattering', mode: 'lut', terrain: false, ...SINGLE },
  { name: 'full picture, LUTs', mode: 'lut', terrain: true, ...LUTS },
  { name: 'full picture, LUTs, moving sun', mode: 'lut', terrain: true, ...LUTS, change: 'sun' },
  { name: 'full picture, LUTs, new medium', mode: 'lut', terrain: true, ...LUTS, change: 'medium' },
  { name: 'full picture, single scattering', mode: 'lut', terrain: true, ...SINGLE },
  { name: 'terrain without an atmosphere', mode: 'lut', terrain: true, ...LUTS, off: true },
];

// ---------------------------------------------------------------- a copy

const TRIANGLE_GLSL = `#version 300 es
void main() {
  vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
  gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}`;
const TRIANGLE_WGSL = `
@vertex fn vertex_main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
  return vec4f(2.0 * vec2f(vec2u((i << 1) & 2, i & 2)) - 1.0, 0.0, 1.0);
}`;
const COPY_GLSL = `#version 300 es
precision highp float;
uniform highp sampler2D source;
out vec4 color;
void main() { color = texelFetch(source, ivec2(gl_FragCoord.xy), 0); }`;
const COPY_WGSL = `${TRIANGLE_WGSL}
@group(0) @binding(0) var source: texture_2d<f32>;
@fragment fn fragment_main(@builtin(position) p: vec4f) -> @location(0) vec4f {
    return textureLoad(source, vec2i(p.xy), 0);
}`;
// ---------------------------------------------------------------- in the page

/**
 * Before the page's own scripts: keeps the WebGPU device, to ask it when it is done, and holds what times
 * frames.
 */
function prepare() {
  if (globalThis.GPUAdapter) {
    const { requestDevice } = GPUAdapter.prototype;
    GPUAdapter.prototype.requestDevice = async function (...args) {
      window.device_ = await requestDevice.apply(this, args);
      return window.device_;
    };
  }
  /** Waits until a WebGL2 canvas holds what was drawn: a pixel of it is read. */
  window.finishGl = (gl) => {
    const bound = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    gl.finish();
    const pixel = new Uint8Array(4);
    gl.readPixels(640, 500, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, bound);
    return pixel;
  };
  /** The best frame in milliseconds. `before` is not timed. */
  window.bestFrame = async (seconds, before, draw, finish) => {
    let best = Infinity;
    const end = performance.now() + 1000 * seconds;
    for (let i = 0; i < 3 || (performance.now() < end && i < 200); i++) {
      if (await before?.(i)) await finish();
      const start = performance.now();
      draw();
      await finish();
      if (i > 0) best = Math.min(best, performance.now() - start); // the first compiles
    }
    return best;
  };
}

/** In the page: one case of the viewer. */
async function timeViewer({ view, one, seconds }) {
  const { viewer } = welkin;
  const canvas = document.querySelector('#stage canvas');
  viewer.set_planet('earth');
  viewer.set_camera(view.alt, view.pitch, 0, 60);
  viewer.set_sun(20, 40);
  viewer.set_mode(one.mode);
  if (one.quality) viewer.set_quality(one.quality);
  else viewer.set_samples(...one.samples);
  viewer.set_terrain(one.terrain);
  viewer.set_enabled(!one.off);
  const finish =
    viewer.backend === 'webgl2'
      ? () => finishGl(canvas.getContext('webgl2'))
      : () => window.device_.queue.onSubmittedWorkDone();
  const before = {
    // One sun after another: LUTs that know the sun are made again each frame.
    sun: (i) => {
      viewer.set_sun(20 + 0.01 * (i % 7), 40);
    },
    // Away and back: all LUTs are made again.
    medium: () => {
      viewer.set_planet('mars');
      viewer.render();
      viewer.set_planet('earth');
      return true;
    },
  }[one.change];
  return bestFrame(seconds, before, () => viewer.render(), finish);
}

/** In the page: a full-screen triangle on a canvas of its own copies a texture. */
async function timeCopy({ backend, size: { width, height }, vertex, fragment, seconds }) {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  canvas.style.cssText = 'position: fixed; left: 0; top: 0';
  document.body.append(canvas);
  let best;
  let pixel;
  if (backend === 'webgl2') {
    const gl = canvas.getContext('webgl2', {
      antialias: false,
      depth: false,
      alpha: false,
      preserveDrawingBuffer: true,
    });
    const program = gl.createProgram();
    for (const [kind, text] of [
      [gl.VERTEX_SHADER, vertex],
      [gl.FRAGMENT_SHADER, fragment],
    ]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);
    gl.viewport(0, 0, width, height);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA16F, width, height);
    const half = new Uint16Array(width * height * 4).fill(0x3800); // 0.5
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.HALF_FLOAT, half);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    best = await bestFrame(
      seconds,
      null,
      () => gl.drawArrays(gl.TRIANGLES, 0, 3),
      () => {
        pixel = finishGl(gl);
      },
    );
    if (gl.getError()) throw new Error('a WebGL error');
    gl.getExtension('WEBGL_lose_context').loseContext();
  } else {
    const adapter = await navigator.gpu.requestAdapter();
    const kept = window.device_;
    const device = await adapter.requestDevice();
    window.device_ = kept;
    device.pushErrorScope('validation');
    const context = canvas.getContext('webgpu');
    context.configure({
      device,
      format: 'rgba8unorm',
      alphaMode: 'opaque',
      usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC,
    });
    const module = device.createShaderModule({ code: fragment });
    const pipeline = device.createRenderPipeline({
      layout: 'auto',
      vertex: { module },
      fragment: { module, targets: [{ format: 'rgba8unorm' }] },
    });
    const texture = device.createTexture({
      size: [width, height],
      format: 'rgba16float',
      usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST,
    });
    const half = new Uint16Array(width * height * 4).fill(0x3800);
    device.queue.writeTexture({ texture }, half, { bytesPerRow: width * 8 }, [width, height]);
    const resource = texture.createView();
    const group = device.createBindGroup({
      layout: pipeline.getBindGroupLayout(0),
      entries: [{ binding: 0, resource }],
    });
    const read = device.createBuffer({ size: 256, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const draw = (keep) => {
      const encoder = device.createCommandEncoder();
      const texture = context.getCurrentTexture();
      const pass = encoder.beginRenderPass({
        colorAttachments: [{ view: texture.createView(), loadOp: 'clear', storeOp: 'store' }],
      });
      pass.setPipeline(pipeline);
      pass.setBindGroup(0, group);
      pass.draw(3);
      pass.end();
      if (keep)
        encoder.copyTextureToBuffer({ texture, origin: [640, height - 1 - 500] }, { buffer: read }, [1, 1]);
      device.queue.submit([encoder.finish()]);
    };
    best = await bestFrame(
      seconds,
      null,
      () => draw(false),
      () => device.queue.onSubmittedWorkDone(),
    );
    draw(true);
    await read.mapAsync(GPUMapMode.READ);
    pixel = new Uint8Array(read.getMappedRange().slice(0, 4));
    const error = await device.popErrorScope();
    if (error) throw new Error(error.message);
    device.destroy();
  }
  canvas.remove();
  return { best, pixel: Array.from(pixel) };
}

/** In the page: three.js's Sky on a canvas of its own. */
async function timeThree({ backend, size: { width, height }, view, seconds }) {
  const gpu = backend === 'webgpu';
  const folder = '/node_modules/three/';
  if (!document.querySelector('script[type=importmap]')) {
    const map = document.createElement('script');
    map.type = 'importmap';
    map.textContent = JSON.stringify({
      imports: {
        three: `${folder}build/three.${gpu ? 'webgpu' : 'module'}.js`,
        'three/webgpu': `${folder}build/three.webgpu.js`,
        'three/tsl': `${folder}build/three.tsl.js`,
      },
    });
    document.head.append(map);
  }
  const THREE = await import('three');
  const { Sky, SkyMesh } = await import(`${folder}examples/jsm/objects/${gpu ? 'SkyMesh' : 'Sky'}.js`);
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  document.body.append(canvas);
  const renderer = new THREE[gpu ? 'WebGPURenderer' : 'WebGLRenderer']({ canvas, antialias: false });
  const kept = window.device_; // the viewer's
  await renderer.init?.();
  window.device_ = kept;
  renderer.setSize(width, height, false);
  renderer.toneMapping = THREE.ACESFilmicToneMapping;
  renderer.toneMappingExposure = 0.5;
  const scene = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(60, width / height, 100, 2e6);
  camera.rotation.x = (view.pitch * Math.PI) / 180;
  const sky = gpu ? new SkyMesh() : new Sky();
  sky.scale.setScalar(450000);
  scene.add(sky);
  // 20° high, 40° to the right of the view.
  const settings = gpu ? sky : sky.material.uniforms;
  settings.sunPosition.value.setFromSphericalCoords(1, (70 * Math.PI) / 180, (140 * Math.PI) / 180);
  settings.turbidity.value = 2.2;
  const finish = gpu
    ? () => renderer.backend.device.queue.onSubmittedWorkDone()
    : () => finishGl(renderer.getContext());
  const best = await bestFrame(seconds, null, () => renderer.render(scene, camera), finish);
  const shown = document.createElement('canvas');
  Object.assign(shown, { width, height });
  renderer.render(scene, camera);
  const context = shown.getContext('2d');
  context.drawImage(canvas, 0, 0);
  const [r, g, b] = context.getImageData(640, 200, 1, 1).data;
  renderer.dispose();
  canvas.remove();
  return { best, pixel: [r, g, b], revision: THREE.REVISION };
}

// ---------------------------------------------------------------- all of it

function options() {
  const { values } = parseArgs({
    options: {
      backend: { type: 'string' },
      only: { type: 'string' },
      rounds: { type: 'string' },
      seconds: { type: 'string' },
      old: { type: 'string' },
    },
  });
  const number = (key, usual, min, max) => {
    const value = values[key] === undefined ? usual : Number(values[key] || NaN);
    if (!(value >= min && value <= max))
      throw new Error(`--${key} ${values[key]} is not allowed: must be from ${min} to ${max}`);
    return value;
  };
  if (values.backend !== undefined && !BACKENDS.includes(values.backend)) {
    throw new Error(`--backend ${values.backend} is not allowed: must be ${BACKENDS.join(' or ')}`);
  }
  const cases = CASES.filter(({ name }) => name.startsWith(values.only ?? ''));
  if (!cases.length) {
    throw new Error(
      `--only ${values.only} is not allowed: must begin one of ${CASES.map((c) => c.name).join('; ')}`,
    );
  }
  const old = values.old && resolve(values.old);
  if (old !== undefined && !['viewer.js', 'pkg'].every((file) => existsSync(join(old, file)))) {
    throw new Error(
      `--old ${values.old} is not allowed: must be a folder with viewer.js and a built module in pkg`,
    );
  }
  return {
    old,
    backends: values.backend ? [values.backend] : BACKENDS,
    cases,
    rounds: number('rounds', 3, 1, 100),
    seconds: number('seconds', 1, 0, 600),
  };
}

const ms = (x) => (x < 100 ? x.toFixed(1) : x.toFixed(0));

async function main() {
  const { old, backends, cases, rounds, seconds } = options();
  const browser = await launch({ folders: old ? [old] : [] });
  try {
    // Of each round.
    const times = new Map();
    const take = (key, value) => times.set(key, [...(times.get(key) ?? []), value]);
    let adapter = '';
    let revision = '';
    for (let round = 1; round <= rounds; round++) {
      for (const backend of backends) {
        const page = await browser.open({ backend, prepare, query: SIZE });
        adapter = await page.textContent('#read-adapter');
        const fragment = backend === 'webgl2' ? COPY_GLSL : COPY_WGSL;
        const copy = await page.evaluate(timeCopy, {
          backend,
          size: SIZE,
          vertex: TRIANGLE_GLSL,
          fragment,
          seconds,
        });
        if (!copy.pixel.slice(0, 3).every((v) => v === 127 || v === 128))
          throw new Error(`${backend}: the copy drew ${copy.pixel}`);
        take(`${backend} copy`, copy.best);
        const three = await page.evaluate(timeThree, { backend, size: SIZE, view: VIEWS[0], seconds });
        const [r, g, b] = three.pixel;
        if (!(b > g && g > r && r > 0 && b < 255))
          throw new Error(`${backend}: three.js drew ${three.pixel}`);
        take(`${backend} three`, three.best);
        revision = three.revision;
        const pages = [['', page]];
        if (old) pages.push(['old ', await browser.open({ folder: old, backend, prepare, query: SIZE })]);
        if (round % 2 === 0) pages.reverse();
        for (const view of VIEWS) {
          for (const one of cases) {
            for (const [which, opened] of pages) {
              await opened.bringToFront();
              take(
                `${which}${backend} ${view.name} ${one.name}`,
                await opened.evaluate(timeViewer, { view, one, seconds }),
              );
            }
          }
          console.error(`round ${round}, ${backend}, ${view.name}`);
        }
        for (const [, opened] of pages) {
          if (opened.problems.length) throw new Error(opened.problems.join('\n'));
          await opened.context().close();
        }
      }
    }
    const best = (key) => Math.min(...times.get(key));
    const date = new Date().toISOString().slice(0, 10);
    console.log(
      `Chromium ${browser.version}, ${SIZE.width} × ${SIZE.height}, ${date}, ` +
        `best frame of ${rounds} rounds, ms ` +
        `(ratio to three.js's Sky, revision ${revision}).`,
    );
    console.log(`${adapter}\n`);
    const sky = (backend) => best(`${backend} three`);
    for (const backend of backends) {
      console.log(
        `${backend}: copy ${ms(best(`${backend} copy`))} ms, three.js's Sky ${ms(sky(backend))} ms.`,
      );
    }
    const against = (key) => {
      const before = times.get(`old ${key}`);
      const ratios = times.get(key).map((time, i) => time / before[i]);
      ratios.sort((a, b) => a - b);
      const middle = 0.5 * (ratios[(rounds - 1) >> 1] + ratios[rounds >> 1]);
      const shown = [middle, ratios[0], ratios[rounds - 1]].map((x) => x.toFixed(3));
      return `, before ${ms(Math.min(...before))}: ${shown[0]} (${shown[1]} to ${shown[2]})`;
    };
    for (const backend of backends) {
      console.log(
        `\n| ${backend} | ${VIEWS.map((v) => `from ${v.name}`).join(' | ')} |\n` +
          `|---|${VIEWS.map(() => '---:|').join('')}`,
      );
      for (const { name } of cases) {
        const cells = VIEWS.map((view) => {
          const key = `${backend} ${view.name} ${name}`;
          const time = best(key);
          return `${ms(time)} (${(time / sky(backend)).toFixed(1)}×)${old ? against(key) : ''}`;
        });
        console.log(`| ${name} | ${cells.join(' | ')} |`);
      }
    }
  } finally {
    await browser.close();
  }
}

main().catch((error) => {
  console.error(`bench: ${error.message}`);
  process.exitCode = 1;
});
