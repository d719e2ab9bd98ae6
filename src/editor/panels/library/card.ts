/** One material of the grid: its picture and its name. */
import type { Document } from '../../../scene/schema.ts';
import { h } from '../../ui/dom.ts';
import { keyOfOffer, type Offer, titleOf } from './chosen.ts';
import { startDrag } from './drag.ts';
import { keyOf, type ThumbnailJob } from './thumbnail-job.ts';
import { drawThumbnail, type Thumbnails, thumbnailCanvas } from './thumbnails.ts';

/** Pixels of a picture's side: sharp on a screen of twice as many as it has room for. */
export const PICTURE_SIZE = 128;

export interface Card {
  readonly element: HTMLElement;
  readonly offer: Offer;
  /** Of the picture that is shown or waited for. */
  readonly pictureKey: string | null;
  /** Name and picture as they are now. */
  show(document: Document): void;
}

/** What an offer's picture is made of; null where it has none. */
export type JobOf = (offer: Offer) => ThumbnailJob | null;

export function createCard(offer: Offer, thumbnails: Thumbnails, jobOf: JobOf): Card {
  const picture = thumbnailCanvas(PICTURE_SIZE);
  const name = h('span', { class: 'material-name' });
  const element = h(
    'button',
    { type: 'button', class: 'material-card', role: 'option', draggable: 'true', tabindex: -1 },
    picture,
    name,
  );
  element.dataset.material = keyOfOffer(offer);
  element.addEventListener('dragstart', (event) => startDrag(event, offer, name.textContent ?? '', picture));
  let shown: string | null = null;
  return {
    element,
    offer,
    get pictureKey() {
      return shown;
    },
    show(document) {
      const title = titleOf(offer, document);
      if (name.textContent !== title) {
        name.textContent = title;
        element.title = title;
      }
      const job = jobOf(offer);
      const key = job && keyOf(job, PICTURE_SIZE);
      if (key === shown) return;
      shown = key;
      if (!job) drawThumbnail(picture, null);
      else
        void thumbnails.picture(job, PICTURE_SIZE, offer.kind !== 'scene').then((pixels) => {
          if (shown === key) drawThumbnail(picture, pixels);
        });
    },
  };
}
