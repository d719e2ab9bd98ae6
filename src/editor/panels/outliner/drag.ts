/** Rows that are dragged into groups and out of them. */
import { isMember } from '../../../scene/entity.ts';
import { moveToGroup } from '../../../scene/group-commands.ts';
import { isWithin, unitsOf } from '../../../scene/groups.ts';
import type { Document } from '../../../scene/schema.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { entitiesOf } from './selecting.ts';
import type { TreeRow } from './tree.ts';

const DRAG_TYPE = 'application/x-irradia-rows';

/** @param rowAt the row that an event happened on */
export function installRowDrag(
  { store, state }: Session,
  list: HTMLElement,
  rowAt: (event: Event) => TreeRow | undefined,
): void {
  /** What is being dragged, all of which is in this document. */
  let dragged: readonly Entity[] = [];
  let marked: Element | null = null;

  const mark = (element: Element | null) => {
    marked?.classList.remove('drop-into');
    marked = element;
    marked?.classList.add('drop-into');
  };
  const end = () => {
    dragged = [];
    mark(null);
  };

  list.addEventListener('dragstart', (event) => {
    const row = rowAt(event);
    if (!row || !event.dataTransfer) return;
    const own = entitiesOf(store.document, row.target).filter(isMember);
    if (own.length === 0) return;
    // All that is selected, where the row is of it.
    const all = own.every((entity) => state.isSelected(entity)) ? state.value.selected.filter(isMember) : own;
    dragged = all;
    event.dataTransfer.setData(DRAG_TYPE, '');
    event.dataTransfer.effectAllowed = 'move';
  });
  list.addEventListener('dragover', (event) => {
    const target = dragged.length > 0 ? targetOf(rowAt(event), store.document) : undefined;
    const element = event.target instanceof Element ? event.target.closest('.outliner-row') : null;
    const { groups } = unitsOf(store.document, dragged);
    const isInItself =
      typeof target === 'string' && groups.some((id) => isWithin(store.document.groups, target, id));
    if (target === undefined || isInItself) {
      mark(null);
      return;
    }
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'move';
    mark(element);
  });
  list.addEventListener('drop', (event) => {
    const target = targetOf(rowAt(event), store.document);
    const { groups, loose } = unitsOf(store.document, dragged);
    if (target === undefined || groups.length + loose.length === 0) return;
    event.preventDefault();
    end();
    attempt(t('Not moved'), () => moveToGroup(store, loose, groups, target));
  });
  list.addEventListener('dragend', end);
}

/** The group that a row means; null for none of them, undefined for rows that mean no place. */
function targetOf(row: TreeRow | undefined, document: Document): string | null | undefined {
  switch (row?.target.type) {
    case 'group':
      return row.target.id;
    case 'section':
      return row.target.kind === 'materials' ? undefined : null;
    case 'entity': {
      const { entity } = row.target;
      return isMember(entity) ? (document[entity.kind][entity.id]?.group ?? null) : undefined;
    }
    default:
      return undefined;
  }
}
