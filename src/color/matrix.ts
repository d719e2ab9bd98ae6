/** Just enough of 3 x 3 matrices, by rows, for colours. */
export type Triple = readonly [number, number, number];
export type Matrix3 = readonly [Triple, Triple, Triple];

export function transform([a, b, c]: Matrix3, [x, y, z]: Triple): [number, number, number] {
  const row = ([r, s, t]: Triple) => r * x + s * y + t * z;
  return [row(a), row(b), row(c)];
}

/** By Cramer's rule: the rows' cross products are the inverse's columns. */
export function inverse([a, b, c]: Matrix3): Matrix3 {
  const [u, v, w] = [cross(b, c), cross(c, a), cross(a, b)];
  const determinant = a[0] * u[0] + a[1] * u[1] + a[2] * u[2];
  const row = (i: 0 | 1 | 2): Triple => [u[i] / determinant, v[i] / determinant, w[i] / determinant];
  return [row(0), row(1), row(2)];
}

function cross(a: Triple, b: Triple): Triple {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
