/** How far the data determine a fit's parameters: what cannot be told apart is said, not hidden. */
import { dot, eigen, gram } from './symmetric.ts';

/**
 * Two BRDFs whose cube roots differ by this share of their size look the same: it is 1.5 % of the light, and
 * people notice 1 to 2 % (Weber's fraction).
 */
export const VISIBLE = 0.005;

/** A coordinate that can move by more than this share of its range, unseen, is not determined. */
const LOOSE = 0.25;
/** The least share of a coordinate in a loose combination, of 1 for all squares together. */
const SHARE = 0.2;

export interface Determinacy {
  /** For each coordinate: how far it can go, if the others follow, until the difference is visible; 1 at most. */
  readonly play: readonly number[];
  /** Sets of coordinates of which only combinations are determined; one alone has no visible effect. */
  readonly loose: readonly (readonly number[])[];
}

/**
 * From the residuals' derivatives: near the best fit the mean square difference grows as x^T (J^T J/m) x, so
 * along an eigenvector of value e it is visible after visible/sqrt(e).
 *
 * @param columns the derivatives of all residuals by each coordinate
 * @param size the root mean square of what is fitted to
 */
export function determinacy(columns: readonly Float64Array[], size: number): Determinacy {
  const count = Math.max(1, columns[0]?.length ?? 0);
  const visible = VISIBLE * size;
  const axes = eigen(gram(columns).map((row) => row.map((x) => x / count)));
  const reach = axes.map(({ value }) => Math.min(1, visible / Math.sqrt(Math.max(value, 1e-300))));
  const play = columns.map((_, i) =>
    Math.min(1, Math.hypot(...axes.map(({ vector }, k) => (vector[i] as number) * (reach[k] as number)))),
  );
  const loose = axes.flatMap(({ vector }, k) => {
    if ((reach[k] as number) < LOOSE) return [];
    return [columns.flatMap((_, i) => ((vector[i] as number) ** 2 > SHARE ** 2 ? [i] : []))];
  });
  return { play, loose: distinct(loose, columns) };
}

/** Eigenvectors of equal values can be any mixture: those without any effect are named one by one. */
function distinct(sets: readonly (readonly number[])[], columns: readonly Float64Array[]): number[][] {
  const largest = Math.max(...columns.map((column) => dot(column, column)));
  const idle = new Set(columns.flatMap((column, i) => (dot(column, column) <= 1e-12 * largest ? [i] : [])));
  const others = sets.map((set) => set.filter((i) => !idle.has(i))).filter((set) => set.length > 0);
  return [...[...idle].map((i) => [i]), ...others];
}
