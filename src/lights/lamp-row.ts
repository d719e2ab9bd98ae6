/**
 * A lamp as numbers for shaders that go through many of them: texels of a row of a texture, in world space.
 *
 *     0  position; a directional light's is (0, 0, 0)    w: kind, see LAMP_KINDS
 *     1  colour times intensity                          w: range^-4
 *     2  unit vector where it shines                     w: cosine of the cut-off, -2 without one
 *     3  exponent, slope of the edge, factors of 1/r and 1/r^2
 *     4  half the width of a rectangle                   w: free
 *     5  half its height                                 w: radius
 */
import {
  type DirectionalLight,
  type Light,
  type PointLight,
  type RectAreaLight,
  Vector3,
} from 'three/webgpu';
import type { Falloff } from './falloff.ts';
import { STEP_SLOPE } from './spot-light.ts';

export const LAMP_TEXELS = 6;
export const LAMP_KINDS = { directional: 0, central: 1, rectangle: 2 } as const;

type Lamp = Light &
  Partial<
    Pick<DirectionalLight, 'target'> &
      Pick<PointLight, 'distance'> &
      Pick<RectAreaLight, 'width' | 'height'> & {
        isDirectionalLight: true;
        isPointLight: true;
        isSpotLight: true;
        isRectAreaLight: true;
        angle: number;
        penumbra: number;
        exponent: number;
        radius: number;
        falloff: Falloff;
      }
  >;

/** Whether a light shines from somewhere, not from everywhere. */
export function isLamp(light: Light): boolean {
  const { isDirectionalLight, isPointLight, isSpotLight, isRectAreaLight } = light as Lamp;
  return Boolean(isDirectionalLight || isPointLight || isSpotLight || isRectAreaLight);
}

const place = new Vector3();
const side = new Vector3();

/** Writes a lamp whose world matrices are up to date. @param at the first of the row's numbers */
export function writeLamp(light: Light, data: Float32Array, at: number): void {
  const lamp = light as Lamp;
  data.fill(0, at, at + 4 * LAMP_TEXELS);
  const put = (texel: number, { x, y, z }: Vector3, w: number) => data.set([x, y, z, w], at + 4 * texel);
  const { r, g, b } = lamp.color;
  const { isDirectionalLight, isRectAreaLight, isSpotLight, distance = 0, falloff = 'inverse-square' } = lamp;
  data.set([r, g, b, 0], at + 4);
  for (let i = 4; i < 7; i++) data[at + i]! *= lamp.intensity;
  if (distance > 0) data[at + 7] = distance ** -4;
  place.setFromMatrixPosition(lamp.matrixWorld);
  const kind = isDirectionalLight ? 'directional' : isRectAreaLight ? 'rectangle' : 'central';
  put(0, isDirectionalLight ? side.set(0, 0, 0) : place, LAMP_KINDS[kind]);
  if (lamp.target) side.setFromMatrixPosition(lamp.target.matrixWorld).sub(place);
  else side.setFromMatrixColumn(lamp.matrixWorld, 2).negate();
  const outer = isSpotLight ? Math.cos(lamp.angle ?? 0) : -2;
  put(2, side.normalize(), outer);
  const inner = isSpotLight ? Math.cos((lamp.angle ?? 0) * (1 - (lamp.penumbra ?? 0))) : outer;
  const slope = inner > outer ? 1 / (inner - outer) : STEP_SLOPE;
  data.set(
    [lamp.exponent ?? 0, slope, Number(falloff === 'linear'), Number(falloff === 'inverse-square')],
    at + 12,
  );
  if (isRectAreaLight) {
    put(
      4,
      side
        .setFromMatrixColumn(lamp.matrixWorld, 0)
        .normalize()
        .multiplyScalar((lamp.width ?? 0) / 2),
      0,
    );
    put(
      5,
      side
        .setFromMatrixColumn(lamp.matrixWorld, 1)
        .normalize()
        .multiplyScalar((lamp.height ?? 0) / 2),
      0,
    );
  }
  data[at + 23] = lamp.radius ?? 0;
}
