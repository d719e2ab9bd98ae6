/** The keys of the page. None of them does anything while something is being typed. */
import { isTextEntry } from '../ui/dom.ts';
import type { Actions } from './action.ts';
import { keysOf } from './keys.ts';

export function installShortcuts(actions: Actions): void {
  window.addEventListener('keydown', (event) => {
    // What has the focus, such as a slider or a menu, comes first.
    if (event.defaultPrevented) return;
    const pressed = keysOf(event);
    if (pressed === null || document.querySelector('dialog[open]')) return;
    // Inside a shadow root, where the code editor is, the event's target is only the root's host.
    const target = event.composedPath()[0] ?? null;
    const typing = isTextEntry(target);
    const found = actions
      .withKeys(pressed)
      .find(({ enabled, whileTyping }) => (whileTyping || !typing) && enabled?.() !== false);
    if (!found || isTheTargets(target, pressed)) return;
    if (found.hasEvent && found.keys?.includes(pressed)) return;
    // Also keeps the browser from its own meaning of Ctrl+S, Ctrl+O and Ctrl+D.
    event.preventDefault();
    found.run();
  });
}

/** Whether keys mean something to what has the focus. */
function isTheTargets(target: EventTarget | null, pressed: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  // In a list a letter means the entry that begins with it.
  if (target instanceof HTMLSelectElement) return !/Ctrl|^(Shift\+)?F\d+$/.test(pressed);
  if (pressed === 'Enter' || pressed === 'Space') return target.matches('button, summary, a, input, [role]');
  return target.matches('input[type=range]') && /(Arrow|Page|Home|End)/.test(pressed);
}
