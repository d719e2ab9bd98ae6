/** The dialog that hands over a link with the whole document, or says why it has to be a file. */

import { language, t } from '../language/language.ts';
import { bytesText } from '../panels/documents/format.ts';
import type { Session } from '../session.ts';
import { linkOf } from '../storage/document-work.ts';
import { h } from '../ui/dom.ts';
import { icon } from '../ui/icons.ts';
import { toast, toastError } from '../ui/toast.ts';
import { largestParts } from './contents.ts';
import { MAX_ADDRESS } from './link.ts';

/** What the strictest of the chats in use lets through: Discord. */
const SHORT_MESSAGE = 2000;

export async function openShare(session: Session): Promise<void> {
  try {
    const address = `${location.origin}${location.pathname}${await linkOf(session.store.document)}`;
    showDialog(address.length <= MAX_ADDRESS ? linkParts(address) : tooLongParts(session, address.length));
  } catch (error) {
    toastError(t('There is no link for this document'), error);
  }
}

function linkParts(address: string): HTMLElement[] {
  const field = h('input', {
    type: 'text',
    class: 'text-field',
    readonly: true,
    value: address,
    'aria-label': t('Link'),
  });
  field.addEventListener('focus', () => field.select());
  const copy = h('button', { type: 'submit', class: 'text-button primary' }, icon('copy'), t('Copy link'));
  copy.addEventListener('click', async (event) => {
    event.preventDefault();
    try {
      await navigator.clipboard.writeText(address);
      copy.closest('dialog')?.close();
      toast('success', t('The link is in the clipboard'));
    } catch {
      // Not every browser or page may write there; the person can.
      field.focus();
      toast('info', t('Copy the marked link'), t('This browser did not let the page do it.'));
    }
  });
  const length = address.length.toLocaleString(language);
  return [
    h('h1', {}, t('Share as a link')),
    h(
      'p',
      {},
      t(
        'The link itself carries the whole document: objects, materials, lights, models and files. Nothing is uploaded.',
      ),
    ),
    h('div', { class: 'share-link' }, field, copy),
    h(
      'p',
      { class: 'hint' },
      `${t('{length} characters.', { length })} `,
      address.length > SHORT_MESSAGE
        ? t('Some chats cut messages at {most}; for those, save a file.', {
            most: SHORT_MESSAGE.toLocaleString(language),
          })
        : t('Short enough for any chat.'),
    ),
  ];
}

function tooLongParts(session: Session, length: number): HTMLElement[] {
  const file = h(
    'button',
    { type: 'submit', class: 'text-button primary', value: 'file' },
    icon('save'),
    t('Save as a file'),
  );
  file.addEventListener('click', () => session.save());
  const parts = largestParts(session.store.document, 4);
  return [
    h('h1', {}, t('Too large for a link')),
    h(
      'p',
      {},
      t('The link would have {length} characters. Address bars take {most}, so it is {excess} too long.', {
        length: length.toLocaleString(language),
        most: MAX_ADDRESS.toLocaleString(language),
        excess: (length - MAX_ADDRESS).toLocaleString(language),
      }),
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
    { type: 'submit', class: 'icon-button share-close', 'aria-label': t('Close'), tip: t('Close (Esc)') },
    icon('close'),
  );
  const dialog = h('dialog', { class: 'confirm share' }, h('form', { method: 'dialog' }, ...parts, close));
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  dialog.querySelector<HTMLElement>('.primary')?.focus();
}
