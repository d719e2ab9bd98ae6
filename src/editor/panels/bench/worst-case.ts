/** Puts a verdict's worst case where it can be seen: on the material, and into the plots. */
import { halfDifferenceOf } from '../../../analysis/plots/half-difference.ts';
import type { Vec3 } from '../../../analysis/vector.ts';
import type { WorstCase } from '../../../analysis/verdict/types.ts';
import type { DocumentStore } from '../../../scene/store.ts';
import { t } from '../../language/language.ts';
import { tenths, wrapped } from './frame.ts';
import { type BenchSettings, STEEPEST } from './settings.ts';

const degrees = (radians: number) => tenths((radians * 180) / Math.PI);
const theta = ([x, y, z]: Vec3) => Math.min(STEEPEST, degrees(Math.atan2(Math.hypot(x, y), z)));
const phi = ([x, y]: Vec3) => wrapped(degrees(Math.atan2(y, x)));

/** Its parameters on the material: one undo step. */
export function putWorstCase(
  store: DocumentStore,
  material: string,
  { parameters, term }: WorstCase,
  label = t('Worst case of {term}', { term }),
): void {
  store.edit(label, (draft) => {
    const target = draft.materials[material];
    if (target) target.parameters = structuredClone(parameters) as typeof target.parameters;
  });
}

/** Its directions and its term; what it has none of stays. */
export function worstSettings({ l, v, term }: WorstCase): Partial<BenchSettings> {
  const half = l && v ? halfDifferenceOf(l, v) : null;
  return {
    term,
    ...(v && { thetaV: theta(v), phiV: phi(v) }),
    ...(l && { thetaL: theta(l), phiL: phi(l) }),
    ...(half && {
      thetaH: Math.min(STEEPEST, degrees(half.thetaH)),
      thetaD: Math.min(STEEPEST, degrees(half.thetaD)),
    }),
  };
}
