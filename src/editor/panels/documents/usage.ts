/** How much of the browser's storage is used, and whether the browser may clear it by itself. */

import { plural, t } from '../../language/language.ts';
import type { KeptDocument } from '../../storage/kept-documents.ts';
import { h } from '../../ui/dom.ts';
import { toast } from '../../ui/toast.ts';
import { bytesText } from './format.ts';

export function createUsage(): {
  element: HTMLElement;
  refresh(kept: readonly KeptDocument[]): Promise<void>;
} {
  const text = h('span');
  const ask = h(
    'button',
    {
      type: 'button',
      class: 'text-button',
      hidden: true,
      tip: t('A browser may clear what pages have stored when the disk is full, unless it is asked not to'),
    },
    t('Protect from clearing'),
  );
  const element = h('footer', { class: 'documents-usage' }, text, ask);

  ask.addEventListener('click', async () => {
    const granted = await navigator.storage.persist();
    if (granted) ask.hidden = true;
    else
      toast(
        'info',
        t('The browser did not agree'),
        t('Some do once the page is installed or bookmarked. Files that you save are always yours.'),
      );
  });

  return {
    element,
    async refresh(kept) {
      const { usage = 0, quota = 0 } = await navigator.storage.estimate();
      const documents = plural(kept.length, '1 document', '{count} documents');
      text.textContent = t('{documents} in this browser · {usage} of {quota} used', {
        documents,
        usage: bytesText(usage),
        quota: bytesText(quota),
      });
      ask.hidden = kept.length === 0 || (await navigator.storage.persisted());
    },
  };
}
