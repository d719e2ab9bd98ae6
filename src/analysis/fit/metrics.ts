/**
 * Differences of two BRDFs over pairs of directions: the root of the mean square difference of g(f (n.l)), over
 * all pairs and channels. The cosine weighs down what hardly reflects; g says how much a peak counts against
 * what is dim.
 */
export const METRICS = {
  /**
   * The cube root: of the metrics compared there, the closest to what people see. A. Fores, J. Ferwerda and
   * J. Gu, 2012, "Toward a Perceptually Based Metric for BRDF Modeling", Color and Imaging Conference 20.
   */
  'cube root': Math.cbrt,
  /**
   * The logarithm. J. Löw, J. Kronander, A. Ynnerman and J. Unger, 2012, "BRDF Models for Accurate and Efficient
   * Rendering of Glossy Surfaces", ACM TOG 31(1).
   */
  logarithm: Math.log1p,
  /** Reflected light itself. A. Ngan, F. Durand and W. Matusik, 2005, "Experimental Analysis of BRDF Models". */
  cosine: (x: number) => x,
} as const satisfies Readonly<Record<string, (x: number) => number>>;

export type Metric = keyof typeof METRICS;

/** The mean of the squares. */
export function meanSquare(values: Float64Array): number {
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += (values[i] as number) ** 2;
  return values.length ? sum / values.length : 0;
}
