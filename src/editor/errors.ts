/** What nobody expected still reaches the person: never a blank page, never silence. */

import { t } from './language/language.ts';
import { h } from './ui/dom.ts';
import { icon } from './ui/icons.ts';
import { messageOf, toastError } from './ui/toast.ts';

export function installErrorReports(): void {
  window.addEventListener('error', (event) => {
    // Chrome reports this when a panel changes size while it is being measured; nothing is wrong.
    if (event.message.startsWith('ResizeObserver loop')) return;
    toastError(t('Something went wrong in the page'), event.error ?? event.message);
  });
  window.addEventListener('unhandledrejection', (event) => {
    toastError(t('Something went wrong in the page'), event.reason);
  });
}

/** In place of the picture, when neither WebGPU nor WebGL 2 can be had. */
export function showStartFailure(viewport: HTMLElement, error: unknown): void {
  viewport.querySelector('.loading')?.remove();
  viewport.append(
    h(
      'div',
      { class: 'failure', role: 'alert' },
      icon('warning'),
      h('h1', {}, t('This browser gave no way to render')),
      h(
        'p',
        {},
        t(
          'Irradia needs WebGPU or WebGL 2. Update the browser, switch on “Use graphics acceleration when available” in its settings, or try another one. Scenes can still be opened, edited and saved here.',
        ),
      ),
      h('p', {}, messageOf(error)),
    ),
  );
}
