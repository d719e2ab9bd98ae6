import type { ParameterValue, ParameterValues, Rgb } from '../../brdf/model.ts';
import type { Vec3 } from '../vector.ts';
import { type Context, percent, placeOf, short, worstOf } from './context.ts';
import { cornerParameters, randomPair, randomPoint } from './space.ts';
import type { Check, GpuEvaluation, Point } from './types.ts';

/** Does the GPU, in 32 bit floats, compute what float64 does? */

/** Where a value is smaller than this, its error is relative to this. */
const FLOOR = 1e-4;
/**
 * A float32 carries 6e-8; a lobe of slope .001 multiplies that by its steepness, to some 1e-4, and exponentials
 * far out by more. From one percent on an eye sees it.
 */
const LIMIT = 1e-2;

/** There is no GPU to ask, or it gave no answer; the message is a sentence. */
export class GpuFailure extends Error {
  override name = 'GpuFailure';
}

export async function checkGpu(context: Context, gpu: GpuEvaluation | undefined): Promise<Check> {
  if (!gpu)
    return context.notApplicable(
      'No GPU was asked; the lab asks its own, and the command does with --backend gpu.',
    );
  const { model, random } = context;
  const points = Array.from({ length: context.trials(800) }, () =>
    rounded(randomPoint(random, model.parameters)),
  );
  for (const parameters of cornerParameters(model.parameters))
    for (let i = 0; i < 4; i++) points.push(rounded({ parameters, ...randomPair(random) }));

  let worst = { error: -1, term: 'BRDF', point: points[0] as Point };
  for (const [i, term] of model.terms.entries()) {
    await context.pulse(i / model.terms.length);
    const values = await gpu(term, points).catch((error: unknown) => {
      if (error instanceof GpuFailure) return error;
      throw error;
    });
    if (values instanceof GpuFailure) return context.notApplicable(values.message);
    for (const [k, point] of points.entries()) {
      const error = difference(values[k] as Rgb, context.f(point, term));
      if (error > worst.error) worst = { error, term, point };
    }
  }
  const { error, term, point } = worst;
  const broken = error > LIMIT;
  return context.check(
    broken ? 'fail' : 'pass',
    error,
    `differs by ${broken ? percent(error) : short(error)}`,
    broken
      ? `On the GPU ${term} is off by ${percent(error)} ${placeOf(point)}: 32 bits are too few for its formula there.`
      : 'The GPU, with half the digits, computes the same values: what you see is what was checked.',
    worstOf(point, term),
  );
}

function difference(gpu: Rgb, cpu: Rgb): number {
  const scale = Math.max(FLOOR, ...cpu.map(Math.abs));
  const error = Math.max(...gpu.map((value, c) => Math.abs(value - (cpu[c] as number)))) / scale;
  // Where float64 itself gives no number, the check of finiteness says so.
  return cpu.every(Number.isFinite) ? (Number.isNaN(error) ? Number.POSITIVE_INFINITY : error) : 0;
}

/** The point as a GPU is given it, so that only its arithmetic is judged. */
function rounded({ parameters, l, v }: Point): Point {
  const round3 = ([x, y, z]: Vec3): Vec3 => [Math.fround(x), Math.fround(y), Math.fround(z)];
  const round = (value: ParameterValue): ParameterValue => {
    if (typeof value === 'boolean') return value;
    return typeof value === 'number' ? Math.fround(value) : round3(value);
  };
  const entries = Object.entries(parameters).map(([name, value]) => [name, round(value)] as const);
  return { parameters: Object.fromEntries(entries) as ParameterValues, l: round3(l), v: round3(v) };
}
