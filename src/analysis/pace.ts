/** How long work goes on before others may run: a page stays alive at 20 pauses a second. */
const SLICE_MS = 50;

/** Interrupts long work: between its pieces others run, and an abort is heard. */
export class Pace {
  private readonly signal: AbortSignal | undefined;
  private rested = Date.now();

  constructor(signal?: AbortSignal) {
    this.signal = signal;
  }

  /** To call between pieces of work. `report` is called before a pause. @throws what the signal aborts with */
  async rest(report?: () => void): Promise<void> {
    this.signal?.throwIfAborted();
    if (Date.now() - this.rested < SLICE_MS) return;
    report?.();
    await new Promise((resolve) => setTimeout(resolve, 0));
    this.rested = Date.now();
    this.signal?.throwIfAborted();
  }
}
