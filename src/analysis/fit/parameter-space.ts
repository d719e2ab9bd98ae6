/** A model's parameters as coordinates in 0..1, for an optimiser that knows nothing of models. */
import type { Parameter, ParameterValue, ParameterValues } from '../../brdf/model.ts';
import { resolveParameters } from '../../brdf/values.ts';
import type { Model } from '../../glsl/model.ts';

/** One coordinate: a number, or a channel of a colour. */
export interface Axis {
  readonly parameter: string;
  /** `roughness`, or `baseColor.r`. */
  readonly name: string;
  readonly channel: 0 | 1 | 2 | null;
  readonly min: number;
  readonly max: number;
}

/** Switches have no steps between: each combination of them is a space of its own (at most so many are tried). */
const MOST_COMBINATIONS = 64;

export class ParameterSpace {
  readonly axes: readonly Axis[];
  /** The combinations of the switches that are free; one, without any, where none is. */
  readonly switches: readonly ParameterValues[];
  /** The coordinates of each parameter: one, or a colour's three. */
  readonly groups: readonly (readonly number[])[];
  /** The parameters' defaults as a point. */
  readonly defaults: Float64Array;
  private readonly fixed: ParameterValues;

  /** @throws BrdfParameterError if a fixed value does not suit its parameter */
  constructor(model: Model, fixed: Readonly<Record<string, unknown>>) {
    const all = resolveParameters(model.file, fixed);
    this.fixed = Object.fromEntries(Object.keys(fixed).map((name) => [name, all[name] as ParameterValue]));
    const free = model.parameters.filter(({ name }) => !Object.hasOwn(fixed, name));
    this.axes = free.flatMap(axesOf);
    this.groups = free.flatMap(({ name }) => {
      const own = this.axes.flatMap(({ parameter }, i) => (parameter === name ? [i] : []));
      return own.length ? [own] : [];
    });
    this.defaults = this.point(all);
    const bools = free.filter(({ type }) => type === 'bool');
    const count = Math.min(2 ** bools.length, MOST_COMBINATIONS);
    this.switches = Array.from({ length: count }, (_, bits) =>
      Object.fromEntries(bools.map(({ name }, i) => [name, Math.floor(bits / 2 ** i) % 2 === 1])),
    );
  }

  /** The parameters' values at a point. */
  values(point: Float64Array, switches: ParameterValues): ParameterValues {
    const values: Record<string, ParameterValue> = { ...switches };
    for (const [i, { parameter, channel, min, max }] of this.axes.entries()) {
      const x = min + (max - min) * (point[i] as number);
      if (channel === null) values[parameter] = x;
      else {
        const color = [...((values[parameter] as readonly number[] | undefined) ?? [0, 0, 0])];
        color[channel] = x;
        values[parameter] = color as unknown as ParameterValue;
      }
    }
    return { ...values, ...this.fixed };
  }

  /** The point of values that lie within the ranges; others are moved to the nearest end. */
  point(values: ParameterValues): Float64Array {
    return Float64Array.from(this.axes, ({ parameter, channel, min, max }) => {
      const value = values[parameter] as number | readonly number[];
      const x = (typeof value === 'number' ? value : value[channel ?? 0]) as number;
      return Math.min(1, Math.max(0, (x - min) / (max - min)));
    });
  }

  /**
   * Points spread evenly: each coordinate takes each of `count` equal parts of its range once (M. D. McKay,
   * R. J. Beckman and W. J. Conover, 1979, "A Comparison of Three Methods...", Latin hypercube sampling).
   */
  spread(count: number, random: () => number): Float64Array[] {
    const points = Array.from({ length: count }, () => new Float64Array(this.axes.length));
    for (const axis of this.axes.keys()) {
      const order = Array.from({ length: count }, (_, i) => i);
      for (let i = count - 1; i > 0; i--) {
        const j = Math.floor(random() * (i + 1));
        [order[i], order[j]] = [order[j] as number, order[i] as number];
      }
      for (const [i, point] of points.entries()) point[axis] = ((order[i] as number) + random()) / count;
    }
    return points;
  }
}

function axesOf(parameter: Parameter): Axis[] {
  const { name, type } = parameter;
  if (type === 'bool') return [];
  if (type === 'float') {
    const { min, max } = parameter;
    return [{ parameter: name, name, channel: null, min, max }];
  }
  return ([0, 1, 2] as const).map((channel) => ({
    parameter: name,
    name: `${name}.${'rgb'[channel]}`,
    channel,
    min: 0,
    max: 1,
  }));
}
