/** What a material keeps of its look when it gets another model. It knows no model, only names and types of parameters. */
import type { Parameter, ParameterValue } from '../brdf/model.ts';
import { createEvaluator, LOCAL_FRAME } from '../glsl/evaluator.ts';
import type { Model } from '../glsl/model.ts';
import type { Material } from './schema.ts';
import { iorOf, specularOf } from './specular.ts';

/** Names by which models call the colour of the body, which is that of a metal's reflection. */
export const COLOR_NAMES: readonly string[] = ['baseColor', 'albedo'];

/**
 * The values and textures of a material under another model: those whose names and types both models have; the colour of
 * the body and the strength of the gloss, under the other's names; and the highlight as wide as it was.
 *
 * @param from undefined where the scene has the model no more: nothing is known about the values then
 */
export function carriedLook(
  from: Model | undefined,
  to: Model | undefined,
  { parameters, textures }: Pick<Material, 'parameters' | 'textures'>,
): Pick<Material, 'parameters' | 'textures'> {
  if (!from || !to) return { parameters: {}, textures: {} };
  const carried: Record<string, ParameterValue> = {};
  for (const [name, value] of Object.entries(parameters)) {
    const target = counterpart(from, to, name);
    if (target) carried[target.name] = converted(from, name, value, to, target);
  }
  const maps = Object.entries(textures).flatMap(([name, map]) => {
    const target = counterpart(from, to, name);
    // A texture multiplies its parameter, which only a colour or the same number can take from another.
    return target && (target.name === name || target.type === 'color') ? [[target.name, map] as const] : [];
  });
  return { parameters: carried as Material['parameters'], textures: Object.fromEntries(maps) };
}

const named = ({ parameters }: Model, name: string) => parameters.find((each) => each.name === name);

function counterpart(from: Model, to: Model, name: string): Parameter | undefined {
  const type = named(from, name)?.type;
  const names = COLOR_NAMES.includes(name) ? [name, ...COLOR_NAMES] : [name, GLOSSES[name] ?? name];
  return names.map((each) => named(to, each)).find((each) => each !== undefined && each.type === type);
}

const GLOSSES: Readonly<Record<string, string>> = { specular: 'ior', ior: 'specular' };

function converted(from: Model, name: string, value: ParameterValue, to: Model, target: Parameter) {
  if (target.type !== 'float' || typeof value !== 'number') return value;
  const inRange = (x: number) => Number(Math.min(target.max, Math.max(target.min, x)).toPrecision(4));
  if (name !== target.name) return inRange(name === 'ior' ? specularOf(value) : iorOf(value));
  return asWide(from, to, value, target, inRange);
}

/** The same number, or for what sets the width of the facets that which makes them as wide. */
function asWide(
  from: Model,
  to: Model,
  value: number,
  target: Parameter & { type: 'float' },
  inRange: (x: number) => number,
): number {
  const [before, after] = [tallness(from, target.name), tallness(to, target.name)];
  if (!before || !after || target.min !== 0) return value;
  const wanted = before(value);
  const isAs = (x: number) => Math.abs(x / wanted - 1) < 1e-6;
  const [narrowest, widest] = [after(0), after(target.max)];
  // What hardly widens the facets is no roughness.
  if (isAs(after(value)) || !(narrowest > 4 * widest)) return value;
  let [low, high] = [0, target.max];
  for (let i = 0; i < 40; i++) {
    const middle = (low + high) / 2;
    if (after(middle) > wanted) low = middle;
    else high = middle;
  }
  return inRange(high);
}

/** How many facets lie flat, over a parameter: 1/(pi width^2). Undefined of models that have no distribution. */
function tallness(model: Model, name: string): ((value: number) => number) | undefined {
  const [distribution] = model.file.declarations.distributions;
  if (distribution === undefined || !named(model, name)) return undefined;
  const evaluator = createEvaluator(model);
  return (value) => {
    evaluator.set({ [name]: value });
    const { N } = LOCAL_FRAME;
    return evaluator.f(N, N, undefined, distribution)[0];
  };
}
