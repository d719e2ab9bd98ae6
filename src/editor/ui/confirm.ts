/** A question that has to be answered before something is lost. */

import { t } from '../language/language.ts';
import { h } from './dom.ts';

export function confirm(question: string, detail: string, yes: string): Promise<boolean> {
  return new Promise((resolve) => {
    const accept = h('button', { type: 'submit', class: 'text-button primary', value: 'yes' }, yes);
    const cancel = h('button', { type: 'submit', class: 'text-button', value: 'no' }, t('Cancel'));
    const form = h(
      'form',
      { method: 'dialog' },
      h('h1', {}, question),
      h('p', {}, detail),
      h('div', { class: 'popup-actions' }, cancel, accept),
    );
    const dialog = h('dialog', { class: 'confirm' }, form);
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue === 'yes');
    });
    document.body.append(dialog);
    dialog.showModal();
    accept.focus();
  });
}
