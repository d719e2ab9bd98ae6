/** The keys that the page comes with: none of them means two things at once. */
import { afterAll, expect, it, vi } from 'vitest';
import type { Action } from '../../src/editor/actions/action.ts';
import { isKeys } from '../../src/editor/actions/keys.ts';
import type { Session } from '../../src/editor/session.ts';
import { EditorStateStore, type Entity } from '../../src/editor/state.ts';
import { addLight, addObject } from '../../src/scene/commands.ts';
import { createDocument } from '../../src/scene/document.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const files = import.meta.glob<Record<string, unknown>>('../../src/editor/actions/*.ts', { eager: true });

/** Something that takes any call: what an action needs only when it is run. */
const anything: unknown = new Proxy(() => {}, {
  get: (_, name) => (name === Symbol.toPrimitive ? () => '' : anything),
  apply: () => anything,
});

const store = new DocumentStore(createDocument());
const state = new EditorStateStore();
const object = { kind: 'objects', id: addObject(store, 'sphere') } as const;
const light = { kind: 'lights', id: addLight(store, 'point') } as const;
const material: Entity = { kind: 'materials', id: Object.keys(store.document.materials)[0] as string };
const session: Session = new Proxy({ store, state } as Session, {
  // Some lists take what has the session, and more.
  get: (own, name) => (name === 'session' ? session : (Reflect.get(own, name) ?? anything)),
});

/** Of every list in the folder: a file that is added is looked at, too. */
const actions = Object.values(files).flatMap((module) =>
  Object.entries(module)
    .filter(([name, make]) => /^[a-z]\w*Actions$/.test(name) && typeof make === 'function')
    .map(([, make]) => (make as (...args: unknown[]) => Action[])(session, anything))
    // Lists of what is handed in, such as the scenes that ship, have no keys.
    .flatMap((list) => (Array.isArray(list) ? list : [])),
);

it('are written as they are pressed, on actions that have a name each', () => {
  expect(actions.length).toBeGreaterThan(20);
  expect(new Set(actions.map(({ id }) => id)).size).toBe(actions.length);
  for (const { id, title, keys = [] } of actions) {
    expect(id).toMatch(/^[a-z]\w*\.\w+$/);
    expect(title, id).not.toBe('');
    for (const key of keys) expect(isKeys(key), `${id}: ${key}`).toBe(true);
  }
});

/** Where the keyboard is: in the viewport, or anywhere else. */
const focus = { activeElement: null as { matches(): boolean; closest(): unknown } | null };
vi.stubGlobal('document', focus);
afterAll(() => vi.unstubAllGlobals());

it.each<[string, readonly Entity[]]>([
  ['nothing', []],
  ['an object', [object]],
  ['a light', [light]],
  ['a material', [material]],
  ['several', [object, light]],
])('with %s selected each runs one action at most', (_, selected) => {
  state.selectAll(selected);
  for (const inViewport of [false, true]) {
    focus.activeElement = { matches: () => inViewport, closest: () => (inViewport ? {} : null) };
    const found = new Map<string, string[]>();
    for (const { id, keys = [], enabled } of actions)
      if (enabled?.() !== false) for (const key of keys) found.set(key, [...(found.get(key) ?? []), id]);
    expect([...found].filter(([, ids]) => ids.length > 1)).toEqual([]);
  }
});
