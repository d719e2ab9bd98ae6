/**
 * The inspector shows the fields of what is selected. It is built anew only when other fields are
 * needed; otherwise every field is updated in place, so that a slider survives its own drag. Until the new ones are there,
 * those of before cannot be used. A field that has the focus hands it to the one of its name.
 */
import { describeEntities } from '../../../scene/entity.ts';
import { geometryNames } from '../../../scene/geometry-schema.ts';
import { lightDefaults } from '../../../scene/light-schema.ts';
import type { Document } from '../../../scene/schema.ts';
import { renameEntity } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { Selection } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { textField } from '../../ui/fields.ts';
import { tabStops } from '../../ui/focus.ts';
import { Follower } from '../../ui/follower.ts';
import { tryEdit } from './cell.ts';
import { groupButton } from './group-button.ts';
import { lightPanel, lightStructure } from './light.ts';
import { manyPanel, manyStructure } from './many.ts';
import { materialPanel, materialStructure } from './material.ts';
import { objectPanel, objectStructure } from './object.ts';
import type { InspectorPanel } from './panel.ts';
import { scenePanel, sceneStructure } from './scene.ts';

export function createInspector(session: Session): HTMLElement {
  const { store, state } = session;
  const kind = h('span', { class: 'inspector-kind' });
  const name = textField(t('Name'), (value) => {
    const { selection } = state.value;
    if (selection) renameEntity(store, selection.kind, selection.id, value);
    else {
      tryEdit(store, t('Rename the scene'), (draft) => {
        draft.name = value;
      });
    }
  });
  const around = groupButton(session);
  const body = h('div', { class: 'inspector-body' });
  const element = h(
    'aside',
    { class: 'inspector', 'aria-label': t('Inspector') },
    h('header', { class: 'inspector-header' }, kind, name.element, around.element),
    body,
  );

  let panel: InspectorPanel | null = null;
  let structure = '';
  let returnFocus: (() => void) | null = null;
  const build = () => {
    body.inert = false;
    window.removeEventListener('keydown', onKey, true);
    const { selection } = state.value;
    const next = structureOf(session, selection);
    if (next === structure) {
      panel?.update();
      returnFocus?.();
      return;
    }
    const sameThing = structure.split(' ', 2).join() === next.split(' ', 2).join();
    const scroll = sameThing ? body.scrollTop : 0;
    structure = next;
    panel = panelFor(session, selection);
    panel.update();
    body.replaceChildren(panel.element);
    body.scrollTop = scroll;
    returnFocus?.();
  };
  // In a task of its own, once for all that changes in this one: what was chosen and a document that is opened.
  const building = new Follower(build, () => false);
  // Browsers put keys before tasks: on a busy page the keyboard would go through fields that are not there yet.
  const onKey = ({ key }: KeyboardEvent) => {
    if (key === 'Tab' || returnFocus || element.contains(document.activeElement)) building.now();
  };
  const update = () => {
    const { document } = store;
    const { selection, selected } = state.value;
    if (structureOf(session, selection) === structure) panel?.update();
    else {
      if (!body.inert) {
        returnFocus = focusReturn(body);
        window.addEventListener('keydown', onKey, true);
      }
      body.inert = true;
      building.soon();
    }
    const several = selected.length > 1;
    name.element.hidden = several;
    element.classList.toggle('several', several);
    around.update();
    if (several) kind.textContent = translate(describeEntities(document, selected));
    else kind.textContent = selection ? kindName(document, selection) : t('Scene');
    name.show(selection ? (document[selection.kind][selection.id]?.name ?? '') : document.name);
  };
  store.subscribe(() => {
    state.forget(store.document);
    update();
  });
  state.subscribe((now, before) => {
    if (now.selected !== before.selected || now.units !== before.units) update();
  });
  update();
  return element;
}

/** What puts the focus where it is now within a panel once that is made anew, if it has such a row and nothing else took the focus. */
function focusReturn(panel: HTMLElement): (() => void) | null {
  const focused = document.activeElement;
  const row = focused?.closest<HTMLElement>('[data-label]');
  if (!(focused instanceof HTMLElement && row && panel.contains(row))) return null;
  const at = tabStops(row).indexOf(focused);
  return () => {
    if (document.activeElement !== document.body) return;
    const rows = [...panel.querySelectorAll<HTMLElement>('[data-label]')];
    const again = rows.find(({ dataset }) => dataset.label === row.dataset.label);
    if (again) tabStops(again)[at]?.focus();
  };
}

function structureOf(session: Session, selection: Selection): string {
  const { document } = session.store;
  if (session.state.value.selected.length > 1) return `many ${manyStructure(session)}`;
  if (!selection) return `scene ${sceneStructure(document)}`;
  const { kind, id } = selection;
  if (kind === 'objects') return `objects ${objectStructure(document, id)}`;
  if (kind === 'materials') return `materials ${materialStructure(document, id)}`;
  return `lights ${lightStructure(session, id)}`;
}

function panelFor(session: Session, selection: Selection): InspectorPanel {
  if (session.state.value.selected.length > 1) return manyPanel(session);
  if (!selection) return scenePanel(session);
  switch (selection.kind) {
    case 'lights':
      return lightPanel(session, selection.id);
    case 'objects':
      return objectPanel(session, selection.id);
    case 'materials':
      return materialPanel(session, selection.id);
  }
}

function kindName(document: Document, { kind, id }: NonNullable<Selection>): string {
  const light = kind === 'lights' ? document.lights[id] : undefined;
  if (light) return translate(lightDefaults[light.type].name);
  const object = kind === 'objects' ? document.objects[id] : undefined;
  return object ? translate(geometryNames[object.geometry.type]) : t('Material');
}
