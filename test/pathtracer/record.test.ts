import { createHash } from 'node:crypto';
import { expect, test } from 'vitest';
import { fromAttributes } from '../../src/cli/render/record.ts';
import { documentHash, type RenderRecord, toAttributes } from '../../src/pathtracer/record.ts';
import { createDocument, serializeDocument } from '../../src/scene/document.ts';

const record: RenderRecord = {
  renderer: 'pathtracer',
  version: '1.2.3',
  document: 'abc',
  camera: '{}',
  seed: 2 ** 32 - 1,
  maxDepth: 16,
  clamp: 0.1,
  strategy: 'mis',
  name: 'A',
  samples: [
    { from: 0, to: 4 },
    { from: 8, to: 9 },
  ],
  until: 'samples 0:9',
  device: 'a fake',
  exposure: -1.5,
  toneMapping: 'neutral',
  denoised: true,
};

test('what is written is read, seeds of 32 bits included', () => {
  expect(fromAttributes(toAttributes(record), 'a.exr')).toEqual(record);
  expect(toAttributes(record)).toMatchObject({ 'irradia:seed': '4294967295', 'irradia:maxDepth': 16 });
});

test('a document that is not known is not written, and misses when parts are merged', () => {
  expect(() => fromAttributes(toAttributes({ ...record, document: '' }), 'a.exr')).toThrow(
    'a.exr: the header has no irradia:document',
  );
});

test("a document's hash is that of its file", async () => {
  const document = createDocument();
  const hash = createHash('sha256').update(serializeDocument(document)).digest('hex');
  expect(await documentHash(document)).toBe(hash);
});
