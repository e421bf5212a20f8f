// Usage: node scripts/shorten-imports.mjs GLUE.js MODULE.wasm
//
// wasm-bindgen ends the name of each import in 16 random digits, which no compression makes smaller: this counts
// them instead, in both files. Names keep their length, so that the module needs no new layout.
import { readFileSync, writeFileSync } from 'node:fs';

const files = process.argv.slice(2);
const texts = files.map((file) => readFileSync(file, 'latin1'));
const hashed = /__wbg_\w+?_[0-9a-f]{16}(?!\w)/g;
const counts = new Map();
const names = new Map();
// In the module, names are followed by the next entry's bytes, so the glue says which names there are.
for (const [name] of texts[0].matchAll(hashed)) {
  if (names.has(name)) continue;
  const head = name.slice(0, -16);
  const count = counts.get(head) ?? 0;
  counts.set(head, count + 1);
  names.set(name, head + String(count).padStart(16, '0'));
}
if (names.size === 0) throw new Error(`${files[0]} holds no import with a hash: has wasm-bindgen changed?`);
texts.forEach((text, i) => {
  writeFileSync(files[i], text.replace(/__wbg_\w+?_[0-9a-f]{16}/g, (name) => names.get(name) ?? name), 'latin1');
});
