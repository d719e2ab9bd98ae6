import * as THREE from 'three/webgpu';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { drawScene, modelNamed } from './lit-sphere.ts';

/**
 * What three.js users expect of any material, with the model `lambert` beside three.js's own Lambert material.
 */

type Either = BrdfMaterial | THREE.MeshLambertNodeMaterial;

export interface Feature {
  readonly set?: (material: Either) => void;
  readonly geometry?: () => THREE.BufferGeometry;
  readonly shadow?: boolean;
  readonly instanced?: boolean;
  /** Beside the sun. */
  readonly lamp?: () => THREE.Light;
  readonly pose?: (mesh: THREE.Mesh) => void;
}

/** A texture of noise, so that no two texels agree by accident. */
function noise(low: readonly number[], high: readonly number[]): THREE.DataTexture {
  const size = 8;
  const texels = new Uint8Array(size * size * 4);
  let state = 1;
  for (let i = 0; i < texels.length; i++) {
    state = (state * 48271) % 0x7fffffff;
    const [from, to] = [low[i % 4] as number, high[i % 4] as number];
    texels[i] = from + (to - from) * (state / 0x7fffffff);
  }
  const texture = new THREE.DataTexture(texels, size, size);
  texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

const sphere = () => new THREE.SphereGeometry(1, 48, 32);
/** Open towards the camera. */
const halfSphere = () => new THREE.SphereGeometry(1, 48, 32, Math.PI * 0.7, Math.PI * 1.3);
const withoutNormals = () => {
  const geometry = sphere();
  geometry.deleteAttribute('normal');
  return geometry;
};
const placed = <L extends THREE.Light>(lamp: L): L => {
  lamp.position.set(-1.2, 1.5, 2.2);
  return lamp;
};
const grey = () => noise([0, 0, 0, 255], [255, 255, 255, 255]);
const normals = () => noise([70, 70, 180, 255], [185, 185, 255, 255]);

export const FEATURES: Readonly<Record<string, Feature>> = {
  'a normal map': { set: (m) => Object.assign(m, { normalMap: normals() }) },
  'a normal map, scaled': {
    set: (m) => Object.assign(m, { normalMap: normals(), normalScale: new THREE.Vector2(0.5, -0.5) }),
  },
  'a normal map with tangents': {
    set: (m) => Object.assign(m, { normalMap: normals() }),
    geometry: () => {
      const geometry = sphere();
      geometry.computeTangents();
      return geometry;
    },
  },
  'a bump map': { set: (m) => Object.assign(m, { bumpMap: grey(), bumpScale: 3 }) },
  'an occlusion map': { set: (m) => Object.assign(m, { aoMap: grey(), aoMapIntensity: 0.8 }) },
  'emission with a map': {
    set: (m) =>
      Object.assign(m, {
        emissive: new THREE.Color(1, 0.5, 0.2),
        emissiveIntensity: 2,
        emissiveMap: noise([0, 0, 0, 255], [255, 255, 255, 255]),
      }),
  },
  transparency: { set: (m) => Object.assign(m, { transparent: true, opacity: 0.4 }) },
  'an alpha map': { set: (m) => Object.assign(m, { transparent: true, alphaMap: grey() }) },
  'an alpha test': { set: (m) => Object.assign(m, { alphaTest: 0.5, alphaMap: grey() }) },
  'two sides': { set: (m) => Object.assign(m, { side: THREE.DoubleSide }), geometry: halfSphere },
  'the back side': { set: (m) => Object.assign(m, { side: THREE.BackSide }) },
  'flat shading': { set: (m) => Object.assign(m, { flatShading: true }) },
  'no normals': { geometry: withoutNormals },
  shadows: { shadow: true },
  'vertex colours': {
    set: (m) => {
      m.vertexColors = true;
    },
    geometry: () => {
      const geometry = sphere();
      const colors = Float32Array.from(
        { length: geometry.getAttribute('position').count * 3 },
        (_, i) => (i % 7) / 6,
      );
      return geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3));
    },
  },
  'colours of instances': { instanced: true },
  'a point light with a range': { lamp: () => placed(new THREE.PointLight(0xffccaa, 8, 4, 1.5)) },
  'a spot light with a penumbra': { lamp: () => placed(new THREE.SpotLight(0xaaccff, 20, 8, 0.35, 0.4)) },
  'a spot light that throws a picture': {
    lamp: () => placed(Object.assign(new THREE.SpotLight(0xffffff, 20, 0, 0.4, 0.2), { map: grey() })),
  },
  'a mesh that is mirrored and squeezed': {
    pose: (mesh) => {
      mesh.scale.set(-1.1, 0.5, 0.8);
      mesh.rotation.set(0.4, 1, 0.3);
    },
  },
  'a light map': {
    set: (m) => {
      const lightMap = grey();
      lightMap.channel = 0;
      Object.assign(m, { lightMap, lightMapIntensity: 0.7 });
    },
  },
};

export async function draw(renderer: THREE.WebGPURenderer, material: Either, feature: Feature) {
  const { set, geometry = sphere, shadow = false, instanced = false, lamp, pose } = feature;
  set?.(material);
  renderer.shadowMap.enabled = true;
  const light = new THREE.DirectionalLight(0xffffff, 3);
  light.position.set(1, 2, 2);
  const mesh = instanced ? twoInstances(geometry(), material) : new THREE.Mesh(geometry(), material);
  pose?.(mesh);
  const scene = new THREE.Scene();
  scene.add(light, new THREE.AmbientLight(0xffffff, 0.3), mesh);
  if (lamp) scene.add(lamp());
  if (shadow) {
    const caster = new THREE.Mesh(new THREE.SphereGeometry(0.3), material);
    caster.position.set(0.5, 1, 1);
    light.castShadow = true;
    caster.castShadow = true;
    mesh.receiveShadow = true;
    scene.add(caster);
  }
  return drawScene(renderer, scene);
}

function twoInstances(geometry: THREE.BufferGeometry, material: Either): THREE.InstancedMesh {
  const mesh = new THREE.InstancedMesh(geometry, material, 2);
  for (const i of [0, 1]) {
    mesh.setMatrixAt(i, new THREE.Matrix4().makeScale(0.5, 0.5, 0.5).setPosition(i - 0.5, 0, 0));
    mesh.setColorAt(i, new THREE.Color(i, 0.5, 1 - i));
  }
  return mesh;
}

export const brdf = () => new BrdfMaterial(modelNamed('lambert'), { albedo: [0.8, 0.5, 0.2] });
export const lambert = () =>
  new THREE.MeshLambertNodeMaterial({ color: new THREE.Color().setRGB(0.8, 0.5, 0.2) });

/** The share of values that are further apart than half a hundredth. */
export const different = (a: Float32Array, b: Float32Array) =>
  a.filter((x, i) => !(Math.abs(x - (b[i] as number)) < 0.005)).length / a.length;
