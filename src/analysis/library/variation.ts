/**
 * Materials near a material, and between two of the same model. Steps are even to the eye: colours go through Oklab, and
 * what sets the width of a model's facets through the square root of that width, whatever the parameter itself is.
 */
import type { FloatParameter, Parameter, ParameterValue } from '../../brdf/model.ts';
import { fromOklab, oklab } from '../../color/oklab.ts';
import { createEvaluator, type Vector3 } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';
import type { Rgb } from '../plots/curve.ts';
import { createRandom } from '../random.ts';

export type Values = Readonly<Record<string, ParameterValue>>;

export interface RandomOptions {
  /** 0 nothing changes, 1 anything in the ranges. */
  readonly amount: number;
  /** The same seed gives the same material. */
  readonly seed: number;
}

/** The values of all parameters; switches stay. */
export function randomised(model: Model, values: Values, { amount, seed }: RandomOptions): Values {
  const random = createRandom(seed);
  const step = () => amount * (2 * random() - 1);
  return Object.fromEntries(
    model.parameters.map((parameter) => {
      // As many numbers for each kind, so that what one parameter gets does not depend on the others' values.
      const steps = [step(), step(), step()] as const;
      const value = values[parameter.name] ?? parameter.default;
      return [parameter.name, amount === 0 ? value : moved(model, parameter, value, steps)];
    }),
  );
}

function moved(
  model: Model,
  parameter: Parameter,
  value: ParameterValue,
  steps: readonly [number, number, number],
): ParameterValue {
  if (parameter.type === 'bool') return value;
  if (parameter.type === 'color') return movedColor(value as Rgb, steps);
  const scale = scaleOf(model, parameter);
  const place = scale.place(value as number);
  return Number(scale.value(folded(place + steps[0])).toPrecision(3));
}

/** The most that chroma has in Rec. 709 is .32, of blue. */
const CHROMA = 0.16;

/** Lightness, chroma and hue move on their own. */
function movedColor(color: Rgb, [first, second, third]: readonly [number, number, number]): Rgb {
  const [lightness, a, b] = oklab(color);
  const chroma = Math.abs(Math.hypot(a, b) + CHROMA * second);
  const hue = Math.atan2(b, a) + Math.PI * third;
  const at = folded(lightness + 0.6 * first);
  return inside([at, chroma * Math.cos(hue), chroma * Math.sin(hue)]);
}

/** A colour that a surface can have, with that hue and lightness: less of the chroma where it would leave 0..1. */
function inside([lightness, a, b]: readonly [number, number, number]): Rgb {
  const isIn = (share: number) => fromOklab([lightness, share * a, share * b]).every((c) => c >= 0 && c <= 1);
  let [low, high] = [0, 1];
  if (!isIn(1))
    for (let i = 0; i < 12; i++) {
      const middle = (low + high) / 2;
      if (isIn(middle)) low = middle;
      else high = middle;
    }
  const share = isIn(1) ? 1 : low;
  const clean = (c: number) => Number(Math.min(1, Math.max(0, c)).toFixed(4));
  return fromOklab([lightness, share * a, share * b]).map(clean) as unknown as Rgb;
}

/** Back into 0..1 at its ends, as in a mirror: what comes evenly stays even. */
function folded(x: number): number {
  const y = ((x % 2) + 2) % 2;
  return y > 1 ? 2 - y : y;
}

/** Between two sets of values of a model: a at 0, b at 1. */
export function between(model: Model, a: Values, b: Values, t: number): Values {
  return Object.fromEntries(
    model.parameters.map((parameter) => {
      const [from, to] = [a, b].map((values) => values[parameter.name] ?? parameter.default);
      return [parameter.name, t <= 0 ? from! : t >= 1 ? to! : mixed(model, parameter, from!, to!, t)];
    }),
  );
}

function mixed(
  model: Model,
  parameter: Parameter,
  from: ParameterValue,
  to: ParameterValue,
  t: number,
): ParameterValue {
  if (parameter.type === 'bool') return t < 0.5 ? from : to;
  if (parameter.type === 'color') {
    const [p, q] = [oklab(from as Rgb), oklab(to as Rgb)];
    return inside(p.map((c, i) => c + t * (q[i]! - c)) as unknown as [number, number, number]);
  }
  const scale = scaleOf(model, parameter);
  const [p, q] = [scale.place(from as number), scale.place(to as number)];
  return Number(scale.value(p + t * (q - p)).toPrecision(4));
}

/** Where on its range a number is, 0..1 in steps that look even. */
interface Scale {
  place(value: number): number;
  value(place: number): number;
}

const scales = new WeakMap<FloatParameter, Scale>();

export function scaleOf(model: Model, parameter: FloatParameter): Scale {
  const known = scales.get(parameter);
  if (known) return known;
  const { min, max } = parameter;
  const power = widthPower(model, parameter) / 2;
  const scale: Scale = {
    place: (value) => Math.min(1, Math.max(0, (value - min) / (max - min))) ** power,
    value: (place) => min + (max - min) * Math.min(1, Math.max(0, place)) ** (1 / power),
  };
  scales.set(parameter, scale);
  return scale;
}

const N: Vector3 = [0, 0, 1];

/**
 * The power of the parameter that the width of the model's facets goes with, by the model's own distribution: D(n) goes
 * with 1 over the square of the width. 2, which is even to the eye, for a parameter that has nothing to do with it.
 */
function widthPower(model: Model, { name, min, max }: FloatParameter): number {
  const [distribution] = model.file.declarations.distributions;
  if (distribution === undefined || min !== 0) return 2;
  const evaluator = createEvaluator(model);
  const [low, high] = [0.4, 0.8].map((part) => {
    evaluator.set({ [name]: part * max });
    return evaluator.f(N, N, undefined, distribution)[0];
  });
  if (!(low! > 0 && high! > 0)) return 2;
  const power = Math.log(low! / high!) / (2 * Math.log(2));
  // Whatever narrows the facets, or hardly widens them, is no roughness.
  return power > 0.5 && power < 4 ? power : 2;
}
