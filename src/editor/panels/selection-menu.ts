/** What can be done to what is selected: in the Edit menu, and by a right click on its row. */
import { actionEntry } from '../actions/entry.ts';
import { t } from '../language/language.ts';
import { selectedMembers } from '../selection.ts';
import type { Session } from '../session.ts';
import type { MenuEntry } from '../ui/menu.ts';

export function selectionEntries(session: Session): MenuEntry[] {
  const { actions, state, store } = session;
  const label = state.value.selection === null ? t('Look at everything') : t('Look at it');
  const members = selectedMembers(session);
  const hidden = members.length > 0 && members.every(({ kind, id }) => !store.document[kind][id]?.visible);
  const locked = members.length > 0 && members.every(({ kind, id }) => store.document[kind][id]?.locked);
  const objects = members.filter(({ kind }) => kind === 'objects').length;
  return [
    actionEntry(actions, 'edit.cut'),
    actionEntry(actions, 'edit.copy', { icon: 'copy' }),
    actionEntry(actions, 'edit.paste'),
    actionEntry(actions, 'edit.duplicate'),
    actionEntry(actions, 'edit.delete', { icon: 'trash' }),
    actionEntry(actions, 'edit.rename'),
    'separator',
    actionEntry(actions, 'edit.group', { icon: 'folder' }),
    actionEntry(actions, 'edit.ungroup'),
    actionEntry(actions, 'edit.orderUp'),
    actionEntry(actions, 'edit.orderDown'),
    actionEntry(actions, 'edit.hide', {
      icon: hidden ? 'eye' : 'eyeOff',
      label: hidden ? t('Show') : t('Hide'),
    }),
    actionEntry(actions, 'edit.lock', {
      icon: locked ? 'lockOpen' : 'lock',
      label: locked ? t('Unlock') : t('Lock'),
    }),
    actionEntry(actions, 'edit.alone'),
    ...(members.length > 1 ? [actionEntry(actions, 'edit.align')] : []),
    ...(objects > 0
      ? ([
          'separator',
          actionEntry(actions, 'edit.selectSameMaterial', { icon: 'material' }),
          actionEntry(actions, 'edit.ownMaterial'),
          ...(objects > 1 ? [actionEntry(actions, 'edit.assignLastMaterial')] : []),
        ] as const)
      : []),
    'separator',
    actionEntry(actions, 'view.focus', { icon: 'focus', label }),
  ];
}
