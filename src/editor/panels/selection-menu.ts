/** What can be done to the selected thing: in the Edit menu, and by a right click on its row. */
import { deleteSelected, duplicateSelected } from '../commands.ts';
import type { Session } from '../session.ts';
import type { MenuEntry } from '../ui/menu.ts';

export function selectionEntries(session: Session): MenuEntry[] {
  const { store, state } = session;
  const { selection } = state.value;
  const disabled = selection === null;
  return [
    { label: 'Rename', shortcut: 'F2', disabled, run: () => session.renameSelected() },
    {
      label: 'Duplicate',
      icon: 'copy',
      shortcut: 'Ctrl+D',
      disabled,
      run: () => duplicateSelected(store, state),
    },
    { label: 'Delete', icon: 'trash', shortcut: 'Del', disabled, run: () => deleteSelected(store, state) },
    'separator',
    {
      label: disabled ? 'Look at everything' : 'Look at it',
      icon: 'focus',
      shortcut: 'F',
      run: () => session.focusSelection(),
    },
  ];
}
