/** Outlines as an image over the picture: lines around what is then erased within them. Made anew only when one has changed. */

/** CSS pixels. */
const WIDTH = { last: 2, others: 1.5 } as const;
const HALO_WIDTH = 1.25;
const COLORS = { last: '#f6a93b', others: '#d8b98a' } as const;
const HALO = 'rgba(0, 0, 0, 0.45)';

export class OutlineLayer {
  readonly #image = document.createElement('canvas');
  readonly #scratch = document.createElement('canvas');
  #drawn: readonly Path2D[] = [];
  #lastCount = 0;

  /** The paths are in CSS pixels; those that are the same objects are the same paths. */
  draw(context: CanvasRenderingContext2D, last: readonly Path2D[], others: readonly Path2D[]): void {
    const { width, height } = context.canvas;
    const paths = [...last, ...others];
    const resized = this.#image.width !== width || this.#image.height !== height;
    const changed =
      this.#lastCount !== last.length ||
      paths.length !== this.#drawn.length ||
      paths.some((path, i) => path !== this.#drawn[i]);
    if (resized || changed) {
      for (const canvas of [this.#image, this.#scratch]) {
        canvas.width = width;
        canvas.height = height;
      }
      const ratio = context.getTransform().a;
      this.#paint(others, 'others', ratio);
      this.#paint(last, 'last', ratio);
      this.#drawn = paths;
      this.#lastCount = last.length;
    }
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.#image, 0, 0);
    context.restore();
  }

  /** Lines twice as wide as wanted, whose inner halves, and all that crosses the thing, are erased. */
  #paint(paths: readonly Path2D[], kind: keyof typeof COLORS, ratio: number): void {
    const on = this.#scratch.getContext('2d');
    const image = this.#image.getContext('2d');
    if (!on || !image || paths.length === 0) return;
    on.setTransform(1, 0, 0, 1, 0, 0);
    on.clearRect(0, 0, this.#scratch.width, this.#scratch.height);
    on.setTransform(ratio, 0, 0, ratio, 0, 0);
    on.lineJoin = 'round';
    for (const [color, extra] of [
      [HALO, HALO_WIDTH],
      [COLORS[kind], 0],
    ] as const) {
      on.strokeStyle = color;
      on.lineWidth = 2 * (WIDTH[kind] + extra);
      for (const path of paths) on.stroke(path);
    }
    on.globalCompositeOperation = 'destination-out';
    for (const path of paths) on.fill(path, 'nonzero');
    on.globalCompositeOperation = 'source-over';
    image.drawImage(this.#scratch, 0, 0);
  }
}
