/** Keys as people write them, `Ctrl+Shift+Z`, and as the browser reports them. Cmd counts as Ctrl. */
import { t } from '../language/language.ts';

const MODIFIERS = ['Ctrl', 'Alt', 'Shift'] as const;

/**
 * The keys of an event, written with the modifiers in the order Ctrl, Alt, Shift; null for a modifier alone
 * and for what the keyboard has not made up its mind about, such as an accent.
 */
export function keysOf(event: KeyboardEvent): string | null {
  const name = nameOf(event);
  if (name === null) return null;
  // AltGr makes the sign; a browser on Windows reports it as Ctrl and Alt.
  const plain = event.getModifierState('AltGraph');
  // Shift is part of a sign such as ?, but not of a letter, a digit or the space bar.
  const isSign = event.key.length === 1 && !/[\p{L}\d ]/u.test(event.key);
  const held = {
    Ctrl: (event.ctrlKey || event.metaKey) && !plain,
    Alt: event.altKey && !plain,
    Shift: event.shiftKey && !isSign,
  };
  return [...MODIFIERS.filter((modifier) => held[modifier]), name].join('+');
}

function nameOf({ key, code, altKey, isComposing }: KeyboardEvent): string | null {
  if (isComposing || NOT_KEYS.has(key)) return null;
  // The digits beside the letters are others, and without NumLock these have other names.
  if (/^Numpad\d$/.test(code)) return code;
  if (key === ' ') return 'Space';
  if (key.length > 1) return key;
  // Where letters are not Latin, and where Alt makes another letter of one, its place on the keyboard counts.
  const place = /^Key([A-Z])$/.exec(code)?.[1];
  const foreign = /\p{L}/u.test(key) && !/\p{Script=Latin}/u.test(key);
  return place && (foreign || altKey) ? place : key.toUpperCase();
}

const NOT_KEYS = new Set([
  ...['Control', 'Alt', 'AltGraph', 'Shift', 'Meta', 'OS', 'CapsLock', 'NumLock', 'ScrollLock', 'Fn'],
  ...['Dead', 'Process', 'Unidentified', 'Compose'],
]);

/** The sign + itself is a key, too. */
const partsOf = (keys: string) => keys.split(/\+(?=.)/);

/** Whether a text is keys as `keysOf` writes them. */
export function isKeys(text: string): boolean {
  const parts = partsOf(text);
  const name = parts.pop() ?? '';
  const held = MODIFIERS.filter((modifier) => parts.includes(modifier));
  if (held.join('+') !== parts.join('+') || [...MODIFIERS, ...NOT_KEYS].includes(name)) return false;
  return name.length === 1 ? /^[^\s\p{Ll}]$/u.test(name) : /^[A-Z][A-Za-z0-9]+$/.test(name);
}

/** Signs in place of names that are long, or printed on the key as a sign. */
const SIGNS: Readonly<Record<string, string>> = {
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Escape: 'Esc',
};
/** What is printed on the keys of a keyboard for the page's language. */
const PRINTED: Readonly<Record<string, string>> = {
  Shift: t('Shift|key'),
  Space: t('Space|key'),
  Enter: t('Enter|key'),
  Backspace: t('Backspace|key'),
  Delete: t('Delete|key'),
  Home: t('Home|key'),
  End: t('End|key'),
  PageUp: t('PageUp|key'),
  PageDown: t('PageDown|key'),
};
const APPLE: Readonly<Record<string, string>> = { Ctrl: '⌘', Alt: '⌥', Shift: '⇧' };

/** Keys as the person's own keyboard has them. */
export function keysText(keys: string, apple = isApple()): string {
  const parts = partsOf(keys).map(
    (part) => SIGNS[part] ?? (apple ? APPLE[part] : undefined) ?? PRINTED[part] ?? part,
  );
  return parts.join(apple ? '' : '+');
}

function isApple(): boolean {
  return typeof navigator !== 'undefined' && /mac|iphone|ipad/i.test(navigator.userAgent);
}
