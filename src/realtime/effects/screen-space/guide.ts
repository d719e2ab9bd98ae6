/** What effects in screen space read of the surfaces: distance and normal, at the frame's size or half of it. */
import {
  Fn,
  float,
  perspectiveDepthToViewZ,
  select,
  texture,
  uniform,
  uv,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import { FloatType, type Node, type Texture, Vector2, type WebGPURenderer } from 'three/webgpu';
import type { FrameInputs } from '../../frame/inputs.ts';
import { Pass } from '../../frame/pass.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** Distance along the view where nothing is, in metres: the largest number that a half float has, nearly. */
export const NOTHING = 6e4;

/**
 * One of a frame's pixels stands for each texel, not a mean of several: means of distances lie where no surface is.
 * Distances are 32-bit floats: half ones would be a pixel's width apart.
 */
export class Guide {
  readonly size = uniform(new Vector2(1, 1));
  readonly #inputs: FrameInputs;
  readonly #pass: Pass;
  readonly #scale: number;
  #drawn = -1;

  constructor(inputs: FrameInputs, scale: number) {
    this.#inputs = inputs;
    this.#scale = scale;
    const own = this.#pixel(uv() as Vec2);
    const distance = distanceOf(inputs, inputs.depth.sample(own).r as unknown as Float);
    this.#pass = new Pass('guide', vec4(inputs.normal.sample(own).xyz, distance), {
      type: FloatType,
      isBlended: false,
    });
  }

  /** Once a frame, whoever asks first. */
  render(renderer: WebGPURenderer): void {
    const { frameIndex, size } = this.#inputs;
    if (this.#drawn === frameIndex.value) return;
    this.#drawn = frameIndex.value;
    const { x, y } = size.value;
    this.size.value.set(scaled(x, this.#scale), scaled(y, this.#scale));
    this.#pass.render(renderer, this.size.value.x, this.size.value.y);
  }

  /** Normal in view space, and distance along the view, of the texel at a place. */
  sample(place: Vec2): Vec4 {
    return texelAt(this.#pass.target.texture, place);
  }

  /** The centre of the texel at a place. */
  texel(place: Vec2): Vec2 {
    return place.mul(this.size).floor().add(0.5).div(this.size) as Vec2;
  }

  /** In view space, given the distance that sample() has there. */
  position(place: Vec2, distance: Float): Vec3 {
    const ndc = this.#pixel(place).mul(2).sub(1).mul(vec2(1, -1)) as Vec2;
    return positionAt(this.#inputs, ndc, distance);
  }

  /** By how much of the frame a point moves that moves by a metre in view space across the view; down is positive. */
  perMetre(distance: Float): Vec2 {
    const column = columnsOf(this.#inputs);
    return vec2(column(0).x, column(1).y.negate()).div(distance.mul(2)) as unknown as Vec2;
  }

  dispose(): void {
    this.#pass.dispose();
  }

  /** The frame's pixel that stands for the texel at a place. */
  #pixel(place: Vec2): Vec2 {
    const { size } = this.#inputs;
    return this.texel(place).mul(size).floor().add(0.5).div(size) as Vec2;
  }
}

/** Of the camera's projection. */
export const columnsOf =
  ({ projection }: FrameInputs) =>
  (i: number): Vec4 =>
    (projection as unknown as { element(i: number): Vec4 }).element(i);

/** Distance along the view from what the depth buffer has, in metres. */
export function distanceOf({ near, far }: FrameInputs, depth: Float): Float {
  const viewZ = perspectiveDepthToViewZ(depth, near, far) as unknown as Float;
  return select(depth.lessThan(1), viewZ.negate().min(NOTHING), float(NOTHING)) as unknown as Float;
}

/** A point in view space from normalised device coordinates and its distance along the view. */
export function positionAt(inputs: FrameInputs, ndc: Vec2, distance: Float): Vec3 {
  const column = columnsOf(inputs);
  // clip.xy = P00 x + P02 z, P11 y + P12 z; w = -z.
  const x = ndc.x.add(column(2).x).div(column(0).x);
  const y = ndc.y.add(column(2).y).div(column(1).y);
  return vec3(x, y, -1).mul(distance) as unknown as Vec3;
}

/** Where in the frame normalised device coordinates are, as uv() counts it. */
export function placeOf(ndc: Vec2): Vec2 {
  return ndc.mul(vec2(0.5, -0.5)).add(0.5) as Vec2;
}

/** Normalised device coordinates of a point in view space, in front of the camera. */
export function ndcOf({ projection }: FrameInputs, point: Vec3): Vec2 {
  const clip = (projection as unknown as { mul(v: Node): Vec4 }).mul(vec4(point, 1));
  return clip.xy.div(clip.w) as Vec2;
}

const scaled = (length: number, scale: number): number => Math.max(1, Math.round(length * scale));

/** A texture at a place, wherever in the shader that is: the finest level, or another. */
export function texelAt(source: Texture, place: Vec2, level: Float = float(0)): Vec4 {
  return texture(source).sample(place).level(level) as unknown as Vec4;
}

interface Shared {
  readonly guide: Guide;
  users: number;
}

const guides = new WeakMap<FrameInputs, Map<number, Shared>>();

/** The guide of a scale; the effects of a frame share it. Give it back with releaseGuide(). */
export function takeGuide(inputs: FrameInputs, scale: number): Guide {
  const known = guides.get(inputs) ?? new Map<number, Shared>();
  guides.set(inputs, known);
  const shared = known.get(scale) ?? { guide: new Guide(inputs, scale), users: 0 };
  known.set(scale, shared);
  shared.users++;
  return shared.guide;
}

export function releaseGuide(inputs: FrameInputs, guide: Guide): void {
  for (const [scale, shared] of guides.get(inputs) ?? []) {
    if (shared.guide !== guide || --shared.users > 0) continue;
    guide.dispose();
    guides.get(inputs)?.delete(scale);
  }
}

/** A function of the shader, evaluated where it is called. */
export const inline = <T extends Node>(body: () => T): T => (Fn(body as never) as () => T)();
