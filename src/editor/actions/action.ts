/**
 * What a person can make the page do: each once, with a name and keys. Menus, shortcuts, the command
 * palette and the list of shortcuts are all made from these.
 */
import { Keymap } from './keymap.ts';
import { keysText } from './keys.ts';

export interface Action {
  /** Stable, such as `edit.duplicate`: changed shortcuts are kept by it. What is before the point is its subject. */
  readonly id: string;
  /** In the page's language. */
  readonly title: string;
  /** Keys that run it unless the person chose others: `Ctrl+Shift+Z`, `F2`, `Delete`, `?`. Ctrl is Cmd, too. */
  readonly keys?: readonly string[];
  /** Its keys run it while something is being typed, too. */
  readonly whileTyping?: boolean;
  /** The browser has an event of its own for its keys, such as `copy`, and somebody listens to that. */
  readonly hasEvent?: boolean;
  /** Whether it can be run now; always, if not given. */
  readonly enabled?: () => boolean;
  /** For what is on or off. */
  readonly on?: () => boolean;
  run(): void;
}

export class Actions {
  readonly #actions = new Map<string, Action>();

  constructor(readonly keymap = new Keymap()) {}

  add(actions: readonly Action[]): void {
    for (const action of actions) {
      if (this.#actions.has(action.id)) throw new Error(`two actions are called ${action.id}`);
      this.#actions.set(action.id, action);
    }
  }

  get all(): readonly Action[] {
    return [...this.#actions.values()];
  }

  get(id: string): Action {
    const action = this.#actions.get(id);
    if (!action) throw new Error(`no action is called ${id}`);
    return action;
  }

  /** Runs it, unless it cannot be run now. */
  run(id: string): void {
    const { enabled, run } = this.get(id);
    if (enabled?.() !== false) run();
  }

  /** The keys that run it: those that the person chose, or its own. */
  keysOf(id: string): readonly string[] {
    return this.keymap.get(id) ?? this.get(id).keys ?? [];
  }

  /** The first of its keys, to be read; undefined if it has none. */
  shortcut(id: string): string | undefined {
    const [keys] = this.keysOf(id);
    return keys === undefined ? undefined : keysText(keys);
  }

  /** All that these keys stand for, the one that is asked first before the others. */
  withKeys(keys: string): readonly Action[] {
    return this.all.filter(({ id }) => this.keysOf(id).includes(keys));
  }
}
