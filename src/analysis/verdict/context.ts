import type { ParameterValues } from '../../brdf/model.ts';
import { createEvaluator, type Evaluator } from '../../glsl/evaluator.ts';
import type { Model } from '../../glsl/model.ts';
import { Pace } from '../pace.ts';
import type { Reflectance } from '../plots/curve.ts';
import { createQuickEvaluator, type QuickEvaluator } from '../quick-evaluator.ts';
import { createRandom } from '../random.ts';
import type { Vec3 } from '../vector.ts';
import { neighbour } from './space.ts';
import type { Check, Outcome, Point, Property, VerdictOptions, WorstCase } from './types.ts';

/** What a check works with: the model in float64, and in float32 to search with, a stream of random numbers, and a way to be interrupted. */
export class Context {
  readonly model: Model;
  readonly evaluator: Evaluator;
  readonly property: Property;
  readonly random: () => number;
  private readonly options: VerdictOptions;
  private readonly progress: (done: number) => void;
  private readonly pace: Pace;
  private readonly quickEvaluator: QuickEvaluator;
  private current: ParameterValues | null = null;
  private quickCurrent: ParameterValues | null = null;

  constructor(model: Model, property: Property, options: VerdictOptions, progress: (done: number) => void) {
    this.model = model;
    this.property = property;
    this.options = options;
    this.progress = progress;
    this.pace = new Pace(options.signal);
    this.evaluator = createEvaluator(model);
    this.quickEvaluator = createQuickEvaluator(model);
    // A stream of its own for each law: what one check draws must not change what another finds.
    const salt = [...property].reduce((sum, letter) => (sum * 31 + letter.charCodeAt(0)) >>> 0, 7);
    this.random = createRandom((options.seed ?? 1) * 0x1_0000 + (salt & 0xffff));
  }

  /** A number of trials, scaled by the effort asked for. */
  trials(count: number): number {
    return Math.max(1, Math.round(count * (this.options.effort ?? 1)));
  }

  /** To call between pieces of work: reports, lets others run every 50 ms, throws where aborted. */
  async pulse(done: number): Promise<void> {
    await this.pace.rest(() => this.progress(Math.min(1, done)));
  }

  /** A term at a point. */
  f(point: Point, term = 'BRDF') {
    this.use(point.parameters);
    return this.evaluator.f(point.l, point.v, undefined, term);
  }

  use(parameters: ParameterValues): void {
    if (this.current === parameters) return;
    this.evaluator.set(parameters);
    this.current = parameters;
  }

  /** A term in float32: to find what is worth a look, never to state a figure. */
  quick(parameters: ParameterValues, term = 'BRDF'): Reflectance {
    return this.quickAt(parameters).term(term);
  }

  /** The density of the model's sampler, likewise. */
  quickPdf(parameters: ParameterValues): (l: Vec3, v: Vec3) => number {
    return this.quickAt(parameters).pdf();
  }

  private quickAt(parameters: ParameterValues): QuickEvaluator {
    if (this.quickCurrent !== parameters) this.quickEvaluator.set(parameters);
    this.quickCurrent = parameters;
    return this.quickEvaluator;
  }

  /** Climbs from a point to a nearby one where the objective is larger. */
  climb(start: Point, objective: (point: Point) => number, steps: number): Found {
    let best: Found = { point: start, value: objective(start) };
    let reach = 0.3;
    for (let i = 0; i < steps; i++) {
      const point = neighbour(this.random, this.model.parameters, best.point, reach);
      const value = objective(point);
      if (value > best.value) {
        best = { point, value };
        reach = Math.min(0.5, reach * 1.5);
      } else reach = Math.max(1e-4, reach * 0.93);
    }
    return best;
  }

  /**
   * The point at which an objective is largest, as far as a search finds it: all the given points, then a
   * climb from the best few of them.
   */
  async maximise(points: readonly Point[], objective: (point: Point) => number): Promise<Found> {
    const found: Found[] = [];
    for (const [i, point] of points.entries()) {
      if (i % 64 === 0) await this.pulse(i / points.length);
      found.push({ point, value: objective(point) });
    }
    found.sort((a, b) => b.value - a.value);
    let best = found[0] as Found;
    for (const { point } of found.slice(0, 3)) {
      await this.pulse(1);
      const top = this.climb(point, objective, this.trials(150));
      if (top.value > best.value) best = top;
    }
    return best;
  }

  /** Whether the header gives this law up, for the whole model or for one term. */
  waived(term: string): boolean {
    return this.model.file.declarations.givesUp.some(
      (waiver) => waiver.property === this.property && (waiver.term === null || waiver.term === term),
    );
  }

  notApplicable(sentence: string): Check {
    const { property } = this;
    return { property, outcome: 'not applicable', figure: null, figureText: '', sentence, worst: null };
  }

  check(
    outcome: Outcome,
    figure: number,
    figureText: string,
    sentence: string,
    worst: WorstCase | null,
  ): Check {
    const finite = Number.isFinite(figure) ? figure : null;
    return { property: this.property, outcome, figure: finite, figureText, sentence, worst };
  }

  /** The outcome for one broken or kept law. */
  outcome(broken: boolean, term = 'BRDF'): Outcome {
    if (!broken) return 'pass';
    return this.waived(term) ? 'given up' : 'fail';
  }
}

export interface Found {
  readonly point: Point;
  readonly value: number;
}

export function worstOf(point: Point, term = 'BRDF'): WorstCase {
  return { term, parameters: point.parameters, l: point.l, v: point.v };
}

/** The place of the worst case in words, to end a sentence with. */
export function placeOf({ l, v }: Pick<WorstCase, 'l' | 'v'>): string {
  const degrees = (w: readonly number[]) =>
    `${((Math.acos(Math.min(1, Math.max(-1, w[2] as number))) * 180) / Math.PI).toFixed(1)}°`;
  const parts = [...(l ? [`the light at ${degrees(l)}`] : []), ...(v ? [`the viewer at ${degrees(v)}`] : [])];
  return parts.length ? `with ${parts.join(' and ')} from the normal` : '';
}

/** A number with three digits. */
export function short(x: number): string {
  if (!Number.isFinite(x)) return String(x);
  return Math.abs(x) >= 1e5 || (x !== 0 && Math.abs(x) < 1e-3)
    ? x.toExponential(1)
    : String(+x.toPrecision(3));
}

export function percent(x: number): string {
  return `${short(100 * x)} %`;
}
