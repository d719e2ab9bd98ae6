/** A target's values at pairs of directions, and the differences of a model's values from them. */
import type { ParameterValues } from '../../brdf/model.ts';
import type { EvaluateSets } from './evaluate.ts';
import { METRICS, type Metric, meanSquare } from './metrics.ts';
import type { Pair } from './samples.ts';

export class Comparison {
  readonly pairs: readonly Pair[];
  private readonly wanted: Float64Array;
  private readonly aims = new Map<Metric, Float64Array>();

  /** @param wanted f (n.l) of the target at each pair: red, green, blue */
  constructor(pairs: readonly Pair[], wanted: Float64Array) {
    this.pairs = pairs;
    this.wanted = wanted;
  }

  /** The root mean square of the target itself. */
  size(metric: Metric): number {
    return Math.sqrt(meanSquare(this.aim(metric)));
  }

  /** The differences of the model's values at sets of parameters. */
  async differences(
    metric: Metric,
    evaluate: EvaluateSets,
    sets: readonly ParameterValues[],
  ): Promise<Float64Array[]> {
    const [g, aim] = [METRICS[metric], this.aim(metric)];
    const found = await evaluate(sets, this.pairs);
    return found.map((values) => values.map((x, i) => g(x) - (aim[i] as number)));
  }

  private aim(metric: Metric): Float64Array {
    let aim = this.aims.get(metric);
    if (!aim) {
      aim = this.wanted.map(METRICS[metric]);
      this.aims.set(metric, aim);
    }
    return aim;
  }
}
