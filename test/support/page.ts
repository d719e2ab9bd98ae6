import { afterAll } from 'vitest';
import { openHarness, type PageHarness } from './harness.ts';

export { watchErrors } from './harness.ts';

/**
 * Runs TypeScript in a real browser, for tests named x.e2e.test.ts:
 *
 *     const harness = await pageHarness(new URL('./sphere.page.ts', import.meta.url));
 *     const pixels = await harness.run<number[]>({ forceWebGL: true });
 *
 * See PageHarness. The browser is closed after the file's last test.
 */
export async function pageHarness(entry: URL): Promise<PageHarness> {
  const harness = await openHarness(entry);
  afterAll(() => harness.close());
  return harness;
}
