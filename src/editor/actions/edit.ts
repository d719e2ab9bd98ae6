/** What changes the document. */
import { removeUnused } from '../../scene/commands.ts';
import { attempt, toggleSource } from '../commands.ts';
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { toastError } from '../ui/toast.ts';
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
      id: 'edit.history',
      title: t('History…'),
      keys: ['Ctrl+Alt+Z'],
      run: () => void openHistory(session),
    },
    {
      id: 'edit.source',
      title: t('Edit the source of the model'),
      keys: ['Ctrl+E'],
      on: () => state.value.source !== null,
      run: () => toggleSource(store, state),
    },
    {
      id: 'edit.removeUnused',
      title: t('Remove unused materials and files'),
      run: () => attempt(t('Nothing was removed'), () => removeUnused(store)),
    },
  ];
}

async function openHistory(session: Session): Promise<void> {
  const anchor = document.querySelector<HTMLElement>('[data-action="undo"]') ?? document.body;
  try {
    (await import('../panels/history/history.ts')).openHistory(session, anchor);
  } catch (error) {
    toastError(t('This part of the page did not come'), error);
  }
}
