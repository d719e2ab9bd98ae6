/** How a material reads what was computed for the surfaces at another size. */
import { float, fwidth, positionView, screenUV, vec2, vec4 } from 'three/tsl';
import type { Node, Texture } from 'three/webgpu';
import { type Guide, inline, texelAt } from './guide.ts';

type Float = Node<'float'>;
type Vec2 = Node<'vec2'>;
type Vec3 = Node<'vec3'>;
type Vec4 = Node<'vec4'>;

/** The part of a neighbour's bilinear weight that it has wherever it lies: at edges only a far one may be of this surface. */
const EVERYWHERE = 0.02;
/** Differences of distance within one surface, as a part of the distance, beside what its slope makes. */
const TOLERANCE = 0.005;

/**
 * The four texels about the fragment, weighted by their place and by how near they are to its distance: a silhouette's
 * pixels, which several samples share, each take what belongs to their own surface.
 *
 * @param target its alpha is the distance along the view
 * @param decode from a texel to what is averaged
 */
export function atFragment(guide: Guide, target: Texture, decode: (texel: Vec4) => Vec4): Vec4 {
  // Read here, at the top level: three.js would move it to where it is needed first, into loops too.
  const kept = vec4(0).toVar();
  kept.assign(gathered(guide, target, decode));
  return kept as unknown as Vec4;
}

function gathered(guide: Guide, target: Texture, decode: (texel: Vec4) => Vec4): Vec4 {
  return inline(() => {
    const place = (screenUV as unknown as Vec2).mul(guide.size).sub(0.5).toVar() as Vec2;
    const corner = place.floor().toVar() as Vec2;
    const part = place.sub(corner).toVar() as Vec2;
    const distance = (positionView as Vec3).z.negate().toVar() as Float;
    const tolerance = fwidth(distance as never)
      .mul(2)
      .add(distance.mul(TOLERANCE))
      .toVar() as unknown as Float;
    const sum = vec4(0).toVar();
    const weights = float(0).toVar();
    for (const [x, y] of [
      [0, 0],
      [1, 0],
      [0, 1],
      [1, 1],
    ] as const) {
      const at = corner.add(vec2(x, y)).add(0.5).div(guide.size) as Vec2;
      const texel = texelAt(target, at).toVar() as Vec4;
      const bilinear = (x ? part.x : part.x.oneMinus()).mul(y ? part.y : part.y.oneMinus());
      const off = texel.w.sub(distance).div(tolerance);
      // Never 0: a fragment that no texel belongs to takes the mean.
      const weight = bilinear.add(EVERYWHERE).mul(off.mul(off).negate().exp2().add(1e-5)).toVar();
      sum.addAssign(decode(texel).mul(weight));
      weights.addAssign(weight);
    }
    return sum.div(weights) as unknown as Vec4;
  });
}
