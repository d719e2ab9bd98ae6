/** A document in the list: its picture, name, age and size. */

import { t } from '../../language/language.ts';
import type { KeptDocument } from '../../storage/kept-documents.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { agoText, bytesText } from './format.ts';

export interface CardState {
  readonly chosen: boolean;
  /** Here, in another tab, or nowhere. */
  readonly state: 'open' | 'elsewhere' | null;
}

const BADGES = { open: t('open'), elsewhere: t('in another tab') };

/** Without its picture, which showPicture() puts there. */
export function createCard(kept: KeptDocument, { chosen, state }: CardState): HTMLButtonElement {
  const card = h(
    'button',
    { type: 'button', class: 'document-card', ...(chosen && { 'aria-current': 'true' }) },
    h(
      'span',
      { class: 'document-picture' },
      icon('scene'),
      state ? h('span', { class: 'badge' }, BADGES[state]) : null,
    ),
    h('span', { class: 'document-name' }, kept.name || t('Untitled')),
    h('span', { class: 'document-facts' }, `${agoText(kept.modified)} · ${bytesText(sizeOf(kept))}`),
  );
  card.dataset.document = kept.id;
  return card;
}

export function showPicture(card: Element, url: string): void {
  const picture = card.querySelector('.document-picture > :is(img, svg)');
  picture?.replaceWith(h('img', { src: url, alt: '', draggable: 'false' }));
}

/** Its own part; versions and what it shares with others left aside. */
export function sizeOf({ textSize, changesSize, assetsSize }: KeptDocument): number {
  return textSize + changesSize + assetsSize;
}
