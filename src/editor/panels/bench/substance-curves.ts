/** The Fresnel reflectance of a real substance as curves of the bench: exact, and Schlick's from the same F0. */
import { fresnelCurves } from '../../../analysis/plots/fresnel.ts';
import { substances } from '../../../analysis/substances/table.ts';
import { t, translate } from '../../language/language.ts';
import { between } from './between.ts';
import type { PlottedCurve } from './frame.ts';

/** Of no material: those have their colours from the bench's legend. */
const EXACT = 'var(--plot-exact)';
const SCHLICK = 'var(--plot-schlick)';

const known = new Map<string, readonly PlottedCurve[]>();

/** None where there is no such substance. */
export function substanceCurves(name: string): readonly PlottedCurve[] {
  const substance = substances.get(name);
  if (!substance) return [];
  const kept = known.get(name);
  if (kept) return kept;
  const { exact, schlick } = fresnelCurves(substance);
  const curves = [
    {
      id: 'exact',
      name: t('{title}, exact', { title: translate(substance.title) }),
      color: EXACT,
      points: exact,
    },
    {
      id: 'schlick',
      name: t('{title}, Schlick', { title: translate(substance.title) }),
      color: SCHLICK,
      points: schlick,
    },
  ].map(
    (curve, index): PlottedCurve => ({
      ...curve,
      index,
      f: () => [0, 0, 0],
      at: (angle) => between(curve.points, angle),
      sweep: [],
      lobe: null,
      picture: null,
    }),
  );
  known.set(name, curves);
  return curves;
}
