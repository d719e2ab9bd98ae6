/**
 * Lines around what meshes cover in the picture, hidden parts included, drawn over the canvas after a frame: whoever reads the
 * frame back finds none. The meshes are drawn once more, with a material that does nothing, into a mask (mask.ts); the line is
 * where the distance from what is covered is small (distances.ts). Only the part of the canvas that they are in is looked at.
 */
import { Fn, texture, uniform, uv, vec4 } from 'three/tsl';
import {
  Color,
  CustomBlending,
  LinearSRGBColorSpace,
  type Mesh,
  NearestFilter,
  type Node,
  NodeMaterial,
  OneFactor,
  OneMinusSrcAlphaFactor,
  type PerspectiveCamera,
  QuadMesh,
  type TextureNode,
  UnsignedByteType,
  Vector2,
  type WebGPURenderer,
} from 'three/webgpu';
import { inputTexture, Pass } from '../frame/pass.ts';
import { distancesFrom, MOST_REACH, nearestInRow } from './distances.ts';
import { CoverageMask } from './mask.ts';
import { type Rectangle, screenBounds } from './screen-bounds.ts';

type Vec2 = Node<'vec2'>;
type Vec4 = Node<'vec4'>;
type Float = Node<'float'>;

/** Meshes that have a line around all that they cover together. */
export interface Outlined {
  readonly meshes: readonly Mesh[];
  /** As CSS writes it. */
  readonly color: string;
  /** Of the line, in pixels of the canvas; it is outside what they cover. */
  readonly width: number;
}

export interface OutlineOptions {
  /** Those that are drawn over the others. */
  readonly front: Outlined;
  readonly back: Outlined;
  /** A dark border around each line, so that it is seen on any ground: pixels of the canvas, and 0..1. */
  readonly halo: { readonly width: number; readonly opacity: number };
}

/** Textures have sizes that are multiples of this, so that few are made anew while something moves. */
const STEP = 64;

export class OutlinePass {
  readonly #mask = new CoverageMask();
  readonly #maskTexture = inputTexture();
  /** Of the mask, and of the rows. */
  readonly #size = uniform(new Vector2(1, 1));
  readonly #reach = uniform(1, 'int');
  readonly #rows: Pass;
  /** Where on the canvas it draws: from which pixel of the mask on, and how many. */
  readonly #offset = uniform(new Vector2());
  readonly #drawn = uniform(new Vector2(1, 1));
  readonly #lines = { front: lineUniforms(), back: lineUniforms() };
  readonly #halo = { width: uniform(0), opacity: uniform(0) };
  readonly #quad: QuadMesh;

  constructor() {
    const size = this.#size as unknown as Vec2;
    const reach = this.#reach as unknown as Node<'int'>;
    const rows = nearestInRow({ source: this.#maskTexture, size, reach }, uv().mul(size).floor() as Vec2);
    this.#rows = new Pass('outline rows', rows, { type: UnsignedByteType, isBlended: false });
    Object.assign(this.#mask.texture, { minFilter: NearestFilter, magFilter: NearestFilter });
    const material = new NodeMaterial();
    material.name = 'outline';
    material.fragmentNode = this.#line({
      source: texture(this.#rows.target.texture) as TextureNode<'vec4'>,
      size,
      reach,
    });
    material.depthTest = false;
    material.depthWrite = false;
    material.blending = CustomBlending;
    material.blendSrc = OneFactor;
    material.blendDst = OneMinusSrcAlphaFactor;
    this.#quad = new QuadMesh(material);
    this.#quad.name = 'outline';
  }

  /**
   * Draws on the canvas as it is. The renderer's output is taken to be what a screen shows, as RealtimeRenderer has it.
   *
   * @param camera as the frame was seen by
   * @param alone with nothing else on the canvas
   * @returns whether anything was drawn
   */
  render(
    three: WebGPURenderer,
    camera: PerspectiveCamera,
    { front, back, halo }: OutlineOptions,
    alone = false,
  ): boolean {
    const meshes = [...front.meshes, ...back.meshes];
    for (const mesh of meshes) mesh.updateWorldMatrix(true, false);
    this.#mask.follow(front.meshes, back.meshes);
    if (meshes.length === 0) return false;
    camera.updateWorldMatrix(true, false);
    const canvas = three.domElement;
    // An edge is up to a pixel nearer than the middle of the one that it is in.
    const reach = Math.min(MOST_REACH, Math.floor(Math.max(widthOf(front), widthOf(back)) + halo.width + 1));
    const bounds = screenBounds(meshes, camera, canvas, reach);
    const drawn = bounds && within(bounds, canvas);
    if (!bounds || !drawn) return false;
    const part = { ...bounds, width: stepped(bounds.width), height: stepped(bounds.height) };
    this.#reach.value = reach;
    this.#size.value.set(part.width, part.height);
    this.#offset.value.set(drawn.x - part.x, drawn.y - part.y);
    this.#drawn.value.set(drawn.width, drawn.height);
    this.#halo.width.value = halo.width;
    this.#halo.opacity.value = halo.opacity;
    for (const [kind, { color, width }] of Object.entries({ front, back })) {
      const line = this.#lines[kind as 'front' | 'back'];
      // The canvas holds what a screen shows: its numbers are the colour's own.
      line.color.value.setStyle(color, LinearSRGBColorSpace);
      line.width.value = width;
    }
    this.#mask.render(three, camera, canvas, part);
    this.#maskTexture.value = this.#mask.texture;
    this.#rows.render(three, part.width, part.height);
    this.#draw(three, drawn, alone);
    return true;
  }

  #draw(three: WebGPURenderer, { x, y, width, height }: Rectangle, alone: boolean): void {
    const { autoClear, domElement } = three;
    three.autoClear = alone;
    three.setViewport(x, y, width, height);
    this.#quad.render(three);
    three.setViewport(0, 0, domElement.width, domElement.height);
    three.autoClear = autoClear;
  }

  dispose(): void {
    this.#mask.dispose();
    this.#rows.dispose();
    (this.#quad.material as NodeMaterial).dispose();
  }

  /** A colour with alpha, which is multiplied in. */
  #line(rows: Parameters<typeof distancesFrom>[0]): Vec4 {
    const { front, back } = this.#lines;
    return Fn(() => {
      const pixel = uv().mul(this.#drawn).floor().add(this.#offset) as Vec2;
      const { away, share } = distancesFrom(rows, pixel);
      const over = this.#around(away.x as Float, share.x as Float, front).toVar() as Vec4;
      const under = this.#around(away.y as Float, share.y as Float, back);
      return over.add(under.mul(over.a.oneMinus()));
    })() as unknown as Vec4;
  }

  /** The line over its halo, and none of both where the meshes are. */
  #around(away: Float, share: Float, { color, width }: ReturnType<typeof lineUniforms>): Vec4 {
    const covered = (reach: Float) => reach.add(0.5).sub(away).clamp(0, 1) as Float;
    const line = covered(width as unknown as Float);
    const halo = covered(width.add(this.#halo.width) as unknown as Float).mul(this.#halo.opacity);
    const outside = share.oneMinus();
    return vec4(color.mul(line), line.add(halo.mul(line.oneMinus()))).mul(outside) as Vec4;
  }
}

const lineUniforms = () => ({ color: uniform(new Color()), width: uniform(0) });

const widthOf = ({ meshes, width }: Outlined): number => (meshes.length === 0 ? 0 : width);

const stepped = (length: number): number => Math.ceil(length / STEP) * STEP;

/** What of it is on the canvas. */
function within(
  { x, y, width, height }: Rectangle,
  canvas: { readonly width: number; readonly height: number },
): Rectangle | null {
  const [left, top] = [Math.max(0, x), Math.max(0, y)];
  const [right, bottom] = [Math.min(canvas.width, x + width), Math.min(canvas.height, y + height)];
  return left < right && top < bottom ? { x: left, y: top, width: right - left, height: bottom - top } : null;
}
