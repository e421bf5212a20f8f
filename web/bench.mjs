// How long a frame takes in a browser, from the first call to the last pixel: prints Markdown tables.
//
// Usage: node web/bench.mjs [--backend webgl2|webgpu] [--only TEXT] [--rounds N] [--seconds S]
//
//   --backend NAME   only this one
//   --rounds N       how often all is timed, in turn; the best frame of all rounds counts (default 3)
//   --only TEXT      only the cases whose name begins with it: --only 'sky alone'
//   --seconds S      at most so long for each measurement in a round, but two frames at least (default 1)
//
// Headless Chromium draws with its software GPU, 1280 × 720, Earth, the sun 20° high. Run scripts/build-web before.
//
// Beside the viewer, and on canvases of the same size, it times two full-screen triangles, each of which draws straight
// to the canvas: a copy of a half-float texture, and the sky of Preetham, Shirley & Smits, "A Practical Analytic
// Model for Daylight" (1999), written for this file from the paper as a stand-in for three.js's Sky.
import { parseArgs } from 'node:util';
import { launch } from './test/browser.mjs';

const SIZE = { width: 1280, height: 720 };
const BACKENDS = ['webgl2', 'webgpu'];
const VIEWS = [
  { name: '500 m', alt: 500, pitch: 12 },
  { name: '400 km', alt: 4e5, pitch: -17 },
  { name: '12,000 km', alt: 1.2e7, pitch: -90 },
];
const TABLES = { quality: 'medium' };
const SINGLE = { samples: [24, 8] };
const CASES = [
  { name: 'sky alone, tables', mode: 'sky-dome', terrain: false, ...TABLES },
  { name: 'sky alone, tables, moving sun', mode: 'sky-dome', terrain: false, ...TABLES, change: 'sun' },
  { name: 'sky alone, single scattering', mode: 'sky-dome', terrain: false, ...SINGLE },
  { name: 'sky and air, tables', mode: 'lut', terrain: false, ...TABLES },
  { name: 'sky and air, tables, moving sun', mode: 'lut', terrain: false, ...TABLES, change: 'sun' },
  { name: 'sky and air, single scattering', mode: 'lut', terrain: false, ...SINGLE },
  { name: 'full picture, tables', mode: 'lut', terrain: true, ...TABLES },
  { name: 'full picture, tables, moving sun', mode: 'lut', terrain: true, ...TABLES, change: 'sun' },
  { name: 'full picture, tables, new medium', mode: 'lut', terrain: true, ...TABLES, change: 'medium' },
  { name: 'full picture, single scattering', mode: 'lut', terrain: true, ...SINGLE },
  { name: 'terrain without an atmosphere', mode: 'lut', terrain: true, ...TABLES, off: true },
];

// ---------------------------------------------------------------- Preetham's sky

/** What depends on the turbidity and the sun's angle from the zenith: five Perez numbers and the zenith, each for Y, x, y. */
function preetham(turbidity, sunZenith) {
  const T = turbidity;
  const s = sunZenith;
  const perez = [
    [0.1787 * T - 1.463, -0.0193 * T - 0.2592, -0.0167 * T - 0.2608],
    [-0.3554 * T + 0.4275, -0.0665 * T + 0.0008, -0.095 * T + 0.0092],
    [-0.0227 * T + 5.3251, -0.0004 * T + 0.2125, -0.0079 * T + 0.2102],
    [0.1206 * T - 2.5771, -0.0641 * T - 0.8989, -0.0441 * T - 1.6537],
    [-0.067 * T + 0.3703, -0.0033 * T + 0.0452, -0.0109 * T + 0.0529],
  ];
  const cubic = (a, b, c, d) => ((a * s + b) * s + c) * s + d;
  const zenith = [
    (4.0453 * T - 4.971) * Math.tan((4 / 9 - T / 120) * (Math.PI - 2 * s)) - 0.2155 * T + 2.4192,
    cubic(0.00166, -0.00375, 0.00209, 0) * T * T + cubic(-0.02903, 0.06377, -0.03202, 0.00394) * T + cubic(0.11693, -0.21196, 0.06052, 0.25886),
    cubic(0.00275, -0.0061, 0.00317, 0) * T * T + cubic(-0.04214, 0.0897, -0.04153, 0.00516) * T + cubic(0.15346, -0.26756, 0.0667, 0.26688),
  ];
  return [...perez, zenith, [0, Math.sin(s), Math.cos(s)]]; // the last: where the sun stands
}

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
@fragment fn fragment_main(@builtin(position) p: vec4f) -> @location(0) vec4f { return textureLoad(source, vec2i(p.xy), 0); }`;
const PREETHAM_GLSL = `#version 300 es
precision highp float;
uniform vec3 k[7];
uniform vec2 size;
out vec4 color;
vec3 perez(float cos_zenith, float angle, float cos_angle) {
  return (1.0 + k[0] * exp(k[1] / cos_zenith)) * (1.0 + k[2] * exp(k[3] * angle) + k[4] * cos_angle * cos_angle);
}
void main() {
  vec2 ndc = 2.0 * gl_FragCoord.xy / size - 1.0;
  vec3 dir = normalize(vec3(ndc.x * size.x / size.y * 0.577, 0.977 - 0.12 * ndc.y, 0.207 + 0.565 * ndc.y));
  float cos_angle = clamp(dot(dir, k[6]), -1.0, 1.0);
  vec3 Yxy = k[5] * perez(max(dir.z, 0.01), acos(cos_angle), cos_angle) / perez(1.0, acos(k[6].z), k[6].z);
  vec3 XYZ = vec3(Yxy.y, Yxy.z, 1.0 - Yxy.y - Yxy.z) * Yxy.x / Yxy.z;
  vec3 rgb = mat3(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570) * XYZ;
  color = vec4(pow(1.0 - exp(-0.1 * max(rgb, 0.0)), vec3(1.0 / 2.2)), 1.0);
}`;
const PREETHAM_WGSL = `${TRIANGLE_WGSL}
struct Sky { k: array<vec4f, 7>, size: vec4f }
@group(0) @binding(0) var<uniform> sky: Sky;
fn perez(cos_zenith: f32, angle: f32, cos_angle: f32) -> vec3f {
  return (1.0 + sky.k[0].xyz * exp(sky.k[1].xyz / cos_zenith))
    * (1.0 + sky.k[2].xyz * exp(sky.k[3].xyz * angle) + sky.k[4].xyz * cos_angle * cos_angle);
}
@fragment fn fragment_main(@builtin(position) p: vec4f) -> @location(0) vec4f {
  let size = sky.size.xy;
  let ndc = (2.0 * p.xy / size - 1.0) * vec2f(1.0, -1.0);
  let dir = normalize(vec3f(ndc.x * size.x / size.y * 0.577, 0.977 - 0.12 * ndc.y, 0.207 + 0.565 * ndc.y));
  let cos_angle = clamp(dot(dir, sky.k[6].xyz), -1.0, 1.0);
  let Yxy = sky.k[5].xyz * perez(max(dir.z, 0.01), acos(cos_angle), cos_angle) / perez(1.0, acos(sky.k[6].z), sky.k[6].z);
  let XYZ = vec3f(Yxy.y, Yxy.z, 1.0 - Yxy.y - Yxy.z) * Yxy.x / Yxy.z;
  let rgb = mat3x3f(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570) * XYZ;
  return vec4f(pow(1.0 - exp(-0.1 * max(rgb, vec3f(0.0))), vec3f(1.0 / 2.2)), 1.0);
}`;

// ---------------------------------------------------------------- in the page

/** Before the page's own scripts: keeps the WebGPU device, to ask it when it is done, and holds what times frames. */
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
  const finish = viewer.backend === 'webgl2'
    ? () => finishGl(canvas.getContext('webgl2'))
    : () => window.device_.queue.onSubmittedWorkDone();
  const before = {
    // One sun after another: tables that know the sun are made again each frame.
    sun: (i) => { viewer.set_sun(20 + 0.01 * (i % 7), 40); },
    // Away and back: all tables are made again.
    medium: () => { viewer.set_planet('mars'); viewer.render(); viewer.set_planet('earth'); return true; },
  }[one.change];
  return bestFrame(seconds, before, () => viewer.render(), finish);
}

/** In the page: a full-screen triangle on a canvas of its own. `k`: uniforms of the sky, or none to copy. */
async function timeTriangle({ backend, size: { width, height }, vertex, fragment, k, seconds }) {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width, height });
  canvas.style.cssText = 'position: fixed; left: 0; top: 0';
  document.body.append(canvas);
  let best;
  let pixel;
  if (backend === 'webgl2') {
    const gl = canvas.getContext('webgl2', { antialias: false, depth: false, alpha: false, preserveDrawingBuffer: true });
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);
    gl.viewport(0, 0, width, height);
    if (k) {
      gl.uniform3fv(gl.getUniformLocation(program, 'k'), k.flat());
      gl.uniform2f(gl.getUniformLocation(program, 'size'), width, height);
    } else {
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA16F, width, height);
      const half = new Uint16Array(width * height * 4).fill(0x3800); // 0.5
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RGBA, gl.HALF_FLOAT, half);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    }
    best = await bestFrame(seconds, null, () => gl.drawArrays(gl.TRIANGLES, 0, 3), () => { pixel = finishGl(gl); });
    if (gl.getError()) throw new Error('a WebGL error');
    gl.getExtension('WEBGL_lose_context').loseContext();
  } else {
    const adapter = await navigator.gpu.requestAdapter();
    const kept = window.device_;
    const device = await adapter.requestDevice();
    window.device_ = kept;
    device.pushErrorScope('validation');
    const context = canvas.getContext('webgpu');
    context.configure({ device, format: 'rgba8unorm', alphaMode: 'opaque', usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC });
    const module = device.createShaderModule({ code: fragment });
    const pipeline = device.createRenderPipeline({ layout: 'auto', vertex: { module }, fragment: { module, targets: [{ format: 'rgba8unorm' }] } });
    let resource;
    if (k) {
      const values = new Float32Array([...k.flatMap((v) => [...v, 0]), width, height, 0, 0]);
      const buffer = device.createBuffer({ size: values.byteLength, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
      device.queue.writeBuffer(buffer, 0, values);
      resource = { buffer };
    } else {
      const texture = device.createTexture({ size: [width, height], format: 'rgba16float', usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST });
      const half = new Uint16Array(width * height * 4).fill(0x3800);
      device.queue.writeTexture({ texture }, half, { bytesPerRow: width * 8 }, [width, height]);
      resource = texture.createView();
    }
    const group = device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries: [{ binding: 0, resource }] });
    const read = device.createBuffer({ size: 256, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const draw = (keep) => {
      const encoder = device.createCommandEncoder();
      const texture = context.getCurrentTexture();
      const pass = encoder.beginRenderPass({ colorAttachments: [{ view: texture.createView(), loadOp: 'clear', storeOp: 'store' }] });
      pass.setPipeline(pipeline);
      pass.setBindGroup(0, group);
      pass.draw(3);
      pass.end();
      if (keep) encoder.copyTextureToBuffer({ texture, origin: [640, height - 1 - 500] }, { buffer: read }, [1, 1]);
      device.queue.submit([encoder.finish()]);
    };
    best = await bestFrame(seconds, null, () => draw(false), () => device.queue.onSubmittedWorkDone());
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

// ---------------------------------------------------------------- all of it

function options() {
  const { values } = parseArgs({ options: { backend: { type: 'string' }, only: { type: 'string' }, rounds: { type: 'string' }, seconds: { type: 'string' } } });
  const number = (key, usual, min, max) => {
    const value = values[key] === undefined ? usual : Number(values[key] || NaN);
    if (!(value >= min && value <= max)) throw new Error(`--${key} ${values[key]} is not allowed: must be from ${min} to ${max}`);
    return value;
  };
  if (values.backend !== undefined && !BACKENDS.includes(values.backend)) {
    throw new Error(`--backend ${values.backend} is not allowed: must be webgl2 or webgpu`);
  }
  const cases = CASES.filter(({ name }) => name.startsWith(values.only ?? ''));
  if (!cases.length) {
    throw new Error(`--only ${values.only} is not allowed: must begin one of ${CASES.map((c) => c.name).join('; ')}`);
  }
  return {
    backends: values.backend ? [values.backend] : BACKENDS,
    cases,
    rounds: number('rounds', 3, 1, 100),
    seconds: number('seconds', 1, 0, 600),
  };
}

const ms = (x) => (x < 100 ? x.toFixed(1) : x.toFixed(0));

async function main() {
  const { backends, cases, rounds, seconds } = options();
  const browser = await launch();
  try {
    const k = preetham(2.2, (70 * Math.PI) / 180);
    const best = new Map();
    const take = (key, value) => best.set(key, Math.min(best.get(key) ?? Infinity, value));
    let adapter = '';
    for (let round = 1; round <= rounds; round++) {
      for (const backend of backends) {
        const page = await browser.open({ backend, prepare, query: SIZE });
        adapter = await page.textContent('#read-adapter');
        for (const [name, texts, uniforms] of [['copy', [COPY_GLSL, COPY_WGSL]], ['Preetham', [PREETHAM_GLSL, PREETHAM_WGSL], k]]) {
          const fragment = texts[BACKENDS.indexOf(backend)];
          const { best: time, pixel: [r, g, b] } = await page.evaluate(timeTriangle, {
            backend, size: SIZE, vertex: TRIANGLE_GLSL, fragment, k: uniforms, seconds,
          });
          const right = uniforms ? b > g && g > r && r > 0 && b < 255 : [r, g, b].every((v) => v === 127 || v === 128);
          if (!right) throw new Error(`${backend}: the ${name} triangle drew ${r} ${g} ${b}`);
          take(`${backend} ${name}`, time);
        }
        for (const view of VIEWS) {
          for (const one of cases) {
            take(`${backend} ${view.name} ${one.name}`, await page.evaluate(timeViewer, { view, one, seconds }));
          }
          console.error(`round ${round}, ${backend}, ${view.name}`);
        }
        if (page.problems.length) throw new Error(page.problems.join('\n'));
        await page.context().close();
      }
    }
    const date = new Date().toISOString().slice(0, 10);
    console.log(`Chromium ${browser.version}, ${SIZE.width} × ${SIZE.height}, ${date}, best frame of ${rounds} rounds, ms (ratio to the Preetham sky).`);
    console.log(`${adapter}\n`);
    const sky = (backend) => best.get(`${backend} Preetham`);
    for (const backend of backends) {
      console.log(`${backend}: copy ${ms(best.get(`${backend} copy`))} ms, Preetham sky ${ms(sky(backend))} ms.`);
    }
    for (const backend of backends) {
      console.log(`\n| ${backend} | ${VIEWS.map((v) => `from ${v.name}`).join(' | ')} |\n|---|${VIEWS.map(() => '---:|').join('')}`);
      for (const { name } of cases) {
        const cells = VIEWS.map((view) => {
          const time = best.get(`${backend} ${view.name} ${name}`);
          return `${ms(time)} (${(time / sky(backend)).toFixed(1)}×)`;
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
