import * as THREE from 'three/webgpu';
import { describe, expect, test } from 'vitest';

import { bring, images, onlyMaterial, triangle } from './gltf-files.ts';

describe('materials become principled', () => {
  test('with the metallic-roughness factors', async () => {
    const material = await onlyMaterial(
      triangle(
        {},
        {
          pbrMetallicRoughness: {
            baseColorFactor: [0.1, 0.2, 0.3, 0.4],
            metallicFactor: 0.6,
            roughnessFactor: 0.7,
          },
          alphaMode: 'BLEND',
          doubleSided: true,
          emissiveFactor: [0.5, 0.25, 0],
          extensions: { KHR_materials_emissive_strength: { emissiveStrength: 4 } },
        },
      ),
    );
    expect(material).toMatchObject({
      name: 'Paint',
      model: 'principled',
      parameters: { baseColor: [0.1, 0.2, 0.3], metallic: 0.6, roughness: 0.7 },
      alphaMode: 'blend',
      opacity: 0.4,
      doubleSided: true,
      emissive: [1, 0.5, 0],
      emissiveIntensity: 2,
      notes: [],
    });
  });

  test('with the textures in their channels and colour spaces', async () => {
    const map = { index: 0 };
    const material = await onlyMaterial(
      triangle(images, {
        pbrMetallicRoughness: { baseColorTexture: map, metallicRoughnessTexture: map },
        normalTexture: { index: 0, scale: 0.5 },
        occlusionTexture: { index: 0, strength: 0.75 },
        emissiveTexture: map,
        emissiveFactor: [1, 1, 1],
      }),
    );
    expect(material.textures).toMatchObject({
      baseColor: { texture: 0, colorSpace: 'srgb', channel: null },
      metallic: { texture: 0, colorSpace: 'linear', channel: 'b' },
      roughness: { texture: 0, colorSpace: 'linear', channel: 'g' },
    });
    expect(material.normalMap).toMatchObject({ texture: 0, scale: 0.5, colorSpace: 'linear' });
    expect(material.occlusionMap).toMatchObject({ scale: 0.75, channel: 'r' });
    expect(material.emissiveMap).toMatchObject({ colorSpace: 'srgb' });
    expect(material.notes).toEqual([]);
  });

  test('with the alpha of their colour as opacity, where it counts', async () => {
    const pbrMetallicRoughness = { baseColorTexture: { index: 0 } };
    const mask = await onlyMaterial(
      triangle(images, { pbrMetallicRoughness, alphaMode: 'MASK', alphaCutoff: 0.3 }),
    );
    expect(mask).toMatchObject({
      alphaMode: 'mask',
      alphaCutoff: 0.3,
      opacityMap: { texture: 0, channel: 'a' },
    });
    const opaque = await onlyMaterial(triangle(images, { pbrMetallicRoughness }));
    expect(opaque.opacityMap).toBeNull();
  });

  test('with the extensions that have a counterpart', async () => {
    const { parameters } = await onlyMaterial(
      triangle(
        {},
        {
          extensions: {
            KHR_materials_clearcoat: { clearcoatFactor: 0.8, clearcoatRoughnessFactor: 0.1 },
            KHR_materials_sheen: { sheenColorFactor: [0.5, 0.25, 0.5] },
            KHR_materials_ior: { ior: 1.8 },
            KHR_materials_anisotropy: { anisotropyStrength: 0.5 },
          },
        },
      ),
    );
    expect(parameters).toMatchObject({ clearcoat: 0.8, sheen: 0.5, sheenTint: 0.5 });
    expect(parameters.clearcoatGloss).toBeCloseTo(0.9091, 3);
    // An ior of 1.8 is what 1 stands for.
    expect(parameters.specular).toBeCloseTo(1.0204, 3);
    // With roughness 1 both widths are 1, however strong the anisotropy.
    expect(parameters.anisotropic).toBe(0);
  });

  test('anisotropic as KHR_materials_anisotropy is', async () => {
    const roughness = 0.4;
    const strength = 0.6;
    const { parameters } = await onlyMaterial(
      triangle(
        {},
        {
          pbrMetallicRoughness: { roughnessFactor: roughness },
          extensions: { KHR_materials_anisotropy: { anisotropyStrength: strength } },
        },
      ),
    );
    const aspect = Math.sqrt(1 - 0.9 * Number(parameters.anisotropic));
    const alpha = Number(parameters.roughness) ** 2;
    expect(alpha * aspect).toBeCloseTo(roughness ** 2, 5);
    expect(alpha / aspect).toBeCloseTo(roughness ** 2 * (1 - strength ** 2) + strength ** 2, 5);
  });

  test('with texture transforms that look up the same texels', async () => {
    const transform = { offset: [0.1, 0.2], rotation: 0.3, scale: [2, 2] };
    const info = { index: 0, extensions: { KHR_texture_transform: transform } };
    const { textures } = await onlyMaterial(
      triangle(images, { pbrMetallicRoughness: { baseColorTexture: info } }),
    );
    const ref = textures.baseColor!;
    const matrix = new THREE.Matrix3().setUvTransform(
      ...ref.offset,
      ...ref.repeat,
      THREE.MathUtils.degToRad(ref.rotation),
      0,
      0,
    );
    // What three's own loader does with v downwards.
    const downwards = new THREE.Matrix3().setUvTransform(0.1, 0.2, 2, 2, 0.3, 0, 0);
    for (const [u, v] of [
      [0.3, 0.4],
      [0, 1],
      [0.9, 0.2],
    ] as const) {
      const expected = new THREE.Vector2(u, v).applyMatrix3(downwards);
      const found = new THREE.Vector2(u, 1 - v).applyMatrix3(matrix);
      expect(found.x).toBeCloseTo(expected.x, 6);
      expect(1 - found.y).toBeCloseTo(expected.y, 6);
    }
  });

  test('and what cannot be mapped is said', async () => {
    const { notes } = await onlyMaterial(
      triangle(
        {},
        {
          extensions: {
            KHR_materials_iridescence: { iridescenceFactor: 1 },
            KHR_materials_dispersion: { dispersion: 0.1 },
            KHR_materials_anisotropy: { anisotropyStrength: 0.5, anisotropyRotation: 1 },
          },
        },
      ),
    );
    expect(notes).toEqual([
      'Paint: the rotation of the anisotropy has no counterpart',
      'Paint: iridescence has no counterpart',
      'Paint: dispersion has no counterpart',
    ]);
  });

  test('and so are textures, filters and extensions that are not read', async () => {
    const map = { index: 0 };
    const { notes, textures } = await onlyMaterial(
      triangle(
        { ...images, samplers: [{ magFilter: 9728 }], textures: [{ source: 0, sampler: 0 }] },
        {
          extensions: {
            KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessTexture: map },
            KHR_materials_specular: { specularColorTexture: map },
            KHR_materials_volume: { thicknessFactor: 1, thicknessTexture: map },
            KHR_materials_diffuse_transmission: {
              diffuseTransmissionFactor: 0.5,
              diffuseTransmissionTexture: map,
              diffuseTransmissionColorTexture: map,
            },
            ADOBE_materials_thin_transparency: {},
          },
        },
      ),
    );
    expect(textures.diffTrans).toMatchObject({ texture: 0, channel: 'a' });
    expect(notes).toEqual([
      'textures[0] is shown smooth from near, not in squares',
      'Paint: light that its sheet lets through diffusely has the base colour',
      'Paint: light goes through it in the path traced picture; the interactive one shows its reflection',
      "Paint: the texture of the clearcoat's roughness has no counterpart",
      "Paint: the texture of the reflection's colour has no counterpart",
      'Paint: the texture of its thickness is not needed: the body is as thick as it is',
      'Paint: the colour texture of the light that its sheet lets through has no counterpart',
      'Paint: ADOBE_materials_thin_transparency is not read',
    ]);
  });

  test('that let light through are principled-bsdf: thin without a volume, otherwise bodies', async () => {
    const transmission = { KHR_materials_transmission: { transmissionFactor: 0.9 } };
    const thin = await onlyMaterial(triangle({}, { extensions: transmission }));
    expect(thin).toMatchObject({
      model: 'principled-bsdf',
      parameters: { specTrans: 0.9, thin: true, ior: 1.5 },
    });
    const body = await onlyMaterial(
      triangle(
        {},
        {
          extensions: {
            ...transmission,
            KHR_materials_ior: { ior: 1.33 },
            KHR_materials_volume: {
              thicknessFactor: 1,
              attenuationDistance: 2,
              attenuationColor: [0.5, 0.6, 0.7],
            },
          },
        },
      ),
    );
    expect(body.parameters).toMatchObject({
      thin: false,
      ior: 1.33,
      transmissionColor: [0.5, 0.6, 0.7],
      transmissionDepth: 2,
    });
    expect(body.parameters).not.toHaveProperty('specular');
  });

  test('that are unlit emit their colour', async () => {
    const material = await onlyMaterial(
      triangle(
        {},
        {
          pbrMetallicRoughness: { baseColorFactor: [0.5, 0.25, 0, 1] },
          extensions: { KHR_materials_unlit: {} },
        },
      ),
    );
    expect(material).toMatchObject({
      emissive: [1, 0.5, 0],
      emissiveIntensity: 0.5,
      parameters: { baseColor: [0, 0, 0], specular: 0 },
    });
  });

  test('of the specular-glossiness workflow: a metal and a dielectric', async () => {
    const workflow = (specularFactor: number[], diffuseFactor: number[]) =>
      triangle(
        {},
        {
          extensions: {
            KHR_materials_pbrSpecularGlossiness: { specularFactor, diffuseFactor, glossinessFactor: 0.75 },
          },
        },
      );
    const metal = await onlyMaterial(workflow([0.9, 0.6, 0.3], [0, 0, 0, 1]));
    expect(metal.parameters.metallic).toBeCloseTo(1, 2);
    expect(metal.parameters.roughness).toBe(0.25);
    const paint = await onlyMaterial(workflow([0.04, 0.04, 0.04], [0.5, 0.2, 0.1, 1]));
    expect(paint.parameters.metallic).toBeCloseTo(0, 6);
    (paint.parameters.baseColor as number[]).forEach((value, c) => {
      expect(value).toBeCloseTo([0.5, 0.2, 0.1][c]!, 6);
    });
  });

  test('of variants are there, beside the one that is shown', async () => {
    const primitive = {
      attributes: { POSITION: 0 },
      material: 0,
      extensions: {
        KHR_materials_variants: {
          mappings: [
            { material: 0, variants: [0] },
            { material: 1, variants: [1] },
          ],
        },
      },
    };
    const { document, notes } = await bring(
      triangle({
        meshes: [{ primitives: [primitive] }],
        materials: [{ name: 'Blue' }, { name: 'Green' }],
        extensions: { KHR_materials_variants: { variants: [{ name: 'day' }, { name: 'night' }] } },
      }),
    );
    expect(Object.values(document.materials).map(({ name }) => name)).toEqual(['Blue', 'Green']);
    expect(Object.values(document.objects)).toMatchObject([{ material: Object.keys(document.materials)[0] }]);
    expect(notes.join()).toContain('variants day, night');
  });

  test('scenes, cameras, animations and extensions that stay behind are told', async () => {
    const camera = { type: 'perspective', perspective: { yfov: 1, znear: 0.1 } };
    const { document, notes } = await bring(
      triangle({
        scenes: [{ nodes: [0, 1, 2] }, { nodes: [] }],
        nodes: [{ mesh: 0 }, { camera: 0, translation: [0, 0, 7] }, { camera: 0 }],
        cameras: [camera],
        animations: [{ channels: [], samplers: [] }],
        extensionsUsed: ['KHR_materials_ior', 'EXT_strange'],
        extensionsRequired: ['KHR_materials_ior', 'EXT_strange'],
      }),
    );
    expect(document.camera.position).toEqual([0, 0, 7]);
    expect(notes).toEqual([
      'its animations are not played',
      'it has 2 scenes; only the one that it names is shown',
      "it has 2 cameras; the view is the first one's",
      'it needs the extension EXT_strange, which is not read',
    ]);
  });

  test('hidden nodes hide what is below them', async () => {
    const hidden = { KHR_node_visibility: { visible: false } };
    const { document } = await bring(
      triangle({ nodes: [{ children: [1], extensions: hidden }, { mesh: 0 }], scenes: [{ nodes: [0] }] }),
    );
    expect(Object.values(document.objects)).toMatchObject([{ visible: false }]);
  });

  test('without an image that cannot be read', async () => {
    const broken = { images: [{ uri: 'data:image/png;base64,AAAA' }], textures: [{ source: 0 }] };
    const material = await onlyMaterial(
      triangle(broken, { pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }),
    );
    expect(material.textures).toEqual({});
    expect(material.notes[0]).toMatch(/sample\.glb, textures\[0\]: the image cannot be read/);
  });
});
