/**
 * Light that a surface sends towards a viewer, as a sum over directions: the shading equation's integral over half
 * vectors, where lobes are as wide for every viewer (reflection-quadrature.ts has the exact one).
 */
import type { Reflectance } from '../plots/curve.ts';
import type { Vec3 } from '../vector.ts';
import { blurLevel } from './studio.ts';

/** Directions l of the local frame with what light from there counts: f (n.l) dl, by channel. */
export interface Lobe {
  readonly count: number;
  /** x, y, z, red, green, blue for each. */
  readonly values: Float32Array;
  /** The map of the studio that is blurred as wide as the direction's share of the integral. */
  readonly levels: Uint8Array;
}

/** Half vectors: rings evenly spread over the logarithm of the angle up to MIDDLE, for lobes of any width; then evenly. */
const MIDDLE = 0.08;
const INNERMOST = 2e-4;
const INNER_RINGS = 22;
/** How far apart directions to the light are in the outer rings, in radians. */
const SPACING = 0.16;

interface Ring {
  readonly theta: number;
  readonly spokes: number;
  /** The solid angle of the half vectors that each spoke stands for. */
  readonly solidAngle: number;
}

const RINGS: readonly Ring[] = (() => {
  // The innermost one is the disc within.
  const edges = [0];
  for (let i = 0; i <= INNER_RINGS; i++) edges.push(INNERMOST * (MIDDLE / INNERMOST) ** (i / INNER_RINGS));
  const outer = Math.ceil((2 * (Math.PI / 2 - MIDDLE)) / SPACING);
  for (let i = 1; i <= outer; i++) edges.push(MIDDLE + ((Math.PI / 2 - MIDDLE) * i) / outer);
  return edges.slice(1).map((end, i) => {
    const start = edges[i] as number;
    // Where half of the ring's solid angle is.
    const theta = Math.acos((Math.cos(start) + Math.cos(end)) / 2);
    const around = 2 * Math.PI * Math.sin(Math.min(2 * theta, Math.PI / 2));
    const spokes = Math.max(6, Math.ceil(around / SPACING));
    return { theta, spokes, solidAngle: (2 * Math.PI * (Math.cos(start) - Math.cos(end))) / spokes };
  });
})();
const DIRECTIONS = RINGS.reduce((sum, { spokes }) => sum + spokes, 0);
/** How much wider than a disc of its solid angle each direction is: neighbours overlap, so that no pattern is seen. */
const OVERLAP = 1.7;
/** What is less of the whole than this is left out. */
const NEGLIGIBLE = 1e-4;

/** Where values are kept while a lobe is made. */
const buffer = new Float32Array(6 * DIRECTIONS);
const blurs = new Uint8Array(DIRECTIONS);

/** @param v above the surface, in the local frame */
export function lobeOf(f: Reflectance, v: Vec3): Lobe {
  let count = 0;
  let most = 0;
  for (const [ring, { theta, spokes, solidAngle }] of RINGS.entries()) {
    const [sine, cosine] = [Math.sin(theta), Math.cos(theta)];
    for (let spoke = 0; spoke < spokes; spoke++) {
      const phi = (2 * Math.PI * (spoke + (ring % 2) / 2)) / spokes;
      const [hx, hy] = [sine * Math.cos(phi), sine * Math.sin(phi)];
      const vh = v[0] * hx + v[1] * hy + v[2] * cosine;
      const l: Vec3 = [2 * vh * hx - v[0], 2 * vh * hy - v[1], 2 * vh * cosine - v[2]];
      if (vh <= 0 || l[2] <= 1e-4) continue;
      // A solid angle about h becomes one about l that is 4 (v.h) times as large.
      const share = 4 * vh * solidAngle;
      const weight = share * l[2];
      const rgb = f(l, v);
      buffer.set(l, 6 * count);
      for (let c = 0; c < 3; c++) {
        const value = weight * rgb[c as 0];
        buffer[6 * count + 3 + c] = value > 0 && value < Number.POSITIVE_INFINITY ? value : 0;
        most = Math.max(most, buffer[6 * count + 3 + c]!);
      }
      blurs[count] = blurLevel(OVERLAP * Math.sqrt(share / Math.PI));
      count += 1;
    }
  }
  return kept(count, NEGLIGIBLE * most);
}

function kept(count: number, least: number): Lobe {
  let end = 0;
  for (let i = 0; i < count; i++) {
    const start = 6 * i;
    if (Math.max(buffer[start + 3]!, buffer[start + 4]!, buffer[start + 5]!) <= least) continue;
    buffer.copyWithin(6 * end, start, start + 6);
    blurs[end] = blurs[i]!;
    end += 1;
  }
  return { count: end, values: buffer.slice(0, 6 * end), levels: blurs.slice(0, end) };
}
