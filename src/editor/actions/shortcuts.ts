/** The keys of the page. None of them does anything while something is being typed. */
import { isTextEntry } from '../ui/dom.ts';
import type { Actions } from './action.ts';
import { keysOf } from './keys.ts';

export function installShortcuts(actions: Actions): void {
  window.addEventListener('keydown', (event) => {
    // Inside a shadow root, where the code editor is, the event's target is only the root's host.
    if (isTextEntry(event.composedPath()[0] ?? null) || document.querySelector('dialog[open]')) return;
    // In a list a letter means the entry that begins with it.
    if (event.target instanceof HTMLSelectElement && !event.ctrlKey && !event.metaKey) return;
    const pressed = keysOf(event);
    const found = actions.all.find(({ keys, enabled }) => keys?.includes(pressed) && enabled?.() !== false);
    if (!found) return;
    // Also keeps the browser from its own meaning of Ctrl+S, Ctrl+O and Ctrl+D.
    event.preventDefault();
    found.run();
  });
}
