import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { loadScene, sceneNames } from '../../scenes/index.ts';
import { createDocument, parseDocument, serializeDocument } from '../../src/scene/document.ts';
import { DocumentError } from '../../src/scene/error.ts';
import { lightDefaults, lightTypes } from '../../src/scene/light-schema.ts';

/** The error that parsing gives; anything else than a DocumentError fails the test. */
function errorOf(input: unknown): DocumentError {
  try {
    parseDocument(input, 'a.json');
  } catch (error) {
    if (error instanceof DocumentError) return error;
    throw error;
  }
  throw new Error('the document was accepted');
}

const header = { format: 'irradia', version: 1 } as const;

describe('parseDocument', () => {
  test('fills in what a file leaves out', () => {
    const document = parseDocument({ ...header, lights: { key: { type: 'point' } } }, 'a.json');
    expect(document.lights.key).toEqual(lightDefaults.point);
    expect(document.camera.fov).toBe(75);
    expect(document.environment.source).toEqual({ type: 'none' });
  });

  test('gives every light type its defaults', () => {
    for (const type of lightTypes) {
      const document = parseDocument({ ...header, lights: { a: { type } } }, 'a.json');
      expect(document.lights.a).toEqual(lightDefaults[type]);
    }
  });

  test('says where text stops being JSON', () => {
    const error = errorOf('{\n  "format": "irradia",\n  version: 1\n}');
    expect(error.message).toBe(
      'a.json: not JSON at line 3, column 3: expected a property name in double quotes, found "v"',
    );
  });

  test.each([
    ['null', 'a.json: not an Irradia document: expected a JSON object'],
    ['[1]', 'a.json: not an Irradia document: expected a JSON object'],
    ['{"format":"gltf"}', 'a.json: format: not an Irradia document: expected "irradia"'],
  ])('refuses %s', (text, message) => {
    expect(errorOf(text).message).toBe(message);
  });

  test('refuses a document of a newer version', () => {
    expect(errorOf({ ...header, version: 2 }).message).toMatch(
      /^a\.json: version: the document has version 2, this Irradia reads up to 1/,
    );
  });

  const material = { name: 'M', model: 'lambert' };
  test.each<[string, object, string | RegExp]>([
    ['lights.key.position[1]', { lights: { key: { type: 'point', position: [0, 'up', 0] } } }, /number/],
    ['lights.key.type', { lights: { key: { type: 'laser' } } }, /spot/],
    ['lights.key.wattage', { lights: { key: { type: 'point', wattage: 60 } } }, 'there is no such field'],
    ['lights["1st"]', { lights: { '1st': { type: 'point' } } }, /name or id/],
    ['camera.fov', { camera: { fov: 400 } }, /170/],
    ['camera.near', { camera: { near: 10, far: 1 } }, /camera\.far/],
    ['objects.a.material', { objects: { a: { material: 'clay', geometry: { type: 'box' } } } }, /"clay"/],
    ['materials.a.model', { materials: { a: { ...material, model: 'phong' } } }, /no model "phong"/],
    [
      'materials.a.parameters.shine',
      { materials: { a: { ...material, parameters: { shine: 1 } } } },
      /no such parameter/,
    ],
    [
      'materials.a.parameters.roughness',
      { materials: { a: { name: 'M', model: 'principled', parameters: { roughness: [1, 1, 1] } } } },
      'expected a finite number',
    ],
    [
      'materials.a.textures.roughness.asset',
      { materials: { a: { name: 'M', model: 'principled', textures: { roughness: { asset: 'dust' } } } } },
      /no asset "dust"/,
    ],
    ['lights.a.group', { lights: { a: { type: 'point', group: 'trees' } } }, 'there is no group "trees"'],
    ['groups.a.parent', { groups: { a: { parent: 'b' } } }, 'there is no group "b"'],
    [
      'groups.a.parent',
      { groups: { a: { parent: 'b' }, b: { parent: 'a' } } },
      'the group would be in itself',
    ],
    ['environment.source.asset', { environment: { source: { type: 'hdr', asset: 'sky' } } }, /no asset/],
    ['view.term.material', { view: { term: { material: 'a', name: 'BRDF' } } }, /no material/],
    [
      'view.term.name',
      { materials: { a: material }, view: { term: { material: 'a', name: 'magic' } } },
      /no term "magic"/,
    ],
    ['assets.a.data', { assets: { a: { name: 'a', mediaType: 'image/png', data: '@@@@' } } }, 'Not base64'],
    [
      'models.glow.source',
      { models: { glow: { source: 'analytic\n::begin shader\nvec3' } } },
      /glow\.brdf:\d/,
    ],
    ['settings', { settings: {} }, 'there is no such field'],
  ])('names the field that is wrong: %s', (path, content, message) => {
    const error = errorOf({ ...header, ...content });
    expect(error.path).toBe(path);
    expect(error.file).toBe('a.json');
    const [issue] = error.issues;
    if (typeof message === 'string') expect(issue?.message).toBe(message);
    else expect(issue?.message).toMatch(message);
  });

  test('allows values beyond a parameter’s range, as long as they are finite', () => {
    const parameters = { metallic: 1.5, roughness: -0.2 };
    const document = parseDocument(
      { ...header, materials: { a: { name: 'M', model: 'principled', parameters } } },
      'a.json',
    );
    expect(document.materials.a?.parameters).toEqual(parameters);
  });

  test('refuses geometry that would not fit into memory', () => {
    const sphere = { type: 'sphere', widthSegments: 4096, heightSegments: 4096 };
    const error = errorOf({
      ...header,
      materials: { m: material },
      objects: { a: { material: 'm', geometry: sphere } },
    });
    expect(error.message).toMatch(/a\.json: objects\.a\.geometry.*triangles/);

    // Each is allowed; equal ones are made once.
    const fine = (radii: readonly number[]) => ({
      ...header,
      materials: { m: material },
      objects: Object.fromEntries(
        radii.map((radius, i) => [
          `s${i}`,
          { material: 'm', geometry: { type: 'sphere', radius, widthSegments: 2048, heightSegments: 2048 } },
        ]),
      ),
    });
    expect(errorOf(fine([1, 2, 3, 4, 5])).message).toMatch(/a\.json: objects: .*together.*triangles/);
    expect(parseDocument(fine([1, 2, 3, 4, 4, 4]), 'a.json')).toBeDefined();
  });

  test('refuses more values than a document could have before looking at any', () => {
    const row = new Array(2000).fill(0);
    expect(errorOf({ ...header, objects: new Array(2001).fill(row) }).message).toContain('values');
  });

  test('refuses groups nested so deep that panels would overflow', () => {
    const nested = (depth: number) => ({
      ...header,
      // From the outermost, and the other way round.
      groups: Object.fromEntries(
        Array.from({ length: depth }, (_, i) => [`g${i}`, { parent: i > 0 ? `g${i - 1}` : null }]).sort(
          depth % 2 ? undefined : () => -1,
        ),
      ),
    });
    for (const depth of [257, 258])
      expect(errorOf(nested(depth)).issues.map(({ message }) => message)).toEqual([
        'more than 256 groups within each other',
      ]);
    for (const depth of [255, 256]) expect(parseDocument(nested(depth), 'a.json')).toBeDefined();
  });

  test('refuses nesting without end, at once', () => {
    const text = `{"format":"irradia","version":1,"lights":${'{"a":'.repeat(1e5)}1${'}'.repeat(1e5)}}`;
    expect(errorOf(text).message).toMatch(/nested/);
  });

  test('is not misled by the names of inherited properties', () => {
    const text =
      '{"format":"irradia","version":1,"lights":{"__proto__":{"type":"point"}},"materials":{"a":{"model":"constructor"}}}';
    expect(errorOf(text).issues.map(({ path }) => path)).toEqual(['lights.__proto__']);
    const error = errorOf({ ...header, materials: { a: { name: 'M', model: 'constructor' } } });
    expect(error.path).toBe('materials.a.model');
  });
});

describe('serializeDocument', () => {
  test('and parseDocument are inverse, and the text is stable', async () => {
    for (const name of sceneNames) {
      const document = await loadScene(name);
      const text = serializeDocument(document);
      const again = parseDocument(text, `${name}.json`);
      expect(again).toEqual(document);
      expect(serializeDocument(again)).toBe(text);
    }
  });

  test('does not depend on the order in which fields were set', () => {
    const document = createDocument('Order');
    const { name, ...rest } = document;
    expect(serializeDocument({ ...rest, name })).toBe(serializeDocument(document));
  });
});

describe('hostile documents', () => {
  const junk = fc.oneof(
    fc.jsonValue({ maxDepth: 3 }),
    fc.constantFrom(null, Number.NaN, Number.POSITIVE_INFINITY, -1, 1e308, '', '__proto__', [], {}),
    fc.bigInt(),
  );

  test('one changed value: accepted, or refused with a path', async () => {
    const scenes = await Promise.all(sceneNames.map((name) => loadScene(name)));
    fc.assert(
      fc.property(fc.constantFrom(...scenes), fc.nat(), junk, (scene, at, value) => {
        const json = structuredClone(scene) as unknown;
        const places = leaves(json);
        const [holder, key] = places[at % places.length]!;
        (holder as Record<string, unknown>)[key] = value;
        const error = accepted(json);
        if (error !== null) expect(error.path === '' && error.issues.length === 0).toBe(false);
      }),
      { numRuns: 300 },
    );
  });

  test('a field taken away or added: accepted, or refused with a path', async () => {
    const scenes = await Promise.all(sceneNames.map((name) => loadScene(name)));
    fc.assert(
      fc.property(fc.constantFrom(...scenes), fc.nat(), fc.string(), junk, (scene, at, added, value) => {
        const json = structuredClone(scene) as unknown;
        const places = leaves(json);
        const [holder, key] = places[at % places.length]!;
        delete (holder as Record<string, unknown>)[key];
        if (!Array.isArray(holder)) (holder as Record<string, unknown>)[added] = value;
        const error = accepted(json);
        if (error !== null) expect(error.path).not.toBe('');
      }),
      { numRuns: 300 },
    );
  });

  test('text cut off, or with a character changed: accepted, or a DocumentError', async () => {
    const text = serializeDocument(await loadScene('thesis'));
    fc.assert(
      fc.property(fc.nat(text.length), fc.string({ maxLength: 2 }), fc.boolean(), (at, piece, cut) => {
        accepted(text.slice(0, at) + piece + (cut ? '' : text.slice(at + 1)));
      }),
      { numRuns: 300 },
    );
  });

  /** The error, or null; anything thrown that is not a DocumentError fails the test. */
  function accepted(input: unknown): DocumentError | null {
    try {
      parseDocument(input, 'hostile.json');
      return null;
    } catch (error) {
      if (error instanceof DocumentError) return error;
      throw error;
    }
  }

  /** Every value in the tree, as the object that holds it and its key there. */
  function leaves(json: unknown): [holder: object, key: string][] {
    if (typeof json !== 'object' || json === null) return [];
    return Object.entries(json).flatMap(([key, value]) => [
      [json, key] as [object, string],
      ...leaves(value),
    ]);
  }
});
