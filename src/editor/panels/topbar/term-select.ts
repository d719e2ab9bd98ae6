/** Which term of the selected material's model is shown: the whole model, or one function of it alone. */
import { findModel } from '../../../scene/models.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { selectField } from '../../ui/fields.ts';
import { tryEdit } from '../inspector/cell.ts';

const WHOLE = '';

export function createTermSelect({ store, state }: Session): HTMLElement {
  const field = selectField('Term', [], (value) => {
    const material = currentMaterial();
    tryEdit(store, value === WHOLE ? 'Show the whole model' : `Show ${value} alone`, (draft) => {
      draft.view.term = value === WHOLE || !material ? null : { material, name: value };
    });
  });

  /** The one that is looked at, else the one that is selected, else the first. */
  const currentMaterial = (): string | undefined => {
    const { document } = store;
    const { selection } = state.value;
    if (document.view.term) return document.view.term.material;
    if (selection?.kind === 'materials') return selection.id;
    const object = selection?.kind === 'objects' ? document.objects[selection.id] : undefined;
    return object?.material ?? Object.keys(document.materials)[0];
  };

  const update = () => {
    const { document } = store;
    const id = currentMaterial();
    const material = id === undefined ? undefined : document.materials[id];
    const terms = material ? (findModel(document, material.model)?.terms ?? []) : [];
    const parts = terms.filter((term) => term !== 'BRDF');
    field.setChoices([
      { value: WHOLE, label: 'Whole model' },
      ...parts.map((value) => ({
        value,
        label: value,
        ...(material && { group: `${material.name} · ${material.model}` }),
      })),
    ]);
    field.show(document.view.term?.name ?? WHOLE);
    element.classList.toggle('on', document.view.term !== null);
  };

  const element = h(
    'label',
    { class: 'term-select', tip: 'Look at one term of the selected material’s model alone' },
    h('span', {}, 'Term'),
    field.element,
  );
  store.subscribe(update);
  state.subscribe((now, before) => {
    if (now.selection !== before.selection) update();
  });
  update();
  return element;
}
