/** The structure of files becomes groups of the document, everything stands where it stood, and a GLB of it comes back. */
import fc from 'fast-check';
import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { addImported } from '../../src/io/gltf.ts';
import { exportGltf } from '../../src/io/gltf-export.ts';
import { importModel, importObjectScene } from '../../src/io/import-model.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { createDocument, parseDocument } from '../../src/scene/document.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { exported, type Json, triangle } from './gltf-files.ts';

const assets = new AssetLoader(nodeAssets);

async function bring(name: string, content: Uint8Array | string | object): Promise<DocumentStore> {
  const store = new DocumentStore(createDocument());
  const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
  const imported =
    bytes instanceof Uint8Array
      ? await importModel(bytes, name, assets)
      : await importObjectScene(JSON.parse(JSON.stringify(bytes)), name, assets);
  if (!imported) throw new Error('not a model');
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
  });
  return store;
}

type Tree = (string | { [group: string]: Tree })[];

/** Groups first, then what is in none: the tree as a person sees it. */
function treeOf(document: Document, parent: string | null = null): Tree {
  const groups = Object.entries(document.groups).filter(([, group]) => group.parent === parent);
  const members = [...Object.values(document.lights), ...Object.values(document.objects)];
  return [
    ...groups.map(([id, { name }]) => ({ [name]: treeOf(document, id) })),
    ...members.filter(({ group }) => group === parent).map(({ name }) => name),
  ];
}

/** Where everything is in the world, by name. */
async function worlds(document: Document): Promise<Map<string, number[]>> {
  const mirror = new SceneMirror({ assets, onError: expect.fail });
  mirror.apply(document);
  await mirror.settled();
  mirror.scene.updateMatrixWorld();
  const found = new Map<string, number[]>();
  for (const [id, { name }] of Object.entries(document.objects))
    found.set(name, mirror.objectFor(id)!.matrixWorld.toArray());
  mirror.dispose();
  return found;
}

function expectSame(found: Map<string, number[]>, wanted: Map<string, number[]>): void {
  expect([...found.keys()].sort()).toEqual([...wanted.keys()].sort());
  for (const [name, matrix] of wanted) {
    const worst = Math.max(...matrix.map((value, i) => Math.abs(value - found.get(name)![i]!)));
    expect(worst, name).toBeLessThan(1e-5);
  }
}

const box = (name: string): THREE.Mesh =>
  Object.assign(new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshStandardMaterial()), { name });
function set(name: string, ...children: THREE.Object3D[]): THREE.Group {
  const group = Object.assign(new THREE.Group(), { name });
  for (const child of children) group.add(child);
  return group;
}

/** A chair beside a lamp, with transforms at every level. */
function room(): THREE.Scene {
  const legs = set('Legs', box('Left leg'), box('Right leg'));
  legs.position.set(0, -1, 0.5);
  legs.rotation.set(0.2, 0.4, -0.3);
  const seat = box('Seat');
  seat.scale.set(2, 0.25, 2);
  const chair = set('Chair', legs, seat, set('Cushion', box('')), set('Nothing'));
  chair.rotation.y = 1;
  chair.scale.setScalar(3);
  const bulb = Object.assign(new THREE.PointLight(0xffffff, 40), { name: 'Bulb' });
  const lamp = set('Wrapper', set('Lamp', box('Shade'), bulb));
  lamp.position.set(4, 1, 0);
  const scene = new THREE.Scene();
  scene.add(chair, lamp);
  scene.updateMatrixWorld();
  return scene;
}

const ofRoom: Tree = [
  {
    room: [{ Chair: [{ Legs: ['Left leg', 'Right leg'] }, 'Seat', 'Cushion'] }, { Lamp: ['Bulb', 'Shade'] }],
  },
];

function worldsOf(scene: THREE.Object3D): Map<string, number[]> {
  const found = new Map<string, number[]>();
  scene.traverse((object) => {
    if (object instanceof THREE.Mesh)
      found.set(object.name || object.parent!.name, object.matrixWorld.toArray());
  });
  return found;
}

describe('what several things are under becomes a group, named as in the file', () => {
  test('of a scene of three.js', async () => {
    const scene = room();
    const { document } = await bring('room.json', scene.toJSON());
    expect(treeOf(document)).toEqual(ofRoom);
    expectSame(await worlds(document), worldsOf(scene));
  });

  test('of a glTF file, which is undone in one step', async () => {
    const scene = room();
    const store = await bring('room.glb', await exported(scene));
    expect(treeOf(store.document)).toEqual(ofRoom);
    expectSame(await worlds(store.document), worldsOf(scene));
    store.undo();
    expect(store.document).toEqual(createDocument());
  });

  test('of an OBJ file', async () => {
    const face = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n';
    const text = `o Chair\ng legs\n${face}g seat\n${face}o Ball\n${face}usemtl a\n${face}o Cup\ng handle\n${face}`;
    const { document } = await bring('room.obj', text);
    expect(treeOf(document)).toEqual([
      { room: [{ Chair: ['legs', 'seat'] }, { Ball: ['Ball 1', 'Ball 2'] }, 'handle'] },
    ]);
    // Groups without objects are the objects themselves.
    expect(treeOf((await bring('two.obj', `g a\n${face}g b\n${face}`)).document)).toEqual([
      { two: ['a', 'b'] },
    ]);
  });

  test('a file of one thing has none; a root without a name of its own has the name of the file', async () => {
    const alone = new THREE.Scene().add(set('Wrapper', box('Ball')));
    expect(treeOf((await bring('ball.json', alone.toJSON())).document)).toEqual(['Ball']);
    const nodes = [
      { name: 'RootNode', children: [1, 2] },
      { mesh: 0, name: 'a' },
      { mesh: 0, name: 'b' },
    ];
    expect(treeOf((await bring('pair.glb', triangle({ nodes }))).document)).toEqual([{ pair: ['a', 'b'] }]);
    const named = [{ ...nodes[0], name: 'Pair of shoes' }, ...nodes.slice(1)];
    expect(treeOf((await bring('x.glb', triangle({ nodes: named }))).document)).toEqual([
      { 'Pair of shoes': ['a', 'b'] },
    ]);
  });

  test('joints of a skeleton are none', async () => {
    const mesh = (name: string) => ({ mesh: 0, name });
    const nodes: Json[] = [
      { name: 'Figure', children: [1, 2] },
      mesh('Skin'),
      { name: 'Hip', children: [3, 4] },
      mesh('Belt'),
      { name: 'Knee', children: [5, 6] },
      mesh('Pad'),
      mesh('Buckle'),
    ];
    const { document } = await bring('figure.glb', triangle({ nodes, skins: [{ joints: [2, 4] }] }));
    expect(treeOf(document)).toEqual([{ Figure: ['Skin', 'Belt', 'Pad', 'Buckle'] }]);
    const bones = new THREE.Bone();
    bones.add(box('Belt'), box('Pad'));
    const three = new THREE.Scene().add(set('Figure', bones, box('Skin')));
    expect(treeOf((await bring('figure.json', three.toJSON())).document)).toEqual([
      { Figure: ['Belt', 'Pad', 'Skin'] },
    ]);
  });
});

describe('a GLB of groups, read again', () => {
  const scene = (parts: Json): Document => parseDocument({ format: 'irradia', version: 1, ...parts }, 'test');

  test('is the same tree of the same names, in the same order and places, whatever the tree is', async () => {
    const vector = (least: number, most: number) =>
      fc.tuple(...[0, 1, 2].map(() => fc.double({ min: least, max: most, noNaN: true })));
    const member = fc.record({
      group: fc.nat(),
      position: vector(-9, 9),
      rotation: vector(-180, 180),
      scale: vector(0.1, 3),
    });
    const lamp = fc.record({ group: fc.nat(), position: vector(-9, 9) });
    await fc.assert(
      fc.asyncProperty(
        fc.array(fc.nat(), { maxLength: 8 }),
        fc.array(member, { minLength: 1, maxLength: 8 }),
        fc.array(lamp, { maxLength: 3 }),
        async (parents, members, lamps) => {
          const within = (count: number, pick: number) => {
            const at = pick % (count + 1);
            return at === 0 ? null : `g${at}`;
          };
          const record = <T>(values: readonly T[], letter: string) =>
            Object.fromEntries(values.map((value, i) => [`${letter}${i + 1}`, value]));
          const place = <T extends { group: number }>(value: T, name: string) => ({
            ...value,
            name,
            group: within(parents.length, value.group),
          });
          const document = scene({
            groups: record(
              parents.map((pick, i) => ({ name: `Group ${i + 1}`, parent: within(i, pick) })),
              'g',
            ),
            materials: { m: { name: 'Paint', model: 'lambert' } },
            objects: record(
              members.map((value, i) => ({
                ...place(value, `Object ${i + 1}`),
                material: 'm',
                geometry: { type: 'box' },
              })),
              'o',
            ),
            lights: record(
              lamps.map((value, i) => ({ ...place(value, `Lamp ${i + 1}`), type: 'point' })),
              'l',
            ),
          });
          const { bytes } = await exportGltf(document, assets);
          const again = (await bring('again.glb', bytes)).document;
          // A group that nothing is in is none in the file.
          const filled = (tree: Tree): Tree =>
            tree.flatMap((entry): Tree => {
              if (typeof entry === 'string') return [entry];
              const [[name, inside]] = Object.entries(entry) as [[string, Tree]];
              const kept = filled(inside);
              return kept.length > 0 ? [{ [name]: kept }] : [];
            });
          expect(treeOf(again)).toEqual(filled(treeOf(document)));
          expectSame(await worlds(again), await worlds(document));
        },
      ),
      { numRuns: 12 },
    );
  });

  test('has groups as nodes that other programs read', async () => {
    const store = await bring('room.json', room().toJSON());
    const { bytes } = await exportGltf(store.document, assets);
    const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
    const { scene: read } = await new GLTFLoader().parseAsync(bytes.slice().buffer, '');
    read.updateMatrixWorld();
    const legs = read.getObjectByName('Legs')!;
    expect(legs.parent!.name).toBe('Chair');
    expect(legs.parent!.parent!.name).toBe('room');
    const found = worldsOf(read);
    // three.js's loader writes names without spaces.
    const wanted = [...worldsOf(room())].map(
      ([name, matrix]) => [name.replaceAll(' ', '_'), matrix] as const,
    );
    expectSame(found, new Map(wanted));
  });
});

describe('trees that nobody made by hand', () => {
  /** Nodes in one another, each with a triangle of its own. */
  const deep = (count: number): Json[] =>
    Array.from({ length: count }, (_, i) => ({
      mesh: 0,
      name: `n${i}`,
      translation: [0, 0, 1],
      ...(i + 1 < count && { children: [i + 1] }),
    }));

  test('ten thousand nodes in one another are all there, in groups of a depth that has an end', async () => {
    const store = new DocumentStore(createDocument());
    const imported = await importModel(triangle({ nodes: deep(10_000) }), 'deep.glb', assets);
    store.edit(imported.label, (draft) => {
      addImported(draft, imported);
    });
    const objects = Object.values(store.document.objects);
    expect(objects).toHaveLength(10_000);
    expect(objects.at(-1)!.position[2]).toBe(10_000);
    expect(Object.keys(store.document.groups)).toHaveLength(32);
    expect(imported.notes.join()).toMatch('its groups are 9999 deep: those deeper than 32 are not kept');
  });

  test('the same in a scene of three.js', async () => {
    let object: Json = { type: 'Mesh', geometry: 'g', name: 'last' };
    for (let i = 0; i < 10_000; i++)
      object = { type: i % 10 ? 'Group' : 'Mesh', geometry: 'g', position: [0, 1, 0], children: [object] };
    const json = {
      metadata: { type: 'Object' },
      geometries: [{ uuid: 'g', type: 'BoxGeometry' }],
      object,
    };
    const imported = await importObjectScene(json, 'deep.json', assets);
    expect(imported!.contents.objects).toHaveLength(1001);
    expect(imported!.contents.groups).toHaveLength(32);
    expect(imported!.contents.objects.at(-1)!.object).toMatchObject({
      name: 'last',
      position: [0, 10_000, 0],
    });
  });

  test('more groups than a document could have are as many as it can', async () => {
    const pairs = Array.from({ length: 3000 }, (_, i) => [
      { name: `p${i}`, children: [3 * i + 1, 3 * i + 2] },
      { mesh: 0 },
      { mesh: 0 },
    ]).flat();
    const scenes = [{ nodes: pairs.flatMap((node, i) => ('children' in node ? [i] : [])) }];
    const { document } = await bring('many.glb', triangle({ nodes: pairs, scenes }));
    expect(Object.values(document.groups).map(({ name }) => name)).toEqual(['many']);
    expect(Object.keys(document.objects)).toHaveLength(6000);
  });

  test.each([
    ['a node in itself', [{ children: [0] }], 'already has a parent|own descendants'],
    ['a circle', [{ children: [1] }, { children: [0], mesh: 0 }], 'among its own descendants'],
    ['two parents', [{ children: [2] }, { children: [2] }, { mesh: 0 }], 'already has a parent'],
    ['a child that is not there', [{ children: [7], mesh: 0 }], 'no nodes\\[7\\]'],
  ])('%s is an error that says so', async (_, nodes, message) => {
    await expect(importModel(triangle({ nodes }), 'bad.glb', assets)).rejects.toThrow(new RegExp(message));
  });
});
