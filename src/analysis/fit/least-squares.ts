/** Nonlinear least squares in a box. */
import { meanSquare } from './metrics.ts';
import { dot, gram, type Matrix, solve } from './symmetric.ts';

/** The residuals at several points of the box 0..1 at once. */
export type Residuals = (points: readonly Float64Array[]) => Promise<Float64Array[]>;

export interface LeastSquaresOptions {
  readonly iterations: number;
  /** The step of the differences that stand for derivatives: 1e-6 in float64, 1e-3 in float32. */
  readonly step: number;
  /** Ends where an iteration takes away less than this share of the error. */
  readonly tolerance: number;
  /** Called after each iteration. */
  readonly onIteration?: (error: number) => void;
}

export interface Minimum {
  readonly point: Float64Array;
  /** The mean square of the residuals. */
  readonly error: number;
}

/** So small a mean square is rounding. */
const NOTHING = 1e-26;
const MOST_TRIES = 8;

/**
 * Levenberg and Marquardt's method (D. W. Marquardt, 1963, "An Algorithm for Least-Squares Estimation of Nonlinear
 * Parameters") with derivatives by differences, in a box: coordinates that stand at a bound and are pushed
 * outward do not take part; a step that would leave the box ends at its side, and the other coordinates
 * are solved for again.
 */
export async function leastSquares(
  residuals: Residuals,
  start: Float64Array,
  options: LeastSquaresOptions,
): Promise<Minimum> {
  let point = start;
  let [values] = (await residuals([point])) as [Float64Array];
  let error = meanSquare(values);
  let damping = 1e-3;
  for (let i = 0; i < options.iterations && error > NOTHING && point.length > 0; i++) {
    const columns = await derivatives(residuals, point, values, options.step);
    const normal = gram(columns);
    const gradient = Float64Array.from(columns, (column) => dot(column, values));
    const before = error;
    for (let tries = 0; tries < MOST_TRIES; tries++) {
      const next = boxedStep(point, normal, gradient, damping);
      const [tried] = (await residuals([next])) as [Float64Array];
      const triedError = meanSquare(tried);
      if (triedError < error) {
        [point, values, error] = [next, tried, triedError];
        damping = Math.max(1e-12, damping / 8);
        break;
      }
      damping *= 6;
    }
    options.onIteration?.(error);
    if (error >= before * (1 - options.tolerance)) break;
  }
  return { point, error };
}

/** The residuals' derivatives by each coordinate. */
export async function derivatives(
  residuals: Residuals,
  point: Float64Array,
  values: Float64Array,
  step: number,
): Promise<Float64Array[]> {
  // Towards the middle of the box, so that no point leaves it.
  const steps = Float64Array.from(point, (x) => (x < 0.5 ? step : -step));
  const beside = await residuals(
    Array.from(steps, (h, i) => {
      const moved = Float64Array.from(point);
      moved[i] = (moved[i] as number) + h;
      return moved;
    }),
  );
  return beside.map((side, i) => side.map((x, k) => (x - (values[k] as number)) / (steps[i] as number)));
}

/** The damped step, and its end inside the box. */
function boxedStep(
  point: Float64Array,
  normal: Matrix,
  gradient: Float64Array,
  damping: number,
): Float64Array {
  const n = point.length;
  const next = Float64Array.from(point);
  let free = Array.from({ length: n }, (_, i) => i).filter((i) => {
    const [x, g] = [point[i] as number, gradient[i] as number];
    return !((x <= 0 && g > 0) || (x >= 1 && g < 0));
  });
  const largest = Math.max(...normal.map((row, i) => row[i] as number));
  while (free.length > 0) {
    const matrix = free.map((i) =>
      Float64Array.from(free, (j) => {
        const own = (normal[i] as Float64Array)[j] as number;
        // A coordinate without effect has 0 on the diagonal, and stays where it is.
        return i === j ? own * (1 + damping) + damping * 1e-6 * largest + 1e-300 : own;
      }),
    );
    const right = Float64Array.from(free, (i) => {
      let sum = -(gradient[i] as number);
      for (let j = 0; j < n; j++) {
        if (!free.includes(j))
          sum -= ((normal[i] as Float64Array)[j] as number) * ((next[j] as number) - (point[j] as number));
      }
      return sum;
    });
    const step = solve(matrix, right);
    if (!step) return next;
    const leaving = free.filter((i, k) => {
      const x = (point[i] as number) + (step[k] as number);
      return x < 0 || x > 1;
    });
    for (const [k, i] of free.entries()) {
      const x = (point[i] as number) + (step[k] as number);
      next[i] = Math.min(1, Math.max(0, x));
    }
    if (leaving.length === 0) break;
    free = free.filter((i) => !leaving.includes(i));
    for (const i of free) next[i] = point[i] as number;
  }
  return next;
}
