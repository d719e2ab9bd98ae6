/** Interactive, path traced, both side by side, or how they differ: a radio group. */

import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { type Rendering, renderings } from '../state.ts';
import { h } from '../ui/dom.ts';

const LABELS: Readonly<Record<Rendering, readonly [label: string, tip: string]>> = {
  interactive: [
    t('Interactive'),
    t('What the GPU draws at once: no shadows, no light from surface to surface'),
  ],
  traced: [t('Path traced'), t('Ground truth: light as it travels, sample by sample')],
  split: [t('Split'), t('Interactive at the left, path traced at the right of a divider')],
  difference: [t('Difference'), t('How different a person would find the two, pixel by pixel')],
};

export function createModeSwitch({ state }: Session): HTMLElement {
  const buttons = renderings.map((rendering) => {
    const [label, tip] = LABELS[rendering];
    const button = h('button', { type: 'button', role: 'radio', tip, keys: `view.${rendering}` }, label);
    button.addEventListener('click', () => state.set({ rendering }));
    return button;
  });
  const element = h(
    'div',
    { class: 'mode-switch', role: 'radiogroup', 'aria-label': t('Rendering') },
    ...buttons,
  );
  element.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const next = renderings.indexOf(state.value.rendering) + step;
    const rendering = renderings[(next + renderings.length) % renderings.length] as Rendering;
    state.set({ rendering });
    buttons[renderings.indexOf(rendering)]?.focus();
  });
  const show = () => {
    for (const [i, button] of buttons.entries()) {
      const chosen = renderings[i] === state.value.rendering;
      button.setAttribute('aria-checked', String(chosen));
      button.tabIndex = chosen ? 0 : -1;
    }
  };
  state.subscribe((now, before) => {
    if (now.rendering !== before.rendering) show();
  });
  show();
  return element;
}
