import fc from 'fast-check';
import { expect, test } from 'vitest';
import { findJsonFault } from '../../src/scene/json-position.ts';

const isJson = (text: string): boolean => {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
};

test('finds a fault exactly where JSON.parse does', () => {
  const mutated = fc
    .tuple(fc.json(), fc.nat(), fc.constantFrom('', ',', '"', '\\', '}', ']', '1', 'x', '\n', '-', '.'))
    .map(([text, at, piece]) => {
      const place = at % (text.length + 1);
      return text.slice(0, place) + piece + text.slice(place + 1);
    });
  fc.assert(
    fc.property(fc.oneof(fc.json(), mutated, fc.string()), (text) => {
      expect(findJsonFault(text) === null).toBe(isJson(text));
    }),
    { numRuns: 2000 },
  );
});

test.each([
  ['', 1, 1, 'expected a value, the text ends'],
  ['{"a": 1,}', 1, 9, 'expected a property name in double quotes, found "}"'],
  ['[1\n 2]', 2, 2, 'expected "," or "]", found "2"'],
  ['{"a": "b\n"}', 1, 9, 'expected the rest of a string, found "\\n"'],
  ['[1] 2', 1, 5, 'expected the end of the text, found "2"'],
  ['{"a" 1}', 1, 6, 'expected ":", found "1"'],
])('%j', (text, line, column, message) => {
  expect(findJsonFault(text)).toEqual({ line, column, message });
});

test('takes megabytes of whatever in its stride', () => {
  const long = 1e6;
  expect(findJsonFault(' '.repeat(long))).not.toBeNull();
  expect(findJsonFault(`"${'a'.repeat(long)}`)).not.toBeNull();
  expect(findJsonFault('['.repeat(long))).not.toBeNull();
  expect(findJsonFault('1'.repeat(long))).toBeNull();
});
