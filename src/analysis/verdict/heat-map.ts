/** A law over a plane of the parameter space: two parameters change, the worst of all directions is found in each cell. */
import type { FloatParameter, ParameterValues } from '../../brdf/model.ts';
import { resolveParameters } from '../../brdf/values.ts';
import type { Model } from '../../glsl/model.ts';
import { type EvaluateSets, exactEvaluation, quickEvaluation } from '../fit/evaluate.ts';
import type { Pair } from '../fit/samples.ts';
import { Pace } from '../pace.ts';
import { createRandom } from '../random.ts';
import { direction, type Vec3 } from '../vector.ts';
import { randomPair } from './space.ts';

/** The laws that have a figure at every place: see docs/verdict.md. */
export const MAPPED = ['energy', 'reciprocity'] as const;
export type MappedProperty = (typeof MAPPED)[number];

export interface HeatMapOptions {
  readonly property: MappedProperty;
  /** The parameters of the axes, to the right and upwards; those that matter most if not given. */
  readonly axes?: readonly [string, string];
  /** What the other parameters are; their defaults, and white for colours, if not given. */
  readonly parameters?: Readonly<Record<string, unknown>>;
  /** Cells along each side; 24 if not given. */
  readonly size?: number;
  readonly signal?: AbortSignal;
  readonly onProgress?: (done: number) => void;
}

export interface HeatMapCell {
  readonly value: number;
  /** The directions of the worst case; energy is of all l. */
  readonly l: Vec3 | null;
  readonly v: Vec3;
}

export interface HeatMap {
  readonly model: string;
  readonly property: MappedProperty;
  readonly x: FloatParameter;
  readonly y: FloatParameter;
  readonly size: number;
  /** Row by row, from the least y; in each from the least x. */
  readonly cells: readonly HeatMapCell[];
  /** What the other parameters are. */
  readonly base: ParameterValues;
}

/** The parameters at a cell. */
export function cellParameters(
  { base, x, y, size }: Pick<HeatMap, 'base' | 'x' | 'y' | 'size'>,
  column: number,
  row: number,
): ParameterValues {
  const at = ({ min, max }: FloatParameter, i: number) => min + ((max - min) * i) / (size - 1);
  return { ...base, [x.name]: at(x, column), [y.name]: at(y, row) };
}

/** Which cell has the largest value. */
export function worstCell({ cells, size }: HeatMap): { column: number; row: number; cell: HeatMapCell } {
  const i = cells.reduce((best, { value }, k) => (value > (cells[best] as HeatMapCell).value ? k : best), 0);
  return { column: i % size, row: Math.floor(i / size), cell: cells[i] as HeatMapCell };
}

type Judge = (set: ParameterValues) => Promise<HeatMapCell>;

/** @throws RangeError for axes that the model does not have; whatever the signal aborts with */
export async function heatMap(model: Model, options: HeatMapOptions): Promise<HeatMap> {
  const { property, size = 24 } = options;
  const pace = new Pace(options.signal);
  const white = model.parameters.filter(({ type }) => type === 'color').map(({ name }) => [name, [1, 1, 1]]);
  const base = resolveParameters(model.file, { ...Object.fromEntries(white), ...options.parameters });
  const judge =
    property === 'energy'
      ? energyJudge(quickEvaluation(model, pace))
      : reciprocityJudge(exactEvaluation(model, pace));
  const [x, y] = options.axes
    ? options.axes.map((name) => axisNamed(model, name))
    : await mainAxes(model, base, judge);
  if (!x || !y || x === y) throw new RangeError(`${model.name} has no two numbers to draw a map over`);
  const plane = { base, x, y, size };
  const cells: HeatMapCell[] = [];
  for (let i = 0; i < size * size; i++) {
    await pace.rest(() => options.onProgress?.(i / (size * size)));
    cells.push(await judge(cellParameters(plane, i % size, Math.floor(i / size))));
  }
  options.onProgress?.(1);
  return { model: model.name, property, ...plane, cells };
}

function axisNamed(model: Model, name: string): FloatParameter {
  const found = model.parameters.find((parameter) => parameter.name === name);
  if (found?.type === 'float') return found;
  const names = model.parameters.filter(({ type }) => type === 'float').map((parameter) => parameter.name);
  throw new RangeError(`${model.name} has no number '${name}'; it has ${names.join(', ') || 'none'}`);
}

/** The two numbers that change the figure most, each alone, in the order of the file. */
async function mainAxes(model: Model, base: ParameterValues, judge: Judge): Promise<FloatParameter[]> {
  const spreads: { parameter: FloatParameter; spread: number }[] = [];
  for (const parameter of model.parameters) {
    if (parameter.type !== 'float') continue;
    const values: number[] = [];
    for (const share of [0, 0.25, 0.5, 0.75, 1]) {
      const value = parameter.min + share * (parameter.max - parameter.min);
      values.push((await judge({ ...base, [parameter.name]: value })).value);
    }
    spreads.push({ parameter, spread: Math.max(...values) - Math.min(...values) });
  }
  const chosen = [...spreads].sort((a, b) => b.spread - a.spread).slice(0, 2);
  return spreads.filter((one) => chosen.includes(one)).map(({ parameter }) => parameter);
}

/** Views from above to 0.6 degrees above the horizon. */
const COSINES = [1, 0.5, 0.15, 0.03, 0.01];
const RINGS = 25;
const SPOKES = 32;

/** The largest directional albedo of all channels and views, within a few thousandths. */
function energyJudge(evaluate: EvaluateSets): Judge {
  const views = COSINES.map((cosine) => {
    const v = direction(cosine, 0.4);
    return { v, ...albedoRule(v) };
  });
  const pairs = views.flatMap((view) => view.pairs);
  return async (set) => {
    const [values] = (await evaluate([set], pairs)) as [Float64Array];
    let worst: HeatMapCell = { value: 0, l: null, v: [0, 0, 1] };
    let at = 0;
    for (const { v, weights } of views) {
      const albedo = [0, 0, 0];
      for (const weight of weights) {
        for (let c = 0; c < 3; c++) albedo[c]! += weight * (values[at + c] as number);
        at += 3;
      }
      const value = Math.max(...albedo);
      if (value > worst.value) worst = { value, l: null, v };
    }
    return worst;
  };
}

/** The innermost ring: a twentieth of the narrowest lobes' width, which models keep above a thousandth. */
const INNERMOST = 5e-5;
/** Up to here rings are evenly spread over the logarithm of theta_h, so that lobes of any width meet as many. */
const MIDDLE = 0.1;

/** Angles from the normal, and the shares of a full turn's solid angle about them. */
function rings(): { theta: number; share: number }[] {
  const span = Math.log(MIDDLE / INNERMOST);
  const inner = Array.from({ length: RINGS }, (_, i) => {
    const theta = INNERMOST * Math.exp((span * (i + 0.5)) / RINGS);
    return { theta, share: (Math.sin(theta) * theta * span) / RINGS };
  });
  const width = (Math.PI / 2 - MIDDLE) / RINGS;
  const outer = Array.from({ length: RINGS }, (_, i) => {
    const theta = MIDDLE + width * (i + 0.5);
    return { theta, share: Math.sin(theta) * width };
  });
  return [...inner, ...outer];
}

/** Directions l and weights of a quadrature of the hemisphere for one view: half vectors in rings about the normal. */
function albedoRule(v: Vec3): { pairs: Pair[]; weights: number[] } {
  const pairs: Pair[] = [];
  const weights: number[] = [];
  for (const [ring, { theta, share }] of rings().entries()) {
    const solidAngle = (share * 2 * Math.PI) / SPOKES;
    for (let spoke = 0; spoke < SPOKES; spoke++) {
      const h = direction(Math.cos(theta), (2 * Math.PI * (spoke + (ring % 2) / 2)) / SPOKES);
      const vh = v[0] * h[0] + v[1] * h[1] + v[2] * h[2];
      const l: Vec3 = [2 * vh * h[0] - v[0], 2 * vh * h[1] - v[1], 2 * vh * h[2] - v[2]];
      if (vh <= 0 || l[2] <= 0) continue;
      pairs.push({ l, v });
      weights.push(4 * vh * solidAngle);
    }
  }
  return { pairs, weights };
}

const PAIRS = 48;

/** The largest relative difference of f(l, v) and f(v, l). */
function reciprocityJudge(evaluate: EvaluateSets): Judge {
  const random = createRandom(1);
  const forth = Array.from({ length: PAIRS }, () => randomPair(random));
  const both = [...forth, ...forth.map(({ l, v }) => ({ l: v, v: l }))];
  return async (set) => {
    const [values] = (await evaluate([set], both)) as [Float64Array];
    let worst: HeatMapCell = { value: 0, ...(forth[0] as Pair) };
    for (const [i, { l, v }] of forth.entries()) {
      for (let c = 0; c < 3; c++) {
        const a = (values[3 * i + c] as number) / l[2];
        const b = (values[3 * (PAIRS + i) + c] as number) / v[2];
        const value = Math.abs(a - b) / Math.max(1e-9, a, b);
        if (value > worst.value) worst = { value, l, v };
      }
    }
    return worst;
  };
}
