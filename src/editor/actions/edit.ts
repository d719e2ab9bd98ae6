/** What changes the document. */
import { toggleSource } from '../commands.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { Action } from './action.ts';

export function editActions(session: Session): Action[] {
  const { store, state } = session;
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
    {
      id: 'edit.source',
      title: t('Edit the source of the model'),
      keys: ['Ctrl+E'],
      on: () => state.value.source !== null,
      run: () => toggleSource(store, state),
    },
  ];
}
