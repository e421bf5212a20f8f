// What `cargo lab stress` does, in headless Chromium: the shaders' functions on a million cases, against f64.
//
// Usage: node web/stress.mjs [--backend webgl2|webgpu] [--cases N] [--seed S] [--case NUMBER]
//
//   --backend NAME   only this one
//   --cases N        how many, the grid of hard cases first (default 1000000)
//   --seed S         which random cases follow the grid (default 1)
//   --case NUMBER    only this one: its inputs, and every number that comes back
//
// Prints a table for each backend, and keeps its numbers in target/artifacts/stress-BACKEND.tsv for
// `cargo lab stress --table`. Exit status 1 when a promise is broken. Run scripts/build-web and
// scripts/build-web --probe before.
import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { BACKENDS, artifacts, launch, waitForLine, web } from './test/browser.mjs';

/** A page with the probe's module on a backend. */
export async function openStress(browser, { backend, seed = 1, cases = 1 }) {
  if (!existsSync(join(web, 'test', 'pkg', 'welkin_bg.wasm')))
    throw new Error('web/test/pkg is not built: run scripts/build-web --probe');
  const page = await browser.open({ path: 'test/probe.html', ready: false });
  await waitForLine(page, 'ready');
  page.about = await page.evaluate((how) => window.open_(how), {
    backend,
    browser: `Chromium ${browser.version}`,
    seed,
    cases,
  });
  return page;
}

/** Try all cases; `judged` is told how many are. */
export async function stress(browser, { backend, seed, cases, judged = () => {} }) {
  const page = await openStress(browser, { backend, seed, cases });
  const begun = Date.now();
  for (let done = 0; done < cases;) judged((done = await page.evaluate(() => window.stress.advance())));
  const result = await page.evaluate(async () => ({
    table: stress.table(),
    saved: stress.save(),
    broken: stress.broken(),
    quantities: [...stress.quantities()],
    findings: await stress.findings(),
  }));
  writeFileSync(join(artifacts, `stress-${backend}.tsv`), result.saved);
  const problems = page.problems;
  await page.context().close();
  return { ...result, problems, about: page.about, seconds: (Date.now() - begun) / 1000 };
}

function whole(name, text, least) {
  const value = Number(text);
  if (!Number.isSafeInteger(value) || value < least)
    throw new Error(`--${name} ${text} is not allowed: must be a whole number from ${least}`);
  return value;
}

async function main() {
  const { values } = parseArgs({
    options: {
      backend: { type: 'string' },
      cases: { type: 'string', default: '1000000' },
      seed: { type: 'string', default: '1' },
      case: { type: 'string' },
    },
  });
  if (values.backend && !BACKENDS.includes(values.backend)) {
    throw new Error(`--backend ${values.backend} is not allowed: must be ${BACKENDS.join(' or ')}`);
  }
  const [cases, seed] = [whole('cases', values.cases, 1), whole('seed', values.seed, 0)];
  const browser = await launch();
  let broken = 0;
  try {
    for (const backend of BACKENDS.filter((b) => !values.backend || b === values.backend)) {
      if (values.case !== undefined) {
        const number = whole('case', values.case, 0);
        const page = await openStress(browser, { backend, seed });
        const text = await page.evaluate((n) => stress.explain(BigInt(n)), number);
        console.log(`${page.about}\n\ncase ${number}, seed ${seed}\n${text}`);
        await page.context().close();
        continue;
      }
      const judged = (n) => process.stderr.isTTY && process.stderr.write(`\r${backend}: ${n} cases`);
      const result = await stress(browser, { backend, seed, cases, judged });
      console.log(
        `${result.about}\n\n${result.table}\n` +
          `${cases} cases, seed ${seed}, in ${result.seconds.toFixed(1)} s\n${result.findings}`,
      );
      broken += result.broken;
    }
  } finally {
    await browser.close();
  }
  if (broken > 0) throw new Error(`${broken} promises were broken`);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await main().catch((e) => {
    console.error(`error: ${e.message}`);
    process.exitCode = 1;
  });
}
