/**
 * What a parallel projection sees of a sphere or of triangles: the normal and the tangent at each pixel. The
 * frame is the plots': at theta_v = 0 one looks along -z, x to the right and y upwards.
 */
import type { Vec3 } from '../vector.ts';
import { radians } from './curve.ts';

export interface Surface {
  readonly size: number;
  /** 1 where there is something. */
  readonly covered: Uint8Array;
  /** Unit vectors, rows from the top. */
  readonly normals: Float32Array;
  readonly tangents: Float32Array;
}

/** Triangles; three numbers for each vertex. */
export interface TriangleMesh {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** null: around the y axis, as lathes leave their marks. */
  readonly tangents: Float32Array | null;
  readonly index: Uint32Array;
}

export interface Eye {
  readonly right: Vec3;
  readonly up: Vec3;
  /** Towards the viewer. */
  readonly back: Vec3;
}

/** The viewer's frame: the plots' own, turned so that z goes to v. Degrees. */
export function eyeAt(thetaV: number, phiV: number): Eye {
  const [c, s] = [Math.cos(radians(thetaV)), Math.sin(radians(thetaV))];
  const [cp, sp] = [Math.cos(radians(phiV)), Math.sin(radians(phiV))];
  // Rodrigues' rotation by theta_v about (-sin phi, cos phi, 0).
  const turn = ([x, y, z]: Vec3): Vec3 => {
    const along = (1 - c) * (-sp * x + cp * y);
    return [c * x + s * cp * z - sp * along, c * y + s * sp * z + cp * along, c * z - s * (cp * x + sp * y)];
  };
  return { right: turn([1, 0, 0]), up: turn([0, 1, 0]), back: turn([0, 0, 1]) };
}

/** The part of the picture's half width that the sphere, or the sphere around the triangles, takes. */
export const FILL = 0.94;

export function sphereSurface({ right, up, back }: Eye, size: number): Surface {
  const surface = empty(size);
  for (let i = 0; i < size * size; i++) {
    const x = ((2 * ((i % size) + 0.5)) / size - 1) / FILL;
    const y = (1 - (2 * (Math.floor(i / size) + 0.5)) / size) / FILL;
    const rest = 1 - x * x - y * y;
    if (rest <= 0) continue;
    const z = Math.sqrt(rest);
    const normal = [0, 1, 2].map((k) => x * right[k as 0] + y * up[k as 0] + z * back[k as 0]);
    put(surface, i, normal as unknown as Vec3, null);
  }
  return surface;
}

export function meshSurface(mesh: TriangleMesh, { right, up, back }: Eye, size: number): Surface {
  const surface = empty(size);
  const { positions, normals, tangents, index } = mesh;
  const { center, radius } = boundOf(positions);
  const depths = new Float32Array(size * size).fill(Number.NEGATIVE_INFINITY);
  const scale = (FILL * size) / 2 / radius;
  const count = positions.length / 3;
  const screen = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const p: Vec3 = [0, 1, 2].map((k) => (positions[3 * i + k] as number) - center[k as 0]) as never;
    screen[3 * i] = size / 2 + scale * dot(p, right);
    screen[3 * i + 1] = size / 2 - scale * dot(p, up);
    screen[3 * i + 2] = dot(p, back);
  }
  const mixed = (data: Float32Array, corners: readonly number[], weights: readonly number[]): Vec3 =>
    [0, 1, 2].map((k) =>
      corners.reduce((sum, corner, j) => sum + (weights[j] as number) * (data[3 * corner + k] as number), 0),
    ) as never;
  for (let t = 0; t + 2 < index.length; t += 3) {
    const corners = [index[t] as number, index[t + 1] as number, index[t + 2] as number];
    const at = (corner: number, k: number) => screen[3 * (corners[corner] as number) + k] as number;
    const [x0, y0, x1, y1, x2, y2] = [at(0, 0), at(0, 1), at(1, 0), at(1, 1), at(2, 0), at(2, 1)];
    const area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
    // y goes down: what faces the viewer winds the other way round.
    if (!(area < 0)) continue;
    const left = Math.max(0, Math.floor(Math.min(x0, x1, x2)));
    const end = Math.min(size - 1, Math.ceil(Math.max(x0, x1, x2)));
    const top = Math.max(0, Math.floor(Math.min(y0, y1, y2)));
    const bottom = Math.min(size - 1, Math.ceil(Math.max(y0, y1, y2)));
    for (let row = top; row <= bottom; row++) {
      for (let column = left; column <= end; column++) {
        const [x, y] = [column + 0.5, row + 0.5];
        const a = ((x1 - x) * (y2 - y) - (x2 - x) * (y1 - y)) / area;
        const b = ((x2 - x) * (y0 - y) - (x0 - x) * (y2 - y)) / area;
        const c = 1 - a - b;
        if (a < 0 || b < 0 || c < 0) continue;
        const depth = a * at(0, 2) + b * at(1, 2) + c * at(2, 2);
        const i = row * size + column;
        if (depth <= (depths[i] as number)) continue;
        depths[i] = depth;
        const tangent = tangents && mixed(tangents, corners, [a, b, c]);
        put(surface, i, mixed(normals, corners, [a, b, c]), tangent);
      }
    }
  }
  return surface;
}

function empty(size: number): Surface {
  const count = size * size;
  return {
    size,
    covered: new Uint8Array(count),
    normals: new Float32Array(3 * count),
    tangents: new Float32Array(3 * count),
  };
}

function put(surface: Surface, i: number, normal: Vec3, tangent: Vec3 | null): void {
  const n = normalized(normal);
  const x = tangent ?? [n[2], 0, -n[0]];
  const along = dot(x, n);
  const across: Vec3 = [x[0] - along * n[0], x[1] - along * n[1], x[2] - along * n[2]];
  surface.covered[i] = 1;
  surface.normals.set(n, 3 * i);
  // On the axis itself any tangent will do.
  surface.tangents.set(Math.hypot(...across) > 1e-9 ? normalized(across) : [1, 0, 0], 3 * i);
}

function boundOf(positions: Float32Array): { center: Vec3; radius: number } {
  const low = [1, 1, 1].map(() => Number.POSITIVE_INFINITY);
  const high = low.map((value) => -value);
  for (const [i, value] of positions.entries()) {
    low[i % 3] = Math.min(low[i % 3] as number, value);
    high[i % 3] = Math.max(high[i % 3] as number, value);
  }
  const center = low.map((value, k) => (value + (high[k] as number)) / 2) as unknown as Vec3;
  let radius = 1e-9;
  for (let i = 0; i < positions.length; i += 3) {
    const [x = 0, y = 0, z = 0] = positions.subarray(i, i + 3);
    radius = Math.max(radius, Math.hypot(x - center[0], y - center[1], z - center[2]));
  }
  return { center, radius };
}

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function normalized(v: Vec3): Vec3 {
  const length = Math.hypot(...v) || 1;
  return [v[0] / length, v[1] / length, v[2] / length];
}
