/** A dialog with a title and a button that closes it. The focus goes back to where it was. */
import { t } from '../language/language.ts';
import { type Child, h } from './dom.ts';
import { icon } from './icons.ts';

export interface DialogOptions {
  title: string;
  class: string;
  /** Beside the title. */
  tools?: readonly Child[];
  onClose?(): void;
}

export function openDialog(options: DialogOptions, ...content: Child[]): HTMLDialogElement {
  const close = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': t('Close'), tip: t('Close (Esc)') },
    icon('close'),
  );
  const dialog = h(
    'dialog',
    { class: `window ${options.class}`, 'aria-label': options.title },
    h('header', {}, h('h1', {}, options.title), ...(options.tools ?? []), close),
    ...content,
  );
  close.addEventListener('click', () => dialog.close());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  dialog.addEventListener('close', () => {
    dialog.remove();
    options.onClose?.();
  });
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}
