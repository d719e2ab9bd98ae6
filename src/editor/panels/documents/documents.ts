/** The documents that the browser keeps: a dialog with their pictures and, for the chosen one, its versions. */

import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { KeptDocument, KeptDocuments } from '../../storage/kept-documents.ts';
import { heldDocuments } from '../../storage/session-record.ts';
import { openDialog } from '../../ui/dialog.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { toast, toastError } from '../../ui/toast.ts';
import { createCard, showPicture } from './card.ts';
import { createDetail } from './detail.ts';
import { createUsage } from './usage.ts';

export interface DocumentsContext {
  readonly session: Session;
  readonly storage: KeptDocuments;
  /** Shows what is kept now. */
  refresh(): Promise<void>;
  close(): void;
}

export async function openDocuments(session: Session): Promise<void> {
  const { workspace } = session;
  const { storage } = workspace;
  if (!storage) {
    toast('error', t('This browser or window keeps no documents'), t('Save to a file before you leave.'));
    return;
  }
  const list = h('div', { class: 'document-list' });
  const detail = h('section', { class: 'document-detail' });
  const usage = createUsage();
  const urls: string[] = [];
  let chosen = workspace.kept?.id;
  let shown = 0;
  // What is on the page stays there while it is true: a click whose button is replaced before it ends does nothing.
  let [cardsShow, detailShows] = ['', ''];

  const context: DocumentsContext = { session, storage, refresh, close: () => dialog.close() };

  async function refresh(): Promise<void> {
    const turn = ++shown;
    const [documents, held] = await Promise.all([storage?.list() ?? [], heldDocuments()]);
    const pictures = await Promise.all(documents.map(({ id }) => storage?.thumbnail(id)));
    if (turn !== shown) return;
    if (!documents.some(({ id }) => id === chosen)) chosen = documents[0]?.id;
    const cardsToShow = JSON.stringify([documents, [...held], workspace.kept?.id]);
    if (cardsToShow !== cardsShow) {
      cardsShow = cardsToShow;
      showCards(documents, held);
    }
    for (const url of urls.splice(0)) URL.revokeObjectURL(url);
    for (const [i, picture] of pictures.entries()) {
      const card = list.children[i];
      if (!card || !picture) continue;
      const url = URL.createObjectURL(picture);
      urls.push(url);
      showPicture(card, url);
    }
    await showDetail(
      documents.find(({ id }) => id === chosen),
      held,
    );
    await usage.refresh(documents);
  }

  function showCards(documents: readonly KeptDocument[], held: ReadonlySet<string>): void {
    const focused = document.activeElement;
    const hadFocus = focused instanceof HTMLElement && list.contains(focused);
    const cards = documents.map((kept) => {
      const open = kept.id === workspace.kept?.id;
      const card = createCard(kept, {
        chosen: kept.id === chosen,
        state: open ? 'open' : held.has(kept.id) ? 'elsewhere' : null,
      });
      card.addEventListener('click', () => choose(kept));
      card.addEventListener('focus', () => chosen !== kept.id && choose(kept));
      card.addEventListener('dblclick', () => void openKept(kept));
      card.addEventListener('keydown', (event) => {
        if (event.key === 'Enter') void openKept(kept);
        else if (event.key.startsWith('Arrow')) step(card, event.key);
        else return;
        event.preventDefault();
      });
      return card;
    });
    list.replaceChildren(
      ...(cards.length > 0
        ? cards
        : [h('p', { class: 'hint' }, t('What you change is kept here by itself. There is nothing yet.'))]),
    );
    if (hadFocus) list.querySelector<HTMLElement>('[aria-current]')?.focus();
  }

  async function showDetail(kept: KeptDocument | undefined, held: ReadonlySet<string>): Promise<void> {
    const versions = kept && storage ? await storage.versions(kept.id) : [];
    const toShow = JSON.stringify([kept, kept?.file?.name, versions, [...held], workspace.kept?.id]);
    if (kept?.id !== chosen || toShow === detailShows) return;
    detailShows = toShow;
    detail.replaceChildren(...(kept ? createDetail(context, kept, { held, versions }) : []));
  }

  function choose(kept: KeptDocument): void {
    chosen = kept.id;
    for (const card of list.children) {
      if (card instanceof HTMLElement && card.dataset.document === chosen)
        card.setAttribute('aria-current', 'true');
      else card.removeAttribute('aria-current');
    }
    void heldDocuments().then((held) => showDetail(kept, held));
  }

  async function openKept(kept: KeptDocument): Promise<void> {
    dialog.close();
    await workspace.openKept(kept);
  }

  function step(card: HTMLElement, key: string): void {
    const cards = [...list.children];
    const columns = getComputedStyle(list).gridTemplateColumns.split(' ').length;
    const by = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -columns, ArrowDown: columns }[key] ?? 0;
    const next = cards[cards.indexOf(card) + by];
    if (next instanceof HTMLElement) next.focus();
  }

  const fresh = h('button', { type: 'button', class: 'text-button' }, icon('file'), t('New'));
  fresh.addEventListener('click', () => {
    dialog.close();
    session.newScene();
  });
  // Also what is brought back by an undo of its deletion.
  const unsubscribe = workspace.subscribe(() => void refresh());
  const dialog = openDialog(
    {
      title: t('Documents'),
      class: 'documents',
      tools: [fresh],
      onClose() {
        unsubscribe();
        for (const url of urls) URL.revokeObjectURL(url);
      },
    },
    h('div', { class: 'documents-body' }, list, detail),
    usage.element,
  );
  try {
    // Its picture may take a while, which is no reason not to show the dialog.
    await workspace.flush();
    await refresh();
    // Who was quicker keeps the field that is written in.
    if (!detail.contains(document.activeElement)) list.querySelector<HTMLElement>('[aria-current]')?.focus();
  } catch (error) {
    dialog.close();
    toastError(t('The documents could not be read'), error);
  }
}
