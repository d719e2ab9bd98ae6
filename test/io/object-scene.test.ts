/** three.js's own scene files: what its toJSON() writes becomes a document that shows the same. */
import fc from 'fast-check';
import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { linkFor } from '../../src/editor/share/link-text.ts';
import { addImported } from '../../src/io/gltf.ts';
import { importObjectScene } from '../../src/io/import-model.ts';
import { encodePng } from '../../src/io/png.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { encodeBase64 } from '../../src/scene/base64.ts';
import { createDocument } from '../../src/scene/document.ts';
import { createPrimitive, type Primitive } from '../../src/scene/mirror/geometry.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';

const assets = new AssetLoader(nodeAssets);
type Json = Record<string, unknown>;

async function bring(json: unknown): Promise<{ document: Document; notes: string[] }> {
  const store = new DocumentStore(createDocument());
  const imported = await importObjectScene(JSON.parse(JSON.stringify(json)), 'scene.json', assets);
  if (imported === null) throw new Error('not taken for a scene of three.js');
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
  });
  return { document: store.document, notes: imported.notes };
}

function sample(): THREE.Scene {
  const scene = new THREE.Scene();
  const group = new THREE.Group();
  group.position.set(1, 2, 3);
  group.rotation.y = Math.PI / 2;
  const box = new THREE.Mesh(
    new THREE.BoxGeometry(1, 2, 3),
    new THREE.MeshPhysicalMaterial({
      name: 'Lacquer',
      color: 0x804020,
      roughness: 0.3,
      metalness: 0.1,
      clearcoat: 0.8,
      ior: 1.4,
      emissive: 0xff0000,
      emissiveIntensity: 3,
    }),
  );
  box.name = 'Box';
  box.scale.setScalar(2);
  const bare = new THREE.BufferGeometry();
  bare.setAttribute('position', new THREE.Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0], 3));
  const triangle = new THREE.Mesh(
    bare,
    new THREE.MeshPhongMaterial({ shininess: 100, side: THREE.DoubleSide }),
  );
  triangle.name = 'Triangle';
  triangle.visible = false;
  group.add(box, triangle);
  const spot = new THREE.SpotLight(0xffffff, 12, 7, Math.PI / 6, 0.25, 2);
  spot.position.set(0, 5, 0);
  spot.target = box;
  const panel = new THREE.RectAreaLight(0xffffff, 3, 2, 1);
  panel.position.set(0, 0, 4);
  scene.add(
    group,
    spot,
    panel,
    new THREE.AmbientLight(0xffffff, Math.PI),
    new THREE.PointLight(0xff0000, 5, 0, 0),
  );
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 50);
  camera.position.set(0, 1, 9);
  scene.add(camera);
  // toJSON() writes the matrices that there are.
  scene.updateMatrixWorld();
  return scene;
}

const near = (found: readonly number[], expected: readonly number[], digits = 5): void => {
  expect(found).toHaveLength(expected.length);
  found.forEach((value, i) => {
    expect(value).toBeCloseTo(expected[i]!, digits);
  });
};

describe('a scene of three.js', () => {
  test('has its objects where the groups put them, with materials, lights and camera', async () => {
    const { document } = await bring(sample().toJSON());
    const [box, triangle] = Object.values(document.objects);
    expect(box).toMatchObject({ name: 'Box', visible: true });
    near(box!.position, [1, 2, 3]);
    near(box!.rotation, [0, 90, 0], 3);
    near(box!.scale, [2, 2, 2]);
    expect(triangle).toMatchObject({ name: 'Triangle', visible: false });
    const lacquer = document.materials[box!.material]!;
    expect(lacquer).toMatchObject({
      name: 'Lacquer',
      model: 'principled',
      emissive: [1, 0, 0],
      emissiveIntensity: 3,
      parameters: { roughness: 0.3, metallic: 0.1, clearcoat: 0.8 },
    });
    near(lacquer.parameters.baseColor as number[], new THREE.Color(0x804020).toArray());
    expect(lacquer.parameters.specular).toBeCloseTo((0.4 / 2.4) ** 2 / 0.08, 9);
    expect(document.materials[triangle!.material]?.doubleSided).toBe(true);
    const lights = Object.values(document.lights);
    expect(lights.find(({ type }) => type === 'spot')).toMatchObject({
      intensity: 12,
      range: 7,
      position: [0, 5, 0],
      target: [1, 2, 3],
      penumbra: 0.25,
      falloff: 'inverse-square',
    });
    expect(lights.find(({ type }) => type === 'ambient')).toMatchObject({ luminance: 1 });
    expect(lights.find(({ type }) => type === 'point')).toMatchObject({
      falloff: 'constant',
      color: [1, 0, 0],
    });
    expect(lights.find(({ type }) => type === 'rectangle')).toMatchObject({
      luminance: 3,
      width: 2,
      height: 1,
    });
    expect(document.camera).toMatchObject({ fov: 40, position: [0, 1, 9] });
  });

  test('has the same vertices in the world', async () => {
    const scene = sample();
    scene.updateMatrixWorld();
    const { document } = await bring(scene.toJSON());
    const mirror = new SceneMirror({ assets, onError: expect.fail });
    mirror.apply(document);
    await mirror.settled();
    mirror.scene.updateMatrixWorld();
    const [id] = Object.keys(document.objects);
    const original = new THREE.Box3().setFromObject(scene.getObjectByName('Box')!, true);
    const found = new THREE.Box3().setFromObject(mirror.objectFor(id!)!, true);
    near(
      [...found.min.toArray(), ...found.max.toArray()],
      [...original.min.toArray(), ...original.max.toArray()],
    );
  });

  test('with textures inside: transformed as three.js does, flipped or not', async () => {
    const png = encodePng(new Uint8Array(16).fill(128), 2, 2);
    const json = sample().toJSON() as unknown as Json & { materials: Json[] };
    const texture = {
      repeat: [2, 3],
      offset: [0.1, 0.2],
      center: [0.5, 0.5],
      rotation: 0.3,
      wrap: [1000, 1000],
    };
    json.images = [{ uuid: 'i', url: `data:image/png;base64,${encodeBase64(png)}` }];
    json.textures = [
      { uuid: 'a', image: 'i', ...texture },
      { uuid: 'b', image: 'i', ...texture, flipY: false },
    ];
    json.materials[0] = { ...json.materials[0], map: 'a', roughnessMap: 'b' };
    const { document, notes } = await bring(json);
    const { textures } = Object.values(document.materials)[0]!;
    const matrixOf = ({ repeat, offset, rotation }: (typeof textures)[string]) =>
      new THREE.Matrix3().setUvTransform(
        offset[0],
        offset[1],
        repeat[0],
        repeat[1],
        THREE.MathUtils.degToRad(rotation),
        0,
        0,
      );
    const expected = new THREE.Matrix3().setUvTransform(0.1, 0.2, 2, 3, 0.3, 0.5, 0.5);
    for (const [u, v] of [
      [0, 0],
      [0.3, 0.9],
      [1, 0.2],
    ] as const) {
      const at = new THREE.Vector2(u, v).applyMatrix3(expected);
      near(new THREE.Vector2(u, v).applyMatrix3(matrixOf(textures.baseColor!)).toArray(), at.toArray());
      near(new THREE.Vector2(u, v).applyMatrix3(matrixOf(textures.roughness!)).toArray(), [at.x, 1 - at.y]);
    }
    expect(notes).toEqual([]);
  });

  test('with several materials on one geometry, instances, and what has no surface', async () => {
    const scene = new THREE.Scene();
    const box = new THREE.BoxGeometry();
    const materials = ['red', 'green', 'blue', 'white', 'grey', 'black'].map(
      (name) => new THREE.MeshStandardMaterial({ name, color: name }),
    );
    scene.add(new THREE.Mesh(box, materials));
    const instances = new THREE.InstancedMesh(box, materials[0], 3);
    for (let i = 0; i < 3; i++) instances.setMatrixAt(i, new THREE.Matrix4().makeTranslation(i, 0, 0));
    scene.add(instances, new THREE.Points(box, new THREE.PointsMaterial()));
    const { document, notes } = await bring(scene.toJSON());
    expect(Object.keys(document.objects)).toHaveLength(6 + 3);
    expect(new Set(Object.values(document.objects).map(({ position }) => position[0]))).toEqual(
      new Set([0, 1, 2]),
    );
    expect(notes.join()).toContain('no surface');
  });

  test('that is a geometry alone, or a project of the editor', async () => {
    const geometry = new THREE.BufferGeometry().copy(new THREE.SphereGeometry(1, 8, 6));
    const alone = await bring({ ...geometry.toJSON(), type: 'BufferGeometry' });
    expect(Object.keys(alone.document.objects)).toHaveLength(1);
    const project = await bring({
      metadata: { type: 'App' },
      project: {},
      scene: sample().toJSON(),
      scripts: {},
    });
    expect(Object.keys(project.document.objects)).toHaveLength(2);
  });

  test('whose author looked at it through a camera beside the scene', async () => {
    const camera = new THREE.PerspectiveCamera(33, 1, 0.5, 80);
    camera.position.set(1, 2, 8);
    camera.lookAt(1, 2, 0);
    camera.updateMatrix();
    const scene = new THREE.Scene().add(new THREE.Mesh(new THREE.BoxGeometry()));
    scene.background = new THREE.Color(0x334455);
    const project = { metadata: { type: 'App' }, camera: camera.toJSON(), scene: scene.toJSON() };
    const { document, notes } = await bring(project);
    expect(document.camera).toMatchObject({ fov: 33, position: [1, 2, 8], near: 0.5, far: 80 });
    near(document.camera.target, [1, 2, 3]);
    expect(notes.join()).toContain('background');
    const broken = await bring({ ...project, camera: { object: { type: 7 } } });
    expect(Object.keys(broken.document.objects)).toHaveLength(1);
  });

  test('saved as a project by the editor, whose own metadata are empty; its scripts are not run', async () => {
    const scene = sample().toJSON();
    const scripts = { [scene.object.uuid]: [{ name: 'turn', source: 'globalThis.wasRun = true' }] };
    const { document, notes } = await bring({ metadata: {}, project: { shadows: true }, scene, scripts });
    expect(Object.keys(document.objects)).toHaveLength(2);
    expect(notes.join('\n')).toMatch(/its scripts \(1\) are left out.*\n.*tone mapping/);
    expect(globalThis).not.toHaveProperty('wasRun');
  });

  test('anything else is not taken for one', async () => {
    expect(await importObjectScene({ format: 'irradia' }, 'a.json', assets)).toBeNull();
    expect(await importObjectScene(null, 'a.json', assets)).toBeNull();
  });
});

describe('a primitive of three.js', () => {
  /** As a scene file says it, of older versions too. */
  const sceneOf = (...geometries: Json[]): Json => ({
    metadata: { type: 'Object' },
    geometries: geometries.map((geometry, i) => ({ uuid: `g${i}`, ...geometry })),
    materials: [{ uuid: 'm', type: 'MeshStandardMaterial' }],
    object: {
      type: 'Scene',
      children: geometries.map((_, i) => ({ type: 'Mesh', geometry: `g${i}`, material: 'm' })),
    },
  });
  const { PI } = Math;
  const classes: Record<string, { fromJSON(data: object): THREE.BufferGeometry }> = {
    ...{ Plane: THREE.PlaneGeometry, Box: THREE.BoxGeometry, Circle: THREE.CircleGeometry },
    ...{ Cone: THREE.ConeGeometry, Cylinder: THREE.CylinderGeometry, Torus: THREE.TorusGeometry },
    Sphere: THREE.SphereGeometry,
  };
  const kinds: Record<string, Record<string, fc.Arbitrary<number | boolean>>> = {};
  const size = fc.double({ min: 0.01, max: 20, noNaN: true });
  const count = fc.integer({ min: 3, max: 9 });
  const start = fc.double({ min: -PI, max: 2 * PI, noNaN: true });
  kinds.Plane = { width: size, height: size, widthSegments: count, heightSegments: count };
  kinds.Box = { ...kinds.Plane, depth: size, depthSegments: count };
  kinds.Circle = { radius: size, segments: count, thetaStart: start, thetaLength: start };
  kinds.Cone = {
    ...{ radius: size, height: size, radialSegments: count, heightSegments: count },
    ...{ openEnded: fc.boolean(), thetaStart: start, thetaLength: start },
  };
  kinds.Cylinder = { ...kinds.Cone, radiusTop: size, radiusBottom: size };
  delete kinds.Cylinder.radius;
  kinds.Torus = { radius: size, tube: size, radialSegments: count, tubularSegments: count, arc: start };
  kinds.Sphere = { radius: size, widthSegments: count, heightSegments: count };

  test.each(Object.keys(kinds))('%s is the document’s own, vertex by vertex', async (kind) => {
    await fc.assert(
      fc.asyncProperty(
        fc.constantFrom('Geometry', 'BufferGeometry'),
        fc.record(kinds[kind]!, { requiredKeys: [] }),
        async (end, parameters) => {
          const { document } = await bring(sceneOf({ type: kind + end, ...parameters }));
          expect(document.assets).toEqual({});
          const [{ geometry }] = Object.values(document.objects) as [Document['objects'][string]];
          const found = createPrimitive(geometry as Primitive);
          const made = classes[kind]!.fromJSON(parameters);
          expect([...(found.index?.array ?? [])]).toEqual([...(made.index?.array ?? [])]);
          for (const name of ['position', 'normal', 'uv']) {
            const expected = made.getAttribute(name).array;
            const values = Array.from(found.getAttribute(name).array);
            expect(values.length).toBe(expected.length);
            const error = Math.max(...values.map((value, i) => Math.abs(value - expected[i]!)));
            expect(error).toBeLessThan(1e-5);
          }
        },
      ),
      { numRuns: 15 },
    );
  });

  test.each([
    ['SphereGeometry', { phiLength: 1 }],
    ['SphereGeometry', { thetaStart: 0.1 }],
    ['TorusGeometry', { thetaLength: 3 }],
    ['BoxGeometry', { depth: 0 }],
    ['PlaneGeometry', { width: -1 }],
    ['CircleGeometry', { segments: 5.5 }],
    ['CircleGeometry', { thetaLength: 7 }],
    ['TorusKnotGeometry', {}],
    ['IcosahedronGeometry', { detail: 1 }],
  ])('%s with %j, which the document cannot say, is a mesh', async (type, parameters) => {
    const { document } = await bring(sceneOf({ type, ...parameters }));
    expect(Object.keys(document.assets)).toHaveLength(1);
    expect(Object.values(document.objects)[0]).toMatchObject({ geometry: { type: 'gltf' } });
  });

  test('keeps angles as people write them, and the cube’s old name', async () => {
    const { document } = await bring(
      sceneOf({ type: 'CircleGeometry', thetaStart: PI / 3, thetaLength: PI }, { type: 'CubeGeometry' }),
    );
    expect(Object.values(document.objects).map(({ geometry }) => geometry)).toMatchObject([
      { thetaStart: 60, thetaLength: 180 },
      { type: 'box', width: 1 },
    ]);
  });

  test('lies among meshes and instances where the file has it, named by what it is', async () => {
    const group = new THREE.Group();
    group.name = 'Pair';
    group.position.x = 5;
    const grey = new THREE.MeshStandardMaterial({ name: 'Grey' });
    const ball = new THREE.SphereGeometry(1, 8, 6);
    const instances = new THREE.InstancedMesh(ball, grey, 2);
    instances.setMatrixAt(0, new THREE.Matrix4().makeTranslation(0, 1, 0));
    instances.setMatrixAt(1, new THREE.Matrix4().makeTranslation(0, 2, 0));
    instances.setColorAt(0, new THREE.Color('red'));
    instances.name = 'Dots';
    group.add(new THREE.Mesh(ball, grey), new THREE.Mesh(new THREE.TorusKnotGeometry(1, 0.2, 8, 4), grey));
    const scene = new THREE.Scene().add(group, instances);
    scene.updateMatrixWorld();
    const { document, notes } = await bring(scene.toJSON());
    const objects = Object.values(document.objects);
    expect(objects.map(({ name, position, geometry }) => [name, geometry.type, ...position])).toEqual([
      ['Sphere', 'sphere', 5, 0, 0],
      ['TorusKnot', 'gltf', 5, 0, 0],
      ['Dots', 'sphere', 0, 1, 0],
      ['Dots 2', 'sphere', 0, 2, 0],
    ]);
    expect(new Set(objects.map(({ material }) => material)).size).toBe(1);
    expect(objects[0]!.group).toBe(objects[1]!.group);
    expect(document.groups[objects[0]!.group!]).toMatchObject({ name: 'Pair' });
    expect(notes).toEqual(['Dots: the colours of its instances are not read']);
  });

  test('with a texture is still none: the file that comes along has the image alone', async () => {
    const png = encodePng(new Uint8Array(16).fill(128), 2, 2);
    const json = {
      ...sceneOf({ type: 'BoxGeometry' }),
      materials: [{ uuid: 'm', type: 'MeshStandardMaterial', map: 't' }],
      textures: [{ uuid: 't', image: 'i' }],
      images: [{ uuid: 'i', url: `data:image/png;base64,${encodeBase64(png)}` }],
    };
    const { document } = await bring(json);
    const [asset] = Object.values(document.assets);
    expect(asset!.data.length).toBeLessThan(2000);
    expect(Object.values(document.objects)[0]).toMatchObject({ geometry: { type: 'box' } });
    expect(Object.values(document.materials)[0]!.textures.baseColor).toMatchObject({
      asset: Object.keys(document.assets)[0],
      texture: 0,
    });
  });

  test('makes a scene that fits into a link', async () => {
    // The thesis's fig. 6.2: twenty balls, each with its own material, and lamps.
    const scene = new THREE.Scene().add(new THREE.AmbientLight(), new THREE.PointLight());
    for (let i = 0; i < 20; i++) {
      const material = new THREE.MeshPhongMaterial({ name: `Ball ${i}`, shininess: i });
      const ball = new THREE.Mesh(new THREE.SphereGeometry(0.5, 64, 32), material);
      ball.position.set(i % 5, Math.floor(i / 5), 0);
      scene.add(ball);
    }
    scene.updateMatrixWorld();
    const { document } = await bring(scene.toJSON());
    expect((await linkFor(document)).length).toBeLessThan(4000);
  });
});

describe('what is wrong is told with its place', () => {
  /** The sample with another value at a path; undefined takes the field away. */
  function broken(path: string, value: unknown): unknown {
    const json: unknown = JSON.parse(JSON.stringify(sample().toJSON()));
    const keys = path.split('.');
    const last = keys.pop() ?? '';
    const holder = keys.reduce((at, key) => (at as Json)[key], json) as Json;
    if (value === undefined) delete holder[last];
    else holder[last] = value;
    return json;
  }
  const position = 'geometries.1.data.attributes.position.array';
  test.each([
    ['geometries.0.widthSegments', 1e9, 'geometries[0]: widthSegments is not between'],
    [
      'geometries.0',
      { uuid: 'x', type: 'SphereGeometry', widthSegments: 4000, heightSegments: 4000 },
      'geometries[0]: it has too many segments',
    ],
    [position, { length: 4e9 }, 'geometries[1].data.attributes.position.array'],
    [`${position}.0`, 'x', 'geometries[1]: it has positions that are not finite'],
    ['object.children.0.children.0.geometry', 'none', 'object.children[0].children[0]: there is no geometry'],
    ['object.children.1.intensity', 'bright', 'object.children[1].intensity'],
    ['object', undefined, 'object'],
  ])('%s = %j: %s', async (path, value, message) => {
    const json = broken(path, value) as Json & { object?: { children: { children: Json[] }[] } };
    // The box has to be the one that is broken.
    const box = json.object?.children[0]?.children[0];
    if (box && path === 'geometries.0') box.geometry = 'x';
    await expect(bring(json)).rejects.toThrow(`scene.json: ${message}`);
  });

  test('whatever values are changed, the end is a ModelFileError, a GltfError or a document', async () => {
    const text = JSON.stringify(sample().toJSON());
    const values = fc.constantFrom('null', '-1', '1e30', '"x"', '[]', '{}', 'true', '4294967296');
    await fc.assert(
      fc.asyncProperty(
        fc.array(fc.tuple(fc.nat(), values), { minLength: 1, maxLength: 4 }),
        async (changes) => {
          const numbers = [...text.matchAll(/(?<=[:[,])-?\d[\d.e-]*/g)];
          let changed = text;
          for (const [at, value] of changes) {
            const { index, 0: old } = numbers[at % numbers.length]!;
            if (changed.length === text.length)
              changed = changed.slice(0, index) + value + changed.slice(index + old.length);
          }
          try {
            await bring(JSON.parse(changed));
          } catch (error) {
            expect((error as Error).name).toMatch(/^(ModelFileError|GltfError|DocumentError)$/);
          }
        },
      ),
      { numRuns: 150 },
    );
  });
});
