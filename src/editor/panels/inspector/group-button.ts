/**
 * The group that what is selected is in: a click in the picture selects a part, and who comes from elsewhere looks for the
 * whole. Where all of a group is selected, its name, and the one around it.
 */
import { isMember } from '../../../scene/entity.ts';
import { groupOf, groupsAround, unitsOf } from '../../../scene/groups.ts';
import type { Document } from '../../../scene/schema.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import type { Bound } from './field.ts';

export function groupButton({ store, state, actions }: Session): Bound {
  const own = h('strong', {});
  const around = h('button', { type: 'button', class: 'text-button', 'data-keys': 'edit.selectGroup' });
  around.dataset.tip = t('Select all of its group');
  around.addEventListener('click', () => actions.run('edit.selectGroup'));
  const element = h('div', { class: 'inspector-group' }, icon('folder'), own, around);
  let shown: readonly unknown[] = [];
  return {
    element,
    update() {
      const { document } = store;
      const { selected } = state.value;
      // Sliders come here with every move of the pointer.
      const [first] = selected.filter(isMember);
      const now = [selected, document.groups, first && groupOf(document, first)];
      if (now.every((value, i) => value === shown[i])) return;
      shown = now;
      const { whole, outer } = groupsOf(document, selected);
      element.hidden = whole === null && outer === null;
      own.textContent = whole;
      own.hidden = whole === null;
      around.textContent = outer === null ? '' : t('in {group}', { group: outer });
      around.hidden = outer === null;
    },
  };
}

/** The names of the one group that is selected as a whole, and of the one around all that is selected. */
function groupsOf(
  document: Document,
  selected: readonly Entity[],
): { whole: string | null; outer: string | null } {
  const { groups, loose } = unitsOf(document, selected);
  const [group] = groups;
  const whole = groups.length === 1 && loose.length === 0 && group !== undefined ? group : null;
  const parents = new Set([
    ...groups.map((id) => document.groups[id]?.parent ?? null),
    ...loose.map((ref) => groupOf(document, ref)),
  ]);
  const [outer = null] = parents;
  const name = (id: string | null) => document.groups[id ?? '']?.name ?? null;
  const isOne = parents.size === 1 && [...groupsAround(document.groups, outer)].length > 0;
  return { whole: name(whole), outer: isOne ? name(outer) : null };
}
