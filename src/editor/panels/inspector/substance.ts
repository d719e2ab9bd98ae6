/** A real substance for a material: sets the parameters that make its model reflect like it. */

import { type SubstanceParameters, substanceParameters } from '../../../analysis/substances/parameters.ts';
import type { Substance } from '../../../analysis/substances/substance.ts';
import { substances } from '../../../analysis/substances/table.ts';
import type { Parameter } from '../../../brdf/model.ts';
import { setParameters } from '../../../scene/material-commands.ts';
import { attempt } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { type Choice, row, selectField } from '../../ui/fields.ts';
import { toast } from '../../ui/toast.ts';
import type { Bound } from './field.ts';

const GROUPS: Readonly<Record<Substance['kind'], string>> = {
  conductor: t('Metals and semiconductors'),
  dielectric: t('Glasses, crystals, plastics, liquids'),
};

/** Null for a model that has no parameters for any. Shows the substance whose values the material has. */
export function substanceRow({ store }: Session, id: string, parameters: readonly Parameter[]): Bound | null {
  const known = new Map<string, { substance: Substance; found: SubstanceParameters }>();
  for (const [name, substance] of substances) {
    const found = substanceParameters(substance, parameters);
    if (found) known.set(name, { substance, found });
  }
  if (known.size === 0) return null;
  const choices: Choice[] = [...known].map(([value, { substance }]) => ({
    value,
    label: translate(substance.title),
    group: GROUPS[substance.kind],
  }));
  const field = selectField(t('Substance'), [{ value: '', label: t('Own values') }, ...choices], (name) => {
    const chosen = known.get(name);
    if (chosen) apply(chosen.substance, chosen.found);
    update();
  });
  const apply = ({ title }: Substance, { values, outside }: SubstanceParameters) => {
    attempt(t('The material stays as it was'), () => setParameters(store, id, title, values));
    const cut = Object.entries(outside).map(([name, value]) =>
      t('{name} would have to be {value}', { name, value: value.toFixed(2) }),
    );
    if (cut.length > 0)
      toast(
        'info',
        t('{title}: more than this model can do', { title: translate(title) }),
        t('It got the nearest that there is; {list}.', { list: cut.join(', ') }),
      );
  };
  const update = () => {
    const current = store.document.materials[id]?.parameters ?? {};
    const match = [...known].find(([, { found }]) =>
      Object.entries(found.values).every(([name, value]) => String(current[name]) === String(value)),
    );
    field.show(match?.[0] ?? '');
  };
  const tip = t(
    'Reflect like a real substance, by its measured index of refraction: metals get their colour, others the strength of their gloss',
  );
  return { element: row({ label: t('Substance'), tip }, field.element), update };
}
