/** How many samples a pass takes. */

/** What a pass should take at most: so often the picture and the figures are new. */
const PASS_SECONDS = 0.5;
/** More samples of a pixel are not summed in float32, as a pass does. */
const MOST_SAMPLES = 256;

/**
 * 1, 1, 2, 4, ...: each pass doubles what is there, as samples of a low-discrepancy sequence are even in powers of
 * two, until a pass takes longer than a person likes to wait for news.
 *
 * @param done samples of a pixel so far, which took `seconds`
 */
export function nextPass(done: number, seconds: number, goal: number): number {
  const left = goal - done;
  if (done === 0) return Math.min(1, left);
  const affordable = seconds > 0 ? (PASS_SECONDS * done) / seconds : done;
  const doubled = Math.min(done, MOST_SAMPLES, Math.max(1, affordable));
  return Math.min(left, 2 ** Math.floor(Math.log2(doubled)));
}
