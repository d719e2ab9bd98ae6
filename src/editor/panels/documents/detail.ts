/** The chosen document: rename, open, duplicate, delete; and its versions. */
import { setField } from '../../../scene/commands.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { KeptDocument, Version } from '../../storage/kept-documents.ts';
import { whileHeld } from '../../storage/session-record.ts';
import { timeText } from '../../storage/workspace.ts';
import { h } from '../../ui/dom.ts';
import { type IconName, icon } from '../../ui/icons.ts';
import { toastError } from '../../ui/toast.ts';
import type { DocumentsContext } from './documents.ts';
import { createVersions } from './versions.ts';

export interface DetailState {
  /** The documents that pages have open. */
  readonly held: ReadonlySet<string>;
  /** Its versions. */
  readonly versions: readonly Version[];
}

export function createDetail(
  context: DocumentsContext,
  kept: KeptDocument,
  { held, versions }: DetailState,
): HTMLElement[] {
  const { session, storage, refresh, close } = context;
  const { workspace, store } = session;
  const isOpen = kept.id === workspace.kept?.id;
  const elsewhere = !isOpen && held.has(kept.id);

  const name = h('input', {
    type: 'text',
    class: 'text-field document-title',
    value: kept.name,
    maxlength: 200,
    disabled: elsewhere,
    'aria-label': t('Name of the document'),
  });
  name.addEventListener('change', () => {
    void run(t('Not renamed'), async () => {
      if (isOpen) {
        attempt(t('Not renamed'), () =>
          setField(store, ['name'], name.value, t('Rename to {name}', { name: name.value })),
        );
        store.endMerge();
        name.value = store.document.name;
        await workspace.flush();
      } else await whileHeld(kept.id, () => storage.rename(kept, name.value));
      await refresh();
    });
  });
  name.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') name.blur();
  });

  const open = action(t('Open'), 'folder', isOpen, async () => {
    close();
    await workspace.openKept(kept);
  });
  open.classList.add('primary');
  const duplicate = action(t('Duplicate'), 'copy', false, async () => {
    await storage.duplicate(kept, t('{name} copy', { name: kept.name.slice(0, 195) }));
    await refresh();
  });
  const remove = action(t('Delete'), 'trash', elsewhere, async () => {
    await workspace.delete(kept, async () => session.newScene());
    await refresh();
  });

  const facts = [
    t('Changed {time}', { time: timeText(kept.modified) }),
    t('begun {time}', { time: timeText(kept.created) }),
  ];
  if (kept.file) facts.push(t('Save writes {name}', { name: kept.file.name }));
  return [
    name,
    h('p', { class: 'document-facts' }, facts.join(' · ')),
    elsewhere ? h('p', { class: 'hint' }, t('Another tab has it open. Opening it here makes a copy.')) : null,
    h('div', { class: 'document-actions' }, open, duplicate, remove),
    createVersions(context, kept, versions),
  ].filter((part) => part !== null);
}

function action(
  label: string,
  name: IconName,
  disabled: boolean,
  what: () => Promise<void>,
): HTMLButtonElement {
  const button = h('button', { type: 'button', class: 'text-button', disabled }, icon(name), label);
  button.addEventListener('click', () => void run(t('{label} did not work', { label }), what));
  return button;
}

export async function run(failure: string, what: () => Promise<void>): Promise<void> {
  try {
    await what();
  } catch (error) {
    toastError(failure, error);
  }
}
