/** Models of every format come to the page: dropped, in folders and archives, from addresses; the page stays awake. */
import { zipSync } from 'fflate';
import { OBJExporter } from 'three/addons/exporters/OBJExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import * as THREE from 'three/webgpu';
import { describe, expect, it } from 'vitest';
import { GltfWriter } from '../../src/io/gltf/writer.ts';
import { encodePng } from '../../src/io/png.ts';
import { encodeBase64 } from '../../src/scene/base64.ts';
import { createDocument, serializeDocument } from '../../src/scene/document.ts';
import { ktx2 } from '../io/ktx2-writer.ts';
import { type LabPage, openLab, small } from './lab.ts';

const lab = await openLab();
const page: LabPage = await (await lab.open(small({}, { width: 560, height: 340 }))).ready();

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
const checker = encodePng(
  Uint8Array.from({ length: 8 * 8 * 4 }, (_, i) =>
    i % 4 === 3 ? 255 : ((i >> 2) + (i >> 5)) % 2 ? 230 : 40,
  ),
  8,
  8,
);
const knot = new THREE.Mesh(new THREE.TorusKnotGeometry(0.5, 0.16, 80, 12), new THREE.MeshStandardMaterial());
const obj = new OBJExporter().parse(knot).replace(/^/, 'mtllib knot.mtl\nusemtl Painted\n');
const mtl = 'newmtl Painted\nKd 1 0.8 0.6\nNs 80\nmap_Kd maps/checker.png\n';
const ply = `ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n`;

function objectScene(): string {
  const scene = new THREE.Scene();
  const group = new THREE.Group();
  group.position.set(0, 1, 0);
  group.add(
    new THREE.Mesh(
      new THREE.SphereGeometry(0.4),
      new THREE.MeshPhysicalMaterial({ color: 0x3366ff, clearcoat: 1 }),
    ),
  );
  scene.add(group, new THREE.PointLight(0xffffff, 3));
  scene.updateMatrixWorld();
  const json = scene.toJSON() as unknown as {
    images: unknown;
    textures: unknown;
    materials: Record<string, unknown>[];
  };
  json.images = [{ uuid: 'i', url: `data:image/png;base64,${encodeBase64(checker)}` }];
  json.textures = [{ uuid: 't', image: 'i', wrap: [1000, 1000], repeat: [4, 4] }];
  json.materials[0]!.map = 't';
  return JSON.stringify(json);
}

/** A quad whose texture is a KTX2 image. */
function ktxModel(): Uint8Array {
  const writer = new GltfWriter();
  writer.use('KHR_texture_basisu');
  const source = writer.image(
    ktx2(8, 4, [
      [200, 10, 20, 255],
      [10, 20, 220, 255],
    ]),
    'image/ktx2',
    'paint',
  );
  const index = writer.add('textures', { extensions: { KHR_texture_basisu: { source } } });
  const material = writer.add('materials', {
    pbrMetallicRoughness: { baseColorTexture: { index }, metallicFactor: 0 },
  });
  const attributes = {
    POSITION: writer.attribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), 'VEC3', true),
    TEXCOORD_0: writer.attribute(new Float32Array([0, 0, 1, 0, 0, 1]), 'VEC2'),
  };
  writer.add('nodes', {
    name: 'Painted',
    mesh: writer.add('meshes', { primitives: [{ attributes, material }] }),
  });
  return writer.finish();
}

/** Drops files, waits until they are in, and takes them out again: one undo step. */
async function imports(files: { name: string; content: Uint8Array | string }[], message: string) {
  const before = await page.document();
  await page.drop(files);
  await page.waitForToast(message);
  const document = await page.document();
  // Every geometry and image has come to the scene.
  await page.page.evaluate('irradia.mirror.settled()');
  const objects = Object.entries(document.objects).filter(([id]) => !(id in before.objects));
  const vertices = (await page.page.evaluate(
    `${JSON.stringify(objects.map(([id]) => id))}.map((id) => irradia.mirror.objectFor(id).geometry.getAttribute('position')?.count ?? 0)`,
  )) as number[];
  await page.page.keyboard.press('Control+z');
  expect(await page.document()).toEqual(before);
  expect(page.errors).toEqual([]);
  return {
    objects: objects.map(([, object]) => object),
    materials: objects.map(([, object]) => document.materials[object.material]),
    lights: Object.keys(document.lights).length - Object.keys(before.lights).length,
    vertices,
  };
}

describe('a dropped', () => {
  it.each([
    ['knot.obj', obj],
    [
      'knot.stl',
      new Uint8Array(
        (new STLExporter().parse(knot, { binary: true } as never) as unknown as DataView).buffer,
      ),
    ],
    ['quad.ply', ply],
    ['painted.glb', ktxModel()],
  ])('%s is in the scene, in one undo step', async (name, content) => {
    const { objects, vertices } = await imports([{ name, content }], `Imported ${name}`);
    expect(objects).toHaveLength(1);
    expect(vertices[0]).toBeGreaterThanOrEqual(3);
  });

  it('scene of three.js is in the scene with materials, textures and lights', async () => {
    const { objects, materials, lights } = await imports(
      [{ name: 'scene.json', content: objectScene() }],
      'Imported scene.json',
    );
    expect(objects).toMatchObject([{ position: [0, 1, 0] }]);
    expect(materials[0]?.textures.baseColor?.repeat).toEqual([4, 4]);
    expect(lights).toBe(1);
  });

  it('zip of an OBJ, its materials and textures finds them in it', async () => {
    const content = zipSync({
      'model/knot.obj': bytesOf(obj),
      'model/knot.mtl': bytesOf(mtl),
      'model/maps/checker.png': checker,
      'model/readme.txt': bytesOf('by nobody'),
    });
    const { materials } = await imports([{ name: 'knot.zip', content }], 'Imported knot.obj');
    expect(materials[0]).toMatchObject({ name: 'Painted', model: 'principled' });
    expect(materials[0]?.textures.baseColor?.texture).toBe(0);
  });

  it('document opens, and has no undo back', async () => {
    const before = await page.document();
    await page.drop([{ name: 'other.json', content: serializeDocument(createDocument('Other')) }]);
    await page.waitForToast('Opened Other');
    expect((await page.document()).name).toBe('Other');
    await page.drop([{ name: 'back.json', content: serializeDocument(before) }]);
    await page.waitForToast(`Opened ${before.name}`);
  });

  it('photograph of all directions lights the scene', async () => {
    const before = await page.document();
    const content = encodePng(new Uint8Array(512 * 256 * 4).fill(180), 512, 256);
    await page.drop([{ name: 'panorama.png', content }]);
    await page.waitForToast('panorama.png lights the scene');
    expect((await page.document()).environment.source.type).toBe('hdr');
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(before);
    expect(page.errors).toEqual([]);
  });

  it.each([
    ['bad.obj', 'v 1 2 3\nf 1 2 3', /bad\.obj: line 2: there is no vertex 2/],
    [
      'bad.json',
      objectScene().replace('"SphereGeometry"', '"EvilGeometry"'),
      /bad\.json: geometries\[0\]: there is no EvilGeometry/,
    ],
    ['empty.zip', zipSync({ 'a.txt': bytesOf('x') }), /nothing in it is a kind of file/],
  ])('%s that is broken says where, and changes nothing', async (name, content, message) => {
    const before = await page.document();
    await page.drop([{ name, content }]);
    await page.page.locator('.toast.error').first().waitFor();
    expect((await page.toasts()).join('\n')).toMatch(message);
    expect(await page.document()).toEqual(before);
    expect(page.errors).toEqual([]);
    await page.page.click('.toast.error .icon-button');
  });
});

/** A grid of vertices as a GLB of some twenty megabytes, made in the page. */
const dropLarge = (side: number) => `(() => {
  const side = ${side};
  const vertices = side * side;
  const positions = new Float32Array(3 * vertices), normals = new Float32Array(3 * vertices), uvs = new Float32Array(2 * vertices);
  const indices = new Uint32Array(6 * (side - 1) * (side - 1));
  for (let i = 0; i < vertices; i++) {
    const x = (i % side) / side, y = Math.floor(i / side) / side;
    positions.set([x - 0.5, y, 0.1 * Math.sin(20 * x) * Math.cos(20 * y)], 3 * i);
    normals.set([0, 0, 1], 3 * i);
    uvs.set([x, y], 2 * i);
  }
  for (let y = 0, at = 0; y < side - 1; y++) for (let x = 0; x < side - 1; x++, at += 6) {
    const a = y * side + x;
    indices.set([a, a + 1, a + side, a + 1, a + side + 1, a + side], at);
  }
  const parts = [positions, normals, uvs, indices];
  let offset = 0;
  const bufferViews = parts.map((part) => { const view = { buffer: 0, byteOffset: offset, byteLength: part.byteLength }; offset += part.byteLength; return view; });
  const json = { asset: { version: '2.0' }, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0, name: 'Large' }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3 }] }], buffers: [{ byteLength: offset }], bufferViews,
    accessors: [
      { bufferView: 0, componentType: 5126, count: vertices, type: 'VEC3', min: [-0.5, 0, -0.1], max: [0.5, 1, 0.1] },
      { bufferView: 1, componentType: 5126, count: vertices, type: 'VEC3' },
      { bufferView: 2, componentType: 5126, count: vertices, type: 'VEC2' },
      { bufferView: 3, componentType: 5125, count: indices.length, type: 'SCALAR' }] };
  let text = JSON.stringify(json); text += ' '.repeat((4 - (text.length % 4)) % 4);
  const head = new Uint32Array([0x46546c67, 2, 28 + text.length + offset, text.length, 0x4e4f534a]);
  const file = new File([head, text, new Uint32Array([offset, 0x004e4942]), ...parts], 'large.glb');
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(file);
  window.frames = 0;
  window.size = file.size;
  let reading = true;
  const unsubscribe = irradia.store.subscribe(() => { reading = false; unsubscribe(); });
  const count = () => { if (reading) { window.frames += 1; requestAnimationFrame(count); } };
  requestAnimationFrame(count);
  document.querySelector('.viewport').dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true }));
})()`;

describe('a file of twenty megabytes', () => {
  it('never holds up the page while it is read, and says how far it is', async () => {
    const before = await page.document();
    // The thread gets the file once the page has been looked at: a fast machine would have read it before.
    await page.page.evaluate(`
      window.AnsweringWorker = Worker;
      window.held = [];
      window.Worker = class extends Worker {
        postMessage(...message) {
          if (held === null) super.postMessage(...message);
          else held.push(() => super.postMessage(...message));
        }
      };`);
    await page.page.evaluate(dropLarge(520));
    const progress = page.page.locator('.toast.progress:has-text("large.glb")');
    await progress.waitFor();
    expect(await progress.locator('button').innerText()).toBe('Cancel');
    // A page that reads it itself, or waits for the reader, draws no frame meanwhile.
    await page.until('held.length > 0 && frames > 5');
    await page.page.evaluate(`
      for (const send of held) send();
      window.held = null;
      window.Worker = AnsweringWorker;`);
    await page.waitForToast('Imported large.glb');
    expect(await page.page.evaluate('size')).toBeGreaterThan(15e6);
    await page.page.evaluate('irradia.mirror.settled()');
    expect(page.errors).toEqual([]);
    await page.page.keyboard.press('Control+z');
    expect(await page.document()).toEqual(before);
  });

  it('can be given up', async () => {
    const before = await page.document();
    // A thread that never answers: a fast machine would have read the file before it can be given up.
    await page.page.evaluate(
      'window.AnsweringWorker = Worker; window.Worker = class extends Worker { postMessage() {} };',
    );
    await page.page.evaluate(dropLarge(520));
    const progress = page.page.locator('.toast.progress:has-text("large.glb")');
    await progress.locator('button').click();
    await progress.waitFor({ state: 'detached' });
    await page.page.evaluate('window.Worker = window.AnsweringWorker');
    expect(await page.document()).toEqual(before);
    expect((await page.toasts()).join()).not.toContain('large.glb was not opened');
  });
});

describe('?import=', () => {
  const other = 'https://models.example/';
  const files = new Map<string, Uint8Array | string>([
    ['knot.obj', obj],
    ['knot.mtl', mtl],
    ['maps/checker.png', checker],
  ]);

  it('fetches a model of another server and all that it refers to, and shows it alone', async () => {
    await page.page.context().route(`${other}**`, (route) => {
      const body = files.get(decodeURIComponent(new URL(route.request().url()).pathname).replace('/m/', ''));
      return route.fulfill({
        status: body === undefined ? 404 : 200,
        headers: { 'Access-Control-Allow-Origin': '*' },
        body: Buffer.from(body ?? ''),
      });
    });
    const query = `?import=${encodeURIComponent(`${other}m/knot.obj`)}`;
    const opened = await (await lab.open({ query, beside: page })).ready();
    await opened.waitForToast('Imported knot.obj');
    const document = await opened.document();
    expect(Object.values(document.materials)).toMatchObject([{ name: 'Painted' }]);
    expect(Object.values(document.materials)[0]?.textures.baseColor).toBeDefined();
    expect(Object.keys(document.objects)).toHaveLength(1);
    await opened.page.waitForFunction(() => !location.search.includes('import'));
    expect(opened.errors).toEqual([]);
  });
});
