/** The outliner: everything in the document by name; select, rename, hide, delete. */
import type { Document } from '../../../scene/schema.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { EntityKind, Selection } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { type IconName, icon, isIcon } from '../../ui/icons.ts';
import { createRow, type OutlinerRow } from './row.ts';

const GROUPS: readonly { kind: EntityKind; title: string }[] = [
  { kind: 'lights', title: t('Lights') },
  { kind: 'objects', title: t('Objects') },
  { kind: 'materials', title: t('Materials') },
];

export interface Outliner {
  readonly element: HTMLElement;
  /** Opens the name of what is selected for typing. */
  renameSelected(): void;
}

export function createOutliner(session: Session): Outliner {
  const { store, state } = session;
  const rows = new Map<string, OutlinerRow>();
  const sceneRow = h(
    'button',
    { type: 'button', class: 'outliner-row scene-row', tip: t('Camera, environment and view') },
    icon('scene'),
    h('span', { class: 'name' }, t('Scene')),
  );
  sceneRow.addEventListener('click', () => state.select(null));

  const lists = GROUPS.map(({ kind, title }) => {
    const count = h('span', { class: 'count' });
    const list = h('div', { class: 'outliner-list', role: 'listbox', 'aria-label': title });
    const heading = h('summary', {}, title, count);
    return {
      kind,
      list,
      count,
      element: h('details', { class: 'outliner-group', open: true }, heading, list),
    };
  });
  const element = h(
    'nav',
    { class: 'outliner', 'aria-label': t('Outliner') },
    sceneRow,
    ...lists.map((list) => list.element),
  );

  const update = (document: Document, previous: Document | null) => {
    for (const { kind, list, count } of lists) {
      const entities = document[kind];
      if (previous && entities === previous[kind]) continue;
      count.textContent = String(Object.keys(entities).length);
      let before: Element | null = list.firstElementChild;
      for (const [id, entity] of Object.entries(entities)) {
        const key = `${kind} ${id}`;
        let row = rows.get(key);
        if (!row) {
          row = createRow(session, kind, id);
          rows.set(key, row);
        }
        row.show(entity.name, iconOf(document, kind, id), 'visible' in entity ? entity.visible : null);
        if (row.element !== before) list.insertBefore(row.element, before);
        else before = before.nextElementSibling;
      }
      for (const id of previous ? Object.keys(previous[kind]) : []) {
        if (id in entities) continue;
        rows.get(`${kind} ${id}`)?.element.remove();
        rows.delete(`${kind} ${id}`);
      }
    }
  };
  const select = (selection: Selection, reveal: boolean) => {
    sceneRow.classList.toggle('selected', selection === null);
    const key = selection && `${selection.kind} ${selection.id}`;
    for (const [other, row] of rows) row.select(other === key);
    if (reveal && key) rows.get(key)?.element.scrollIntoView({ block: 'nearest' });
  };

  store.subscribe(({ document, previous, reason }) => {
    if (reason === 'open') {
      for (const row of rows.values()) row.element.remove();
      rows.clear();
    }
    update(document, reason === 'open' ? null : previous);
    select(state.value.selection, false);
  });
  state.subscribe(({ selection }, previous) => {
    if (selection !== previous.selection) select(selection, true);
  });
  element.addEventListener('keydown', (event) => moveFocus(event, element));
  update(store.document, null);
  select(state.value.selection, false);

  return {
    element,
    renameSelected() {
      const { selection } = state.value;
      if (selection) rows.get(`${selection.kind} ${selection.id}`)?.rename();
    },
  };
}

function iconOf(document: Document, kind: EntityKind, id: string): IconName {
  if (kind === 'materials') return 'material';
  const type = kind === 'lights' ? document.lights[id]?.type : document.objects[id]?.geometry.type;
  return type && isIcon(type) ? type : 'mesh';
}

/** Arrow keys walk through the rows, as in a list. */
function moveFocus(event: KeyboardEvent, element: HTMLElement): void {
  if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return;
  if (!(event.target instanceof HTMLElement) || !event.target.classList.contains('outliner-row')) return;
  event.preventDefault();
  const all = [...element.querySelectorAll<HTMLElement>('.outliner-row')].filter((row) => row.offsetParent);
  const next = all[all.indexOf(event.target) + (event.key === 'ArrowDown' ? 1 : -1)];
  next?.focus();
  next?.click();
}
