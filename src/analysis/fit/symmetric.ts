/** Small symmetric matrices, as rows. */
export type Matrix = readonly Float64Array[];

/** J^T J. */
export function gram(columns: readonly Float64Array[]): Matrix {
  return columns.map((a) => Float64Array.from(columns, (b) => dot(a, b)));
}

export function dot(a: Float64Array, b: Float64Array): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += (a[i] as number) * (b[i] as number);
  return sum;
}

/** x of A x = b for a positive definite A, by Cholesky's factors; null where A is not. */
export function solve(a: Matrix, b: Float64Array): Float64Array | null {
  const n = b.length;
  const factor = a.map((row) => Float64Array.from(row));
  const x = Float64Array.from(b);
  for (let i = 0; i < n; i++) {
    const row = factor[i] as Float64Array;
    for (let j = 0; j <= i; j++) {
      const other = factor[j] as Float64Array;
      let sum = row[j] as number;
      for (let k = 0; k < j; k++) sum -= (row[k] as number) * (other[k] as number);
      if (i > j) row[j] = sum / (other[j] as number);
      else if (sum > 0) row[i] = Math.sqrt(sum);
      else return null;
    }
    let sum = x[i] as number;
    for (let k = 0; k < i; k++) sum -= (row[k] as number) * (x[k] as number);
    x[i] = sum / (row[i] as number);
  }
  for (let i = n - 1; i >= 0; i--) {
    let sum = x[i] as number;
    for (let k = i + 1; k < n; k++) sum -= ((factor[k] as Float64Array)[i] as number) * (x[k] as number);
    x[i] = sum / ((factor[i] as Float64Array)[i] as number);
  }
  return x;
}

export interface Eigen {
  readonly value: number;
  readonly vector: Float64Array;
}

/** Eigenvalues and unit eigenvectors by Jacobi's rotations (C. G. J. Jacobi, 1846). */
export function eigen(a: Matrix): Eigen[] {
  const n = a.length;
  const m = a.map((row) => Float64Array.from(row));
  const vectors = m.map((_, i) => Float64Array.from({ length: n }, (_, j) => (i === j ? 1 : 0)));
  const at = (rows: Float64Array[], i: number, j: number) => (rows[i] as Float64Array)[j] as number;
  const put = (rows: Float64Array[], i: number, j: number, x: number) => {
    (rows[i] as Float64Array)[j] = x;
  };
  // Each sweep squares what is left beside the diagonal; some ten do for any matrix.
  for (let sweep = 0; sweep < 30; sweep++) {
    let rotated = false;
    for (let p = 0; p < n; p++) {
      for (let q = p + 1; q < n; q++) {
        const off = at(m, p, q);
        if (Math.abs(off) <= 1e-17 * Math.sqrt(Math.abs(at(m, p, p) * at(m, q, q)))) continue;
        rotated = true;
        const theta = (at(m, q, q) - at(m, p, p)) / (2 * off);
        const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.hypot(theta, 1));
        const c = 1 / Math.hypot(t, 1);
        const s = t * c;
        for (let k = 0; k < n; k++) {
          const [x, y] = [at(m, k, p), at(m, k, q)];
          put(m, k, p, c * x - s * y);
          put(m, k, q, s * x + c * y);
        }
        for (let k = 0; k < n; k++) {
          const [x, y] = [at(m, p, k), at(m, q, k)];
          put(m, p, k, c * x - s * y);
          put(m, q, k, s * x + c * y);
          const [u, w] = [at(vectors, p, k), at(vectors, q, k)];
          put(vectors, p, k, c * u - s * w);
          put(vectors, q, k, s * u + c * w);
        }
      }
    }
    if (!rotated) break;
  }
  return vectors.map((vector, i) => ({ value: at(m, i, i), vector }));
}
