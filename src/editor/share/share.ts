/** The dialog that hands over a link with the whole document, or says why it has to be a file. */
import { bytesText } from '../panels/documents/format.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { toast, toastError } from '../ui/toast.ts';
import { largestParts } from './contents.ts';
import { linkFor, MAX_ADDRESS } from './link.ts';

/** What the strictest of the chats in use lets through: Discord. */
const SHORT_MESSAGE = 2000;

export async function openShare(session: Session): Promise<void> {
  try {
    const address = `${location.origin}${location.pathname}${await linkFor(session.store.document)}`;
    showDialog(address.length <= MAX_ADDRESS ? linkParts(address) : tooLongParts(session, address.length));
  } catch (error) {
    toastError('There is no link for this document', error);
  }
}

function linkParts(address: string): HTMLElement[] {
  const field = h('input', {
    type: 'text',
    class: 'text-field',
    readonly: true,
    value: address,
    'aria-label': 'Link',
  });
  field.addEventListener('focus', () => field.select());
  const copy = h('button', { type: 'submit', class: 'text-button primary' }, icon('copy'), 'Copy link');
  copy.addEventListener('click', async (event) => {
    event.preventDefault();
    try {
      await navigator.clipboard.writeText(address);
      copy.closest('dialog')?.close();
      toast('success', 'The link is in the clipboard');
    } catch {
      // Not every browser or page may write there; the person can.
      field.focus();
      toast('info', 'Copy the marked link', 'This browser did not let the page do it.');
    }
  });
  const length = address.length.toLocaleString();
  return [
    h('h1', {}, 'Share as a link'),
    h(
      'p',
      {},
      'The link itself carries the whole document: objects, materials, lights, models and files. Nothing is uploaded.',
    ),
    h('div', { class: 'share-link' }, field, copy),
    h(
      'p',
      { class: 'hint' },
      `${length} characters.`,
      address.length > SHORT_MESSAGE
        ? ` Some chats cut messages at ${SHORT_MESSAGE.toLocaleString()}; for those, save a file.`
        : ' Short enough for any chat.',
    ),
  ];
}

function tooLongParts(session: Session, length: number): HTMLElement[] {
  const file = h(
    'button',
    { type: 'submit', class: 'text-button primary', value: 'file' },
    icon('save'),
    'Save as a file',
  );
  file.addEventListener('click', () => session.save());
  const parts = largestParts(session.store.document, 4);
  return [
    h('h1', {}, 'Too large for a link'),
    h(
      'p',
      {},
      `The link would have ${length.toLocaleString()} characters. Address bars take ${MAX_ADDRESS.toLocaleString()}, so it is ${(length - MAX_ADDRESS).toLocaleString()} too long.`,
    ),
    h(
      'ul',
      { class: 'share-parts' },
      ...parts.map(({ name, size }) => h('li', {}, h('span', {}, name), bytesText(size))),
    ),
    h('div', { class: 'popup-actions' }, file),
  ];
}

function showDialog(parts: readonly HTMLElement[]): void {
  const close = h(
    'button',
    { type: 'submit', class: 'icon-button share-close', 'aria-label': 'Close', tip: 'Close (Esc)' },
    icon('close'),
  );
  const dialog = h('dialog', { class: 'confirm share' }, h('form', { method: 'dialog' }, ...parts, close));
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  dialog.querySelector<HTMLElement>('.primary')?.focus();
}
