/** The keys of the page. None of them fires while something is being typed. */
import { isTextEntry } from './ui/dom.ts';

export interface Shortcut {
  /** `event.key` in lower case. */
  readonly key: string;
  readonly ctrl?: boolean;
  readonly shift?: boolean;
  run(): void;
}

export function installShortcuts(shortcuts: readonly Shortcut[]): void {
  window.addEventListener('keydown', (event) => {
    // Inside a shadow root, where the code editor is, the event's target is only the root's host.
    if (isTextEntry(event.composedPath()[0] ?? null) || document.querySelector('dialog[open]')) return;
    const ctrl = event.ctrlKey || event.metaKey;
    // In a list a letter means the entry that begins with it.
    if (event.target instanceof HTMLSelectElement && !ctrl) return;
    const found = shortcuts.find(
      (shortcut) =>
        shortcut.key === event.key.toLowerCase() &&
        Boolean(shortcut.ctrl) === ctrl &&
        Boolean(shortcut.shift) === event.shiftKey &&
        !event.altKey,
    );
    if (!found) return;
    // Also keeps the browser from its own meaning of Ctrl+S, Ctrl+O and Ctrl+D.
    event.preventDefault();
    found.run();
  });
}
