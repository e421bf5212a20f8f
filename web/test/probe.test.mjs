// The shaders' functions on a million cases in a real browser, by the library's own judge: the same for both backends.
import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { stress } from '../stress.mjs';
import { launch } from './browser.mjs';

const CASES = 1_000_000;

let browser;
before(async () => { browser = await launch(); });
after(async () => { await browser?.close(); });

describe('a million cases keep every promise', () => {
  for (const backend of ['webgl2', 'webgpu']) {
    it(`on ${backend}`, async () => {
      const { about, table, findings, broken, quantities, problems, seconds } = await stress(browser, { backend, seed: 1, cases: CASES });
      console.log(`${about}\n${table}${CASES} cases in ${seconds.toFixed(1)} s\n${findings}`);
      assert.equal(quantities[0], quantities[1], 'a quantity was never judged');
      assert.equal(broken, 0, findings);
      assert.deepEqual(problems, [], 'the page reported errors');
    });
  }
});
