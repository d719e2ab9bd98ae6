/** What is being dragged from the library or from the outliner: the browser tells it to nobody before it is dropped. */
import type { Offer } from './chosen.ts';

export const DRAG_TYPE = 'application/x-irradia-material';

let dragged: Offer | null = null;

export const draggedOffer = (): Offer | null => dragged;

/** @param picture what follows the pointer */
export function startDrag(event: DragEvent, offer: Offer, title: string, picture?: HTMLElement): void {
  if (!event.dataTransfer) return;
  dragged = offer;
  event.dataTransfer.setData(DRAG_TYPE, title);
  event.dataTransfer.effectAllowed = 'copy';
  if (picture) {
    const { width, height } = picture.getBoundingClientRect();
    event.dataTransfer.setDragImage(picture, width / 2, height / 2);
  }
}

export function endDrag(): void {
  dragged = null;
}
