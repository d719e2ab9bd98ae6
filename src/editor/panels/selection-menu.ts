/** What can be done to the selected thing: in the Edit menu, and by a right click on its row. */
import { actionEntry } from '../actions/entry.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { MenuEntry } from '../ui/menu.ts';

export function selectionEntries({ actions, state }: Session): MenuEntry[] {
  const label = state.value.selection === null ? t('Look at everything') : t('Look at it');
  return [
    actionEntry(actions, 'edit.rename'),
    actionEntry(actions, 'edit.duplicate', { icon: 'copy' }),
    actionEntry(actions, 'edit.delete', { icon: 'trash' }),
    'separator',
    actionEntry(actions, 'view.focus', { icon: 'focus', label }),
  ];
}
