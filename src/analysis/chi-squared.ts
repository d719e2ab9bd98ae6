/**
 * Pearson's chi-squared test: do counts agree with what a theory expects?
 *
 * W. H. Press et al., 2007, "Numerical Recipes", 3rd edition, section 6.2 for the incomplete gamma function.
 */

/** ln Gamma(x) for x > 0, by Lanczos' approximation (g = 7, n = 9), to about 15 digits. */
export function logGamma(x: number): number {
  const coefficients = [
    0.9999999999998099, 676.5203681218851, -1259.1392167224028, 771.3234287776531, -176.6150291621406,
    12.507343278686905, -0.13857109526572012, 9.9843695780195716e-6, 1.5056327351493116e-7,
  ];
  if (x < 0.5) return Math.log(Math.PI / Math.sin(Math.PI * x)) - logGamma(1 - x);
  const z = x - 1;
  const t = z + 7.5;
  const sum = coefficients.reduce((total, c, i) => (i === 0 ? c : total + c / (z + i)), 0);
  return 0.5 * Math.log(2 * Math.PI) + (z + 0.5) * Math.log(t) - t + Math.log(sum);
}

/** The regularized upper incomplete gamma function Q(a, x), a > 0, x >= 0. */
export function gammaQ(a: number, x: number): number {
  if (x <= 0) return 1;
  if (x === Number.POSITIVE_INFINITY) return 0;
  const factor = Math.exp(a * Math.log(x) - x - logGamma(a));
  if (x < a + 1) {
    // The series of P = 1 - Q.
    let term = 1 / a;
    let sum = term;
    for (let n = 1; term > sum * 1e-16; n++) {
      term *= x / (a + n);
      sum += term;
    }
    return 1 - sum * factor;
  }
  // The continued fraction, by Lentz's method.
  let b = x + 1 - a;
  let c = Number.MAX_VALUE;
  let d = 1 / b;
  let fraction = d;
  for (let i = 1; i < 100_000; i++) {
    const numerator = -i * (i - a);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    fraction *= d * c;
    if (Math.abs(d * c - 1) < 1e-15) break;
  }
  return fraction * factor;
}

/** The probability that chi-squared with so many degrees of freedom exceeds the statistic. */
export function chiSquaredSurvival(statistic: number, degreesOfFreedom: number): number {
  return gammaQ(degreesOfFreedom / 2, statistic / 2);
}

export interface ChiSquaredResult {
  readonly statistic: number;
  readonly degreesOfFreedom: number;
  /** The probability of a statistic as large as this or larger if the theory is right. */
  readonly pValue: number;
}

/**
 * Compares counts with their expectations.
 *
 * Chi-squared's law only holds for cells that expect a handful of counts; cells that expect fewer than
 * `minimum` are pooled, in order of their expectation, into cells that reach it (W. G. Cochran, 1954, "Some
 * Methods for Strengthening the Common chi-squared Tests", asks for 5).
 *
 * @throws RangeError if the lists differ in length or an expectation is negative or not a number
 */
export function chiSquaredTest(
  observed: readonly number[],
  expected: readonly number[],
  minimum = 5,
): ChiSquaredResult {
  if (observed.length !== expected.length) throw new RangeError('as many counts as expectations are needed');
  const bad = expected.findIndex((value) => !(value >= 0));
  if (bad >= 0) throw new RangeError(`expectation ${bad} is ${expected[bad]}`);

  const order = [...expected.keys()].sort((i, j) => expected[i]! - expected[j]!);
  let statistic = 0;
  let cells = 0;
  let pooledObserved = 0;
  let pooledExpected = 0;
  for (const [position, i] of order.entries()) {
    pooledObserved += observed[i]!;
    pooledExpected += expected[i]!;
    // The largest cell is always the last, so what is pooled before it reaches the minimum or joins it.
    if (pooledExpected < minimum && position < order.length - 1) continue;
    if (pooledExpected > 0) statistic += (pooledObserved - pooledExpected) ** 2 / pooledExpected;
    else if (pooledObserved > 0) statistic = Number.POSITIVE_INFINITY;
    cells++;
    pooledObserved = 0;
    pooledExpected = 0;
  }
  const degreesOfFreedom = cells - 1;
  const pValue = degreesOfFreedom > 0 ? chiSquaredSurvival(statistic, degreesOfFreedom) : 1;
  return { statistic, degreesOfFreedom, pValue };
}

/**
 * The level of each of `tests` independent tests that makes all of them together wrong with probability
 * `level` (Z. Sidak, 1967, "Rectangular Confidence Regions for the Means of Multivariate Normal
 * Distributions").
 */
export function sidakLevel(level: number, tests: number): number {
  return -Math.expm1(Math.log1p(-level) / tests);
}
