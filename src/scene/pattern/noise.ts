/**
 * What patterns are made of. Everything repeats after a whole number of lattice cells, so that a picture of it has no seam.
 * The lattice is hashed, not tabulated: any period and any seed cost the same.
 */

/** 32 bits of a lattice point. Finaliser of MurmurHash3 (A. Appleby, 2011) over a sum that sets rows, columns and seeds apart. */
export function hash(x: number, y: number, seed: number): number {
  let h = (Math.imul(x, 0x9e3779b1) + Math.imul(y, 0x85ebca77) + Math.imul(seed, 0xc2b2ae3d)) | 0;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (h ^ (h >>> 16)) >>> 0;
}

/** The same as a number in [0, 1). */
export const random = (x: number, y: number, seed: number): number => hash(x, y, seed) / 2 ** 32;

export const modulo = (x: number, period: number): number => x - period * Math.floor(x / period);
export const mix = (a: number, b: number, t: number): number => a + (b - a) * t;
export const clamp = (x: number): number => Math.min(1, Math.max(0, x));

/** 0 up to `low`, 1 from `high`, with level ends between. */
export function smoothstep(low: number, high: number, x: number): number {
  const t = clamp((x - low) / (high - low));
  return t * t * (3 - 2 * t);
}

/** Sixteen directions: so few are as good as any, and cheaper than to compute them. */
const DIRECTIONS = Float64Array.from({ length: 32 }, (_, i) => {
  const angle = (Math.PI / 8) * (i >> 1);
  return i & 1 ? Math.sin(angle) : Math.cos(angle);
});
/** No dot product exceeds half the diagonal of a cell. */
const SCALE = Math.SQRT2;

const fade = (t: number): number => t * t * t * (t * (t * 6 - 15) + 10);

/**
 * Gradient noise, -1..1 (K. Perlin, 1985, "An Image Synthesizer"; the fade is that of his "Improving Noise", 2002).
 *
 * @param x in lattice cells, of which `columns` make a period
 */
export function gradientNoise(x: number, y: number, columns: number, rows: number, seed: number): number {
  // No arrays here: this runs millions of times for a picture.
  const left = Math.floor(x);
  const low = Math.floor(y);
  const fx = x - left;
  const fy = y - low;
  const x0 = modulo(left, columns);
  const y0 = modulo(low, rows);
  const x1 = x0 + 1 === columns ? 0 : x0 + 1;
  const y1 = y0 + 1 === rows ? 0 : y0 + 1;
  const a = slope(hash(x0, y0, seed), fx, fy);
  const b = slope(hash(x1, y0, seed), fx - 1, fy);
  const c = slope(hash(x0, y1, seed), fx, fy - 1);
  const d = slope(hash(x1, y1, seed), fx - 1, fy - 1);
  const u = fade(fx);
  return SCALE * mix(mix(a, b, u), mix(c, d, u), fade(fy));
}

function slope(bits: number, x: number, y: number): number {
  const i = 2 * (bits >>> 28);
  return DIRECTIONS[i]! * x + DIRECTIONS[i + 1]! * y;
}

/** Noise of one octave after the other, each twice as fine and half as strong; about -1..1. u and v are 0..1 over the picture. */
export function fractal(
  u: number,
  v: number,
  columns: number,
  rows: number,
  octaves: number,
  seed: number,
): number {
  let sum = 0;
  let whole = 0;
  for (let i = 0; i < octaves; i++) {
    const nx = columns << i;
    const ny = rows << i;
    sum += gradientNoise(u * nx, v * ny, nx, ny, seed + i) / (1 << i);
    whole += 1 / (1 << i);
  }
  return sum / whole;
}

/** Perlin's turbulence (1985): the same of magnitudes, which has creases; 0..1. */
export function turbulence(u: number, v: number, cells: number, octaves: number, seed: number): number {
  let sum = 0;
  let whole = 0;
  for (let i = 0; i < octaves; i++) {
    const n = cells << i;
    sum += Math.abs(gradientNoise(u * n, v * n, n, n, seed + i)) / (1 << i);
    whole += 1 / (1 << i);
  }
  return sum / whole;
}

/** What is near a point among points scattered one to a cell. */
export interface Near {
  /** Distances to the nearest and to the next, in cells. */
  first: number;
  second: number;
  /** 32 bits of the nearest point. */
  id: number;
}

/** S. Worley, 1996, "A Cellular Texture Basis Function". @param jitter 0 puts the points in the middle of their cells, 1 anywhere in them */
export function cellNoise(
  x: number,
  y: number,
  columns: number,
  rows: number,
  seed: number,
  jitter: number,
  out: Near,
): Near {
  const column = Math.floor(x);
  const row = Math.floor(y);
  let first = Number.POSITIVE_INFINITY;
  let second = first;
  let id = 0;
  for (let j = row - 1; j <= row + 1; j++) {
    for (let i = column - 1; i <= column + 1; i++) {
      const bits = hash(modulo(i, columns), modulo(j, rows), seed);
      const dx = i + 0.5 + jitter * ((bits & 0xffff) / 0xffff - 0.5) - x;
      const dy = j + 0.5 + jitter * ((bits >>> 16) / 0xffff - 0.5) - y;
      const squared = dx * dx + dy * dy;
      if (squared < first) {
        second = first;
        first = squared;
        id = bits;
      } else if (squared < second) second = squared;
    }
  }
  out.first = Math.sqrt(first);
  out.second = Math.sqrt(second);
  out.id = id;
  return out;
}
