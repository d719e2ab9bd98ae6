/** The line between the two renderings. */

import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { splitLine } from '../ui/split-line.ts';
import type { PathTracing } from './path-tracing.ts';

export function createDivider({ state }: Session, tracing: PathTracing): HTMLElement {
  const line = splitLine(t('Divider between the interactive and the path traced picture'), (divider) =>
    state.set({ divider }),
  );
  const right = h('span', { class: 'split-label right' });
  const element = h(
    'div',
    { class: 'split', hidden: true },
    h('span', { class: 'split-label left' }, t('Interactive')),
    right,
    line.element,
  );
  const show = () => {
    const { rendering, divider } = state.value;
    element.hidden = rendering !== 'split';
    line.show(divider);
    right.textContent = tracing.texture ? t('Path traced') : t('Path traced: not yet');
  };
  state.subscribe((now, before) => {
    if (now.rendering !== before.rendering || now.divider !== before.divider) show();
  });
  tracing.subscribe(show);
  show();
  return element;
}
