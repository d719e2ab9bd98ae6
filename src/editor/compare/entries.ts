/** What a material can be compared with, as a menu. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { MenuEntry } from '../ui/menu.ts';
import { otherModels } from './comparison.ts';
import { compareModel, startComparison } from './start.ts';

export function comparisonEntries(session: Session, id: string, openLibrary: () => void): MenuEntry[] {
  const { document } = session.store;
  const material = document.materials[id];
  if (!material) return [];
  const others = Object.entries(document.materials).filter(([other]) => other !== id);
  return [
    {
      label: t('A material of the library…'),
      icon: 'material',
      tip: t('Choose one there, then Compare'),
      run: openLibrary,
    },
    { heading: t('The same look in another model') },
    ...otherModels(document, material).map((model) => ({
      label: model,
      run: () => compareModel(session, id, model),
    })),
    ...(others.length > 0 ? [{ heading: t('A material of this scene') }] : []),
    ...others.map(([other, { name }]) => ({
      label: name,
      run: () => startComparison(session, id, { kind: 'scene', id: other }),
    })),
  ];
}
