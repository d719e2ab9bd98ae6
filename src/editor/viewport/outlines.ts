/** The outlines of what is selected, over the picture: the last chosen in the accent's colour, the others paler. */
import type { Mesh } from 'three/webgpu';
import { type OutlineOptions, OutlinePass } from '../../realtime/outline/outline-pass.ts';
import type { RealtimeRenderer } from '../../realtime/renderer.ts';
import type { SceneMirror } from '../../scene/mirror.ts';
import type { Session } from '../session.ts';

/** Widths in CSS pixels. */
const LAST = { color: '#f6a93b', width: 2 };
const OTHERS = { color: '#d8b98a', width: 1.5 };
const HALO = { width: 1.25, opacity: 0.45 };

export interface OutlinesOptions {
  readonly session: Session;
  readonly mirror: SceneMirror;
  readonly renderer: RealtimeRenderer;
}

export class Outlines {
  readonly #options: OutlinesOptions;
  readonly #pass = new OutlinePass();

  constructor(options: OutlinesOptions) {
    this.#options = options;
  }

  /** To be called in the task in which the picture was drawn on the canvas. */
  draw(): void {
    this.#draw(false);
  }

  /** On a canvas over something else than the picture, whose own canvas is left with nothing but them. */
  drawOn(lines: HTMLCanvasElement): void {
    const { canvas } = this.#options.renderer;
    // Also empties it.
    [lines.width, lines.height] = [canvas.width, canvas.height];
    if (this.#draw(true)) lines.getContext('2d')?.drawImage(canvas, 0, 0);
  }

  #draw(alone: boolean): boolean {
    const { session, mirror, renderer } = this.#options;
    const { selected } = session.state.value;
    const front: Mesh[] = [];
    const back: Mesh[] = [];
    for (const [i, { kind, id }] of selected.entries()) {
      const mesh = kind === 'objects' ? mirror.objectFor(id) : undefined;
      if (mesh?.visible) (i === selected.length - 1 ? front : back).push(mesh);
    }
    const isDrawn = this.#pass.render(renderer.three, mirror.camera, outlinesOf(front, back), alone);
    renderer.times.mark('outline');
    return isDrawn;
  }
}

function outlinesOf(front: readonly Mesh[], back: readonly Mesh[]): OutlineOptions {
  const pixels = <T extends { readonly width: number }>(style: T): T => ({
    ...style,
    width: style.width * devicePixelRatio,
  });
  return {
    front: { ...pixels(LAST), meshes: front },
    back: { ...pixels(OTHERS), meshes: back },
    halo: pixels(HALO),
  };
}
