/**
 * `node tools/run.mjs tools/microfacet-albedo.ts`: derives the constants of models/lib/missing-*.glsl, what a rough mirror
 * loses because light that bounces from facet to facet is left out: M(mu, alpha) = 1 - E(mu, alpha), E the directional albedo
 * of the facets with F = 1. Prints the largest and the root mean square error of each fit.
 */
import { writeFileSync } from 'node:fs';

/** Points of the quadrature along each side of the unit square. */
const SIDE = 160;

type Albedo = (mu: number, alpha: number) => number;

interface Surface {
  readonly file: string;
  readonly suffix: string;
  readonly about: string;
  readonly albedo: Albedo;
  /** Degrees of the polynomial in alpha and in y. */
  readonly degrees: readonly [number, number];
}

/** E of gtr2.glsl: visible normals (J. Dupuy and A. Benyoub, 2023), weight G1(l). */
const ofGTR2: Albedo = (mu, alpha) => {
  const v = [Math.sqrt(1 - mu * mu), mu] as const;
  const length = Math.hypot(v[0] * alpha, v[1]);
  const [x, z] = [(v[0] * alpha) / length, v[1] / length];
  return mean(SIDE, (u, phi) => {
    const capZ = (1 - u) * (1 + z) - z;
    const r = Math.sqrt(Math.max(1 - capZ * capZ, 0));
    const h = [(r * Math.cos(phi) + x) * alpha, r * Math.sin(phi) * alpha, Math.max(capZ + z, 1e-6)] as const;
    const norm = Math.hypot(...h);
    const cosine = (2 * (v[0] * h[0] + v[1] * h[2]) * h[2]) / norm / norm - mu;
    return cosine > 0 ? (2 * cosine) / (cosine + Math.sqrt(alpha ** 2 + (1 - alpha ** 2) * cosine ** 2)) : 0;
  });
};

/** E of beckmann.glsl with v-cavity.glsl: normals of density D (n.h), weight G (v.h)/((n.v)(n.h)). */
const ofBeckmann: Albedo = (mu, slope) => {
  const sine = Math.sqrt(1 - mu * mu);
  return mean(2 * SIDE, (u, phi) => {
    const NdotH = 1 / Math.sqrt(1 - slope * slope * Math.log(1 - u));
    const VdotH = sine * Math.sqrt(1 - NdotH * NdotH) * Math.cos(phi) + mu * NdotH;
    const cosine = 2 * VdotH * NdotH - mu;
    if (VdotH <= 0 || cosine <= 0) return 0;
    return (Math.min(1, (2 * NdotH * Math.min(mu, cosine)) / VdotH) * VdotH) / (mu * NdotH);
  });
};

const surfaces: readonly Surface[] = [
  {
    file: 'missing-gtr2.glsl',
    suffix: 'GTR2',
    about: 'gtr2.glsl, isotropic, with the masking of l and of v independent',
    albedo: ofGTR2,
    degrees: [3, 5],
  },
  {
    file: 'missing-beckmann.glsl',
    suffix: 'Beckmann',
    about: 'beckmann.glsl with the masking of v-cavity.glsl',
    albedo: ofBeckmann,
    degrees: [5, 6],
  },
];

for (const surface of surfaces) derive(surface);

function derive({ file, suffix, about, albedo, degrees }: Surface): void {
  const points: { alpha: number; mu: number; missing: number }[] = [];
  const alphas = [0.001, 0.003, 0.01, 0.02, 0.04, 0.07, 0.1, 0.15, ...steps(0.2, 1, 0.1)];
  for (const alpha of alphas) {
    // Even in y, where the function's shape is, and even in mu, where people look.
    const even = steps(1 / 48, 47 / 48, 1 / 24).map((y) => (y * alpha) / (1 - y));
    for (const mu of [...even, ...steps(0.05, 1, 0.05)]) {
      if (mu > 1e-4 && mu <= 1) points.push({ alpha, mu, missing: 1 - albedo(mu, alpha) });
    }
  }
  const [inAlpha, inY] = degrees;
  const basis = (mu: number, alpha: number): number[] => {
    const y = mu / (mu + alpha);
    return steps(0, inAlpha, 1).flatMap((i) =>
      steps(0, inY, 1).map((j) => alpha ** i * y ** j * (1 - y) ** 2),
    );
  };
  const coefficients = leastSquares(
    points.map(({ mu, alpha }) => basis(mu, alpha)),
    points.map(({ missing }) => missing),
  ).map((c) => Number(c.toPrecision(8)));
  const fitted = (mu: number, alpha: number) =>
    Math.max(
      0,
      basis(mu, alpha).reduce((sum, b, i) => sum + b * (coefficients[i] as number), 0),
    );
  const errors = points.map(({ mu, alpha, missing }) => Math.abs(fitted(mu, alpha) - missing));

  // The mean of the fit, not of the truth, keeps the lobe's energy exact. Fitted relative to it.
  const meanOf = (alpha: number) =>
    steps(0.5, 3999.5, 1).reduce(
      (sum, i) => sum + 2 * (i / 4000) ** 3 * (2 / 4000) * fitted((i / 4000) ** 2, alpha),
      0,
    );
  const fine = steps(0, 1, 1 / 60).map((t) => 0.001 + 0.999 * t * t);
  const means = fine.map(meanOf);
  // Wide tails make it alpha^2 log(alpha) where alpha is small.
  const meanBasis = (alpha: number) => [...steps(0, 5, 1).map((k) => alpha ** k), Math.log(alpha)];
  const ofMean = leastSquares(
    fine.map((alpha, i) => meanBasis(alpha).map((b) => (b * alpha ** 2) / (means[i] as number))),
    fine.map(() => 1),
  ).map((c) => Number(c.toPrecision(8)));
  const meanErrors = fine.map((alpha, i) => {
    const sum = meanBasis(alpha).reduce((total, b, k) => total + b * (ofMean[k] as number), 0);
    return Math.abs((sum * alpha ** 2) / (means[i] as number) - 1);
  });
  console.log(
    `${suffix}: M at most ${Math.max(...errors).toFixed(4)} off, rms ${rms(errors).toFixed(5)}; ` +
      `its mean at most ${(100 * Math.max(...meanErrors)).toFixed(2)} % off`,
  );

  const rows = steps(0, inAlpha, 1).map((i) => coefficients.slice(i * (inY + 1), (i + 1) * (inY + 1)));
  writeFileSync(
    new URL(`../models/lib/${file}`, import.meta.url),
    `// What this rough mirror does not give back, for want of the light that bounces from facet to facet:
// ${about}.
// Derived by tools/microfacet-albedo.ts; do not edit. A polynomial in alpha and y = mu/(mu + alpha), fitted to a
// quadrature; it errs by at most ${Math.max(...errors).toFixed(4)}, root mean square ${rms(errors).toFixed(4)}.

// 1 - E, E the directional albedo at the cosine mu in 0..1 of facets that absorb nothing; alpha in .001..1.
float missing${suffix}(float mu, float alpha) {
    float y = mu / (mu + alpha);
${rows.map((row, i) => `    float c${i} = ${horner(row, 'y')};`).join('\n')}
    return max((1.0 - y) * (1.0 - y) * (${horner(
      rows.map((_, i) => `c${i}`),
      'alpha',
    )}), 0.0);
}

// Its mean over the hemisphere, 2 times the integral of (1 - E) mu.
float missingMean${suffix}(float alpha) {
    return alpha * alpha * (${horner(ofMean.slice(0, -1), 'alpha')} + ${ofMean.at(-1)} * log(alpha));
}
`,
  );
}

/** The mean of f(u, phi) over u in 0..1 and phi in 0..2 pi, at the middles of cells that crowd at the ends of u: the tails. */
function mean(side: number, f: (u: number, phi: number) => number): number {
  let sum = 0;
  for (let i = 0; i < side; i++) {
    const s = (i + 0.5) / side;
    const u = s * s * (3 - 2 * s);
    const weight = (6 * s * (1 - s)) / side / SIDE;
    for (let j = 0; j < SIDE; j++) sum += weight * f(u, (2 * Math.PI * (j + 0.5)) / SIDE);
  }
  return sum;
}

function steps(from: number, to: number, step: number): number[] {
  return Array.from({ length: Math.round((to - from) / step) + 1 }, (_, i) => from + i * step);
}

function rms(values: readonly number[]): number {
  return Math.sqrt(values.reduce((sum, x) => sum + x * x, 0) / values.length);
}

/** The x that makes |A x - b| least, by the normal equations with a touch of ridge against near dependence. */
function leastSquares(rows: readonly (readonly number[])[], b: readonly number[]): number[] {
  const n = (rows[0] as readonly number[]).length;
  const system = Array.from({ length: n }, (_, i) => {
    const line = Array.from({ length: n + 1 }, (_, j) =>
      rows.reduce(
        (sum, row, k) => sum + (row[i] as number) * (j < n ? (row[j] as number) : (b[k] as number)),
        0,
      ),
    );
    line[i] = (line[i] as number) + 1e-9;
    return line;
  });
  for (let i = 0; i < n; i++) {
    const pivot = system
      .slice(i)
      .reduce((best, line, k) => (Math.abs(line[i]!) > Math.abs(system[best]![i]!) ? i + k : best), i);
    [system[i], system[pivot]] = [system[pivot]!, system[i]!];
    for (let k = i + 1; k < n; k++) {
      const factor = system[k]![i]! / system[i]![i]!;
      for (let j = i; j <= n; j++) system[k]![j]! -= factor * system[i]![j]!;
    }
  }
  const x = new Array<number>(n).fill(0);
  for (let i = n - 1; i >= 0; i--) {
    const rest = x.slice(i + 1).reduce((sum, value, k) => sum + value * system[i]![i + 1 + k]!, 0);
    x[i] = (system[i]![n]! - rest) / system[i]![i]!;
  }
  return x;
}

/** c0 + x (c1 + x (...)) as GLSL. */
function horner(terms: readonly (number | string)[], x: string): string {
  const text = (term: number | string) =>
    typeof term === 'number' && Number.isInteger(term) ? `${term}.0` : `${term}`;
  return terms
    .slice(0, -1)
    .reduceRight<string>((inner, term) => `${text(term)} + ${x} * (${inner})`, text(terms.at(-1) ?? 0));
}
