/** A scene of many alike, drawn as instances and one by one. */
import {
  BoxGeometry,
  DataTexture,
  DirectionalLight,
  EquirectangularReflectionMapping,
  FloatType,
  Group,
  type Material,
  Mesh,
  PerspectiveCamera,
  RGBAFormat,
  Scene,
  SphereGeometry,
  TorusGeometry,
} from 'three/webgpu';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { ensureTangents } from '../../src/material/tangents.ts';
import type { RealtimeRenderer } from '../../src/realtime/renderer.ts';
import { modelNamed } from '../material/lit-sphere.ts';

export const SIZE = { width: 96, height: 64 };
const view = { exposure: 0, toneMapping: 'none', resolutionScale: 1 } as const;

/** Drawn one by one. */
class OneMesh extends Mesh {}

const COUNT = 340;
const COLUMNS = 20;

export interface Repeated {
  readonly scene: Scene;
  readonly camera: PerspectiveCamera;
  readonly meshes: readonly Mesh[];
  readonly materials: readonly BrdfMaterial[];
}

/** @param far from the origin, m */
export function repeatedScene(isInstanced: boolean, far = 0): Repeated {
  const scene = new Scene();
  const geometries = [new BoxGeometry(), new SphereGeometry(0.6, 12, 8), new TorusGeometry(0.5, 0.2, 6, 10)];
  for (const geometry of geometries) ensureTangents(geometry);
  const principled = modelNamed('principled');
  const materials = [
    new BrdfMaterial(principled, { baseColor: [0.8, 0.3, 0.1], roughness: 0.4 }),
    new BrdfMaterial(principled, { metallic: 1, anisotropic: 0.9, roughness: 0.4 }),
    Object.assign(new BrdfMaterial(principled, { baseColor: [0.1, 0.4, 0.8] }), {
      transparent: true,
      opacity: 0.5,
    }),
  ];
  materials.push(new BrdfMaterial(principled, { baseColor: [0.05, 0.8, 0.1] }));
  const group = new Group();
  const meshes = Array.from({ length: COUNT }, (_, i) => {
    const mesh = new (isInstanced ? Mesh : OneMesh)(geometries[i % 3], materials[i % 20 === 7 ? 2 : i % 2]);
    mesh.position.set((i % COLUMNS) - COLUMNS / 2 + far, (i % 7) / 7, -Math.floor(i / COLUMNS));
    mesh.rotation.set(i, 2 * i, 3 * i);
    // Every eleventh a mirror image.
    mesh.scale.set(0.5, 0.3 + 0.05 * (i % 9), i % 11 === 5 ? -0.4 : 0.4);
    return mesh;
  });
  group.add(...meshes);
  const light = new DirectionalLight(0xffffff, 3);
  light.position.set(1, 2, 2);
  const texels = Float32Array.from({ length: 4 * 32 }, (_, i) => (i % 4 === 3 ? 1 : 0.2 + (i % 13) / 13));
  const environment = new DataTexture(texels, 8, 4, RGBAFormat, FloatType);
  environment.mapping = EquirectangularReflectionMapping;
  environment.needsUpdate = true;
  scene.environment = environment;
  scene.add(group, light);
  const camera = new PerspectiveCamera(50, SIZE.width / SIZE.height, 0.1, 100);
  camera.position.set(far, 5, 4);
  camera.lookAt(far, 0, -6);
  return { scene, camera, meshes, materials };
}

type Change = (scene: Repeated) => void;

/** One after another, each to what the one before left. */
export const CHANGES: Readonly<Record<string, Change>> = {
  'at first': () => {},
  'some moved, and a slider': ({ meshes, materials }) => {
    for (const mesh of meshes.slice(40, 120)) mesh.position.y += 0.8;
    materials[0]?.set('roughness', 0.9);
  },
  'another view, some hidden, some gone': ({ camera, meshes }) => {
    camera.position.set(-8, 3, -2);
    camera.lookAt(2, 0, -9);
    for (const mesh of meshes.slice(0, 60)) mesh.visible = false;
    for (const mesh of meshes.slice(300, 310)) mesh.removeFromParent();
  },
  'another material': ({ meshes, materials }) => {
    for (const mesh of meshes.slice(60, 160)) mesh.material = materials[1] as Material;
  },
  'all shown, and far more': ({ meshes }) => {
    for (const mesh of meshes.slice(0, 60)) mesh.visible = true;
    for (let copy = 1; copy < 6; copy++)
      for (const mesh of meshes.slice(0, 200)) {
        const other = mesh.clone();
        other.position.y -= 0.7 * copy;
        mesh.parent?.add(other);
      }
  },
  'copies in the place of others, of another material': ({ meshes, materials }) => {
    // Fewer than are worth instances.
    for (const mesh of meshes.slice(100, 110)) {
      const other = mesh.clone();
      other.material = materials[3] as Material;
      mesh.parent?.add(other);
    }
  },
};

export interface Likeness {
  /** Of the pixels, those that differ by more than a hundredth. */
  readonly differing: number;
  /** Mean difference, relative to the mean. */
  readonly mean: number;
  /** three.js's calls for the picture. */
  readonly calls: number;
  readonly single: number;
}

/** Of the two ways of drawing, after each change. */
export async function compareRepeated(
  renderer: RealtimeRenderer,
  changes = Object.keys(CHANGES),
  far = 0,
): Promise<Readonly<Record<string, Likeness>>> {
  const many = repeatedScene(true, far);
  const one = repeatedScene(false, far);
  const found: Record<string, Likeness> = {};
  for (const name of changes) {
    const draw = async (content: Repeated) => {
      CHANGES[name]?.(content);
      renderer.render(content, { view }, SIZE);
      return { calls: renderer.three.info.render.drawCalls, ...(await renderer.readRadiance()) };
    };
    const [a, b] = [await draw(many), await draw(one)];
    let [differing, sum, total] = [0, 0, 0];
    for (let at = 0; at < a.pixels.length; at += 4) {
      let most = 0;
      for (let c = at; c < at + 3; c++) {
        const [x, y] = [a.pixels[c]!, b.pixels[c]!];
        most = Math.max(most, Math.abs(x - y) / Math.max(y, 0.01));
        sum += Math.abs(x - y);
        total += y;
      }
      if (most > 1e-2) differing += 4 / a.pixels.length;
    }
    found[name] = { differing, mean: sum / total, calls: a.calls, single: b.calls };
  }
  return found;
}
