/** In the inspector of a material: what else there is for it. */
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';

export function materialButtons({ actions }: Session): HTMLElement[] {
  const button = (action: string, text: string, tip: string) => {
    const made = h('button', { type: 'button', class: 'text-button', tip, keys: action }, text);
    made.addEventListener('click', () => actions.run(action));
    return made;
  };
  return [
    button('material.library', t('Library'), t('Metals, glass, paints and others to start from')),
    button(
      'material.compare',
      t('Compare…'),
      t('Two materials or models on the same object, with a divider'),
    ),
    button('material.vary', t('Vary…'), t('Materials near this one, and between it and another')),
  ];
}
