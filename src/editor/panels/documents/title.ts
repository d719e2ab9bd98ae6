/** The document's name in the top bar, and whether what was done to it is kept; opens the list of documents. */

import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { KeepState } from '../../storage/autosave.ts';
import { explainFailure } from '../../storage/failure.ts';
import { timeText } from '../../storage/workspace.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { openDocuments } from './documents.ts';

export function createTitle(session: Session): HTMLElement {
  const { store, workspace } = session;
  const name = h('span', { class: 'scene-name' });
  const mark = h('span', { class: 'keep-mark' });
  const button = h('button', { type: 'button', class: 'document-button' }, name, mark);
  button.addEventListener('click', () => void openDocuments(session));

  const showName = () => {
    name.textContent = store.document.name || t('Untitled');
    document.title = `${store.document.name} – Irradia`;
  };
  const showState = (state: KeepState) => {
    button.dataset.keep = state.kind;
    mark.replaceChildren(state.kind === 'failed' ? icon('warning') : markOf(state.kind));
    button.dataset.keys = 'file.documents';
    button.dataset.tip = `${tipOf(state)}\n${t('Documents and versions')}`;
  };
  store.subscribe(showName);
  workspace.subscribe(showState);
  showName();
  showState(workspace.keepState);
  return button;
}

const markOf = (kind: KeepState['kind']) => (kind === 'kept' ? t('kept') : kind === 'waiting' ? '•' : '');

function tipOf(state: KeepState): string {
  switch (state.kind) {
    case 'unchanged':
      return t('As it was opened');
    case 'waiting':
      return t('Being kept in this browser');
    case 'kept':
      return t('Kept in this browser {time}', { time: timeText(state.time) });
    case 'failed':
      return t('Not kept. {reason}', { reason: explainFailure(state.error) });
  }
}
