/** What a person is told where the browser keeps nothing. */
import { expect, test } from 'vitest';
import { explainFailure } from '../../../src/editor/storage/failure.ts';

test.each([
  [
    'no database at all, in words of a person',
    new TypeError('undefined is not an object'),
    /no storage\. Save/,
  ],
  [
    'a refusal, in the words of the browser',
    new DOMException('denied', 'SecurityError'),
    /no storage \(denied\)/,
  ],
  ['no room', new DOMException('', 'QuotaExceededError'), /storage is full/],
  ['a newer page', new DOMException('', 'InvalidStateError'), /Another tab/],
])('%s', (_, error, message) => expect(explainFailure(error)).toMatch(message));
