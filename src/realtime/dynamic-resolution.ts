/** Holds a frame's time while things move, by drawing fewer pixels. */

/** Parts of the resolution, along each side. */
const STEPS = [0.5, 0.6, 0.7, 0.8, 0.9, 1] as const;
/** Frames that are looked at before a step: one slow frame among them says nothing. */
const WINDOW = 6;
/** The time must be so much above the target before the resolution goes down, */
const ABOVE = 1.05;
/** and would have to stay so much below it before the resolution goes up. Between the two it stays. */
const BELOW = 0.85;

/**
 * A frame is taken to cost in proportion to its pixels. Some of it does not, so that going up costs less than expected:
 * what goes up does not have to go down again at once. Going down may take a second step.
 */
export class DynamicResolution {
  #step = STEPS.length - 1;
  #times: number[] = [];

  /** To multiply the resolution scale by, 0.5..1. */
  get factor(): number {
    return STEPS[this.#step] as number;
  }

  /**
   * @param milliseconds that the GPU took for a frame at the present factor
   * @param target in milliseconds; 0: full resolution
   */
  add(milliseconds: number, target: number): void {
    if (!(target > 0)) {
      this.#go(STEPS.length - 1);
      return;
    }
    this.#times.push(milliseconds);
    if (this.#times.length < WINDOW) return;
    const sorted = this.#times.sort((a, b) => a - b);
    const usual = sorted[WINDOW >> 1] as number;
    const expected = (step: number) => usual * ((STEPS[step] as number) / this.factor) ** 2;
    this.#times = [];
    if (usual > target * ABOVE) {
      let step = Math.max(0, this.#step - 1);
      while (step > 0 && expected(step) > target) step--;
      this.#go(step);
    } else if (this.#step < STEPS.length - 1 && expected(this.#step + 1) <= target * BELOW)
      this.#go(this.#step + 1);
  }

  #go(step: number): void {
    this.#step = step;
    this.#times = [];
  }
}
