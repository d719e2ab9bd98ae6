/** OBJ with MTL, PLY and STL: what programs write is read, what is broken is told with its place. */
import fc from 'fast-check';
import { OBJExporter } from 'three/addons/exporters/OBJExporter.js';
import { PLYExporter } from 'three/addons/exporters/PLYExporter.js';
import { STLExporter } from 'three/addons/exporters/STLExporter.js';
import * as THREE from 'three/webgpu';
import { afterAll, describe, expect, test, vi } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { Notes } from '../../src/io/gltf/notes.ts';
import { addImported } from '../../src/io/gltf.ts';
import { importModel } from '../../src/io/import-model.ts';
import { readObj } from '../../src/io/meshes/obj.ts';
import { readPly } from '../../src/io/meshes/ply.ts';
import { readStl } from '../../src/io/meshes/stl.ts';
import { encodePng } from '../../src/io/png.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { createDocument } from '../../src/scene/document.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';

// three's exporter hands its result over in a frame.
vi.stubGlobal('requestAnimationFrame', (run: () => void) => setTimeout(run, 0));
afterAll(() => void vi.unstubAllGlobals());

const assets = new AssetLoader(nodeAssets);
const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

async function bring(
  name: string,
  content: Uint8Array | string,
  companions: Record<string, Uint8Array> = {},
): Promise<{ document: Document; notes: string[] }> {
  const store = new DocumentStore(createDocument());
  const bytes = typeof content === 'string' ? bytesOf(content) : content;
  const imported = await importModel(bytes, name, assets, {
    companions: new Map(Object.entries(companions)),
  });
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
  });
  return { document: store.document, notes: imported.notes };
}

async function geometryOf(document: Document, at = 0): Promise<THREE.BufferGeometry> {
  const { geometry } = Object.values(document.objects)[at]!;
  if (geometry.type !== 'gltf') throw new Error('not a mesh');
  return assets.gltfGeometry(document.assets[geometry.asset]!, geometry.node, geometry.primitive);
}

/** Corners of triangles, one after another. */
function corners(geometry: THREE.BufferGeometry): number[] {
  const { array } = geometry.index
    ? geometry.toNonIndexed().getAttribute('position')
    : geometry.getAttribute('position');
  return [...array];
}
const near = (found: readonly number[], expected: readonly number[]): void => {
  expect(found).toHaveLength(expected.length);
  const worst = Math.max(...found.map((value, i) => Math.abs(value - expected[i]!)));
  expect(worst).toBeLessThan(1e-5);
};

const knot = new THREE.TorusKnotGeometry(1, 0.3, 20, 6);
const mesh = new THREE.Mesh(knot, new THREE.MeshStandardMaterial());

describe('what three.js writes', () => {
  test('as OBJ comes back with normals and coordinates', async () => {
    const { document } = await bring('knot.obj', new OBJExporter().parse(mesh));
    const geometry = await geometryOf(document);
    near(corners(geometry), corners(knot));
    const uvs = [...geometry.toNonIndexed().getAttribute('uv').array];
    near(uvs, [...knot.toNonIndexed().getAttribute('uv').array]);
    near(
      [...geometry.toNonIndexed().getAttribute('normal').array],
      [...knot.toNonIndexed().getAttribute('normal').array],
    );
  });

  test.each([
    ['text', { binary: false }],
    ['binary', { binary: true }],
    ['binary, big-endian', { binary: true, littleEndian: false }],
  ])('as PLY comes back: %s', async (_, options) => {
    const written = await new Promise<string | ArrayBuffer>((resolve) => {
      new PLYExporter().parse(mesh, resolve as never, options as never);
    });
    const content = typeof written === 'string' ? written : new Uint8Array(written);
    const { document } = await bring('knot.ply', content);
    near(corners(await geometryOf(document)), corners(knot));
  });

  test.each([
    ['text', false],
    ['binary', true],
  ] as const)('as STL comes back: %s', async (_, binary) => {
    const written = new STLExporter().parse(mesh, { binary } as never) as unknown as string | DataView;
    const content = typeof written === 'string' ? written : new Uint8Array(written.buffer);
    const { document } = await bring('knot.stl', content);
    const geometry = await geometryOf(document);
    near(corners(geometry), corners(knot));
    expect(geometry.hasAttribute('normal')).toBe(true);
  });
});

describe('OBJ', () => {
  const cube = `# two materials
mtllib scene.mtl
o Box
v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1
usemtl Red paint
f 1/1 2/2 3/3 4/4
usemtl Metal
f -5 -4 -1
`;
  const mtl = `newmtl Red paint
Kd 1 0.1 0.1
Ns 200
Ks 0.5 0.5 0.5
map_Kd -s 2 2 1 -o 0.5 0 -clamp on textures/wood grain.png
map_Bump -bm 0.3 bump.png
Ke 2 1 0
d 0.5
newmtl Metal
Kd .9 .8 .7
Pm 1
Pr .3
`;
  const png = encodePng(new Uint8Array(16).fill(200), 2, 2);
  const files = { 'a/scene.mtl': bytesOf(mtl), 'a/textures/wood grain.png': png, 'a/bump.png': png };

  test('with materials and textures of its folder', async () => {
    const { document, notes } = await bring('a/box.obj', cube, files);
    expect(notes).toEqual([]);
    expect(Object.values(document.objects).map(({ name }) => name)).toEqual(['Box 1', 'Box 2']);
    const [red, metal] = Object.values(document.materials);
    expect(red).toMatchObject({
      name: 'Red paint',
      model: 'principled',
      parameters: { baseColor: [1, 0.1, 0.1], metallic: 0, specular: 0.5 },
      textures: { baseColor: { repeat: [2, 2], offset: [0.5, 0], wrap: 'clamp', colorSpace: 'srgb' } },
      bumpMap: { scale: 0.3 },
      emissive: [1, 0.5, 0],
      emissiveIntensity: 2,
      alphaMode: 'blend',
      opacity: 0.5,
    });
    expect(red?.parameters.roughness).toBeCloseTo((2 / 202) ** 0.25, 12);
    expect(metal).toMatchObject({ parameters: { metallic: 1, roughness: 0.3 } });
    near(corners(await geometryOf(document)), [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0]);
    near(corners(await geometryOf(document, 1)), [0, 0, 0, 1, 0, 0, 0, 0, 1]);
  });

  test('with names that have a # in them, a renamed .mtl, cut-outs and a TGA', async () => {
    const numbered =
      'newmtl Material #1\nKd 1 0 0\nnewmtl Material #2\nmap_Kd D:\\maps\\LEAF.tga\nmap_d leaf.tga\n';
    // 1 x 1, 32 bits, from the top.
    const tga = Uint8Array.from([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 0x28, 30, 200, 10, 128]);
    const { document, notes } = await bring('b/leaf.obj', cube.replaceAll('Red paint', 'Material #2'), {
      'b/leaf.mtl': bytesOf(numbered),
      'b/leaf.tga': tga,
    });
    expect(notes).toEqual(['there is no material Metal in its .mtl file']);
    const [leaf] = Object.values(document.materials);
    expect(leaf).toMatchObject({ name: 'Material #2', opacityMap: { channel: 'a' }, alphaMode: 'blend' });
    const asset = document.assets[leaf?.textures.baseColor?.asset ?? ''];
    const image = await assets.image(asset!, leaf?.textures.baseColor?.texture ?? null);
    expect([...(image as { data: Uint8Array }).data]).toEqual([10, 200, 30, 128]);
  });

  test('with an image of a format that is not read says which', async () => {
    const { notes } = await bring('a/box.obj', cube, {
      'a/scene.mtl': bytesOf('newmtl Red paint\nmap_Kd maps/wall.psd\nnewmtl Metal\nmap_Kd broken.tga\n'),
      'a/maps/wall.psd': bytesOf('8BPS'),
      'a/broken.tga': bytesOf('no image, though it is named like one'),
    });
    expect(notes.join()).toMatch(/wall\.psd is in a format that is not read.*broken\.tga is in a format/);
  });

  test('without its .mtl says so and is grey', async () => {
    const { document, notes } = await bring('box.obj', cube);
    expect(notes.join()).toContain('scene.mtl did not come along');
    expect(Object.values(document.materials)).toHaveLength(1);
  });

  test('smoothing groups make normals', () => {
    const roof = 'v 0 0 0\nv 1 0 0\nv 0 1 1\nv 1 1 1\nv 0 2 0\nv 1 2 0\ns 1\nf 1 2 4 3\nf 3 4 6 5\n';
    const [part] = readObj(bytesOf(roof), 'roof.obj', new Notes()).parts;
    const ridge = [...part!.normals!.slice(3 * 2, 3 * 3)];
    expect(Math.abs(ridge[1]!)).toBeLessThan(1e-6);
    expect(
      readObj(bytesOf(roof.replace('s 1', 's off')), 'roof.obj', new Notes()).parts[0]?.normals,
    ).toBeUndefined();
  });

  test.each([
    ['v 1 x 2\nf 1 1 1', 'line 1: expected 3 numbers after "v"'],
    ['v 1 2 3\nf 1 2 3', 'line 2: there is no vertex 2 before this line'],
    ['v 1 2 3\nf 1 0 1', 'line 2: "0" is not the number of a vertex'],
    ['v 1 2 3\nf 1/7 1 1', 'line 2: there is no texture coordinate 7 before this line'],
    ['v 1 2 3\nf 1 1', 'line 2: a face needs three corners'],
    ['v 1 2 3\nl 1 1', 'the file has no faces'],
    ['%PDF-1.4', 'line 1: "%PDF-1.4" is not a word of OBJ'],
  ])('%j: %s', (text, message) => {
    expect(() => readObj(bytesOf(text), 'bad.obj', new Notes())).toThrow(`bad.obj: ${message}`);
  });
});

describe('PLY', () => {
  const header = (vertices: number | string, faces: number) =>
    `ply\nformat ascii 1.0\ncomment made by hand\nelement vertex ${vertices}\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`;
  const quad = '0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 9 9\n';

  test('polygons become triangles; colours are told', async () => {
    const { document, notes } = await bring('quad.ply', `${header(4, 1)}${quad}4 0 1 2 3\n`);
    near(corners(await geometryOf(document)), [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0]);
    expect(notes).toEqual(['its vertex colours are not read']);
  });

  test.each([
    [`${header(4, 1)}${quad}4 0 1 2 7\n`, 'triangle 1: there is no vertex 7; there are 4'],
    [`${header(4, 1)}${quad}4 0 1 2\n`, 'line 19: the file ends here, within an element'],
    [`${header(4, 1)}${quad.replace('1 0 0', '1 zero 0')}3 0 1 2\n`, 'line 15: "zero" is not a number'],
    [`${header(4_000_000_000, 1)}${quad}`, 'line 14: the header says 4000000000 of "vertex"'],
    [`${header('many', 1)}`, 'line 4: expected "element NAME COUNT"'],
    [`${header(4, 0)}${quad}`, 'the file has no faces'],
    ['solid', 'line 1: not a PLY file'],
  ])('%#: %s', (text, message) => {
    expect(() => readPly(bytesOf(text), 'bad.ply')).toThrow(`bad.ply: ${message}`);
  });
});

describe('STL', () => {
  test.each([
    [
      'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0\n',
      'line 4: expected three numbers after "vertex"',
    ],
    ['solid a\nouter loop\nvertex 0 0 0\nendloop\n', 'line 4: a facet with 1 corners; expected 3'],
    ['solid a\nendsolid a\n', 'the file has no triangles'],
    ['solid a\nhello\n', 'line 2: "hello" is not a word of STL'],
  ])('%#: %s', (text, message) => {
    expect(() => readStl(bytesOf(text), 'bad.stl')).toThrow(`bad.stl: ${message}`);
  });

  test('that is cut off says at which byte', () => {
    const bytes = new Uint8Array(84 + 50 + 10);
    new DataView(bytes.buffer).setUint32(80, 2, true);
    expect(() => readStl(bytes, 'cut.stl')).toThrow(
      'cut.stl: byte 84: the file ends here; expected 100 more bytes',
    );
  });
});

describe('hostile files end in an error with the name of the file, or in a model', () => {
  const samples: [string, () => Uint8Array][] = [
    ['x.obj', () => bytesOf(`mtllib m.mtl\n${new OBJExporter().parse(mesh).slice(0, 4000)}`)],
    [
      'x.stl',
      () =>
        new Uint8Array(
          (new STLExporter().parse(mesh, { binary: true } as never) as unknown as DataView).buffer.slice(
            0,
            684,
          ),
        ),
    ],
    [
      'x.ply',
      () =>
        bytesOf(
          'ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n' +
            `${'\0'.repeat(36)}\x03\0\0\0\0\x01\0\0\0\x02\0\0\0`,
        ),
    ],
  ];
  test.each(samples)('%s', (name, make) => {
    const sample = make();
    const read = {
      'x.obj': (b: Uint8Array) => readObj(b, name, new Notes()),
      'x.stl': (b: Uint8Array) => readStl(b, name),
      'x.ply': (b: Uint8Array) => readPly(b, name),
    }[name]!;
    const survives = (bytes: Uint8Array): void => {
      try {
        read(bytes);
      } catch (error) {
        expect((error as Error).name).toMatch(/^(ModelFileError|ByteError)$/);
        expect((error as Error).message).toMatch(new RegExp(`^${name}: `));
      }
    };
    for (let length = 0; length < sample.length; length += Math.ceil(sample.length / 200))
      survives(sample.slice(0, length));
    fc.assert(
      fc.property(fc.array(fc.tuple(fc.nat(), fc.nat(255)), { minLength: 1, maxLength: 8 }), (changes) => {
        const bytes = sample.slice();
        for (const [at, value] of changes) bytes[at % bytes.length] = value;
        survives(bytes);
      }),
      { numRuns: 300 },
    );
  });
});
