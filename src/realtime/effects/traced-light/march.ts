/**
 * A ray through what the picture shows: along its image on the screen, with 1/distance, which is linear there (M. McGuire
 * and M. Mara, 2014, "Efficient GPU Screen-Space Ray Tracing", JCGT 3(4)).
 */
import { Break, float, If, mix, select, vec2, vec4 } from 'three/tsl';
import type { Node } from 'three/webgpu';
import { repeat } from '../../../material/statements.ts';
import type { FrameInputs } from '../../frame/inputs.ts';
import { type Guide, inline, NOTHING, ndcOf, placeOf } from '../screen-space/guide.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** How far above its surface a ray begins, as a part of its distance from the camera. */
const LIFT = 2e-3;
/** As far as rays go, in distances of their origin. */
const FAR = 1e3;
/** Steps grow by this power of their number: what is near matters more than what is far. */
const GROWTH = 1.5;
/** How far behind the surface itself a hit may be found, as a part of its distance. */
const EXACT = 0.02;
/** Halvings of the step in which the hit is. */
const HALVINGS = 5;

export interface March {
  readonly steps: Float;
  readonly thickness: Float;
}

/**
 * Where a ray hits.
 *
 * @param P origin in view space, on a surface with the normal N
 * @param shift 0..1, by which the steps are moved
 * @param strict 0..1: whether it must be the surface itself that is hit, or may be what is thought to lie behind it
 * @returns place in the frame, distance of the hit from the origin, 1 if there is one, else 0
 */
export function march(
  inputs: FrameInputs,
  guide: Guide,
  { steps, thickness }: March,
  P: Vec3,
  N: Vec3,
  L: Vec3,
  shift: Float,
  strict: Float,
): Vec4 {
  return inline(() => {
    const hit = vec4(0).toVar() as Vec4;
    const origin = P.add(N.mul(P.z.mul(-LIFT))).toVar() as Vec3;
    // Towards the camera it ends before it.
    const near = inputs.near as unknown as Float;
    const reach = select(
      L.z.greaterThan(1e-4),
      origin.z.negate().sub(near).div(L.z.max(1e-4)).mul(0.999).max(0),
      origin.z.mul(-FAR),
    ).toVar() as unknown as Float;
    const end = origin.add(L.mul(reach.min(origin.z.mul(-FAR)))).toVar() as Vec3;
    const from = placeOf(ndcOf(inputs, origin)).toVar() as Vec2;
    const way = placeOf(ndcOf(inputs, end)).sub(from).toVar() as Vec2;
    // The part of it that is on the screen.
    const room = select(way.greaterThan(vec2(0)) as never, from.oneMinus(), from) as unknown as Vec2;
    const exits = room.div(way.abs().max(1e-9)) as Vec2;
    const shown = exits.x.min(exits.y).clamp(0, 1).toVar() as Float;
    const pixels = way.mul(guide.size).length().mul(shown).toVar() as Float;
    const [near1, far1] = [origin.z.negate().reciprocal().toVar(), end.z.negate().reciprocal().toVar()];
    /** Distance along the view at a part of the way. */
    const distanceAt = (part: Float) => mix(near1, far1, part).reciprocal() as unknown as Float;
    If(pixels.greaterThan(1), () => {
      const before = float(0).toVar() as Float;
      repeat(steps, (i) => {
        const grown = i.add(shift).add(0.5).div(steps).min(1).pow(GROWTH) as Float;
        const part = grown.max(i.add(1.5).div(pixels)).min(1).mul(shown).toVar() as Float;
        const at = from.add(way.mul(part)).toVar() as Vec2;
        const surface = (guide.sample(at) as Vec4).w.toVar() as Float;
        const ray = distanceAt(part).toVar() as Float;
        const nearest = ray.min(distanceAt(before)) as Float;
        const crosses = ray
          .greaterThan(surface)
          .and(nearest.lessThan(surface.add(thickness)))
          .and(surface.lessThan(NOTHING * 0.99));
        If(crosses, () => {
          const [low, high] = [before.toVar(), part.toVar()] as [Float, Float];
          repeat(HALVINGS, () => {
            const middle = low.add(high).mul(0.5).toVar() as Float;
            const there = (guide.sample(from.add(way.mul(middle)) as Vec2) as Vec4).w;
            const behind = distanceAt(middle).greaterThan(there);
            low.assign(select(behind, low, middle) as unknown as Float);
            high.assign(select(behind, middle, high) as unknown as Float);
          });
          const place = from.add(way.mul(high)).toVar() as Vec2;
          const found = (guide.sample(place) as Vec4).w.toVar() as Float;
          const depth = distanceAt(high).toVar() as Float;
          const Q = guide.position(place, found).sub(P).toVar() as Vec3;
          const limit = mix(thickness, found.mul(EXACT).min(thickness), strict);
          // What is not above the surface's plane is the surface itself.
          const above = Q.dot(N).greaterThan(P.z.mul(-LIFT / 2));
          If(
            depth
              .sub(found)
              .lessThan(limit as never)
              .and(found.lessThan(NOTHING * 0.99))
              .and(above),
            () => {
              hit.assign(vec4(place, Q.length(), 1));
              Break();
            },
          );
        });
        before.assign(part);
      });
    });
    return hit;
  });
}
