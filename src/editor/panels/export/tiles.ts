/**
 * The interactive picture at any size: in tiles, each a part of the view that the camera would have of the whole. Around
 * each tile a margin is drawn and thrown away, so that effects which look at pixels nearby see them at a tile's edge, too.
 */
import { PerspectiveCamera } from 'three/webgpu';
import type { FrameSettings, Radiance, RealtimeRenderer, Size } from '../../../realtime/renderer.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Document } from '../../../scene/schema.ts';

export interface Tile extends Size {
  /** Of its left upper corner in the whole. */
  readonly x: number;
  readonly y: number;
}

/** Small enough for any GPU, and for the page to answer in between. */
const LARGEST_TILE = 1024;
/** As far as contact shadows, ambient occlusion and anti-aliasing look, and most of what shines around a light. */
const MARGIN = 64;
/** Frames of a tile that gets better with more of them. */
const MOST_FRAMES = 16;

/** The tiles of a picture, row by row. */
export function tilesOf({ width, height }: Size, largest = LARGEST_TILE): Tile[] {
  const columns = Math.ceil(width / largest);
  const rows = Math.ceil(height / largest);
  return Array.from({ length: columns * rows }, (_, i) => {
    const [column, row] = [i % columns, Math.floor(i / columns)];
    const x = Math.floor((column * width) / columns);
    const y = Math.floor((row * height) / rows);
    return {
      x,
      y,
      width: Math.floor(((column + 1) * width) / columns) - x,
      height: Math.floor(((row + 1) * height) / rows) - y,
    };
  });
}

/** The renderer gives its camera the proportions of what it draws; a tile has those of the whole. */
class TileCamera extends PerspectiveCamera {
  #whole: number | undefined;

  constructor(source: PerspectiveCamera, whole: number) {
    super(source.fov, whole, source.near, source.far);
    this.#whole = whole;
    this.position.copy(source.position);
    this.quaternion.copy(source.quaternion);
  }

  override updateProjectionMatrix(): void {
    const own = this.aspect;
    // The constructor of three.js's camera calls this, before there is a field.
    if (#whole in this && this.#whole !== undefined) this.aspect = this.#whole;
    super.updateProjectionMatrix();
    this.aspect = own;
  }
}

/** Reads a tile's picture after it has been drawn, with what lies around it. */
export type TileReader = (
  renderer: RealtimeRenderer,
  settings: FrameSettings,
) => Promise<{ pixels: Uint8Array | Float32Array }>;

/** What a screen shows, 8 bits a channel. */
export const readScreen: TileReader = async (renderer, { view }) => ({
  pixels: await renderer.readImage(view as Document['view'], null),
});
/** Linear radiance. */
export const readLinear: TileReader = (renderer): Promise<Radiance> => renderer.readRadiance();

export interface TilesOptions {
  readonly renderer: RealtimeRenderer;
  readonly mirror: Pick<SceneMirror, 'scene' | 'camera'>;
  readonly document: Document;
  readonly size: Size;
  readonly read: TileReader;
  /** The longest side of a tile, in pixels. */
  readonly largest?: number;
  readonly signal: AbortSignal;
  onTile(tile: Tile, pixels: Uint8Array | Float32Array, done: number): void;
}

export async function renderTiles(options: TilesOptions): Promise<void> {
  const { renderer, mirror, document, size, read, largest, signal, onTile } = options;
  // A meter would see each tile for itself; the size is what was asked for.
  const exposure = renderer.exposure(document.view);
  const view = { ...document.view, exposure, exposureMode: 'manual' as const, resolutionScale: 1 };
  const settings: FrameSettings = { ...document, view };
  const { companion } = renderer;
  const tiles = tilesOf(size, largest);
  try {
    for (const [i, tile] of tiles.entries()) {
      const margin = tiles.length === 1 ? 0 : MARGIN;
      const around = { width: tile.width + 2 * margin, height: tile.height + 2 * margin };
      const camera = new TileCamera(mirror.camera, size.width / size.height);
      camera.setViewOffset(
        size.width,
        size.height,
        tile.x - margin,
        tile.y - margin,
        around.width,
        around.height,
      );
      renderer.companion = null;
      renderer.cut();
      for (let frame = 0; frame === 0 || (renderer.unsettled && frame < MOST_FRAMES); frame++)
        renderer.render({ scene: mirror.scene, camera }, settings, around);
      // Asked for in the same turn in which it was drawn: the viewport may draw in the next.
      const { pixels } = await read(renderer, settings);
      signal.throwIfAborted();
      onTile(tile, cut(pixels, around.width, margin, tile), (i + 1) / tiles.length);
      await new Promise((resolve) => setTimeout(resolve));
    }
  } finally {
    renderer.companion = companion;
    renderer.cut();
  }
}

/** Without the margin. */
function cut<A extends Uint8Array | Float32Array>(pixels: A, stride: number, margin: number, tile: Tile): A {
  if (margin === 0) return pixels;
  const { width, height } = tile;
  const result = new (pixels.constructor as new (length: number) => A)(4 * width * height);
  for (let y = 0; y < height; y++) {
    const from = 4 * ((y + margin) * stride + margin);
    result.set(pixels.subarray(from, from + 4 * width), 4 * width * y);
  }
  return result;
}
