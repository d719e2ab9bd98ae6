/**
 * Where a text stops being JSON. Engines word their messages differently and some give no
 * position, so the first fault is found here; it runs only on text that JSON.parse refused.
 */

export interface JsonFault {
  line: number;
  column: number;
  message: string;
}

const whitespace = /[ \t\n\r]*/y;
const special = /["\\]|[^ -\u{10ffff}]/gu;
const escaped = /\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4})/y;
const scalar = /true|false|null|-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?/y;

/** The first fault, or null when the text is JSON. Works without recursion: depth costs nothing. */
export function findJsonFault(text: string): JsonFault | null {
  let at = 0;
  const take = (pattern: RegExp): boolean => {
    pattern.lastIndex = at;
    const found = pattern.test(text);
    if (found) at = pattern.lastIndex;
    return found;
  };
  const is = (character: string): boolean => {
    take(whitespace);
    if (text[at] !== character) return false;
    at += 1;
    return true;
  };
  const fault = (expected: string): JsonFault => {
    const before = text.slice(0, at);
    const line = before.split('\n').length;
    const column = at - before.lastIndexOf('\n');
    const found = at >= text.length ? 'the text ends' : `found ${JSON.stringify(text[at])}`;
    return { line, column, message: `expected ${expected}, ${found}` };
  };
  /** On a fault inside the string, `at` is left there. */
  const takeString = (): boolean => {
    if (!is('"')) return false;
    for (;;) {
      special.lastIndex = at;
      at = special.exec(text)?.index ?? text.length;
      if (text[at] === '"') {
        at += 1;
        return true;
      }
      if (!take(escaped)) return false;
    }
  };

  const open: ('}' | ']')[] = [];
  for (;;) {
    // A value, or the end of an empty collection.
    take(whitespace);
    if (is('{')) {
      if (!is('}')) {
        open.push('}');
        if (!takeString()) return fault('a property name in double quotes');
        if (!is(':')) return fault('":"');
        continue;
      }
    } else if (is('[')) {
      if (!is(']')) {
        open.push(']');
        continue;
      }
    } else if (text[at] === '"') {
      if (!takeString()) return fault('the rest of a string');
    } else if (!take(scalar)) {
      return fault('a value');
    }
    // What may follow a value.
    for (;;) {
      const close = open.at(-1);
      if (close === undefined) {
        take(whitespace);
        return at === text.length ? null : fault('the end of the text');
      }
      if (is(close)) {
        open.pop();
        continue;
      }
      if (!is(',')) return fault(`"," or "${close}"`);
      if (close === '}') {
        if (!takeString()) return fault('a property name in double quotes');
        if (!is(':')) return fault('":"');
      }
      break;
    }
  }
}
