/** What a substance does to light: its index of refraction n and extinction k, over the wavelength. */

interface Named {
  /** What the command line and menus call it. */
  readonly name: string;
  readonly title: string;
  /** Conductors let no light through: all that they show is reflected. Semiconductors count as such here. */
  readonly kind: 'conductor' | 'dielectric';
  /** Author, year, title, place. */
  readonly source: string;
  /** In nm, for what a formula was made; beyond, it is continued. */
  readonly range?: readonly [number, number];
}

/** [wavelength in nm, n, k], ascending; straight between, level beyond. */
export interface Tabulated extends Named {
  readonly samples: readonly (readonly [nm: number, n: number, k: number])[];
}

/** n^2 = constant + sum of b w^2/(w^2 - c), w in micrometres (W. Sellmeier, 1871). */
export interface Sellmeier extends Named {
  readonly sellmeier: {
    readonly constant: number;
    readonly terms: readonly (readonly [b: number, c: number])[];
  };
}

/** n = sum of a w^p, w in micrometres (A.-L. Cauchy, 1836). */
export interface Cauchy extends Named {
  readonly cauchy: readonly (readonly [a: number, p: number])[];
}

/**
 * The Lorentz-Drude model: epsilon = 1 - f0 P^2/(E (E + i G0)) + sum of f P^2/(E0^2 - E^2 - i E G), all energies in eV
 * (A. D. Rakic et al., 1998, equations 2 to 5).
 */
export interface LorentzDrude extends Named {
  readonly lorentzDrude: {
    readonly plasma: number;
    readonly free: readonly [f: number, damping: number];
    readonly bound: readonly (readonly [f: number, damping: number, energy: number])[];
  };
}

export type Substance = Tabulated | Sellmeier | Cauchy | LorentzDrude;

export type OpticalConstants = readonly [n: number, k: number];

/** h c in eV nm. */
const ELECTRONVOLT_NM = 1239.841984;

/** n and k at a wavelength in nm. */
export function opticalConstants(substance: Substance, nm: number): OpticalConstants {
  if ('samples' in substance) return interpolate(substance.samples, nm);
  if ('lorentzDrude' in substance) return lorentzDrude(substance.lorentzDrude, ELECTRONVOLT_NM / nm);
  const w = nm / 1000;
  if ('cauchy' in substance) return [substance.cauchy.reduce((n, [a, p]) => n + a * w ** p, 0), 0];
  const { constant, terms } = substance.sellmeier;
  return [Math.sqrt(terms.reduce((sum, [b, c]) => sum + (b * w * w) / (w * w - c), constant)), 0];
}

function interpolate(samples: Tabulated['samples'], nm: number): OpticalConstants {
  const after = samples.findIndex(([at]) => at >= nm);
  const [a, b] = [samples[after - 1] ?? samples.at(after)!, samples.at(after)!];
  const t = a === b ? 0 : (nm - a[0]) / (b[0] - a[0]);
  return [a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])];
}

function lorentzDrude(
  { plasma, free, bound }: LorentzDrude['lorentzDrude'],
  energy: number,
): OpticalConstants {
  // strength/(real + i imaginary), added to epsilon.
  let [re, im] = [1, 0];
  const add = (strength: number, real: number, imaginary: number) => {
    const divisor = real * real + imaginary * imaginary;
    re += (strength * real) / divisor;
    im -= (strength * imaginary) / divisor;
  };
  add(-free[0] * plasma ** 2, energy * energy, energy * free[1]);
  for (const [f, damping, resonance] of bound)
    add(f * plasma ** 2, resonance * resonance - energy * energy, -energy * damping);
  // (n + i k)^2 = epsilon.
  const length = Math.hypot(re, im);
  return [Math.sqrt((length + re) / 2), Math.sqrt((length - re) / 2)];
}
