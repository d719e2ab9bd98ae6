import type { Vec3 } from './vector.ts';

/**
 * Adaptive integration over rectangles and over the hemisphere about +z.
 *
 * A BRDF is smooth nearly everywhere and a thousand times larger in one small spot. So cells are split
 * where a rule of high order and one of low order disagree, and around the directions (`focus`) where the
 * caller knows a peak to be, which no rule would find by itself if all its points missed it.
 */

export interface QuadratureOptions {
  /** Stop when the estimated absolute error of every component is below this. */
  readonly tolerance?: number;
  /** Stop, with a larger error, after about this many evaluations of the integrand. */
  readonly maxEvaluations?: number;
  /** How often the cells around a focus are halved before anything is measured; 8 if not given. */
  readonly focusDepth?: number;
}

export interface Integral {
  readonly value: readonly number[];
  /** Estimated absolute error of the worst component; pessimistic where the integrand is smooth. */
  readonly error: number;
  readonly evaluations: number;
}

interface Cell {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly value: readonly number[];
  readonly error: number;
}

/** Gauss-Kronrod (3, 7) on -1..1: node, Kronrod's weight, Gauss's weight (0 where Gauss has no node). */
const RULE: readonly (readonly [number, number, number])[] = [
  [-0.9604912687080203, 0.10465622602646726, 0],
  [-0.7745966692414834, 0.26848808986833345, 5 / 9],
  [-0.4342437493468026, 0.4013974147759622, 0],
  [0, 0.45091653865847414, 8 / 9],
  [0.4342437493468026, 0.4013974147759622, 0],
  [0.7745966692414834, 0.26848808986833345, 5 / 9],
  [0.9604912687080203, 0.10465622602646726, 0],
];

export interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** The integral over a rectangle of a function with one or more components. */
export function integrateRectangle(
  f: (x: number, y: number) => readonly number[],
  rectangle: Rectangle,
  options: QuadratureOptions & {
    readonly focus?: readonly (readonly [number, number])[];
    /** Columns and rows to begin with; one cell if not given. */
    readonly grid?: readonly [number, number];
  } = {},
): Integral {
  const { tolerance = 1e-6, maxEvaluations = 200_000, focus = [], focusDepth = 8, grid = [1, 1] } = options;
  let evaluations = 0;

  const measure = ({ x, y, width, height }: Rectangle): Cell => {
    let fine: number[] = [];
    let coarse: number[] = [];
    for (const [nodeX, kronrodX, gaussX] of RULE) {
      for (const [nodeY, kronrodY, gaussY] of RULE) {
        const values = f(x + (width * (1 + nodeX)) / 2, y + (height * (1 + nodeY)) / 2);
        if (fine.length === 0) {
          fine = values.map(() => 0);
          coarse = values.map(() => 0);
        }
        const [kronrod, gauss] = [kronrodX * kronrodY, gaussX * gaussY];
        for (let i = 0; i < values.length; i++) {
          fine[i]! += kronrod * values[i]!;
          coarse[i]! += gauss * values[i]!;
        }
      }
    }
    evaluations += RULE.length ** 2;
    const scale = (width * height) / 4;
    const error = Math.max(...fine.map((value, i) => Math.abs(value - coarse[i]!))) * scale;
    return { x, y, width, height, value: fine.map((value) => value * scale), error };
  };
  const quarters = ({ x, y, width, height }: Rectangle): Rectangle[] => {
    const [w, h] = [width / 2, height / 2];
    return [
      { x, y, width: w, height: h },
      { x: x + w, y, width: w, height: h },
      { x, y: y + h, width: w, height: h },
      { x: x + w, y: y + h, width: w, height: h },
    ];
  };
  // What is on an edge belongs to both sides, whatever the edge was rounded to.
  const within = (x: number, start: number, length: number) =>
    x >= start - 1e-9 * length && x <= start + (1 + 1e-9) * length;
  const contains = (cell: Rectangle) =>
    focus.some(([x, y]) => within(x, cell.x, cell.width) && within(y, cell.y, cell.height));
  const refine = (cell: Rectangle, depth: number): Rectangle[] =>
    depth > 0 && contains(cell) ? quarters(cell).flatMap((quarter) => refine(quarter, depth - 1)) : [cell];

  const [columns, rows] = grid;
  const [width, height] = [rectangle.width / columns, rectangle.height / rows];
  const first = Array.from({ length: columns * rows }, (_, i) => ({
    x: rectangle.x + (i % columns) * width,
    y: rectangle.y + Math.floor(i / columns) * height,
    width,
    height,
  }));
  let cells = first.flatMap((cell) => refine(cell, focusDepth)).map(measure);
  for (;;) {
    const error = cells.reduce((sum, cell) => sum + cell.error, 0);
    if (error <= tolerance || evaluations >= maxEvaluations) {
      const value = cells[0]!.value.map((_, i) => cells.reduce((sum, cell) => sum + cell.value[i]!, 0));
      return { value, error, evaluations };
    }
    // At least one cell is above the mean allowance, or the sum would not be above the tolerance.
    const allowance = tolerance / cells.length;
    cells = cells.flatMap((cell) => (cell.error > allowance ? quarters(cell).map(measure) : [cell]));
  }
}

/**
 * The integral over the hemisphere about +z, with respect to solid angle (multiply by z for the cosine).
 *
 * The square -1..1 is mapped to the unit disc by x = a sqrt(1 - b^2/2), y = b sqrt(1 - a^2/2), and the disc
 * to the hemisphere by Lambert's azimuthal equal-area projection, z = 1 - r^2. Both are smooth at the pole
 * and at the horizon, where spherical angles and the projected disc are not.
 *
 * @param options.focus directions near which f may be large
 */
export function integrateHemisphere(
  f: (direction: Vec3) => readonly number[],
  options: QuadratureOptions & { readonly focus?: readonly Vec3[] } = {},
): Integral {
  const integrand = (a: number, b: number): readonly number[] => {
    const [scaleX, scaleY] = [Math.sqrt(1 - (b * b) / 2), Math.sqrt(1 - (a * a) / 2)];
    const [x, y] = [a * scaleX, b * scaleY];
    const stretch = Math.sqrt(2 - x * x - y * y);
    const area = (1 - (a * a + b * b) / 2) / (scaleX * scaleY);
    return f([x * stretch, y * stretch, 1 - x * x - y * y]).map((value) => 2 * area * value);
  };
  const focus = (options.focus ?? []).filter(([, , z]) => z >= 0).map(squareFromHemisphere);
  return integrateRectangle(integrand, { x: -1, y: -1, width: 2, height: 2 }, { ...options, focus });
}

/** The inverse of integrateHemisphere's map. */
function squareFromHemisphere([dx, dy, dz]: Vec3): readonly [number, number] {
  const stretch = Math.sqrt(1 + dz);
  const [x, y] = [dx / stretch, dy / stretch];
  const difference = x * x - y * y;
  const coordinate = (own: number, signed: number) => {
    const sum = 2 + signed;
    return (
      (Math.sqrt(Math.max(0, sum + 2 * Math.SQRT2 * own)) -
        Math.sqrt(Math.max(0, sum - 2 * Math.SQRT2 * own))) /
      2
    );
  };
  return [coordinate(x, difference), coordinate(y, -difference)];
}
