/**
 * What the generic sampler knows of a material whose model brings no sampler: a table of the material's own reflection,
 * laid out as docs/decisions/path-tracer.md says and read by kernel/generic-sampler.glsl.
 */
import type { ParameterValues } from '../../brdf/model.ts';
import { createEvaluator } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';
import { emitWasm } from '../../glsl/wasm/emit.ts';
import { instantiateWasm, type WasmExports } from '../../glsl/wasm/instantiate.ts';
import { turnsWithTangent } from '../../material/tangent-dependence.ts';
import { genericTableKernel } from '../kernel.ts';
import { GENERIC_TABLE, HEADER, WORDS_PER_SLOT } from './layout.ts';
import type { Pace } from './pace.ts';

const { rows: ROWS, columns: COLUMNS, views: VIEWS, azimuths: AZIMUTHS, points: POINTS } = GENERIC_TABLE;
const CELLS = ROWS * COLUMNS;
const MARGINAL = WORDS_PER_SLOT * Math.ceil((ROWS + 1) / WORDS_PER_SLOT);
const LOBE = MARGINAL + ROWS * (COLUMNS + 1);

/** Views nearer to the horizon are taken as this one: there models may be 0. */
const LEAST_COSINE = 1e-3;

/**
 * The part of the hemisphere, by its cosine, where a cosine lobe may draw more than the model reflects: what it does not
 * reach is left to the table.
 */
const BELOW_COSINE_LOBE = 0.05;
/** Steps of finding it. */
const BISECTIONS = 20;
/** What is less of a material's reflection is rounding, and no reason for a table. */
const LEAST_SHARE = 1e-5;
/**
 * The share of a cosine lobe that is kept everywhere, for what falls between the table's points; and where textures
 * make the material another one than the table's.
 */
const KEPT_SHARE = 0.001;
const KEPT_SHARE_OF_TEXTURED = 0.1;

/** A material as its table sees it. */
export interface TabulatedMaterial {
  readonly model: Model;
  /** GENERIC_TABLE.points of them: the material at some of its places, all the same without textures. */
  readonly places: readonly ParameterValues[];
  readonly isTextured: boolean;
}

/** The tables of a scene's materials, each made once for as long as a material like it is in use. */
export class GenericTables {
  #tables = new Map<string, Uint32Array<ArrayBuffer>>();
  readonly #numbers = new WeakMap<Model, number>();
  #models = 0;

  /** For each material its table, or null where the model brings a sampler. */
  async get(
    materials: readonly TabulatedMaterial[],
    pace: Pace,
  ): Promise<(Uint32Array<ArrayBuffer> | null)[]> {
    const used = new Map<string, Uint32Array<ArrayBuffer>>();
    const tables = [];
    for (const material of materials) {
      if (material.model.hasSampling) {
        tables.push(null);
        continue;
      }
      const key = this.#keyOf(material);
      const table = used.get(key) ?? this.#tables.get(key) ?? (await tabulate(material, pace));
      used.set(key, table);
      tables.push(table);
    }
    this.#tables = used;
    return tables;
  }

  #keyOf({ model, places, isTextured }: TabulatedMaterial): string {
    const number = this.#numbers.get(model) ?? this.#models++;
    this.#numbers.set(model, number);
    const values = places.map((place) => model.parameters.map(({ name }) => place[name]));
    return JSON.stringify([number, isTextured, values]);
  }
}

/** A model's kernel in WebAssembly, for one table after the other. */
interface Tabulator {
  readonly exports: WasmExports;
  readonly film: Float32Array;
  readonly scene: Float32Array;
}

const tabulators = new WeakMap<Model, Promise<Tabulator>>();

const STACK = 1 << 16;
const FILM_BYTES = 16 * CELLS;
const PAGE = 65536;
/** In the tabulator's memory: a header of which only the models' data are there, then parameters, then data. */
const MODEL_SLOT = HEADER.models + 1;
const PARAMETER_SLOT = MODEL_SLOT + 1;

async function tabulatorOf(model: Model): Promise<Tabulator> {
  const kernel = genericTableKernel(model);
  const bytes = emitWasm([kernel.entry('tabulateView')], { shared: false });
  const module = await WebAssembly.compile(bytes);
  const dataWord = WORDS_PER_SLOT * (PARAMETER_SLOT + POINTS * model.parameters.length);
  const scene = STACK + FILM_BYTES;
  const size = scene + 4 * (dataWord + (model.data?.length ?? 0));
  const memory = new WebAssembly.Memory({ initial: Math.ceil(size / PAGE), maximum: PAGE });
  const words = new Uint32Array(memory.buffer, scene);
  words[WORDS_PER_SLOT * HEADER.models] = MODEL_SLOT;
  words.set([dataWord, (model.data?.length ?? 0) / 3], WORDS_PER_SLOT * MODEL_SLOT);
  const floats = new Float32Array(memory.buffer, scene);
  if (model.data) floats.set(model.data, dataWord);
  const { exports } = instantiateWasm(module, { memory, scene, film: STACK, stack: STACK });
  return { exports, film: new Float32Array(memory.buffer, STACK, 4 * CELLS), scene: floats };
}

export async function tabulate(
  { model, places, isTextured }: TabulatedMaterial,
  pace: Pace,
): Promise<Uint32Array<ArrayBuffer>> {
  const tabulator = tabulators.get(model) ?? tabulatorOf(model);
  tabulators.set(model, tabulator);
  const { exports, film, scene } = await tabulator;

  const { transmission } = model.file;
  const [place = {}] = places;
  const isThin = transmission?.thin ? place[transmission.thin] === true : false;
  const ior = transmission ? Math.max(Number(place[transmission.ior]), 1e-3) : 1;
  // Of a body both sides are seen.
  const iors = transmission && !isThin ? [Math.max(ior, 1 / ior), Math.min(ior, 1 / ior)] : [ior];
  const isRound = !places.some((values) => turnsWithTangent(createEvaluator(model, values), 'BRDF'));
  const azimuths = isRound ? 1 : AZIMUTHS;
  const lobes = transmission ? 2 : 1;

  const nodeWords = WORDS_PER_SLOT + lobes * LOBE;
  const table = new Uint32Array(WORDS_PER_SLOT + iors.length * azimuths * VIEWS * nodeWords);
  table.set([azimuths, lobes, iors.length]);
  const floats = new Float32Array(table.buffer);
  for (let i = 0; i < iors.length * azimuths * VIEWS; i++) {
    if (pace.due) await pace.rest();
    // Another table may have been made in the meantime.
    for (const [k, values] of places.entries()) writeParameters(scene, model, values, k);
    const view = i % VIEWS;
    const azimuth = Math.floor(i / VIEWS) % azimuths;
    const phi = isRound ? 0 : (Math.PI / 2) * (azimuth / (AZIMUTHS - 1));
    const cosine = Math.max((view / (VIEWS - 1)) ** 2, LEAST_COSINE);
    const sine = Math.sqrt(1 - cosine * cosine);
    exports.tabulateView?.(
      PARAMETER_SLOT,
      model.parameters.length,
      sine * Math.cos(phi),
      sine * Math.sin(phi),
      cosine,
      iors[Math.floor(i / (VIEWS * azimuths))] ?? ior,
      Number(isRound),
      Number(transmission !== null),
      Number(isThin),
    );
    const keptShare = isTextured ? KEPT_SHARE_OF_TEXTURED : KEPT_SHARE;
    writeNode(floats, WORDS_PER_SLOT + i * nodeWords, film, lobes, keptShare);
  }
  return table;
}

function writeParameters(scene: Float32Array, model: Model, values: ParameterValues, place: number): void {
  const first = PARAMETER_SLOT + place * model.parameters.length;
  for (const [i, { name }] of model.parameters.entries()) {
    const value = values[name] ?? 0;
    scene.set(typeof value === 'object' ? value : [Number(value)], WORDS_PER_SLOT * (first + i));
  }
}

/** One view: weights of the lobes, then the distributions of the facets' normals. */
function writeNode(
  floats: Float32Array,
  node: number,
  film: Float32Array,
  lobes: number,
  keptShare: number,
): void {
  // Cosine above, facets above, cosine below, facets below.
  const weights = [0, 0, 0, 0];
  for (let lobe = 0; lobe < lobes; lobe++) {
    const floor = cosineLobe(film, 2 * lobe);
    const cells = new Float64Array(CELLS);
    for (let i = 0; i < CELLS; i++)
      cells[i] = Math.max(0, film[4 * i + 2 * lobe]! - floor * film[4 * i + 2 * lobe + 1]!);
    // The cosine's integral over the hemisphere is pi.
    weights[2 * lobe] = Math.PI * floor;
    weights[2 * lobe + 1] = writeDistribution(floats, node + WORDS_PER_SLOT + lobe * LOBE, cells);
  }
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  for (let lobe = 0; lobe < lobes; lobe++) {
    const hasTable = weights[2 * lobe + 1]! > LEAST_SHARE * total;
    if (!hasTable) weights[2 * lobe + 1] = 0;
    if (hasTable || keptShare === KEPT_SHARE_OF_TEXTURED)
      weights[2 * lobe] = Math.max(weights[2 * lobe]!, keptShare * total);
  }
  // A black surface: any direction will do.
  if (total === 0) weights[0] = 1;
  const all = weights.reduce((sum, weight) => sum + weight, 0);
  floats.set(
    weights.map((weight) => weight / all),
    node,
  );
}

/**
 * The f of the cosine lobe: what the model reflects nearly everywhere, by bisection.
 *
 * @param at 0 above, 2 below
 */
function cosineLobe(film: Float32Array, at: number): number {
  let light = 0;
  let cosines = 0;
  for (let i = at; i < film.length; i += 4) {
    light += film[i]!;
    cosines += film[i + 1]!;
  }
  if (light === 0) return 0;
  let low = 0;
  // No more than the mean over the part that reflects more.
  let high = light / cosines / (1 - BELOW_COSINE_LOBE);
  for (let step = 0; step < BISECTIONS; step++) {
    const middle = (low + high) / 2;
    let below = 0;
    for (let i = at; i < film.length; i += 4) if (film[i]! < middle * film[i + 1]!) below += film[i + 1]!;
    if (below <= BELOW_COSINE_LOBE * cosines) low = middle;
    else high = middle;
  }
  return low;
}

/** Rows' cumulative shares, then those of the cells in each row. @returns the cells' sum */
function writeDistribution(floats: Float32Array, at: number, cells: Float64Array): number {
  const sums = new Float64Array(ROWS);
  for (let row = 0; row < ROWS; row++) {
    const inRow = cells.subarray(row * COLUMNS, (row + 1) * COLUMNS);
    sums[row] = writeCumulative(floats, at + MARGINAL + row * (COLUMNS + 1), inRow);
  }
  return writeCumulative(floats, at, sums);
}

/** From 0 to 1; all 0 but the end where there is nothing. @returns the sum */
function writeCumulative(floats: Float32Array, at: number, shares: Float64Array): number {
  let total = 0;
  for (const share of shares) total += share;
  let sum = 0;
  for (const [i, share] of shares.entries()) {
    sum += share;
    floats[at + i + 1] = i === shares.length - 1 ? 1 : total > 0 ? sum / total : 0;
  }
  return total;
}
