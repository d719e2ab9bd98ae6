/** What can be added: in the Add menu, and by a right click on nothing. */
import { addableGeometries, geometryNames } from '../../scene/geometry-schema.ts';
import { lightDefaults, lightTypes } from '../../scene/light-schema.ts';
import { actionEntry } from '../actions/entry.ts';
import { t, translate } from '../language/language.ts';
import type { Session } from '../session.ts';
import { isIcon } from '../ui/icons.ts';
import type { MenuEntry } from '../ui/menu.ts';

export function addEntries({ actions }: Session): MenuEntry[] {
  const entry = (type: string, name: string): MenuEntry =>
    actionEntry(actions, `add.${type}`, { label: translate(name), icon: isIcon(type) ? type : 'mesh' });
  return [
    { heading: t('Objects') },
    ...addableGeometries.map((type) => entry(type, geometryNames[type])),
    'separator',
    { heading: t('Lights') },
    ...lightTypes.map((type) => entry(type, lightDefaults[type].name)),
    'separator',
    entry('material', 'Material'),
    actionEntry(actions, 'material.library', { icon: 'material', label: t('Material of the library…') }),
  ];
}
