/**
 * Which term of a material's model is shown: the whole model, or one function of it alone. Offered are
 * the terms of the selected material, and of the one that is looked at already.
 */
import { findModel } from '../../../scene/models.ts';
import { t } from '../../language/language.ts';
import { termLabel } from '../../language/terms.ts';
import { selectedMaterial } from '../../selected-material.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { type Choice, selectField } from '../../ui/fields.ts';
import { tryEdit } from '../inspector/cell.ts';

const WHOLE: Choice = { value: '', label: t('Whole model') };

/** Ids and names of terms have no spaces. */
const choiceOf = (term: { material: string; name: string } | null) =>
  term ? `${term.material} ${term.name}` : WHOLE.value;

export function createTermSelect({ store, state }: Session): HTMLElement {
  const field = selectField(t('Term'), [], (value) => {
    const [material, name] = value.split(' ');
    tryEdit(store, name ? t('Show {name} alone', { name }) : t('Show the whole model'), (draft) => {
      draft.view.term = material && name ? { material, name } : null;
    });
  });

  const termsOf = (id: string): Choice[] => {
    const material = store.document.materials[id];
    const terms = material ? (findModel(store.document, material.model)?.terms ?? []) : [];
    return terms
      .filter((name) => name !== 'BRDF')
      .map((name) => ({
        value: choiceOf({ material: id, name }),
        label: termLabel(name),
        ...(material && { group: `${material.name} · ${material.model}` }),
      }));
  };

  const update = () => {
    const { term } = store.document.view;
    const ids = new Set(
      [selectedMaterial(store.document, state.value.selection), term?.material].filter(
        (id) => id !== undefined,
      ),
    );
    field.setChoices([WHOLE, ...[...ids].flatMap(termsOf)]);
    field.show(choiceOf(term));
    element.classList.toggle('on', term !== null);
  };

  const element = h(
    'label',
    { class: 'term-select', tip: t('Look at one term of the selected material’s model alone') },
    h('span', {}, t('Term')),
    field.element,
  );
  store.subscribe(update);
  state.subscribe((now, before) => {
    if (now.selection !== before.selection) update();
  });
  update();
  return element;
}
