/** A panel that floats by its anchor, stays inside the window and closes on Escape or a click outside. */
import { h } from './dom.ts';
import { keepTabWithin } from './focus.ts';

export interface PopupOptions {
  anchor: HTMLElement;
  content: HTMLElement;
  label: string;
  /** Of the panel; none where the content says what it is. */
  role?: 'dialog' | 'none';
  onClose?(): void;
}

const MARGIN = 6;

let closeOpen: (() => void) | null = null;

/** @returns closes it; the focus goes back to the anchor if it was inside */
export function openPopup(options: PopupOptions): () => void {
  closeOpen?.();
  const { anchor, role = 'dialog' } = options;
  const popup = h(
    'div',
    { class: 'popup', role, tabindex: -1, ...(role === 'dialog' && { 'aria-label': options.label }) },
    options.content,
  );
  // Nothing outside an open dialog can be reached.
  (anchor.closest('dialog') ?? document.body).append(popup);
  // What it shows may come later than itself.
  const sized = new ResizeObserver(() => place(popup, anchor));
  sized.observe(popup);
  place(popup, anchor);
  popup.focus({ preventScroll: true });
  keepTabWithin(popup);

  const close = () => {
    if (closeOpen !== close) return;
    closeOpen = null;
    document.removeEventListener('pointerdown', outside, true);
    document.removeEventListener('keydown', onEscape, true);
    const hadFocus = popup.contains(document.activeElement);
    sized.disconnect();
    popup.remove();
    options.onClose?.();
    if (hadFocus) anchor.focus({ preventScroll: true });
  };
  const outside = (event: Event) => {
    if (!(event.target instanceof Node) || popup.contains(event.target)) return;
    // The focus goes where the pointer is.
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    close();
  };
  const onEscape = (event: KeyboardEvent) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    event.preventDefault();
    close();
  };
  document.addEventListener('pointerdown', outside, true);
  document.addEventListener('keydown', onEscape, true);
  closeOpen = close;
  return close;
}

function place(popup: HTMLElement, anchor: HTMLElement): void {
  const at = anchor.getBoundingClientRect();
  const box = popup.getBoundingClientRect();
  const below = at.bottom + 4;
  const top = below + box.height + MARGIN <= innerHeight ? below : Math.max(MARGIN, at.top - box.height - 4);
  popup.style.left = `${Math.max(MARGIN, Math.min(at.left, innerWidth - box.width - MARGIN))}px`;
  popup.style.top = `${top}px`;
}
