import type { Rgb } from '../../src/brdf/model.ts';
import type { Vector3 } from '../../src/glsl/evaluator.ts';

/** What the tests write: a known function on the adaptive grid, by the paper (Dupuy and Jakob 2018). */
export interface RglOptions {
  /** Measured polar angles: this many from 0 to 90 degrees. */
  thetas?: number;
  /** Measured azimuths from -pi; 1 for an isotropic file. */
  phis?: number;
  /** How often the pattern repeats over a turn. */
  symmetry?: 1 | 2 | 4;
  /** Nodes along each side of the colours' square. */
  resolution?: number;
  /** Widths of the facets' distribution that the grid follows, along x and y. */
  alpha?: [number, number];
  jacobian?: boolean;
  /** Writes spectra of these wavelengths in place of colours; `f` is then asked for each. */
  spectrum?: { wavelengths: number[]; at(rgb: Rgb, nm: number): number };
}

type Field = { shape: number[]; data: Float32Array | Uint8Array };

const VNDF_SIZE = 64;
/** The cosine above the horizon from which on the function is asked. */
const LOWEST = 0.02;
const NDF_SIZE = 96;

export function writeRgl(
  f: (L: Vector3, V: Vector3) => Rgb,
  options: RglOptions = {},
): Uint8Array<ArrayBuffer> {
  return tensorFile(rglFields(f, options));
}

export function rglFields(
  f: (L: Vector3, V: Vector3) => Rgb,
  {
    thetas = 16,
    phis = 1,
    symmetry = 1,
    resolution = 32,
    alpha = [0.3, 0.3],
    jacobian = true,
    spectrum,
  }: RglOptions = {},
): Record<string, Field> {
  const theta = Float32Array.from({ length: thetas }, (_, i) => (i * Math.PI) / 2 / (thetas - 1));
  const phi = Float32Array.from({ length: phis }, (_, i) =>
    phis === 1 ? 0 : -Math.PI + (2 * Math.PI * i) / symmetry / (phis - 1),
  );
  const ndf = grid(NDF_SIZE, (u, v) => distribution(direction(u, v), alpha));
  const sigma = grid(NDF_SIZE, (u, v) => projectedArea(direction(u, v), alpha));
  const slices: { V: Vector3; vndf: Float32Array; luminance: Float32Array; colors: Rgb[] }[] = [];
  for (const p of phi) {
    for (const t of theta) {
      const V: Vector3 = [Math.sin(t) * Math.cos(p), Math.sin(t) * Math.sin(p), Math.cos(t)];
      const vndf = grid(VNDF_SIZE, (u, v) => {
        const h = direction(u, v);
        const cosine = Math.max(0, h[0] * V[0] + h[1] * V[1] + h[2] * V[2]);
        return distribution(h, alpha) * cosine * u * Math.hypot(h[0], h[1]) + 1e-4;
      });
      const colors: Rgb[] = [];
      const area = between(sigma, NDF_SIZE, Math.sqrt((2 * t) / Math.PI), (p + Math.PI) / (2 * Math.PI));
      for (const [u, v] of warped(vndf, VNDF_SIZE, resolution)) {
        const h = direction(u, v);
        const cosine = h[0] * V[0] + h[1] * V[1] + h[2] * V[2];
        const L: Vector3 = [2 * cosine * h[0] - V[0], 2 * cosine * h[1] - V[1], 2 * cosine * h[2] - V[2]];
        const scale = (jacobian ? (4 * area) / between(ndf, NDF_SIZE, u, v) : 1) * Math.max(L[2], 0);
        colors.push(f(raised(L), raised(V)).map((c) => c * scale) as unknown as Rgb);
      }
      const luminance = Float32Array.from(colors, ([r, g, b]) => (r + g + b) / 3);
      slices.push({ V, vndf, luminance, colors });
    }
  }
  const shape = [phis, thetas];
  const square = [resolution, resolution];
  const channels = spectrum
    ? spectrum.wavelengths.map((nm) => (rgb: Rgb) => spectrum.at(rgb, nm))
    : [0, 1, 2].map((c) => (rgb: Rgb) => rgb[c] as number);
  const values = slices.flatMap(({ colors }) => channels.map((channel) => colors.map(channel))).flat();
  return {
    description: { shape: [4], data: new TextEncoder().encode('test') },
    jacobian: { shape: [1], data: Uint8Array.of(jacobian ? 1 : 0) },
    phi_i: { shape: [phis], data: phi },
    theta_i: { shape: [thetas], data: theta },
    ndf: { shape: [NDF_SIZE, NDF_SIZE], data: ndf },
    sigma: { shape: [NDF_SIZE, NDF_SIZE], data: sigma },
    vndf: { shape: [...shape, VNDF_SIZE, VNDF_SIZE], data: joined(slices.map(({ vndf }) => vndf)) },
    luminance: { shape: [...shape, ...square], data: joined(slices.map(({ luminance }) => luminance)) },
    ...(spectrum && {
      wavelengths: { shape: [spectrum.wavelengths.length], data: Float32Array.from(spectrum.wavelengths) },
    }),
    [spectrum ? 'spectra' : 'rgb']: {
      shape: [...shape, channels.length, ...square],
      data: Float32Array.from(values),
    },
  };
}

/** A direction just above the horizon for one that is not. */
function raised([x, y, z]: Vector3): Vector3 {
  if (z >= LOWEST) return [x, y, z];
  const r = Math.sqrt(1 - LOWEST * LOWEST) / (Math.hypot(x, y) || 1);
  return [x * r, y * r, LOWEST];
}

function joined(parts: Float32Array[]): Float32Array {
  return Float32Array.from(parts.flatMap((part) => [...part]));
}

/** The unit square to the hemisphere: theta = pi/2 u^2, phi = pi (2 v - 1). */
function direction(u: number, v: number): Vector3 {
  const [theta, phi] = [(Math.PI / 2) * u * u, Math.PI * (2 * v - 1)];
  return [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
}

/** GGX (B. Walter et al. 2007), anisotropic. */
function distribution([x, y, z]: Vector3, [ax, ay]: [number, number]): number {
  return 1 / (Math.PI * ax * ay * ((x / ax) ** 2 + (y / ay) ** 2 + z * z) ** 2);
}

/** The area of its facets as seen from v (E. Heitz 2014). */
function projectedArea([x, y, z]: Vector3, [ax, ay]: [number, number]): number {
  return (z + Math.hypot(x * ax, y * ay, z)) / 2;
}

/** Values at the nodes of a square, row by row. */
function grid(size: number, value: (u: number, v: number) => number): Float32Array {
  return Float32Array.from({ length: size * size }, (_, i) =>
    value((i % size) / (size - 1), Math.floor(i / size) / (size - 1)),
  );
}

function between(table: Float32Array, size: number, u: number, v: number): number {
  const [px, py] = [Math.max(u, 0) * (size - 1), Math.max(v, 0) * (size - 1)];
  const [x, y] = [Math.min(Math.floor(px), size - 2), Math.min(Math.floor(py), size - 2)];
  const [s, t] = [px - x, py - y];
  const at = (i: number, k: number) => table[(y + k) * size + x + i] as number;
  return (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1));
}

/** Where the marginal and conditional inversion of a density takes the points (x, y) of the unit square, row by row. */
function* warped(table: Float32Array, size: number, count: number): Generator<[number, number]> {
  const rows = integrals(
    Array.from({ length: size }, (_, k) => integrals([...table.subarray(k * size, (k + 1) * size)]).total),
  );
  for (let y = 0; y < count; y++) {
    const v = invert(rows, y / (count - 1));
    const k = Math.min(Math.floor(v), size - 2);
    const t = v - k;
    const column = integrals(
      Array.from(
        { length: size },
        (_, i) => (1 - t) * (table[k * size + i] as number) + t * (table[(k + 1) * size + i] as number),
      ),
    );
    for (let x = 0; x < count; x++) yield [invert(column, x / (count - 1)) / (size - 1), v / (size - 1)];
  }
}

interface Integrals {
  nodes: number[];
  /** The integral up to each node. */
  upTo: number[];
  total: number;
}

function integrals(nodes: number[]): Integrals {
  const upTo = [0];
  for (let i = 1; i < nodes.length; i++)
    upTo.push((upTo[i - 1] as number) + ((nodes[i - 1] as number) + (nodes[i] as number)) / 2);
  return { nodes, upTo, total: upTo.at(-1) as number };
}

/** Where the integral of a density, straight between its nodes, reaches the share u: by bisection. */
function invert({ nodes, upTo, total }: Integrals, u: number): number {
  const found = upTo.findIndex((sum) => sum >= u * total);
  const cell = Math.min(Math.max(found - 1, 0), nodes.length - 2);
  const [a, b] = [nodes[cell] as number, nodes[cell + 1] as number];
  let [low, high] = [0, 1];
  for (let turn = 0; turn < 40; turn++) {
    const t = (low + high) / 2;
    if ((upTo[cell] as number) + t * a + (t * t * (b - a)) / 2 < u * total) low = t;
    else high = t;
  }
  return cell + (low + high) / 2;
}

/** The container, by its description in brdf-loader. */
export function tensorFile(fields: Record<string, Field>): Uint8Array<ArrayBuffer> {
  const head: number[] = [...Buffer.from('tensor_file\0'), 1, 0];
  const number = (value: number, size: number) => {
    for (let i = 0; i < size; i++) head.push(Math.floor(value / 256 ** i) % 256);
  };
  const entries = Object.entries(fields);
  number(entries.length, 4);
  const places: number[] = [];
  for (const [name, { shape, data }] of entries) {
    number(name.length, 2);
    head.push(...Buffer.from(name));
    number(shape.length, 2);
    number(data instanceof Uint8Array ? 1 : 10, 1);
    places.push(head.length);
    number(0, 8);
    for (const size of shape) number(size, 8);
  }
  const parts = entries.map(([, { data }]) => Buffer.from(data.buffer, data.byteOffset, data.byteLength));
  const file = Buffer.concat([Buffer.from(head), ...parts]);
  let at = head.length;
  for (const [i, part] of parts.entries()) {
    file.writeBigUInt64LE(BigInt(at), places[i] as number);
    at += part.length;
  }
  return new Uint8Array(file.buffer, file.byteOffset, file.length).slice();
}
