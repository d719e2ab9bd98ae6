/**
 * The light in which small pictures of materials are made: what stands around a product photographer's table. Radiance
 * by direction, blurred beforehand to several widths, so that a lobe of any width takes few looks at it.
 */
import type { Rgb } from '../plots/curve.ts';
import type { Vec3 } from '../vector.ts';

/** A soft box: a rectangle seen from the middle of the table, as tangents about the direction to it. */
interface SoftBox {
  readonly towards: Vec3;
  readonly width: number;
  readonly height: number;
  readonly radiance: Rgb;
}

/** A large warm one at the upper left, a tall cool strip at the right, and two behind that draw the rim and the fuzz of cloth. */
const BOXES: readonly SoftBox[] = [
  { towards: [-0.58, 0.62, 0.53], width: 0.44, height: 0.44, radiance: [7, 6.7, 6.25] },
  { towards: [0.93, 0.14, 0.34], width: 0.13, height: 0.8, radiance: [2.5, 2.8, 3.2] },
  { towards: [0.42, 0.5, -0.76], width: 0.55, height: 0.4, radiance: [4.6, 4.7, 4.9] },
  { towards: [-0.88, 0.05, -0.48], width: 0.2, height: 0.7, radiance: [3.4, 3.3, 3.2] },
];
const ZENITH: Rgb = [0.72, 0.74, 0.77];
/** Where walls meet the table. */
const WALL: Rgb = [0.35, 0.35, 0.355];
const TABLE: Rgb = [0.27, 0.258, 0.247];
/** Of the table right below, which the sphere keeps the light from. */
const SHADED = 0.16;
/** How soft edges are where nothing is blurred, in radians. */
const EDGE = 0.03;

const smooth = (t: number): number => {
  const x = Math.min(1, Math.max(0, 0.5 + 0.5 * t));
  return x * x * (3 - 2 * x);
};

/** @param blur how much it is blurred, in radians */
export function studioRadiance([x, y, z]: Vec3, blur: number): [number, number, number] {
  const edge = Math.hypot(EDGE, blur);
  const above = smooth(y / Math.max(0.09, edge));
  const height = Math.max(0, y) ** 0.8;
  const depth = Math.max(0, -y);
  const sum: [number, number, number] = [0, 0, 0];
  for (let c = 0; c < 3; c++) {
    const up = WALL[c]! + (ZENITH[c]! - WALL[c]!) * height;
    const down = TABLE[c]! * (SHADED + (1 - SHADED) * (1 - depth) ** 2);
    sum[c] = down + (up - down) * above;
  }
  for (const { towards, width, height: tall, radiance } of BOXES) {
    const [tx, ty, tz] = towards;
    const scale = 1 / Math.hypot(tx, ty, tz);
    const along = (x * tx + y * ty + z * tz) * scale;
    if (along <= 0) continue;
    // The box stands upright: its width is level.
    const level = Math.hypot(tx, tz);
    const across = (x * tz - z * tx) / level / along;
    const upward = (y * level - ((x * tx + z * tz) * ty) / level) * scale;
    const share =
      smooth((width - Math.abs(across)) / edge) * smooth((tall - Math.abs(upward / along)) / edge);
    for (let c = 0; c < 3; c++) sum[c]! += share * radiance[c]!;
  }
  return sum;
}

/** Texels along a side of a map. */
const SIDE = 256;
/** How much each map is blurred, in radians. */
export const BLURS = [0, 0.05, 0.1, 0.18, 0.32] as const;

let maps: Float32Array[] | null = null;

/** Octahedral maps (T. Engelhardt and C. Dachsbacher, 2008, "Octahedron Environment Maps"), one for each blur. */
export function studioMaps(): readonly Float32Array[] {
  maps ??= BLURS.map((blur) => {
    const map = new Float32Array(3 * SIDE * SIDE);
    for (let i = 0; i < SIDE * SIDE; i++) {
      const u = (2 * ((i % SIDE) + 0.5)) / SIDE - 1;
      const v = (2 * (Math.floor(i / SIDE) + 0.5)) / SIDE - 1;
      const y = 1 - Math.abs(u) - Math.abs(v);
      const folded = y < 0;
      const x = folded ? (1 - Math.abs(v)) * Math.sign(u) : u;
      const z = folded ? (1 - Math.abs(u)) * Math.sign(v) : v;
      const length = Math.hypot(x, y, z);
      map.set(studioRadiance([x / length, y / length, z / length], blur), 3 * i);
    }
    return map;
  });
  return maps;
}

/** Where in a map the radiance of a direction is: of red, before green and blue. */
export function studioTexel(x: number, y: number, z: number): number {
  const sum = Math.abs(x) + Math.abs(y) + Math.abs(z);
  let u = x / sum;
  let v = z / sum;
  if (y < 0) {
    const unfolded = u;
    u = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
    v = (1 - Math.abs(unfolded)) * (v < 0 ? -1 : 1);
  }
  const column = Math.min(SIDE - 1, Math.floor((u + 1) * (SIDE / 2)));
  const row = Math.min(SIDE - 1, Math.floor((v + 1) * (SIDE / 2)));
  return 3 * (row * SIDE + column);
}

/** The map that is blurred about as much. */
export function blurLevel(width: number): number {
  let best = 0;
  for (const [i, blur] of BLURS.entries())
    if (Math.abs(blur - width) < Math.abs(BLURS[best]! - width)) best = i;
  return best;
}
