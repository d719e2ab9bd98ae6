/** A sphere, or another shape, under one light far away, as a viewer far away sees it. */
import { direction, type Vec3 } from '../vector.ts';
import { type Reflectance, radians } from './curve.ts';
import type { Picture } from './picture.ts';
import { type Eye, eyeAt, type Surface } from './surface.ts';

/** Degrees. The viewer and the light at the pole of the sphere are those of the plots. */
export interface LitOptions {
  readonly thetaV: number;
  readonly phiV: number;
  readonly thetaL: number;
  readonly phiL: number;
  /**
   * As in BRDF Explorer: one looks down the normal, and the light is at twice theta_l, so that the highlight is
   * where theta_l says.
   */
  readonly doubleTheta: boolean;
}

/** Pixels of a side, and samples of a side in each. */
const PASSES = [
  { size: 48, samples: 1 },
  { size: 128, samples: 1 },
  { size: 256, samples: 2 },
] as const;
const PIXELS_AT_ONCE = 2000;

export function litDirections(options: LitOptions): { eye: Eye; l: Vec3 } {
  const { thetaV, phiV, thetaL, phiL, doubleTheta } = options;
  return {
    eye: doubleTheta ? eyeAt(0, 0) : eyeAt(thetaV, phiV),
    l: direction(Math.cos(radians(doubleTheta ? 2 * thetaL : thetaL)), radians(phiL)),
  };
}

/**
 * Radiance for an illuminance of pi lx: a white diffuse surface that faces the light has 1.
 *
 * Pixels are multiplied by their alpha.
 *
 * @param surfaceOf the shape at a size, in pixels
 * @returns null in the pauses
 */
export function* litPictures(
  f: Reflectance,
  surfaceOf: (eye: Eye, size: number) => Surface,
  options: LitOptions,
): Generator<Picture | null> {
  const { eye, l } = litDirections(options);
  for (const { size, samples } of PASSES) {
    const surface = surfaceOf(eye, size * samples);
    const pixels = new Float32Array(3 * size * size);
    const alpha = new Float32Array(size * size);
    for (let i = 0; i < size * size; i++) {
      if (i % PIXELS_AT_ONCE === PIXELS_AT_ONCE - 1) yield null;
      const { normal, tangent, coverage } = meanOf(surface, i % size, Math.floor(i / size), samples);
      if (coverage === 0) continue;
      alpha[i] = coverage;
      const rgb = radiance(f, normal, tangent, l, eye.back);
      pixels.set(
        rgb.map((value) => coverage * value),
        3 * i,
      );
    }
    yield { size, pixels, alpha };
  }
}

/** Edges are smooth, at the price of one evaluation a pixel: what its samples see is averaged before. */
function meanOf(
  { size, covered, normals, tangents }: Surface,
  column: number,
  row: number,
  samples: number,
): { normal: Vec3; tangent: Vec3; coverage: number } {
  const normal = [0, 0, 0];
  const tangent = [0, 0, 0];
  let count = 0;
  for (let y = row * samples; y < (row + 1) * samples; y++) {
    for (let x = column * samples; x < (column + 1) * samples; x++) {
      const i = y * size + x;
      if (!covered[i]) continue;
      count += 1;
      for (let c = 0; c < 3; c++) {
        normal[c] = (normal[c] as number) + (normals[3 * i + c] as number);
        tangent[c] = (tangent[c] as number) + (tangents[3 * i + c] as number);
      }
    }
  }
  const n = unit(normal);
  const along = n[0] * (tangent[0] as number) + n[1] * (tangent[1] as number) + n[2] * (tangent[2] as number);
  const across = tangent.map((value, c) => value - along * (n[c] as number));
  return { normal: n, tangent: unit(across), coverage: count / samples ** 2 };
}

function unit(v: readonly number[]): Vec3 {
  const [x = 0, y = 0, z = 0] = v;
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}

function radiance(f: Reflectance, n: Vec3, t: Vec3, l: Vec3, v: Vec3): readonly number[] {
  const [nx, ny, nz] = n;
  const [tx, ty, tz] = t;
  const local = ([x, y, z]: Vec3): Vec3 => [
    tx * x + ty * y + tz * z,
    (ny * tz - nz * ty) * x + (nz * tx - nx * tz) * y + (nx * ty - ny * tx) * z,
    nx * x + ny * y + nz * z,
  ];
  const [toLight, toViewer] = [local(l), local(v)];
  if (toLight[2] <= 0 || toViewer[2] <= 0) return [0, 0, 0];
  return f(toLight, toViewer).map((value) => Math.PI * value * toLight[2]);
}
