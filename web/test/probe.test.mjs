// The shaders' functions on many cases in a real browser, by the library's own judge: the same for both
// backends. WELKIN_CASES says how many for each, at least and by default 200,000.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { stress } from '../stress.mjs';
import { BACKENDS, launch } from './browser.mjs';

const LEAST = 200_000;
const CASES = Number(process.env.WELKIN_CASES || LEAST);
if (!Number.isSafeInteger(CASES) || CASES < LEAST) {
  throw new Error(
    `WELKIN_CASES = ${process.env.WELKIN_CASES} is not allowed: must be a whole number from ${LEAST}`,
  );
}

let browser;
before(async () => {
  browser = await launch();
});
after(async () => {
  await browser?.close();
});

// Beside each other: while one judges what came back, which is one thread's work, the other draws.
describe(`${CASES} cases keep every promise`, { concurrency: true }, () => {
  for (const backend of BACKENDS) {
    it(`on ${backend}`, async () => {
      const { about, table, findings, broken, quantities, problems, seconds } = await stress(browser, {
        backend,
        seed: 1,
        cases: CASES,
      });
      console.log(`${about}\n${table}${CASES} cases in ${seconds.toFixed(1)} s\n${findings}`);
      assert.equal(quantities[0], quantities[1], 'a quantity was never judged');
      assert.equal(broken, 0, findings);
      assert.deepEqual(problems, [], 'the page reported errors');
    });
  }
});
