import type { Parameter, ParameterValue, ParameterValues } from '../../brdf/model.ts';
import type { Vec3 } from '../vector.ts';
import { type Context, percent, placeOf, worstOf } from './context.ts';
import { randomPair, randomParameters } from './space.ts';
import type { Check, Point } from './types.ts';

/**
 * Does the model jump? Along random paths through directions and parameters the spots of greatest change are
 * halved again and again: a change that is still there when the piece is 2^-40 of the path has no slope.
 */

const PIECES = 48;
const HALVINGS = 40;
/**
 * The steepest lobe that ships, facets of slope .001, changes by 1e3 of itself per radian: by 1e-9 over what
 * is left of the path after the halvings. A jump of a thousandth, below which no eye sees an edge, is a
 * million times that.
 */
const JUMP = 1e-3;
/** A jump between values that are this small is none that can be seen. */
const FLOOR = 1e-6;

type Path = (t: number) => Point;

export async function checkContinuity(context: Context): Promise<Check> {
  const { terms } = context.model;
  let worst: { term: string; point: Point; value: number } | null = null;
  const rank = (term: string) => (context.waived(term) ? 0 : 1);
  const paths = makePaths(context);
  for (const [i, path] of paths.entries()) {
    await context.pulse(i / paths.length);
    for (const term of terms) {
      const found = largestJump(context, path, term);
      const graver =
        !worst ||
        rank(term) > rank(worst.term) ||
        (rank(term) === rank(worst.term) && found.value > worst.value);
      if (found.value > JUMP && graver) worst = { term, ...found };
    }
  }
  if (!worst) {
    return context.check(
      'pass',
      0,
      'no jump',
      `Over ${paths.length} paths through directions and parameters nothing jumps: no hard edges in the picture, ` +
        'and sliders act smoothly.',
      null,
    );
  }
  const { term, point, value } = worst as { term: string; point: Point; value: number };
  return context.check(
    context.outcome(true, term),
    value,
    `jumps by ${percent(value)}`,
    `${term} jumps by ${percent(value)} at one spot, ${placeOf(point)}: the picture has a hard edge there, or a ` +
      'slider a step.',
    worstOf(point, term),
  );
}

function makePaths(context: Context): Path[] {
  const { model, random } = context;
  const { parameters } = model;
  const paths: Path[] = [];
  for (let i = context.trials(60); i > 0; i--) {
    const [from, to] = [randomPair(random), randomPair(random)];
    const first = randomParameters(random, parameters);
    // Half of the paths move directions only: these are the edges that a picture shows.
    const last = i % 2 ? keepSwitches(parameters, first, randomParameters(random, parameters)) : first;
    paths.push((t) => ({
      parameters: first === last ? first : mixed(first, last, t),
      l: between(from.l, to.l, t),
      v: between(from.v, to.v, t),
    }));
  }
  for (const parameter of parameters) {
    if (parameter.type !== 'float') continue;
    for (let i = context.trials(2); i > 0; i--) {
      const pair = randomPair(random);
      const set = randomParameters(random, parameters);
      const { name, min, max } = parameter;
      paths.push((t) => ({ ...pair, parameters: { ...set, [name]: min + (max - min) * t } }));
    }
  }
  return paths;
}

function largestJump(context: Context, path: Path, term: string): { point: Point; value: number } {
  const at = (t: number) => context.f(path(t), term);
  const change = (a: readonly number[], b: readonly number[]) => {
    let largest = 0;
    let scale = FLOOR;
    for (let c = 0; c < 3; c++) {
      largest = Math.max(largest, Math.abs((a[c] as number) - (b[c] as number)));
      scale = Math.max(scale, Math.abs(a[c] as number), Math.abs(b[c] as number));
    }
    return Number.isFinite(largest / scale) ? largest / scale : 0;
  };
  const values = Array.from({ length: PIECES + 1 }, (_, i) => at(i / PIECES));
  const changes = values.slice(1).map((value, i) => change(values[i] as readonly number[], value));
  // A jump stands out of the changes beside it, large or small.
  const excess = changes.map((x, i) => x - 0.5 * ((changes[i - 1] ?? x) + (changes[i + 1] ?? x)));
  const spots = new Set([argmax(changes), argmax(excess)]);
  let best = { point: path(0), value: 0 };
  for (const spot of spots) {
    let [low, high] = [spot / PIECES, (spot + 1) / PIECES];
    let [below, above] = [values[spot] as readonly number[], values[spot + 1] as readonly number[]];
    for (let i = 0; i < HALVINGS && change(below, above) > JUMP; i++) {
      const middle = (low + high) / 2;
      const value = at(middle);
      if (change(below, value) > change(value, above)) [high, above] = [middle, value];
      else [low, below] = [middle, value];
    }
    const value = change(below, above);
    if (value > best.value) best = { point: path(low), value };
  }
  return best.value > JUMP ? best : { ...best, value: 0 };
}

function argmax(values: readonly number[]): number {
  return values.reduce((best, value, i) => (value > (values[best] as number) ? i : best), 0);
}

/** A switch is meant to jump. */
function keepSwitches(
  parameters: readonly Parameter[],
  first: ParameterValues,
  last: ParameterValues,
): ParameterValues {
  const switches = parameters
    .filter(({ type }) => type === 'bool')
    .map(({ name }) => [name, first[name]] as const);
  return { ...last, ...(Object.fromEntries(switches) as ParameterValues) };
}

function mixed(first: ParameterValues, last: ParameterValues, t: number): ParameterValues {
  const result: Record<string, ParameterValue> = {};
  for (const [name, a] of Object.entries(first)) {
    const b = last[name] as ParameterValue;
    if (typeof a === 'number' && typeof b === 'number') result[name] = a + (b - a) * t;
    else if (typeof a === 'object' && typeof b === 'object') result[name] = mix3(a, b, t);
    else result[name] = a;
  }
  return result;
}

function mix3(a: Vec3, b: Vec3, t: number): Vec3 {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
}

/** Both are above the surface, so the straight line between them, pushed out to the sphere, is too. */
function between(a: Vec3, b: Vec3, t: number): Vec3 {
  const [x, y, z] = mix3(a, b, t);
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
}
