/** A document written as GLB and read again is the same, as far as glTF can say it, and what it cannot is said. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { nodeAssets } from '../../src/cli/node-assets.ts';
import { readGlb } from '../../src/io/gltf/glb.ts';
import { addImported, importGltf } from '../../src/io/gltf.ts';
import { exportGltf } from '../../src/io/gltf-export.ts';
import { encodePng } from '../../src/io/png.ts';
import { AssetLoader } from '../../src/scene/assets.ts';
import { encodeBase64 } from '../../src/scene/base64.ts';
import { createDocument, parseDocument } from '../../src/scene/document.ts';
import { SceneMirror } from '../../src/scene/mirror.ts';
import type { Document } from '../../src/scene/schema.ts';
import { DocumentStore } from '../../src/scene/store.ts';
import { readTexels } from '../../src/scene/texels.ts';

const assets = new AssetLoader(nodeAssets);

async function again(document: Document): Promise<{ document: Document; notes: string[]; lost: string[] }> {
  const { bytes, notes: lost } = await exportGltf(document, assets);
  const imported = await importGltf(bytes, 'scene.glb', assets);
  const store = new DocumentStore(createDocument());
  store.edit(imported.label, (draft) => {
    addImported(draft, imported);
  });
  return { document: store.document, notes: imported.notes, lost };
}

const scene = (parts: Record<string, unknown>): Document =>
  parseDocument({ format: 'irradia', version: 1, ...parts }, 'test');

async function vertices(document: Document): Promise<Map<string, number[]>> {
  const mirror = new SceneMirror({ assets, onError: expect.fail });
  mirror.apply(document);
  await mirror.settled();
  mirror.scene.updateMatrixWorld();
  const found = new Map<string, number[]>();
  for (const [id, object] of Object.entries(document.objects)) {
    const mesh = mirror.objectFor(id)!;
    const position = mesh.geometry.clone().applyMatrix4(mesh.matrixWorld).getAttribute('position');
    found.set(object.name, [
      ...position.array,
      ...(mesh.geometry.getAttribute('uv')?.array ?? []),
      ...(mesh.geometry.index?.array ?? []),
    ]);
  }
  mirror.dispose();
  return found;
}

const distance = (a: readonly number[], b: readonly number[]): number =>
  a.length === b.length
    ? Math.max(0, ...a.map((value, i) => Math.abs(value - b[i]!)))
    : Number.POSITIVE_INFINITY;

describe('a GLB of a scene, read again', () => {
  const sample = scene({
    camera: { fov: 40, position: [1, 2, 5], target: [0, 1, 0], near: 0.1, far: 90 },
    materials: { paint: { name: 'Paint', model: 'principled' } },
    objects: {
      box: {
        name: 'Box',
        material: 'paint',
        position: [1, 2, 3],
        rotation: [20, -50, 130],
        scale: [1, 2, 0.5],
        geometry: { type: 'box' },
      },
      ring: { name: 'Ring', material: 'paint', rotation: [90, 0, 0], geometry: { type: 'torus' } },
      monkey: { name: 'Monkey', material: 'paint', visible: false, geometry: { type: 'suzanne' } },
    },
    lights: {
      sun: {
        type: 'directional',
        illuminance: 3,
        position: [1, 2, 3],
        target: [1, 0, 0],
        color: [1, 0.5, 0.25],
      },
      lamp: { type: 'point', intensity: 7, position: [0, 3, 0], range: 9 },
      spot: {
        type: 'spot',
        intensity: 30,
        position: [0, 4, 0],
        target: [0, 0, 0],
        cutoff: 25,
        penumbra: 0.5,
        exponent: 0,
      },
      sky: { type: 'ambient', luminance: 1 },
    },
  });

  test('has every vertex where it was, to 1e-5', async () => {
    const before = await vertices(sample);
    const after = await vertices((await again(sample)).document);
    for (const [name, values] of before)
      expect(distance(values, after.get(name) ?? []), name).toBeLessThan(1e-5);
  });

  test('has nothing of the ground that shows shadows', async () => {
    const ground = { shadowCatcher: true, height: -1 };
    const [without, with_] = await Promise.all(
      [sample, { ...sample, ground: { ...sample.ground, ...ground } }].map((it) => exportGltf(it, assets)),
    );
    // Byte by byte, but not by an assertion for each of them.
    expect(Buffer.compare(with_!.bytes, without!.bytes)).toBe(0);
  });

  test('has visibility, lights and the camera', async () => {
    const { document, lost } = await again(sample);
    expect(Object.values(document.objects).map(({ visible }) => visible)).toEqual([true, true, false]);
    const lights = Object.values(document.lights);
    expect(lights.map(({ type }) => type)).toEqual(['directional', 'point', 'spot']);
    expect(lights[0]).toMatchObject({ illuminance: 3, color: [1, 0.5, 0.25] });
    expect(lights[1]).toMatchObject({ intensity: 7, range: 9 });
    expect((lights[2] as { cutoff: number }).cutoff).toBeCloseTo(25, 5);
    expect((lights[2] as { penumbra: number }).penumbra).toBeCloseTo(0.5, 5);
    const direction = (from: readonly number[], to: readonly number[]) => {
      const d = to.map((value, i) => value - from[i]!);
      return d.map((value) => value / Math.hypot(...d));
    };
    const sun = lights[0] as { position: number[]; target: number[] };
    expect(distance(direction(sun.position, sun.target), direction([1, 2, 3], [1, 0, 0]))).toBeLessThan(1e-5);
    expect(document.camera.fov).toBeCloseTo(40, 5);
    expect(
      distance(direction(document.camera.position, document.camera.target), direction([1, 2, 5], [0, 1, 0])),
    ).toBeLessThan(1e-5);
    expect(lost.join()).toContain('no lights of the kind ambient');
  });

  const unit = fc.double({ min: 0, max: 1, noNaN: true });
  const ball = (material: Record<string, unknown>) =>
    scene({ materials: { m: material }, objects: { o: { material: 'm', geometry: { type: 'plane' } } } });

  test('has principled materials as they were, to 1e-5', async () => {
    const parameters = fc.record({
      baseColor: fc.tuple(unit, unit, unit),
      metallic: unit,
      roughness: fc.double({ min: 0.1, max: 1, noNaN: true }),
      specular: unit,
      clearcoat: fc.double({ min: 0.01, max: 1, noNaN: true }),
      clearcoatGloss: unit,
    });
    await fc.assert(
      fc.asyncProperty(parameters, unit, async (values, strength) => {
        const { document } = await again(
          ball({
            model: 'principled',
            parameters: values,
            emissive: [1, 0.5, 0],
            emissiveIntensity: 5 * strength + 0.01,
          }),
        );
        const [found] = Object.values(document.materials);
        const complete = { specular: 0.5, ...found!.parameters };
        for (const [name, value] of Object.entries(values))
          expect(
            distance([value].flat(), [(complete as Record<string, number | number[]>)[name]!].flat()),
            name,
          ).toBeLessThan(1e-5);
        expect(found!.emissiveIntensity).toBeCloseTo(5 * strength + 0.01, 5);
      }),
      { numRuns: 40 },
    );
  });

  test.each([0.1, 0.5, 0.9])('has anisotropy %f as it was', async (anisotropic) => {
    const { document } = await again(
      ball({ model: 'principled', parameters: { anisotropic, roughness: 0.4 } }),
    );
    const { parameters } = Object.values(document.materials)[0]!;
    expect(parameters.anisotropic).toBeCloseTo(anisotropic, 5);
    expect(parameters.roughness).toBeCloseTo(0.4, 5);
  });

  test('has glass: a body and a sheet', async () => {
    const body = {
      specTrans: 1,
      ior: 1.33,
      roughness: 0.1,
      transmissionColor: [0.2, 0.5, 0.8],
      transmissionDepth: 0.7,
    };
    const found = await again(ball({ model: 'principled-bsdf', parameters: body }));
    expect(Object.values(found.document.materials)[0]).toMatchObject({
      model: 'principled-bsdf',
      parameters: { ...body, thin: false },
    });
    const sheet = await again(ball({ model: 'principled-bsdf', parameters: { diffTrans: 0.5, thin: true } }));
    expect(Object.values(sheet.document.materials)[0]?.parameters).toMatchObject({
      diffTrans: 0.5,
      thin: true,
    });
    const glass = await again(ball({ model: 'dielectric', parameters: { ior: 1.7 } }));
    expect(Object.values(glass.document.materials)[0]?.parameters).toMatchObject({
      specTrans: 1,
      ior: 1.7,
      thin: false,
    });
  });

  test('says which models it cannot describe', async () => {
    const { lost } = await again(ball({ model: 'cook-torrance' }));
    expect(lost.join()).toContain('cook-torrance is written as');
  });
});

describe('textures', () => {
  const image = (values: readonly number[]) =>
    encodeBase64(
      encodePng(
        Uint8Array.from({ length: 16 }, (_, i) => values[i % 4]!),
        2,
        2,
      ),
    );
  const withTextures = (textures: Record<string, unknown>, rest: Record<string, unknown> = {}) =>
    scene({
      assets: {
        a: { name: 'a.png', mediaType: 'image/png', data: image([10, 20, 30, 40]) },
        b: { name: 'b.png', mediaType: 'image/png', data: image([50, 60, 70, 80]) },
      },
      materials: { m: { model: 'principled', parameters: { metallic: 1, roughness: 1 }, textures, ...rest } },
      objects: { o: { material: 'm', geometry: { type: 'plane' } } },
    });
  async function texel(
    document: Document,
    name: string,
  ): Promise<{ texel: number[]; channel: string | null }> {
    const ref = Object.values(document.materials)[0]!.textures[name]!;
    const { bytes } = readTexels(await assets.image(document.assets[ref.asset]!, ref.texture));
    return { texel: [...bytes.slice(0, 4)], channel: ref.channel };
  }

  test('that glTF reads as they are stay the files that they were, transformed', async () => {
    const place = { repeat: [2, 2], offset: [0.25, 0.5], rotation: 30, wrap: 'mirror' };
    const source = withTextures({ baseColor: { asset: 'a', colorSpace: 'srgb', ...place } });
    const { document, lost } = await again(source);
    const ref = Object.values(document.materials)[0]!.textures.baseColor!;
    expect(distance([...ref.repeat, ...ref.offset, ref.rotation], [2, 2, 0.25, 0.5, 30])).toBeLessThan(1e-5);
    expect(ref.wrap).toBe('mirror');
    expect((await texel(document, 'baseColor')).texel).toEqual([10, 20, 30, 40]);
    expect(lost.filter((note) => !/camera|point/.test(note))).toEqual([]);
    const { bytes } = await exportGltf(source, assets);
    const { binary } = readGlb(bytes, 'x');
    expect(Buffer.from(binary!).includes(Buffer.from(source.assets.a!.data, 'base64'))).toBe(true);
  });

  test('in other channels are put together', async () => {
    const { document } = await again(
      withTextures({ roughness: { asset: 'a', channel: 'r' }, metallic: { asset: 'b', channel: 'a' } }),
    );
    const roughness = await texel(document, 'roughness');
    const metallic = await texel(document, 'metallic');
    expect(roughness).toEqual({ texel: [255, 10, 80, 255], channel: 'g' });
    expect(metallic).toEqual({ texel: [255, 10, 80, 255], channel: 'b' });
  });

  test('of colour and opacity become one', async () => {
    const { document } = await again(
      withTextures(
        { baseColor: { asset: 'a', colorSpace: 'srgb' } },
        { alphaMode: 'blend', opacityMap: { asset: 'b', channel: 'g' } },
      ),
    );
    expect((await texel(document, 'baseColor')).texel).toEqual([10, 20, 30, 60]);
  });

  test('that lie differently on the surface are left out, and said', async () => {
    const { lost } = await again(
      withTextures({
        roughness: { asset: 'a', channel: 'r' },
        metallic: { asset: 'b', channel: 'a', repeat: [2, 2] },
      }),
    );
    expect(lost.join()).toContain('lie differently');
  });
});
