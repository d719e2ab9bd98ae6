import type { Rgb } from '../../src/brdf/model.ts';
import type { Vector3 } from '../../src/glsl/evaluator.ts';

export interface CsailOptions {
  /** Bins of theta_in, theta_out, phi_diff and phi_in. */
  bins?: [number, number, number, number];
  /** phi_diff from 0 to pi only. */
  half?: boolean;
}

/** The directions in the middle of a bin; azimuths count from -x, as BRDF Explorer takes them. */
export function directionsOf(
  at: readonly [number, number, number, number],
  { bins = [18, 18, 36, 36], half = false }: CsailOptions,
): { L: Vector3; V: Vector3 } {
  const middle = (axis: number, range: number) =>
    (((at[axis] as number) + 0.5) / (bins[axis] as number)) * range;
  const phiIn = middle(3, 2 * Math.PI);
  const phiOut = phiIn + middle(2, half ? Math.PI : 2 * Math.PI);
  const direction = (theta: number, phi: number): Vector3 => [
    -Math.sin(theta) * Math.cos(phi),
    -Math.sin(theta) * Math.sin(phi),
    Math.cos(theta),
  ];
  return { L: direction(middle(0, Math.PI / 2), phiIn), V: direction(middle(1, Math.PI / 2), phiOut) };
}

/** A CSAIL file of a BRDF, in the middle of each bin; null marks a bin without data. */
export function writeCsail(
  f: (L: Vector3, V: Vector3) => Rgb | null,
  options: CsailOptions = {},
): Uint8Array<ArrayBuffer> {
  const { bins = [18, 18, 36, 36], half = false } = options;
  const count = bins[0] * bins[1] * bins[2] * bins[3];
  const bytes = new Uint8Array(64 + count * 12);
  const view = new DataView(bytes.buffer);
  for (const [i, value] of [...bins, 0, 0, 1, 0, 0, half ? 1 : 0, 3].entries())
    view.setInt32(4 * i, value, true);
  let sample = 0;
  for (let a = 0; a < bins[0]; a++) {
    for (let b = 0; b < bins[1]; b++) {
      for (let c = 0; c < bins[2]; c++) {
        for (let d = 0; d < bins[3]; d++, sample++) {
          const { L, V } = directionsOf([a, b, c, d], options);
          const rgb = f(L, V);
          // The file's unit is ten times 1/sr.
          for (let k = 0; k < 3; k++)
            view.setFloat32(64 + 4 * (k * count + sample), rgb ? (rgb[k] as number) / 10 : -1, true);
        }
      }
    }
  }
  return bytes;
}
