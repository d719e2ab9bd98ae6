import type { Integral } from './quadrature.ts';
import { integrateReflection, type ReflectionOptions } from './reflection-quadrature.ts';
import type { Vec3 } from './vector.ts';

/**
 * The directional albedo R(v) = integral of f(l, v) (n.l) dl, n = +z: the share of the light that a surface
 * in a uniformly white world sends towards v, and by reciprocity the share that it reflects of light that
 * comes from v. A surface that makes no light of its own has R <= 1.
 *
 * @param f the BRDF in 1/sr
 * @param v the direction to the viewer
 */
export function directionalAlbedo(
  f: (l: Vec3, v: Vec3) => Vec3,
  v: Vec3,
  options: ReflectionOptions = {},
): Integral {
  return integrateReflection(
    (l) => {
      const [r, g, b] = f(l, v);
      return [r * l[2], g * l[2], b * l[2]];
    },
    v,
    { tolerance: 1e-4, ...options },
  );
}
