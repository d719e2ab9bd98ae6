/**
 * The library of materials: a column between the picture and the inspector, with a picture of each material. It is
 * loaded when it is opened first.
 */

import { materialLibrary } from '../../../analysis/library/library.ts';
import { endComparison } from '../../compare/ending.ts';
import { startComparison } from '../../compare/start.ts';
import { t } from '../../language/language.ts';
import { selectedMaterial } from '../../selected-material.ts';
import type { Session } from '../../session.ts';
import type { OwnEntry } from '../../storage/material-library.ts';
import { arrange, h } from '../../ui/dom.ts';
import { selectField } from '../../ui/fields.ts';
import { iconButton } from '../../ui/icon-button.ts';
import { toast } from '../../ui/toast.ts';
import { type Card, createCard, type JobOf } from './card.ts';
import { addToScene, giveToSelected, keyOfOffer, type Offer } from './chosen.ts';
import { detailOf } from './detail.ts';
import { endDrag } from './drag.ts';
import { gridMove } from './grid-keys.ts';
import { addOwn, exportOwn, importOwn, removeOwn } from './own.ts';
import { allSections, sectionsOf } from './sections.ts';
import type { Thumbnails } from './thumbnails.ts';

export interface LibraryPanel {
  readonly element: HTMLElement;
  readonly isOpen: boolean;
  open(): void;
  close(): void;
  /** Puts a material of the scene into the person's own library. */
  keep(id: string): Promise<void>;
}

/** A section of the list. */
interface Part {
  readonly head: HTMLElement;
  readonly count: HTMLElement;
  readonly grid: HTMLElement;
}

/** After an edit of the scene, before its pictures are made anew, ms. */
const REST_MS = 250;

export function createLibrary(session: Session, thumbnails: Thumbnails, jobOf: JobOf): LibraryPanel {
  const { store, state } = session;
  let own: OwnEntry[] = [];
  let only = '';
  let focused: Offer | null = null;
  const cards = new Map<string, Card>();
  const parts = new Map<string, Part>();
  const nothing = h('p', { class: 'hint' }, t('No material is called that.'));

  const search = h('input', {
    type: 'search',
    class: 'text-field',
    placeholder: t('Search'),
    'aria-label': t('Search the materials'),
    spellcheck: 'false',
  });
  const category = selectField(t('Category'), [], (value) => {
    only = value;
    build();
    list.scrollTop = 0;
  });
  const list = h('div', { class: 'library-list', role: 'listbox', 'aria-label': t('Materials') });
  const detail = h('div', { class: 'library-detail' });
  const progress = h('progress', { max: 1, value: 0, hidden: true, 'aria-label': t('Pictures are made') });
  const element = h(
    'section',
    { class: 'library', 'aria-label': t('Library of materials'), hidden: true },
    h(
      'header',
      { class: 'library-head' },
      h('strong', {}, t('Materials')),
      h('span', { class: 'spacer' }),
      iconButton('folder', t('Add a material’s file to My library'), () => void importFiles()),
      iconButton('close', t('Close the library'), close, { keys: 'material.library' }),
    ),
    h('div', { class: 'library-filter' }, search, category.element),
    progress,
    list,
    detail,
  );

  const near = new Set<string>();
  const seen = new IntersectionObserver(
    (changes) => {
      for (const { target, isIntersecting } of changes) {
        const key = cards.get((target as HTMLElement).dataset.material ?? '')?.pictureKey;
        if (!key) continue;
        if (isIntersecting) near.add(key);
        else near.delete(key);
      }
      thumbnails.hasten(near);
    },
    { root: list, rootMargin: '100px' },
  );

  const partOf = (key: string, title: string): Part => {
    const known = parts.get(key);
    if (known) return known;
    const count = h('span', { class: 'count' });
    const part: Part = {
      // The group below has the same name.
      head: h('h2', { 'aria-hidden': 'true' }, title, count),
      count,
      grid: h('div', { class: 'library-grid', role: 'group', 'aria-label': title, 'data-section': key }),
    };
    parts.set(key, part);
    return part;
  };

  function build(): void {
    const sections = sectionsOf(store.document, own, { query: search.value, only });
    const wanted = new Set<string>();
    const shown = sections.flatMap(({ key, title, offers }) => {
      const { head, count, grid } = partOf(key, title);
      count.textContent = String(offers.length);
      const elements = offers.map((offer) => {
        const name = keyOfOffer(offer);
        wanted.add(name);
        const known = cards.get(name);
        const card = known ?? createCard(offer, thumbnails, jobOf);
        if (!known) seen.observe(card.element);
        cards.set(name, card);
        card.show(store.document);
        return card.element;
      });
      arrange(grid, elements);
      return [head, grid];
    });
    arrange(list, sections.length > 0 ? shown : [nothing]);
    for (const [name, card] of cards) {
      if (!name.startsWith('scene') || wanted.has(name)) continue;
      seen.unobserve(card.element);
      cards.delete(name);
    }
    if (focused && !wanted.has(keyOfOffer(focused))) focused = null;
    mark();
  }

  /** Which card the keys are on; always one, so that Tab leads there. */
  function mark(): void {
    const all = [...list.querySelectorAll<HTMLElement>('.material-card')];
    const chosen = focused && keyOfOffer(focused);
    for (const element of all) {
      const isChosen = element.dataset.material === chosen;
      element.setAttribute('aria-selected', String(isChosen));
      element.tabIndex = isChosen ? 0 : -1;
    }
    if (!chosen && all[0]) all[0].tabIndex = 0;
    detail.replaceChildren(...detailOf(session, focused, actions));
  }

  function choose(offer: Offer): void {
    focused = offer;
    mark();
  }

  const actions = {
    give(offer: Offer): void {
      if (giveToSelected(session, offer)) return;
      toast(
        'info',
        t('Nothing is selected'),
        t('Select an object or a material, or drag it onto an object.'),
      );
    },
    add(offer: Offer): void {
      const id = addToScene(session, offer);
      if (id !== undefined) state.select({ kind: 'materials', id });
    },
    compare(offer: Offer): void {
      const id = selectedMaterial(store.document, state.value.selection);
      if (id !== undefined) startComparison(session, id, offer);
    },
    keep: (offer: Offer): void => {
      if (offer.kind === 'scene') void keep(offer.id);
    },
    save(offer: Offer): void {
      if (offer.kind === 'own') exportOwn(offer.entry);
    },
    remove(offer: Offer): void {
      if (offer.kind === 'own') void removeOwn(thumbnails, offer.entry, refresh);
    },
  };

  async function refresh(): Promise<void> {
    own = (await (await thumbnails.storage())?.entries()) ?? [];
    category.setChoices([
      { value: '', label: t('All categories') },
      ...allSections(store.document, own).map(({ key, title }) => ({ value: key, label: title })),
    ]);
    category.show(only);
    build();
  }

  async function keep(id: string): Promise<void> {
    if (await addOwn(thumbnails, store.document, id)) await refresh();
  }

  async function importFiles(): Promise<void> {
    if (await importOwn(thumbnails, await session.chooseFiles('.json', true))) await refresh();
  }

  function open(): void {
    session.closeSheet();
    element.hidden = false;
    void refresh();
    search.focus({ preventScroll: true });
  }

  function close(): void {
    element.hidden = true;
  }

  search.addEventListener('input', build);
  search.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && state.value.comparison) endComparison(state);
    else if (event.key === 'ArrowDown') list.querySelector<HTMLElement>('.material-card')?.focus();
    else if (event.key !== 'Escape') return;
    else if (search.value) {
      search.value = '';
      build();
    } else close();
    event.preventDefault();
    event.stopPropagation();
  });
  const offerOf = (event: Event): Offer | undefined => {
    const card = event.target instanceof Element ? event.target.closest('.material-card') : null;
    return card instanceof HTMLElement ? cards.get(card.dataset.material ?? '')?.offer : undefined;
  };
  list.addEventListener('focusin', (event) => {
    const offer = offerOf(event);
    if (offer && (!focused || keyOfOffer(offer) !== keyOfOffer(focused))) choose(offer);
  });
  list.addEventListener('click', (event) => {
    const offer = offerOf(event);
    if (!offer) return;
    choose(offer);
    // What is looked at need not be anybody's: a click is no demand then.
    if (state.value.selected.some(({ kind }) => kind !== 'lights')) actions.give(offer);
  });
  list.addEventListener('dblclick', (event) => {
    const offer = offerOf(event);
    if (offer && !state.value.selected.some(({ kind }) => kind !== 'lights') && offer.kind !== 'scene')
      actions.add(offer);
  });
  list.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      // What is over the picture goes first, by the page's own shortcut.
      if (state.value.comparison) return;
      event.stopPropagation();
      search.focus();
    } else if (gridMove(list, event)) event.preventDefault();
  });
  list.addEventListener('dragend', endDrag);

  let timer = 0;
  const later = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => !element.hidden && build(), REST_MS);
  };
  store.subscribe(({ document, previous }) => {
    if (document.materials !== previous.materials || document.models !== previous.models) later();
  });
  /** Once it is known which pictures there are, those that are kept beside them can go. */
  const prune = () => {
    const kept = [...cards.values()].filter(({ offer }) => offer.kind !== 'scene');
    if (kept.length < materialLibrary.size + own.length) return;
    const keys = kept.flatMap(({ pictureKey }) => pictureKey ?? []);
    void thumbnails
      .storage()
      .then((storage) => storage?.prunePictures(new Set(keys)))
      .catch(() => {
        // They only take room; the next session tries again.
      });
  };
  let begun = 0;
  thumbnails.onProgress = (done, left) => {
    if (left === 0) {
      begun = done;
      prune();
    }
    progress.hidden = left < 4;
    progress.value = left === 0 ? 1 : (done - begun) / (done - begun + left);
  };

  return {
    element,
    get isOpen() {
      return !element.hidden;
    },
    open,
    close,
    keep,
  };
}
