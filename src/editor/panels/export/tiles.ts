/**
 * The interactive picture at any size: in tiles, each a part of the view that the camera would have of the whole. Around
 * each tile a margin is drawn and thrown away, so that effects which look at pixels nearby see them at a tile's edge, too.
 */
import { PerspectiveCamera } from 'three/webgpu';
import { BLOOM_GRID } from '../../../realtime/effects/bloom.ts';
import { MOST_RADIUS } from '../../../realtime/effects/depth-of-field/circle.ts';
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
/**
 * Where rays are traced through the picture: what is not in their tile is not found, so a mirror's picture of the wall would end
 * at a border. As large as a view on a large screen, which such settings have to draw, too.
 */
const LARGEST_TRACED_TILE = 4096;
/** As far as contact shadows, anti-aliasing and the means over neighbours look. */
const MARGIN = 64;
/** Most of what ambient occlusion sees: what is farther away on the screen hides little. */
const OCCLUSION_MARGIN = 256;
/** Most of what traced rays hit. */
const TRACED_MARGIN = 512;
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

/** How far effects look, in pixels of a picture of this size. */
export function marginOf({ effects, camera }: Document, { width, height }: Size): number {
  const { ambientOcclusion, reflections, indirectLight, depthOfField, bloom, lens } = effects;
  const reach = Math.max(
    MARGIN,
    ambientOcclusion.enabled ? OCCLUSION_MARGIN : 0,
    reflections.enabled || indirectLight.enabled ? TRACED_MARGIN : 0,
    depthOfField.enabled && camera.fStop > 0 ? height * MOST_RADIUS : 0,
    // The smallest level of the glow is as wide as a few of its pixels.
    bloom.enabled ? MARGIN + 3 * BLOOM_GRID * bloom.radius : 0,
  );
  // Red and blue are looked for by half of the dispersion away, of the way from the middle.
  const fringe = lens.enabled ? (lens.dispersion / 2) * (Math.max(width, height) / 2) : 0;
  return Math.ceil(reach + fringe);
}

/** A tile with its margin, its corners on a grid. */
export function around(tile: Tile, margin: number, grid: number): Tile {
  const low = (at: number) => Math.floor((at - margin) / grid) * grid;
  const high = (at: number) => Math.ceil((at + margin) / grid) * grid;
  const [x, y] = [low(tile.x), low(tile.y)];
  return { x, y, width: high(tile.x + tile.width) - x, height: high(tile.y + tile.height) - y };
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
  const { renderer, mirror, document, size, read, signal, onTile } = options;
  // A meter would see each tile for itself; the size is what was asked for.
  const exposure = renderer.exposure(document.view);
  const view = { ...document.view, exposure, exposureMode: 'manual' as const, resolutionScale: 1 };
  const settings: FrameSettings = { ...document, view };
  const { companion } = renderer;
  const { reflections, indirectLight, bloom } = document.effects;
  const traces = reflections.enabled || indirectLight.enabled;
  const { largest = traces ? LARGEST_TRACED_TILE : LARGEST_TILE } = options;
  const tiles = tilesOf(size, largest);
  const margin = tiles.length === 1 ? 0 : marginOf(document, size);
  // Effects at half the size, and smaller ones, divide each tile into the pixels into which they would divide the whole.
  const grid = tiles.length === 1 ? 1 : bloom.enabled ? BLOOM_GRID : 2;
  try {
    for (const [i, tile] of tiles.entries()) {
      const drawn = around(tile, margin, grid);
      const camera = new TileCamera(mirror.camera, size.width / size.height);
      camera.setViewOffset(size.width, size.height, drawn.x, drawn.y, drawn.width, drawn.height);
      renderer.companion = null;
      renderer.cut();
      for (let frame = 0; frame === 0 || (renderer.unsettled && frame < MOST_FRAMES); frame++)
        renderer.render({ scene: mirror.scene, camera }, settings, drawn);
      // Asked for in the same turn in which it was drawn: the viewport may draw in the next.
      const { pixels } = await read(renderer, settings);
      signal.throwIfAborted();
      onTile(tile, cut(pixels, drawn, tile), (i + 1) / tiles.length);
      await new Promise((resolve) => setTimeout(resolve));
    }
  } finally {
    renderer.companion = companion;
    renderer.cut();
  }
}

/** Without the margin. */
function cut<A extends Uint8Array | Float32Array>(pixels: A, drawn: Tile, tile: Tile): A {
  const { width, height } = tile;
  if (drawn.width === width && drawn.height === height) return pixels;
  const [left, top] = [tile.x - drawn.x, tile.y - drawn.y];
  const result = new (pixels.constructor as new (length: number) => A)(4 * width * height);
  for (let y = 0; y < height; y++) {
    const from = 4 * ((y + top) * drawn.width + left);
    result.set(pixels.subarray(from, from + 4 * width), 4 * width * y);
  }
  return result;
}
