/** What changes the document. */
import { deleteSelected, duplicateSelected, toggleSource } from '../commands.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { Action } from './action.ts';

export function editActions(session: Session): Action[] {
  const { store, state } = session;
  const enabled = () => state.value.selection !== null;
  return [
    {
      id: 'edit.undo',
      title: t('Undo'),
      keys: ['Ctrl+Z'],
      enabled: () => store.canUndo,
      run: () => store.undo(),
    },
    {
      id: 'edit.redo',
      title: t('Redo'),
      keys: ['Ctrl+Shift+Z', 'Ctrl+Y'],
      enabled: () => store.canRedo,
      run: () => store.redo(),
    },
    { id: 'edit.rename', title: t('Rename'), keys: ['F2'], enabled, run: () => session.renameSelected() },
    {
      id: 'edit.duplicate',
      title: t('Duplicate'),
      keys: ['Ctrl+D'],
      enabled,
      run: () => duplicateSelected(store, state),
    },
    {
      id: 'edit.delete',
      title: t('Delete'),
      keys: ['Delete', 'Backspace'],
      enabled,
      run: () => deleteSelected(store, state),
    },
    { id: 'edit.selectNothing', title: t('Select nothing'), keys: ['Escape'], run: () => state.select(null) },
    {
      id: 'edit.source',
      title: t('Edit the source of the model'),
      keys: ['Ctrl+E'],
      on: () => state.value.source !== null,
      run: () => toggleSource(store, state),
    },
  ];
}
