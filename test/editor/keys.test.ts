/** Keys as they are pressed on keyboards of different kinds, written, and kept. */
import { expect, it, vi } from 'vitest';
import { Actions } from '../../src/editor/actions/action.ts';
import { Keymap, parseChosen } from '../../src/editor/actions/keymap.ts';
import { isKeys, keysOf, keysText } from '../../src/editor/actions/keys.ts';

type Held = Partial<Record<'ctrl' | 'meta' | 'alt' | 'shift' | 'altGraph' | 'isComposing', boolean>>;

function press(key: string, held: Held = {}, code = ''): string | null {
  return keysOf({
    key,
    code,
    ctrlKey: held.ctrl ?? false,
    metaKey: held.meta ?? false,
    altKey: held.alt ?? false,
    shiftKey: held.shift ?? false,
    isComposing: held.isComposing ?? false,
    getModifierState: (name: string) => name === 'AltGraph' && held.altGraph === true,
  } as KeyboardEvent);
}

it.each<[expected: string, key: string, held?: Held, code?: string]>([
  ['Z', 'z'],
  ['Shift+Z', 'Z', { shift: true }],
  ['Ctrl+Shift+Z', 'z', { ctrl: true, shift: true }],
  ['Ctrl+Z', 'z', { meta: true }],
  ['?', '?', { shift: true }],
  ['Shift+1', '1', { shift: true }],
  ['Shift+Space', ' ', { shift: true }],
  ['Alt+ArrowLeft', 'ArrowLeft', { alt: true }],
  ['Shift+F6', 'F6', { shift: true }],
  // AltGr+2 on a Spanish keyboard, as Windows reports it.
  ['@', '@', { ctrl: true, alt: true, altGraph: true }],
  // Alt+A on a Mac.
  ['Alt+A', 'å', { alt: true }, 'KeyA'],
  ['Ctrl+Z', 'я', { ctrl: true }, 'KeyZ'],
  ['Ñ', 'ñ', {}, 'Semicolon'],
])('is written %s', (expected, key, held, code) => {
  expect(press(key, held, code)).toBe(expected);
  expect(isKeys(expected)).toBe(true);
});

it('is nothing yet: a modifier alone, an accent, what an input method composes', () => {
  expect(press('Control', { ctrl: true })).toBeNull();
  expect(press('Dead')).toBeNull();
  expect(press('a', { isComposing: true })).toBeNull();
});

it('tells keys from other texts', () => {
  for (const keys of ['+', 'Ctrl++', 'Ctrl+Alt+Shift+F12', '?']) expect(isKeys(keys), keys).toBe(true);
  for (const text of ['', 'z', 'Shift+Ctrl+Z', 'Ctrl', 'Ctrl+', 'Ctrl+Ctrl+Z', 'Hyper+Z', 'a b', '<b>', ' '])
    expect(isKeys(text), text).toBe(false);
});

it('is read with the signs that are on the keyboard', () => {
  expect(keysText('Ctrl+Shift+ArrowLeft', false)).toBe('Ctrl+Shift+←');
  expect(keysText('Ctrl+Shift+Z', true)).toBe('⌘⇧Z');
  expect(keysText('Ctrl++', false)).toBe('Ctrl++');
});

it('takes from storage only what are keys of actions', () => {
  expect(parseChosen(null)).toEqual({});
  expect(parseChosen('{')).toEqual({});
  expect(parseChosen('[["edit.undo"]]')).toEqual({});
  expect(
    parseChosen(
      '{"edit.undo":["Q"],"edit.redo":[],"edit.delete":["q"],"view.focus":"F","__proto__":["A"],"x":1}',
    ),
  ).toEqual({ 'edit.undo': ['Q'], 'edit.redo': [] });
});

it('a chosen key takes the place of those that the action comes with, until it is reset', () => {
  const keep = vi.fn();
  const actions = new Actions(new Keymap({}, keep));
  const run = vi.fn();
  actions.add([
    { id: 'edit.a', title: 'A', keys: ['A', 'Ctrl+A'], run },
    { id: 'edit.b', title: 'B', keys: ['B'], run },
  ]);
  actions.keymap.set({ 'edit.a': ['B'], 'edit.b': ['A'] });
  expect(actions.withKeys('B').map(({ id }) => id)).toEqual(['edit.a']);
  expect(actions.shortcut('edit.b')).toBe('A');
  expect(actions.withKeys('Ctrl+A')).toEqual([]);
  expect(keep).toHaveBeenLastCalledWith({ 'edit.a': ['B'], 'edit.b': ['A'] });
  actions.keymap.set({ 'edit.b': [] });
  expect(actions.shortcut('edit.b')).toBeUndefined();
  actions.keymap.reset();
  expect(actions.keysOf('edit.a')).toEqual(['A', 'Ctrl+A']);
  expect(keep).toHaveBeenLastCalledWith({});
});

it('an action that cannot be run now is not run, and no two have one id', () => {
  const actions = new Actions();
  const run = vi.fn();
  actions.add([{ id: 'edit.a', title: 'A', enabled: () => false, run }]);
  actions.run('edit.a');
  expect(run).not.toHaveBeenCalled();
  expect(() => actions.add([{ id: 'edit.a', title: 'A', run }])).toThrow('edit.a');
  expect(() => actions.get('edit.none')).toThrow('edit.none');
});
