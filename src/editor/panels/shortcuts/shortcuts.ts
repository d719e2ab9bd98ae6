/** All keys of the page: found by words or by the keys themselves, and changed by pressing others. */
import type { Action, Actions } from '../../actions/action.ts';
import { keysOf, keysText } from '../../actions/keys.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { openDialog } from '../../ui/dialog.ts';
import { h } from '../../ui/dom.ts';
import { iconButton } from '../../ui/icon-button.ts';
import { fixedKeys, subjectsOf } from './subjects.ts';

export function openShortcuts({ actions }: Session): void {
  const { keymap } = actions;
  const search = h('input', {
    type: 'search',
    class: 'text-field',
    placeholder: t('Search for words or keys'),
    'aria-label': t('Search the shortcuts'),
  });
  const resetAll = h('button', { type: 'button', class: 'text-button' }, t('Reset all'));
  const list = h('div', { class: 'shortcut-list' });
  /** The action whose new keys are being waited for, and what was pressed that another action has. */
  let waiting: string | null = null;
  let wanted: string | null = null;
  let updating = false;

  const wait = (id: string | null, keys: string | null = null) => {
    waiting = id;
    wanted = keys;
    update();
  };
  const assign = (id: string, changes: Parameters<typeof keymap.set>[0]) => {
    waiting = null;
    wanted = null;
    keymap.set(changes);
    focusOn(id);
  };
  const focusOn = (id: string) =>
    list.querySelector<HTMLElement>(`[data-action="${id}"] .shortcut-keys`)?.focus();

  const onKey = (event: KeyboardEvent, action: Action) => {
    if (waiting !== action.id) return;
    // The page must not take the way out from those who use the keyboard.
    if (event.key === 'Tab') {
      wait(null);
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    const pressed = keysOf(event);
    if (pressed === null) return;
    if (pressed === 'Escape') wait(null);
    else if (othersWith(actions, action, pressed).length > 0) wait(action.id, pressed);
    else assign(action.id, { [action.id]: [pressed] });
    const next = wanted ? list.querySelector<HTMLElement>('.shortcut-conflict button') : null;
    if (next) next.focus();
    else focusOn(action.id);
  };

  const row = (action: Action) => {
    const { id, title } = action;
    const keys = actions.keysOf(id);
    const isWaiting = waiting === id && wanted === null;
    const change = h(
      'button',
      {
        type: 'button',
        class: 'shortcut-keys',
        'aria-label': isWaiting
          ? t('Press the new keys for {action}', { action: title })
          : t('{action}: {keys}. Change', { action: title, keys: spoken(keys) }),
      },
      ...(isWaiting
        ? [t('Press the new keys…')]
        : keys.length > 0
          ? keys.flatMap((each) => [h('kbd', {}, keysText(each)), ' '])
          : [h('span', { class: 'shortcut-none' }, t('none'))]),
    );
    change.classList.toggle('waiting', isWaiting);
    change.addEventListener('click', () => {
      wait(waiting === id ? null : id);
      focusOn(id);
    });
    change.addEventListener('keydown', (event) => onKey(event, action));
    change.addEventListener('blur', () => {
      // A browser may say so, too, of what is taken off the page to be made anew.
      if (!updating && waiting === id && wanted === null) wait(null);
    });
    const element = h(
      'li',
      {},
      h('span', { class: 'shortcut-title' }, title),
      change,
      iconButton('close', t('{action}: no keys', { action: title }), () => assign(id, { [id]: [] }), {
        disabled: keys.length === 0,
      }),
      iconButton('undo', t('Reset {action}', { action: title }), () => assign(id, { [id]: undefined }), {
        disabled: keymap.get(id) === undefined,
      }),
      waiting === id && wanted !== null ? conflict(action, wanted) : null,
    );
    element.dataset.action = id;
    return element;
  };

  const conflict = (action: Action, keys: string) => {
    const others = othersWith(actions, action, keys);
    const without = others.map((other) => [
      other.id,
      actions.keysOf(other.id).filter((each) => each !== keys),
    ]);
    const swap = h('button', { type: 'button', class: 'text-button' }, t('Swap the keys'));
    swap.addEventListener('click', () => {
      const [first, ...rest] = without as [string, string[]][];
      if (first) first[1].push(...actions.keysOf(action.id));
      assign(action.id, {
        ...Object.fromEntries([first, ...rest].filter((e) => e !== undefined)),
        [action.id]: [keys],
      });
    });
    const take = h('button', { type: 'button', class: 'text-button' }, t('Take them away there'));
    take.addEventListener('click', () =>
      assign(action.id, { ...Object.fromEntries(without), [action.id]: [keys] }),
    );
    const leave = h('button', { type: 'button', class: 'text-button' }, t('Leave all as it is'));
    leave.addEventListener('click', () => {
      wait(null);
      focusOn(action.id);
    });
    return h(
      'div',
      { class: 'shortcut-conflict', role: 'alert' },
      h(
        'span',
        {},
        t('{keys} is taken: {actions}', {
          keys: keysText(keys),
          actions: others.map((other) => other.title).join(', '),
        }),
      ),
      swap,
      take,
      leave,
    );
  };

  const update = () => {
    updating = true;
    const word = search.value.trim().toLocaleLowerCase();
    const isFound = (title: string, keys: string) => `${title} ${keys}`.toLocaleLowerCase().includes(word);
    const groups = subjectsOf(actions.all)
      .map(({ title, actions: all }) => ({
        title,
        rows: all.filter((action) => isFound(action.title, spoken(actions.keysOf(action.id)))).map(row),
      }))
      .filter(({ rows }) => rows.length > 0);
    const fixed = fixedKeys().filter(({ title, keys }) => isFound(title, keys));
    list.replaceChildren(
      ...groups.map(({ title, rows }) => h('section', {}, h('h2', {}, title), h('ul', {}, ...rows))),
      fixed.length > 0 ? fixedSection(fixed) : '',
      groups.length + fixed.length > 0
        ? ''
        : h('p', { class: 'hint' }, t('No shortcut has these words or keys.')),
    );
    updating = false;
    resetAll.disabled = !actions.all.some(({ id }) => keymap.get(id) !== undefined);
  };

  search.addEventListener('input', () => wait(null));
  resetAll.addEventListener('click', () => {
    keymap.reset();
    search.focus();
  });
  const unsubscribe = keymap.subscribe(update);
  update();
  openDialog(
    { title: t('Keyboard shortcuts'), class: 'shortcuts', tools: [search, resetAll], onClose: unsubscribe },
    list,
  );
  search.focus();
}

/** The other actions that have these keys. */
function othersWith(actions: Actions, { id }: Action, keys: string): readonly Action[] {
  return actions.withKeys(keys).filter((other) => other.id !== id);
}

function spoken(keys: readonly string[]): string {
  return keys.length > 0 ? keys.map((each) => keysText(each)).join(' ') : t('none');
}

function fixedSection(fixed: ReturnType<typeof fixedKeys>): HTMLElement {
  return h(
    'section',
    {},
    h('h2', {}, t('In fields and menus; these cannot be changed')),
    h(
      'ul',
      {},
      ...fixed.map(({ title, keys }) =>
        h(
          'li',
          {},
          h('span', { class: 'shortcut-title' }, title),
          h('span', { class: 'shortcut-keys fixed' }, ...keys.split(' ').map((key) => h('kbd', {}, key))),
        ),
      ),
    ),
  );
}
