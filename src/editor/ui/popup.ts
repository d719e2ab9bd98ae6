/** A panel that floats by its anchor, stays inside the window and closes on Escape or a click outside. */
import { h } from './dom.ts';

export interface PopupOptions {
  anchor: HTMLElement;
  content: HTMLElement;
  label: string;
  onClose?(): void;
}

let closeOpen: (() => void) | null = null;

export function openPopup(options: PopupOptions): () => void {
  closeOpen?.();
  const popup = h(
    'div',
    { class: 'popup', role: 'dialog', 'aria-label': options.label, tabindex: -1 },
    options.content,
  );
  document.body.append(popup);

  const anchor = options.anchor.getBoundingClientRect();
  const box = popup.getBoundingClientRect();
  const margin = 6;
  const below = anchor.bottom + 4;
  const top =
    below + box.height + margin <= innerHeight ? below : Math.max(margin, anchor.top - box.height - 4);
  popup.style.left = `${Math.max(margin, Math.min(anchor.left, innerWidth - box.width - margin))}px`;
  popup.style.top = `${top}px`;
  popup.focus({ preventScroll: true });

  const close = () => {
    if (closeOpen !== close) return;
    closeOpen = null;
    document.removeEventListener('pointerdown', outside, true);
    document.removeEventListener('keydown', onEscape, true);
    popup.remove();
    options.onClose?.();
  };
  const outside = (event: Event) => {
    if (event.target instanceof Node && !popup.contains(event.target)) close();
  };
  const onEscape = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    close();
    options.anchor.focus({ preventScroll: true });
  };
  document.addEventListener('pointerdown', outside, true);
  document.addEventListener('keydown', onEscape, true);
  closeOpen = close;
  return close;
}
