/** Rows that are dragged: between others, into groups and out of them. */
import { isMember } from '../../../scene/entity.ts';
import { moveMaterials, moveToGroup } from '../../../scene/group-commands.ts';
import { isWithin, unitsOf } from '../../../scene/groups.ts';
import { contentsOf } from '../../../scene/order.ts';
import type { Document } from '../../../scene/schema.ts';
import { attempt } from '../../commands.ts';
import { plural, t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { type Dragged, type Landing, landingAt } from './landing.ts';
import { entitiesOf } from './selecting.ts';
import type { RowTarget, TreeRow } from './tree.ts';
import type { RowWindow } from './window.ts';

const DRAG_TYPE = 'application/x-irradia-rows';

/** px: nearer to an edge than this, the list scrolls, */
const EDGE = 28;
/** px per frame: as fast as this at the edge itself. */
const FASTEST = 12;

export interface RowDrag {
  /** The row that is being dragged has to stay on the page for the browser to say when the drag ends. */
  readonly key: string | null;
}

export interface DraggableRows {
  readonly list: HTMLElement;
  readonly view: RowWindow;
  rows(): readonly TreeRow[];
  /** The place among them of the row that an event happened on; -1 for none. */
  rowAt(event: Event): number;
  /** The element of a row, if it is on the page. */
  elementOf(key: string): HTMLElement | undefined;
}

export function installRowDrag(
  { store, state }: Session,
  { list, view, rows, rowAt, elementOf }: DraggableRows,
): RowDrag {
  const drag = { key: null as string | null };
  let dragged: Dragged | null = null;
  let landing: Landing | null = null;
  let marked: Element | undefined;
  let pointer = 0;
  let frame = 0;
  const line = h('div', { class: 'drop-line', hidden: true, 'aria-hidden': 'true' });
  list.append(line);

  const mark = (next: Landing | null) => {
    landing = next;
    marked?.classList.remove('drop-into');
    marked = next && 'row' in next.mark ? elementOf(next.mark.row) : undefined;
    marked?.classList.add('drop-into');
    line.hidden = !next || !('line' in next.mark);
    if (!next || !('line' in next.mark)) return;
    line.style.top = `${next.mark.line * view.rowHeight}px`;
    line.style.setProperty('--level', String(next.mark.level));
  };
  const end = () => {
    drag.key = null;
    dragged = null;
    mark(null);
    cancelAnimationFrame(frame);
    frame = 0;
  };
  /** While the pointer rests at an edge, too. */
  const scroll = () => {
    const { top, bottom } = view.element.getBoundingClientRect();
    const beyond = Math.max(0, pointer - (bottom - EDGE)) - Math.max(0, top + EDGE - pointer);
    view.element.scrollTop += Math.max(-1, Math.min(1, beyond / EDGE)) * FASTEST;
    frame = requestAnimationFrame(scroll);
  };

  list.addEventListener('dragstart', (event) => {
    const row = rows()[rowAt(event)];
    const found = row && draggedBy(store.document, row.target, state.value.selected);
    if (!row || !found || !event.dataTransfer) return;
    drag.key = row.key;
    dragged = found;
    const count = found.groups.length + found.members.length + found.materials.length;
    event.dataTransfer.setData(DRAG_TYPE, '');
    event.dataTransfer.effectAllowed = 'move';
    const name = count === 1 ? row.name : plural(count, '{count} thing', '{count} things');
    const picture = h('div', { class: 'drag-picture' }, name);
    document.body.append(picture);
    event.dataTransfer.setDragImage(picture, -12, 8);
    // The browser has taken its picture by then.
    setTimeout(() => picture.remove());
  });
  const follow = (event: DragEvent) => {
    if (!dragged) return;
    pointer = event.clientY;
    if (frame === 0) frame = requestAnimationFrame(scroll);
    const { left, top } = list.getBoundingClientRect();
    const at = (event.clientY - top) / view.rowHeight;
    const index = Math.floor(at);
    // As style/outliner.css indents them: a name begins behind its twisty and its symbol.
    const level = Math.floor((event.clientX - left - INDENT.first) / INDENT.step) + 1;
    mark(landingAt(store.document, rows(), index, { y: at - index, level }, dragged));
    if (!landing) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = 'move';
  };
  list.addEventListener('dragover', follow);
  // Of a row that it comes to, the browser says no more at first; and while the list scrolls, each move comes to another one.
  list.addEventListener('dragenter', follow);
  view.element.addEventListener('dragleave', (event) => {
    const to = event.relatedTarget;
    if (to instanceof Node && view.element.contains(to)) return;
    mark(null);
    cancelAnimationFrame(frame);
    frame = 0;
  });
  list.addEventListener('drop', (event) => {
    if (!dragged || !landing) return;
    event.preventDefault();
    const [{ groups, members, materials }, { group, beside }] = [dragged, landing];
    end();
    attempt(t('Not moved'), () => {
      if (materials.length === 0) moveToGroup(store, members, groups, group, beside);
      else if (beside) moveMaterials(store, materials, beside);
    });
  });
  list.addEventListener('dragend', end);
  return drag;
}

/** px: of style/outliner.css, where the first level begins, and how much further each other one does. */
const INDENT = { first: 18, step: 12 } as const;

/** What goes along with a row: all that is selected, where the row is of it. */
function draggedBy(
  document: Document,
  target: RowTarget,
  selected: Session['state']['value']['selected'],
): Dragged | null {
  const own = entitiesOf(document, target);
  if (own.length === 0) return null;
  const chosen = new Set(selected.map(({ kind, id }) => `${kind} ${id}`));
  const isSelected = own.every(({ kind, id }) => chosen.has(`${kind} ${id}`));
  if (target.type === 'group' && !isSelected) return { groups: [target.id], members: [], materials: [] };
  const all = isSelected ? selected : own;
  const { groups, loose } = unitsOf(document, all);
  const materials = all.filter(({ kind }) => kind === 'materials').map(({ id }) => id);
  const held = target.type === 'entity' && isMember(target.entity) ? target.entity : null;
  const around = held && (document[held.kind][held.id]?.group ?? null);
  const opened = groups.filter((id) => around !== null && isWithin(document.groups, around, id));
  if (opened.length === 0) return { groups, members: loose, materials };
  // By one of its members, what is in a group is taken out of it, and not the group.
  const contents = contentsOf(document);
  const parts = { groups: groups.filter((id) => !opened.includes(id)), members: [...loose], materials };
  for (let next = opened.pop(); next !== undefined; next = opened.pop()) {
    const inside = contents.get(next) ?? { groups: [], members: [] };
    parts.members.push(...inside.members);
    for (const id of inside.groups)
      if (around !== null && isWithin(document.groups, around, id)) opened.push(id);
      else parts.groups.push(id);
  }
  return parts;
}
