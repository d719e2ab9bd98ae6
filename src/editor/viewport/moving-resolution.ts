/** Fewer pixels while things move, to hold the document's target frame time; all of them for a picture that stands still. */
import { DynamicResolution } from '../../realtime/dynamic-resolution.ts';
import type { Document } from '../../scene/schema.ts';

/** A picture that has not changed for so long stands still. Changes by a hand come faster than that. */
const STILL_MS = 200;

export class MovingResolution {
  readonly #control = new DynamicResolution();
  readonly #redraw: () => void;
  #movedAt = Number.NEGATIVE_INFINITY;
  #timer: number | undefined;
  #factor = 1;
  /** Effects that gather frames ask whether the settings are the same object. */
  #settings: { readonly of: Document; readonly factor: number; readonly scaled: Document } | null = null;

  /** @param redraw what is shown is to be drawn anew, though nothing has changed */
  constructor(redraw: () => void) {
    this.#redraw = redraw;
  }

  /** Of the last frame: its part of the resolution, along each side. */
  get factor(): number {
    return this.#factor;
  }

  moved(): void {
    this.#movedAt = performance.now();
  }

  /** The document as the next frame is drawn. @param whole with all its pixels, as for a picture that is saved */
  next(document: Document, whole: boolean): Document {
    const moves = performance.now() - this.#movedAt < STILL_MS;
    this.#factor = document.view.targetFrameTime > 0 && moves && !whole ? this.#control.factor : 1;
    clearTimeout(this.#timer);
    if (this.#factor === 1) return document;
    this.#timer = window.setTimeout(this.#redraw, STILL_MS);
    if (this.#settings?.of !== document || this.#settings.factor !== this.#factor) {
      const resolutionScale = document.view.resolutionScale * this.#factor;
      const scaled = { ...document, view: { ...document.view, resolutionScale } };
      this.#settings = { of: document, factor: this.#factor, scaled };
    }
    return this.#settings.scaled;
  }

  /** What the last frame took the GPU. */
  add(milliseconds: number, { view }: Document): void {
    if (view.targetFrameTime === 0 || performance.now() - this.#movedAt < STILL_MS)
      this.#control.add(milliseconds, view.targetFrameTime);
  }
}
