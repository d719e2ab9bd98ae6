/** Below the grid: what the chosen material is, where its values come from, and what can be done with it. */
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { type IconName, icon } from '../../ui/icons.ts';
import { contentOf, type Offer, titleOf } from './chosen.ts';

export interface DetailActions {
  give(offer: Offer): void;
  add(offer: Offer): void;
  compare(offer: Offer): void;
  keep(offer: Offer): void;
  save(offer: Offer): void;
  remove(offer: Offer): void;
}

export function detailOf({ store }: Session, offer: Offer | null, actions: DetailActions): Node[] {
  if (!offer)
    return [
      h(
        'p',
        { class: 'hint' },
        t('A click gives a material to what is selected. Or drag it onto an object of the picture.'),
      ),
    ];
  const { document } = store;
  const button = (text: string, tip: string, run: () => void, name?: IconName) => {
    const made = h('button', { type: 'button', class: 'text-button', tip }, name && icon(name), text);
    made.addEventListener('click', run);
    return made;
  };
  let model = '';
  try {
    model = contentOf(offer, document)?.material.model ?? '';
  } catch {
    model = t('It can no longer be read');
  }
  const source =
    offer.kind === 'library'
      ? translate(offer.entry.source)
      : offer.kind === 'own'
        ? t('Kept in this browser on {date}', { date: new Date(offer.entry.added).toLocaleDateString() })
        : t('A material of this scene');
  return [
    h(
      'div',
      { class: 'library-about' },
      h('strong', {}, titleOf(offer, document)),
      h('span', { class: 'library-model' }, model),
    ),
    h('p', { class: 'library-source' }, source),
    h(
      'div',
      { class: 'library-actions' },
      button(t('Assign'), t('Give it to what is selected (Enter)'), () => actions.give(offer)),
      offer.kind !== 'scene' &&
        button(t('Add'), t('Add it to the materials of the scene'), () => actions.add(offer)),
      button(t('Compare'), t('Beside the selected material, with a divider in the picture'), () =>
        actions.compare(offer),
      ),
      h('span', { class: 'spacer' }),
      offer.kind === 'scene' &&
        button(t('Keep'), t('Put a copy into My library, which this browser keeps'), () =>
          actions.keep(offer),
        ),
      offer.kind === 'own' && button(t('Export'), t('Save it as a file'), () => actions.save(offer), 'save'),
      offer.kind === 'own' &&
        button(t('Delete'), t('Delete it from My library'), () => actions.remove(offer), 'trash'),
    ),
  ];
}
