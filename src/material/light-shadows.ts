/** Shadows as materials see them: whatever finds them tells it through the frame's context. */
import {
  cameraWorldMatrix,
  cross,
  dFdx,
  dFdy,
  dot,
  positionView,
  screenCoordinate,
  vec2,
  vec4,
} from 'three/tsl';
import type { Light, Node, NodeBuilder } from 'three/webgpu';
import { keptFloat, keptVec3 } from './statements.ts';

type Float = Node<'float'>;
type Vec3 = Node<'vec3'>;

/** What is asked for shadows on it. */
export interface ShadedPoint {
  /** In world space. */
  readonly position: Vec3;
  /** Of the mesh's own plane there, not the interpolated one; a unit vector in world space, towards the viewer. */
  readonly normal: Vec3;
  /** 0..1, another in every pixel: turns the pattern of samples. */
  readonly noise: Float;
}

/** The part of a lamp that a point sees, 0..1 (docs/decisions/light-sizes.md). */
export type LampShadow = (point: ShadedPoint) => Float;

/** A rectangle is seen point by point. */
export interface PanelShadow {
  /** How far away what keeps its light off stands, for seen(). */
  blocker(point: ShadedPoint): Float;
  /**
   * 1 where a point sees this place of the rectangle, else 0.
   *
   * @param place in halves of its width and height from the centre, each -1..1
   * @param turn 0..1, another for every place: spreads the places that are looked at
   */
  seen(point: ShadedPoint, blocker: Float, place: Node<'vec2'>, turn: Float): Float;
}

export interface LightShadows {
  /** Comes first, at the top level of a fragment's code: what is read there, not in branches. */
  start(builder: NodeBuilder): void;
  /** Null for a light that casts none. */
  lamp(light: Light, builder: NodeBuilder): LampShadow | null;
  /** Which of a light's maps has the point, 0 being the finest; null for a light that has one alone, or none. */
  cascade(light: Light, builder: NodeBuilder): ((point: ShadedPoint) => Float) | null;
  panel(light: Light, builder: NodeBuilder): PanelShadow | null;
}

/** Null where nothing casts shadows. */
export function lightShadows(builder: NodeBuilder): LightShadows | null {
  const { context } = builder as unknown as { context: { readonly shadows?: LightShadows } };
  return context.shadows ?? null;
}

/** The fragment that is shaded, to be called at the top level of a fragment's code: it contains derivatives. */
export function fragmentPoint(): ShadedPoint {
  const P = positionView as Vec3;
  // From view space: there it is exact however close the camera is.
  const plane = cross(dFdx(P) as Vec3, dFdy(P) as Vec3) as unknown as Vec3;
  const unit = plane.mul(dot(plane, plane).max(1e-36).inverseSqrt());
  const facing = unit.mul(dot(unit, P).greaterThan(0).select(-1, 1)) as Vec3;
  const world = cameraWorldMatrix as unknown as Node<'mat4'>;
  return {
    position: keptVec3(world.mul(vec4(P, 1)).xyz as Vec3, 'shadedPosition'),
    normal: keptVec3(world.mul(vec4(facing, 0)).xyz as Vec3, 'shadedPlane'),
    noise: keptFloat(interleavedGradientNoise()),
  };
}

/** J. Jimenez, 2014, "Next Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH course. */
function interleavedGradientNoise(): Float {
  const pixel = (screenCoordinate as Node<'vec2'>).xy;
  return dot(pixel, vec2(0.06711056, 0.00583715)).fract().mul(52.9829189).fract() as Float;
}
