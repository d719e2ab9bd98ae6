import type { Rgb } from '../../src/brdf/model.ts';
import type { Vector3 } from '../../src/glsl/evaluator.ts';
import { MERL_BINS, MERL_SAMPLES, MERL_SCALES } from '../../src/io/merl.ts';

/** The directions in the middle of a bin, by the definition of the angles (Rusinkiewicz 1998), n = +z. */
export function directionsOf(h: number, d: number, p: number): { L: Vector3; V: Vector3 } {
  const thetaH = (((h + 0.5) / 90) ** 2 * Math.PI) / 2;
  const thetaD = (((d + 0.5) / 90) * Math.PI) / 2;
  const phiD = ((p + 0.5) / 180) * Math.PI;
  const x = Math.sin(thetaD) * Math.cos(phiD);
  const y = Math.sin(thetaD) * Math.sin(phiD);
  const z = Math.cos(thetaD);
  // The difference stands about h; turning by theta_h about y puts h where it belongs.
  const turned = (x: number, y: number): Vector3 => [
    x * Math.cos(thetaH) + z * Math.sin(thetaH),
    y,
    z * Math.cos(thetaH) - x * Math.sin(thetaH),
  ];
  return { L: turned(x, y), V: turned(-x, -y) };
}

/**
 * A MERL file of an isotropic BRDF, in the middle of each bin; what is below the horizon is marked as missing,
 * as in the database.
 */
export function writeMerl(f: (L: Vector3, V: Vector3) => Rgb): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(12 + MERL_SAMPLES * 24);
  const view = new DataView(bytes.buffer);
  for (const [i, count] of MERL_BINS.entries()) view.setInt32(4 * i, count, true);
  for (let h = 0; h < 90; h++) {
    for (let d = 0; d < 90; d++) {
      // Mirrored at the plane of n and h nothing changes: half the work.
      for (let p = 0; p < 90; p++) {
        const { L, V } = directionsOf(h, d, p);
        const value = L[2] > 0 && V[2] > 0 ? f(L, V) : null;
        for (let c = 0; c < 3; c++) {
          const stored = value === null ? -1 : (value[c] as number) / (MERL_SCALES[c] as number);
          const row = 12 + (c * MERL_SAMPLES + (h * 90 + d) * 180) * 8;
          view.setFloat64(row + 8 * p, stored, true);
          view.setFloat64(row + 8 * (179 - p), stored, true);
        }
      }
    }
  }
  return bytes;
}
