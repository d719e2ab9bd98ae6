import type { Browser } from 'playwright-core';
import { afterAll } from 'vitest';
import { launchBrowser } from './browser.ts';
import { openHarness, type PageHarness } from './harness.ts';

export { watchErrors } from './harness.ts';

/**
 * Runs TypeScript in a real browser, for tests named x.e2e.test.ts:
 *
 *     const harness = await pageHarness(new URL('./sphere.page.ts', import.meta.url));
 *     const pixels = await harness.run<number[]>({ forceWebGL: true });
 *
 * See PageHarness.
 */
export async function pageHarness(entry: URL): Promise<PageHarness> {
  const harness = await openHarness(entry, await testBrowser());
  afterAll(() => harness.close());
  return harness;
}

let launched: Promise<Browser> | undefined;

/** The browser of all test files that share this process; it ends with the process. Every page is a profile of its own. */
export async function testBrowser(): Promise<Browser> {
  // One that a file's tests have brought down is no matter for the next file.
  if (launched && !(await launched).isConnected()) launched = undefined;
  launched ??= launchBrowser();
  return launched;
}
