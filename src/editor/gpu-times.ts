/** What the GPU spends on the parts of a frame, for the panels that show it. Nothing is measured while nobody asks. */
import type { GpuTime } from '../realtime/frame/gpu-times.ts';

/** New times weigh this much: single frames waver. */
const SHARE = 0.2;

export class GpuTimesBoard {
  readonly #milliseconds = new Map<string, number>();
  readonly #listeners = new Set<() => void>();
  readonly #labels = new Map<HTMLElement, string>();
  #available: boolean | null = null;

  /** By part of a frame, in the order of drawing; empty while nothing is measured. */
  get times(): ReadonlyMap<string, number> {
    return this.#milliseconds;
  }

  /** Null until it is known. */
  get available(): boolean | null {
    return this.#available;
  }

  set available(value: boolean) {
    this.#available = value;
    this.#tell();
  }

  add(times: readonly GpuTime[]): void {
    const before = new Map(this.#milliseconds);
    this.#milliseconds.clear();
    for (const { name, milliseconds } of times) {
      const last = before.get(name) ?? milliseconds;
      this.#milliseconds.set(name, last + SHARE * (milliseconds - last));
    }
    this.#tell();
  }

  clear(): void {
    this.#milliseconds.clear();
    this.#tell();
  }

  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  /** An element shows the time of one part from now on, for as long as it is on the page. */
  label(element: HTMLElement, part: string): void {
    this.#labels.set(element, part);
    this.#write(element, part);
  }

  #tell(): void {
    for (const [element, part] of this.#labels) {
      if (element.isConnected) this.#write(element, part);
      else this.#labels.delete(element);
    }
    for (const listener of this.#listeners) listener();
  }

  #write(element: HTMLElement, part: string): void {
    const milliseconds = this.#milliseconds.get(part);
    const text = milliseconds === undefined ? '' : gpuTimeText(milliseconds);
    if (element.textContent !== text) element.textContent = text;
  }
}

export function gpuTimeText(milliseconds: number): string {
  return `${milliseconds.toFixed(milliseconds < 10 ? 2 : milliseconds < 100 ? 1 : 0)} ms`;
}
