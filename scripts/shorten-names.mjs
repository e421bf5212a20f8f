// Usage: node scripts/shorten-names.mjs GLUE.js MODULE.wasm
//
// wasm-bindgen names each import of the module after what it calls and ends that in 16 random digits, which
// no compression makes smaller; many exports have such names too. This gives both names of one or two
// letters, in both files, drops exports that the glue never asks for, and takes comments and indentation out
// of the glue.
import { readFileSync, writeFileSync } from 'node:fs';

const [glueFile, moduleFile] = process.argv.slice(2);
const [IMPORTS, EXPORTS] = [2, 7]; // the sections' numbers
const SPACE = './welkin_bg.js'; // where wasm-bindgen's imports are from

const module = readFileSync(moduleFile);
let at = 8;
function number() {
  let value = 0;
  for (let shift = 0; ; shift += 7) {
    const byte = module[at++];
    value += (byte & 127) * 2 ** shift;
    if (byte < 128) return value;
  }
}
function bytes(count) {
  at += count;
  return module.subarray(at - count, at);
}
const text = () => bytes(number()).toString();
function encoded(value) {
  const out = [];
  for (; value > 127; value = Math.floor(value / 128)) out.push((value & 127) | 128);
  return Buffer.from([...out, value]);
}
const encodedText = (string) => Buffer.concat([encoded(Buffer.byteLength(string)), Buffer.from(string)]);

const LETTERS = 'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ';
const short = (i) =>
  (i < LETTERS.length ? '' : short(Math.floor(i / LETTERS.length) - 1)) + LETTERS[i % LETTERS.length];

const names = new Map();
const exports = new Map();
const glueAsMade = readFileSync(glueFile, 'utf8');
const asked = new Set(Array.from(glueAsMade.matchAll(/\bwasm\.(\w+)/g), ([, name]) => name));

function shorterImports() {
  const count = number();
  const parts = [encoded(count)];
  for (let i = 0; i < count; i++) {
    const [space, name] = [text(), text()];
    const from = at;
    const what = bytes(1)[0];
    if (space !== SPACE || what !== 0)
      throw new Error(`${moduleFile} imports ${space} ${name}: has wasm-bindgen changed?`);
    number(); // its type
    if (!names.has(name)) names.set(name, short(names.size));
    parts.push(encodedText('w'), encodedText(names.get(name)), module.subarray(from, at));
  }
  return parts;
}

function shorterExports() {
  const count = number();
  const parts = [];
  for (let i = 0; i < count; i++) {
    const name = text();
    const from = at;
    bytes(1); // its kind
    number(); // its index
    if (!asked.has(name)) continue;
    exports.set(name, short(exports.size));
    parts.push(encodedText(exports.get(name)), module.subarray(from, at));
  }
  return [encoded(exports.size), ...parts];
}

const sections = [module.subarray(0, 8)];
while (at < module.length) {
  const begin = at;
  const kind = module[at++];
  const end = number() + at;
  if (kind === IMPORTS || kind === EXPORTS) {
    const body = Buffer.concat(kind === IMPORTS ? shorterImports() : shorterExports());
    sections.push(Buffer.from([kind]), encoded(body.length), body);
  } else {
    at = end;
    sections.push(module.subarray(begin, end));
  }
}
const missing = [...asked].filter((name) => !exports.has(name));
if (missing.length > 0) {
  throw new Error(`${moduleFile} does not export ${missing.join(', ')}: has wasm-bindgen changed?`);
}

let seen = 0;
const glue = glueAsMade
  .replace(/^( +)(\w+)(?=: )/gm, (whole, indent, name) => {
    if (!names.has(name)) return whole;
    seen++;
    return indent + names.get(name);
  })
  .replace(`"${SPACE}": import0`, 'w: import0')
  .replace(/\bwasm\.(\w+)/g, (_, name) => `wasm.${exports.get(name)}`)
  .replace(/^ *\/\*\*.*?\*\/\n/gms, '')
  .replace(/^ *\/\/.*\n/gm, '')
  .replace(/^ +/gm, '');
if (names.size === 0 || seen !== names.size) {
  throw new Error(`${glueFile} has ${seen} of the module's ${names.size} imports: has wasm-bindgen changed?`);
}
writeFileSync(glueFile, glue);
writeFileSync(moduleFile, Buffer.concat(sections));
