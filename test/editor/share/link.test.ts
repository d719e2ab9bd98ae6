import { deflateRawSync } from 'node:zlib';
import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import { loadScene, sceneNames } from '../../../scenes/index.ts';
import { documentOfLink, isLink, MAX_ADDRESS, MAX_TEXT } from '../../../src/editor/share/link.ts';
import { linkFor } from '../../../src/editor/share/link-text.ts';
import { compactDocument } from '../../../src/scene/compact.ts';
import { createDocument, parseDocument, serializeDocument } from '../../../src/scene/document.ts';
import type { Document } from '../../../src/scene/schema.ts';

const scenes = await Promise.all(sceneNames.map((name) => loadScene(name)));

type Json = Record<string, unknown>;

/** Every number, text and truth value in it: the holder and the key. */
function leaves(value: unknown): [Json, string][] {
  if (typeof value !== 'object' || value === null) return [];
  return Object.entries(value).flatMap(([key, part]): [Json, string][] =>
    typeof part === 'object' ? leaves(part) : [[value as Json, key]],
  );
}

/** The scene with some fields gone back to their defaults and some numbers changed; null if it is no document. */
function varied(scene: Document, steps: readonly (readonly [at: number, factor: number])[]): Document | null {
  const json = structuredClone(scene) as unknown as Json;
  for (const [at, factor] of steps) {
    const all = leaves(json);
    const [holder, key] = all[at % all.length] ?? [json, 'name'];
    const old = holder[key];
    if (Array.isArray(holder) || factor > 0.5) {
      if (typeof old === 'number') holder[key] = Number.isInteger(old) ? old + 1 : old * factor;
    } else if (factor < 0.25) delete holder[key];
  }
  try {
    return parseDocument(json, 'varied');
  } catch {
    return null;
  }
}

const fragmentOf = (bytes: Uint8Array) => `#document=${Buffer.from(bytes).toString('base64url')}`;

describe('a link', () => {
  it('gives back the same document, to the letter', async () => {
    const step = fc.tuple(fc.nat(100_000), fc.double({ min: 0, max: 1, noNaN: true }));
    await fc.assert(
      fc.asyncProperty(
        fc.constantFrom(...scenes),
        fc.array(step, { maxLength: 12 }),
        async (scene, steps) => {
          const document = varied(scene, steps);
          fc.pre(document !== null);
          const back = await documentOfLink(await linkFor(document));
          expect(serializeDocument(back)).toBe(serializeDocument(document));
        },
      ),
      { numRuns: 30 },
    );
  });

  it('carries pasted sources and names of any script', async () => {
    const source =
      'analytic\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(.3); }\n::end shader\n';
    const document = parseDocument(
      {
        ...createDocument('Ünï—漢字 <b>&amp;</b>'),
        models: { mine: { source } },
        materials: { m: { name: 'M', model: 'mine' } },
      },
      'a.json',
    );
    expect(await documentOfLink(await linkFor(document))).toEqual(document);
  });

  it('of every scene that ships fits', async () => {
    for (const scene of scenes) {
      const link = await linkFor(scene);
      expect(isLink(link)).toBe(true);
      expect(link.length).toBeLessThan(MAX_ADDRESS);
    }
  });

  it('leaves out what the defaults say', () => {
    expect(compactDocument(createDocument())).toEqual({ format: 'irradia', version: 1 });
  });

  it('that holds too much is not unpacked to its end', async () => {
    // 16 MB of spaces; a bomb's JSON would even be valid.
    const bomb = deflateRawSync(Buffer.alloc(4 * MAX_TEXT, 0x20));
    const decode = vi.spyOn(TextDecoder.prototype, 'decode');
    await expect(documentOfLink(fragmentOf(bomb))).rejects.toThrow('more than 4 MB');
    const bytes = decode.mock.calls.reduce((sum, [part]) => sum + (part?.byteLength ?? 0), 0);
    decode.mockRestore();
    expect(bytes).toBeLessThan(2 * MAX_TEXT);
  });

  const linked = (content: object | string) =>
    fragmentOf(deflateRawSync(typeof content === 'string' ? content : JSON.stringify(content)));
  const document = (content: object) => linked({ format: 'irradia', version: 1, ...content });
  const shader = (code: string) =>
    document({ models: { mine: { source: `analytic\n::begin shader\n${code}\n::end shader\n` } } });
  const brdf = (body: string) => shader(`vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n${body}\n}`);
  const spheres = (count: number) => ({
    materials: { m: { model: 'lambert' } },
    objects: Object.fromEntries(
      Array.from({ length: count }, (_, i) => [
        `o${i}`,
        {
          material: 'm',
          geometry: { type: 'sphere', radius: 1 + i, widthSegments: 512, heightSegments: 512 },
        },
      ]),
    ),
  });
  const doubling = Array.from(
    { length: 30 },
    (_, i) => `float f${i + 1}(float x) { return f${i}(x) + f${i}(.5 * x); }`,
  ).join('\n');
  const inside = 'vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)';

  it.each([
    ['brackets without end', linked('['.repeat(1e6)), /not JSON/],
    [
      'too deep',
      linked(`{"format":"irradia","version":1,"x":${'['.repeat(1e5)}${']'.repeat(1e5)}}`),
      /levels/,
    ],
    ['a prototype', linked('{"format":"irradia","version":1,"materials":{"__proto__":{}}}'), /__proto__/],
    [
      'a prototype’s parameter',
      document({ materials: { m: { model: 'lambert', parameters: { toString: 1 } } } }),
      /no such parameter/,
    ],
    ['a prototype as its model', document({ materials: { m: { model: 'constructor' } } }), /no model/],
    ['objects without number', document(spheres(20_001)), /at most 20000/],
    ['triangles without number', document(spheres(2000)), /together .* triangles/],
    ['groups without end', document({ groups: { a: { parent: 'b' }, b: { parent: 'a' } } }), /in itself/],
    ['an endless loop', brdf('vec3 s = vec3(0.); for (;;) s += .1; return s;'), /constant bounds/],
    [
      'a loop that stands still',
      brdf('vec3 s = vec3(0.); for (float i = 0.; i < 1.; i += 0.) s += .1; return s;'),
      /constant bounds/,
    ],
    [
      'loops in loops',
      brdf(
        'vec3 s = vec3(0.); for (int i = 0; i < 4000; i++) for (int j = 0; j < 4000; j++) s += .1; return s;',
      ),
      /does too much/,
    ],
    [
      'calls without number',
      shader(`float f0(float x) { return x; }\n${doubling}\n${inside} { return vec3(f30(1.)); }`),
      /does too much/,
    ],
    [
      'a function that calls itself',
      shader(`float f(float x) { return f(x); }\n${inside} { return vec3(f(1.)); }`),
      /calls itself/,
    ],
    ['brackets in a shader', brdf(`return vec3(${'('.repeat(1e5)}1.${')'.repeat(1e5)});`), /too long/],
    ['memory without end', brdf('float x[100000000]; return vec3(x[0]);'), /from 1 to 4096/],
    ['a file of the server’s', shader('::include ../../../../etc/passwd'), /no file/],
    [
      'an address for an environment',
      document({ environment: { source: { type: 'preset', name: 'https://example.com/x.hdr' } } }),
      /environment\.source\.name/,
    ],
    [
      'a media type with a header',
      document({ assets: { a: { name: 'a', mediaType: 'text/html;charset=x', data: '' } } }),
      /mediaType/,
    ],
    ['an infinite number', linked('{"format":"irradia","version":1,"camera":{"fov":1e999}}'), /camera\.fov/],
  ])('with %s is refused', async (_, link, message) => {
    await expect(documentOfLink(link)).rejects.toThrow(message);
  });

  it.each([
    ['cut off', async () => (await linkFor(scenes[0]!)).slice(0, -40), /damaged/],
    ['not base64', async () => '#document=<script>', /damaged/],
    ['not deflated', async () => fragmentOf(Buffer.from('hello')), /damaged/],
    ['no text', async () => fragmentOf(deflateRawSync(Buffer.from([0xff, 0xfe, 0x80]))), /damaged/],
    [
      'cut within a letter',
      async () => fragmentOf(deflateRawSync(Buffer.concat([Buffer.from('{}'), Buffer.from([0xc3])]))),
      /damaged/,
    ],
    ['empty', async () => '#document=', /damaged|not JSON/],
    ['another format', async () => fragmentOf(deflateRawSync('{"format":"x"}')), /not an Irradia document/],
  ])('that is %s is refused', async (_, link, message) => {
    await expect(documentOfLink(await link())).rejects.toThrow(message);
  });

  it('survives line breaks and padding that a mail program adds', async () => {
    const link = await linkFor(createDocument('Mail'));
    const broken = `${link.slice(0, 30)}\n${link.slice(30)}%3D`;
    expect((await documentOfLink(broken)).name).toBe('Mail');
  });
});
