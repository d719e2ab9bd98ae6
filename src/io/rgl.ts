/**
 * Measured BRDFs of the RGL database (`.bsdf`), with RGB colours or with spectra. J. Dupuy and W. Jakob, 2018, "An
 * Adaptive Parameterization for Efficient Material Acquisition and Rendering", ACM TOG 37(6).
 */
import { colorWeights } from '../color/spectrum.ts';
import { ByteError } from './bytes.ts';
import { TensorFile, writeTensorFile } from './tensor-file.ts';

/** A grid of numbers; x varies fastest. */
interface Grid {
  readonly width: number;
  readonly height: number;
  readonly values: Float32Array;
}

/** What a file holds. Slices are ordered by phi, then theta. */
interface Measurement {
  /** Azimuths and polar angles of the view that were measured, radians, ascending. */
  readonly phi: Float32Array;
  readonly theta: Float32Array;
  /** D(h) and the projected area of the facets, over the square of their angles. */
  readonly ndf: Grid;
  readonly sigma: Grid;
  /** Per slice: the density of visible normals, and the luminance over the square that it warps to. */
  readonly vndf: Grid;
  readonly luminance: Grid;
  /** Per slice red, green and blue: f (n.l), over D/(4 sigma) if `jacobian`. */
  readonly rgb: Float32Array;
  readonly jacobian: boolean;
  readonly description: Uint8Array;
}

/** The lookup's binary search ends after twelve turns. */
const LONGEST_AXIS = 4096;
/** What fits into a texture that every GPU has: 2048 x 8192. */
const MOST_TRIPLES = 2 ** 24;
/** 0.1 mm: no detector for light sees more. The number guards against sizes that only waste time. */
const MOST_WAVELENGTHS = 2048;

/** Where the tables begin, see rglTriples(). */
const HEAD = 6;

/**
 * The triples that models/measured/rgl.brdf reads: six of sizes, the angles, then the tables.
 *
 * 0: number of phi, number of theta, symmetry. 1 to 4: width, height and first triple of ndf, sigma, vndf,
 * luminance. 5: first triple of the colours, whose size is luminance's; 1 if they are over D/(4 sigma). A triple of
 * vndf or luminance is the density over the unit square, the integral along its row up to it, and the integral over
 * all rows up to its own.
 *
 * @throws ByteError naming the file, the byte, the field and what is wrong there
 */
export function readRgl(bytes: Uint8Array, fileName: string): Float32Array {
  return rglTriples(readMeasurement(bytes, fileName));
}

/**
 * The same measurement as a document keeps it: colours instead of spectra, a hundredth of the size.
 *
 * @throws ByteError as readRgl()
 */
export function packRgl(bytes: Uint8Array, fileName: string): Uint8Array {
  const file = readMeasurement(bytes, fileName);
  const grid = ({ height, width, values }: Grid, ...slices: number[]) => ({
    shape: [...slices, height, width],
    data: values,
  });
  const slices = [file.phi.length, file.theta.length];
  const { width, height } = file.luminance;
  return writeTensorFile({
    description: { shape: [file.description.length], data: file.description },
    jacobian: { shape: [1], data: Uint8Array.of(file.jacobian ? 1 : 0) },
    phi_i: { shape: [file.phi.length], data: file.phi },
    theta_i: { shape: [file.theta.length], data: file.theta },
    ndf: grid(file.ndf),
    sigma: grid(file.sigma),
    vndf: grid(file.vndf, ...slices),
    luminance: grid(file.luminance, ...slices),
    rgb: { shape: [...slices, 3, height, width], data: file.rgb },
  });
}

function readMeasurement(bytes: Uint8Array, fileName: string): Measurement {
  const file = new TensorFile(bytes, fileName);
  const phi = readAxis(file, 'phi_i', Math.PI);
  if (![0, 1, 2, 4].includes(symmetry(phi)))
    throw file.error('phi_i', `from ${phi[0]} to ${phi.at(-1)}; expected a turn, a half or a quarter of one`);
  const theta = readAxis(file, 'theta_i', Math.PI / 2);
  const slices = [phi.length, theta.length];
  const luminance = readGrid(file, 'luminance', slices, Number.NEGATIVE_INFINITY);
  const jacobian = file.uint8('jacobian');
  if (jacobian.length !== 1) throw file.error('jacobian', `${jacobian.length} values; expected 1`);
  const measurement = {
    phi,
    theta,
    ndf: readGrid(file, 'ndf', [], 0),
    sigma: readGrid(file, 'sigma', [], 0),
    vndf: readGrid(file, 'vndf', slices, 0),
    luminance,
    rgb: readColors(file, slices, luminance),
    jacobian: jacobian[0] !== 0,
    description: file.has('description') ? file.uint8('description') : new Uint8Array(),
  };
  const { size } = placesOf(measurement);
  if (size > MOST_TRIPLES)
    throw new ByteError(
      fileName,
      0,
      `${size} values in all; expected ${MOST_TRIPLES} at most, what fits on a GPU`,
    );
  checkDensities(file, measurement);
  return measurement;
}

/** Each slice must have some facets, or no warp follows from it. */
function checkDensities(file: TensorFile, { theta, vndf }: Measurement): void {
  const nodes = vndf.width * vndf.height;
  for (let slice = 0; slice * nodes < vndf.values.length; slice++) {
    if (vndf.values.subarray(slice * nodes, (slice + 1) * nodes).some((value) => value > 0)) continue;
    const which = `phi_i ${Math.floor(slice / theta.length)}, theta_i ${slice % theta.length}`;
    throw file.error('vndf', `nothing but 0 for ${which}; expected a density`);
  }
}

/** Angles that ascend, up to `largest` and a little rounding in size. */
function readAxis(file: TensorFile, name: string, largest: number): Float32Array {
  const values = file.float32(name, 1);
  if (values.length < 1 || values.length > LONGEST_AXIS)
    throw file.error(name, `${values.length} angles; expected 1 to ${LONGEST_AXIS}`);
  for (const [i, value] of values.entries()) {
    if (i > 0 && value <= (values[i - 1] as number))
      throw file.error(name, `angle ${i} is ${value} after ${values[i - 1]}; expected ascending angles`);
    if (Math.abs(value) > largest + 1e-3)
      throw file.error(name, `angle ${i} is ${value}; expected radians up to ${largest.toFixed(4)}`);
  }
  return values;
}

function readGrid(file: TensorFile, name: string, slices: readonly number[], least: number): Grid {
  const values = file.float32(name, slices.length + 2, least);
  const shape = file.shape(name);
  checkSlices(file, name, slices);
  const [height, width] = shape.slice(-2) as [number, number];
  for (const size of [width, height]) {
    if (size < 2 || size > LONGEST_AXIS)
      throw file.error(name, `${height} x ${width} values; expected 2 to ${LONGEST_AXIS} along each side`);
  }
  return { width, height, values };
}

function checkSlices(file: TensorFile, name: string, expected: readonly number[]): void {
  const shape = file.shape(name);
  if (expected.some((size, i) => shape[i] !== size))
    throw file.error(
      name,
      `${shape.join(' x ')} values; expected ${expected.join(' x ')} x ..., as many as phi_i and theta_i`,
    );
}

/** The colours of `rgb`, or of `spectra` under D65. */
function readColors(file: TensorFile, slices: readonly number[], { width, height }: Grid): Float32Array {
  const name = file.has('rgb') || !file.has('spectra') ? 'rgb' : 'spectra';
  const values = file.float32(name, 5);
  const wavelengths = name === 'spectra' ? readWavelengths(file) : null;
  const channels = wavelengths?.length ?? 3;
  const expected = [...slices, channels, height, width];
  if (file.shape(name).some((size, i) => size !== expected[i]))
    throw file.error(name, `${file.shape(name).join(' x ')} values; expected ${expected.join(' x ')}`);
  return wavelengths ? toColors(values, wavelengths, width * height) : values;
}

function readWavelengths(file: TensorFile): Float32Array {
  const nm = file.float32('wavelengths', 1, 1);
  if (nm.length < 1 || nm.length > MOST_WAVELENGTHS)
    throw file.error('wavelengths', `${nm.length} of them; expected 1 to ${MOST_WAVELENGTHS}`);
  const wrong = nm.findIndex((value, i) => i > 0 && value <= (nm[i - 1] as number));
  if (wrong > 0)
    throw file.error('wavelengths', `${nm[wrong]} after ${nm[wrong - 1]}; expected ascending nm`);
  return nm;
}

/**
 * Every interpolation of the tables is linear in their values, so that turning each value into a colour gives the
 * colour of the interpolated spectrum.
 */
function toColors(spectra: Float32Array, wavelengths: Float32Array, nodes: number): Float32Array {
  const weights = colorWeights([...wavelengths]);
  const slices = spectra.length / (weights.length * nodes);
  const rgb = new Float32Array(slices * 3 * nodes);
  const sum = new Float64Array(3 * nodes);
  for (let slice = 0; slice < slices; slice++) {
    sum.fill(0);
    for (const [k, weight] of weights.entries()) {
      const start = (slice * weights.length + k) * nodes;
      for (const c of [0, 1, 2] as const) {
        if (weight[c] === 0) continue;
        for (let i = 0; i < nodes; i++) sum[c * nodes + i]! += weight[c] * (spectra[start + i] as number);
      }
    }
    rgb.set(sum, slice * 3 * nodes);
  }
  return rgb;
}

/** Where each table begins among the triples, and how many there are. */
function placesOf({ phi, theta, ndf, sigma, vndf, luminance }: Measurement) {
  let size = HEAD + phi.length + theta.length;
  const starts = [ndf, sigma, vndf, luminance].map(({ values }) => {
    size += values.length;
    return size - values.length;
  }) as [number, number, number, number];
  return { starts, colors: size, size: size + luminance.values.length };
}

function rglTriples(file: Measurement): Float32Array {
  const { phi, theta, ndf, sigma, vndf, luminance, rgb } = file;
  const { starts, colors, size } = placesOf(file);
  const triples = new Float32Array(3 * size);
  triples.set([phi.length, theta.length, symmetry(phi)]);
  for (const [i, { width, height }] of [ndf, sigma, vndf, luminance].entries())
    triples.set([width, height, starts[i] as number], 3 * (i + 1));
  triples.set([colors, file.jacobian ? 1 : 0, 0], 3 * (HEAD - 1));
  for (const [i, angle] of [...phi, ...theta].entries()) triples[3 * (HEAD + i)] = angle;
  for (const [i, { values }] of [ndf, sigma].entries())
    for (const [k, value] of values.entries()) triples[3 * ((starts[i] as number) + k)] = value;
  const nodes = luminance.width * luminance.height;
  for (let slice = 0; slice < phi.length * theta.length; slice++) {
    putDensity(triples, starts[2], vndf, slice);
    putDensity(triples, starts[3], luminance, slice);
    const at = 3 * (colors + slice * nodes);
    for (let c = 0; c < 3; c++)
      for (let i = 0; i < nodes; i++) triples[at + 3 * i + c] = rgb[(3 * slice + c) * nodes + i] as number;
  }
  return triples;
}

/** 0: isotropic. Else how often the pattern repeats over a turn: 1, or 2 and 4 where only a part was measured. */
function symmetry(phi: Float32Array): number {
  if (phi.length <= 2) return 0;
  return Math.round((2 * Math.PI) / ((phi.at(-1) as number) - (phi[0] as number)));
}

/**
 * One slice of a table as a density with its integrals, over cells of size 1 as in the reference. Noise below 0
 * counts as 0; where there is nothing but 0 the density is even.
 */
function putDensity(
  triples: Float32Array,
  start: number,
  { width, height, values }: Grid,
  slice: number,
): void {
  const nodes = width * height;
  const table = values.subarray(slice * nodes, (slice + 1) * nodes).map((value) => Math.max(value, 0));
  if (table.every((value) => value === 0)) table.fill(1);
  const rows = Array.from({ length: height }, (_, y) =>
    runningSum(table.subarray(y * width, (y + 1) * width)),
  );
  const up = runningSum(rows.map((along) => along[width - 1] as number));
  const scale = 1 / (up[height - 1] as number);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = y * width + x;
      const triple = [table[i] as number, rows[y]?.[x] as number, up[y] as number];
      triples.set(
        triple.map((value) => value * scale),
        3 * (start + slice * nodes + i),
      );
    }
  }
}

/** The integral up to each node of what runs straight between nodes at distance 1. */
function runningSum(nodes: ArrayLike<number>): number[] {
  const sums = [0];
  for (let i = 1; i < nodes.length; i++)
    sums.push((sums[i - 1] as number) + ((nodes[i - 1] as number) + (nodes[i] as number)) / 2);
  return sums;
}
