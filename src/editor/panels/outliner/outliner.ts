/** The outliner: everything in the document by name; select, search, rename, group, hide, lock, delete. */

import { rename } from '../../../scene/commands.ts';
import { isMember } from '../../../scene/entity.ts';
import { groupOf, groupsAround, unitsOf } from '../../../scene/groups.ts';
import { attempt, renameEntity } from '../../commands.ts';
import { t } from '../../language/language.ts';
import { toggleAlone, toggleLocked, toggleVisible } from '../../selection.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { Follower } from '../../ui/follower.ts';
import { openMenu } from '../../ui/menu.ts';
import { selectionEntries } from '../selection-menu.ts';
import { installRowDrag } from './drag.ts';
import { treeMove } from './keys.ts';
import { createRow, keyOfRow, type OutlinerRow, partOf, rowId } from './row.ts';
import { createSearch } from './search.ts';
import { between, chosenIn, entitiesOf, toggled, union } from './selecting.ts';
import { entityKey, groupKey, sectionKey, type TreeRow, treeRows } from './tree.ts';
import { createWindow } from './window.ts';

/** Rows of more objects than this follow an edit or a selection in a task of their own. */
const AT_ONCE = 500;

export interface Outliner {
  readonly element: HTMLElement;
  /** Opens the name of what is selected for typing. */
  renameSelected(): void;
  /** Puts the cursor into the search field. */
  search(): void;
}

export function createOutliner(session: Session): Outliner {
  const { store, state } = session;
  const folded = new Set<string>();
  const elements = new Map<string, OutlinerRow>();
  let rows: readonly TreeRow[] = [];
  let query = '';
  /** Where the keys are, and from where a range is selected. */
  let current = 'scene';
  let anchor = 'scene';
  let renaming = false;
  /** The selection is being changed here: the keys are where the person put them. */
  let choosing = false;
  /** The rows are of an earlier document; what is selected was not brought into sight yet. */
  let [isStale, isSought] = [false, false];
  const follow = new Follower(catchUp, () => Object.keys(store.document.objects).length <= AT_ONCE);

  const list = h('div', {
    class: 'outliner-tree',
    role: 'tree',
    tabindex: 0,
    'aria-label': t('Outliner'),
    'aria-multiselectable': 'true',
  });
  // As style/tokens.css has it for this screen, and for a finger or a mouse, in CSS pixels.
  const rowHeight = Number.parseFloat(getComputedStyle(document.documentElement).getPropertyValue('--row'));
  const view = createWindow(list, rowHeight, draw);
  const search = createSearch({
    onQuery(next) {
      follow.now();
      query = next;
      rebuild();
      view.element.scrollTop = 0;
      // What was selected is where the keys go on.
      if (next === '') reveal(state.value.selection);
      view.update(rows.length);
    },
    onLeave: (intoList) => {
      follow.now();
      const first = rows.findIndex(({ target }) => target.type === 'entity');
      if (intoList && rows[first]) choose(first, 'select');
      list.focus();
    },
  });
  const element = h('nav', { class: 'outliner', 'aria-label': t('Outliner') }, search.element, view.element);

  function rebuild(): void {
    rows = treeRows(store.document, { folded, query });
    if (indexOf(current) < 0) current = rows[0]?.key ?? '';
    search.showFound(query ? rows.filter(({ target }) => target.type === 'entity').length : null);
    view.update(rows.length);
  }

  function catchUp(): void {
    const [wasStale, wasSought] = [isStale, isSought];
    [isStale, isSought] = [false, false];
    if (wasStale) {
      const before = indexOf(current);
      rebuild();
      // What was moved stays in sight.
      const now = indexOf(current);
      if (now !== before && now >= 0 && current !== 'scene') view.reveal(now);
    }
    if (!wasSought) return;
    reveal(state.value.selection);
    view.update(rows.length);
  }

  function draw(first: number, last: number): void {
    // What they stand for may be gone.
    if (isStale) return;
    const near = rows.slice(first, last);
    const wanted = new Set(near.map(({ key }) => key));
    // The name that is being typed stays, and what is being dragged.
    if (!renaming)
      for (const [key, { element: old }] of elements)
        if (!wanted.has(key) && key !== drag.key) drop(key, old);
    const chosen = chosenIn(store.document, state.value.selected);
    let before: Element | null = list.firstElementChild;
    near.forEach((row, i) => {
      let shown = elements.get(row.key);
      if (!shown) {
        shown = createRow(row.key);
        elements.set(row.key, shown);
      }
      shown.element.style.top = `${(first + i) * rowHeight}px`;
      shown.show(row, chosen(row.target), row.key === current);
      if (shown.element !== before) list.insertBefore(shown.element, before);
      else before = before.nextElementSibling;
    });
    list.setAttribute('aria-activedescendant', rowId(current));
  }

  function drop(key: string, old: Element): void {
    old.remove();
    elements.delete(key);
  }

  const indexOf = (key: string) => rows.findIndex((row) => row.key === key);
  const rowOf = (event: Event): number => {
    follow.now();
    const row = event.target instanceof Element ? event.target.closest('.outliner-row') : null;
    return row ? indexOf(keyOfRow(row)) : -1;
  };

  /** Selects a row alone, with all from the anchor, or as well. */
  function choose(index: number, how: 'select' | 'extend' | 'toggle' | 'add'): void {
    const row = rows[index];
    if (!row) return;
    const { document } = store;
    const own = entitiesOf(document, row.target);
    const { selected } = state.value;
    current = row.key;
    const from = indexOf(anchor);
    choosing = true;
    if (how === 'extend' && from >= 0) state.selectAll(between(document, rows, from, index));
    else if (how === 'add' && from >= 0)
      state.selectAll(union(selected, between(document, rows, from, index)));
    else {
      anchor = row.key;
      if (how === 'toggle') state.selectAll(toggled(selected, own));
      // A title has nothing that could be selected, and takes nothing away.
      else if (row.target.type !== 'section') state.selectAll(own);
    }
    choosing = false;
    // A change of what is selected draws the rows.
    if (state.value.selected === selected) view.update(rows.length);
    view.reveal(index);
  }

  function fold(key: string, isFolded: boolean): void {
    if (isFolded) folded.add(key);
    else folded.delete(key);
    rebuild();
  }

  function renameRow(index: number): void {
    const row = rows[index];
    if (!row || (row.target.type !== 'entity' && row.target.type !== 'group')) return;
    view.reveal(index);
    view.update(rows.length);
    const { target } = row;
    renaming = true;
    elements.get(row.key)?.rename((name) => {
      renaming = false;
      if (name !== null && name !== row.name) {
        if (target.type === 'entity') renameEntity(store, target.entity.kind, target.entity.id, name);
        else attempt(t('Not renamed'), () => rename(store, 'groups', target.id, name));
      }
      list.focus({ preventScroll: true });
      view.update(rows.length);
    });
  }

  list.addEventListener('click', (event) => {
    const index = rowOf(event);
    const row = rows[index];
    if (!row || event.target instanceof HTMLInputElement) return;
    const part = partOf(event);
    const members = entitiesOf(store.document, row.target).filter(isMember);
    const held = event.ctrlKey || event.metaKey;
    if (part === 'eye' && event.altKey) toggleAlone(session, members);
    else if (part === 'eye') toggleVisible(session, members);
    else if (part === 'lock') toggleLocked(session, members);
    else if (row.expanded !== null && (part === 'twisty' || row.target.type === 'section'))
      fold(row.key, row.expanded);
    else if (event.shiftKey) choose(index, held ? 'add' : 'extend');
    else choose(index, held ? 'toggle' : 'select');
  });
  list.addEventListener('dblclick', (event) => {
    if (partOf(event) === 'row') renameRow(rowOf(event));
  });
  list.addEventListener('contextmenu', (event) => {
    event.preventDefault();
    const at = rowOf(event);
    const index = at >= 0 ? at : indexOf(current);
    const row = rows[index];
    const place = row && elements.get(row.key);
    if (!row || !place) return;
    const own = entitiesOf(store.document, row.target);
    if (!own.every((entity) => state.isSelected(entity)) || own.length === 0) choose(index, 'select');
    openMenu(place.element, row.name, selectionEntries(session));
  });
  list.addEventListener('keydown', (event) => {
    if (event.target !== list) return;
    follow.now();
    const at = indexOf(current);
    const move = treeMove(event, rows, at);
    const row = rows[at];
    if (!move || !row) return;
    event.preventDefault();
    if (move === 'choose' || move === 'toggle') {
      if (row.target.type === 'section') fold(row.key, row.expanded === true);
      else choose(at, move === 'toggle' ? 'toggle' : 'select');
    } else if ('fold' in move) fold(row.key, move.fold);
    else if (move.how === 'walk') {
      current = rows[move.to]?.key ?? current;
      view.update(rows.length);
      view.reveal(move.to);
    } else choose(move.to, move.how);
  });

  const drag = installRowDrag(session, {
    list,
    view,
    rows() {
      follow.now();
      return rows;
    },
    rowAt: rowOf,
    elementOf: (key) => elements.get(key)?.element,
  });

  /** Brings what was selected elsewhere into sight. */
  function reveal(entity: Entity | null): void {
    const key = entity ? entityKey(entity) : 'scene';
    const own = indexOf(current);
    // The keys are on it, or on the group that has it.
    const isThere =
      rows[own] && entity && entitiesOf(store.document, rows[own].target).some((e) => entityKey(e) === key);
    if (isThere) return;
    if (entity) {
      const group = isMember(entity) ? groupOf(store.document, entity) : null;
      const around = [...groupsAround(store.document.groups, group)];
      const unfolded = [...around.map(groupKey), sectionKey(group === null ? entity.kind : 'groups')];
      const closed = unfolded.filter((other) => folded.delete(other));
      if (closed.length > 0) rebuild();
    }
    const index = indexOf(key);
    if (index < 0) return;
    current = key;
    anchor = key;
    // Nothing is no reason to leave the place in a long list.
    if (entity) view.reveal(index);
  }

  store.subscribe(({ document, previous, reason }) => {
    if (reason === 'open') folded.clear();
    const parts = ['groups', 'lights', 'objects', 'materials'] as const;
    if (!parts.some((part) => document[part] !== previous[part])) return;
    isStale = true;
    follow.soon();
  });
  state.subscribe(({ selected }, previous) => {
    if (selected === previous.selected) return;
    if (choosing) view.update(rows.length);
    else {
      isSought = true;
      follow.soon();
    }
  });
  // The height of what is seen is known only on the page.
  new ResizeObserver(() => view.update(rows.length)).observe(view.element);
  rebuild();

  return {
    element,
    search: () => search.focus(),
    renameSelected() {
      follow.now();
      const { selection, selected } = state.value;
      if (!selection) return;
      const at = rows[indexOf(current)];
      const { groups, loose } = unitsOf(store.document, selected);
      const [group] = groups;
      const isGroup = at?.target.type === 'group' && at.target.id === group;
      if (isGroup && groups.length === 1 && loose.length === 0) renameRow(indexOf(groupKey(at.target.id)));
      else {
        reveal(selection);
        renameRow(indexOf(entityKey(selection)));
      }
    },
  };
}
