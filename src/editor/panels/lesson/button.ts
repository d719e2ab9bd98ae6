/** The lessons' place in the top bar. */
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';

export function createLearnButton({ actions }: Session): HTMLElement {
  const button = h(
    'button',
    {
      type: 'button',
      class: 'menu-button',
      tip: t('Lessons, from light to a complete material'),
      keys: 'learn.lessons',
    },
    t('Learn'),
  );
  button.addEventListener('click', () => actions.run('learn.lessons'));
  return button;
}
