import * as THREE from 'three/webgpu';
import { BrdfMaterial } from '../../src/material/brdf-material.ts';
import { drawScene, modelNamed } from './lit-sphere.ts';

/**
 * Meshes that the vertex shader moves (instances, bones, morph targets), beside plain meshes that were baked
 * on the CPU to the same vertices, normals and tangents.
 */

interface DeformedMesh {
  readonly moved: THREE.Object3D;
  readonly baked: THREE.Object3D;
}

type Deform = (material: THREE.Material) => DeformedMesh;

function torus(): THREE.BufferGeometry {
  const geometry = new THREE.TorusGeometry(0.6, 0.25, 24, 48);
  geometry.computeTangents();
  return geometry;
}

/** Two instances, both turned, one of them stretched. */
const instanced: Deform = (material) => {
  const turn = (x: number, y: number, z: number) =>
    new THREE.Quaternion().setFromEuler(new THREE.Euler(x, y, z));
  const matrices = [
    new THREE.Matrix4().compose(
      new THREE.Vector3(-0.5, 0.4, 0),
      turn(0.4, 0.5, 1),
      new THREE.Vector3(0.6, 0.6, 0.6),
    ),
    new THREE.Matrix4().compose(
      new THREE.Vector3(0.4, -0.4, 0),
      turn(-0.9, 0.2, 0.6),
      new THREE.Vector3(0.9, 0.5, 0.7),
    ),
  ];
  const moved = new THREE.InstancedMesh(torus(), material, matrices.length);
  const baked = new THREE.Group();
  matrices.forEach((matrix, i) => {
    moved.setMatrixAt(i, matrix);
    baked.add(new THREE.Mesh(torus().applyMatrix4(matrix), material));
  });
  return { moved, baked };
};

/** Two bones; what is above y = 0 follows the second one more and more. */
const skinned: Deform = (material) => {
  const geometry = torus();
  const position = geometry.getAttribute('position');
  const indices: number[] = [];
  const weights: number[] = [];
  for (let i = 0; i < position.count; i++) {
    const second = THREE.MathUtils.smoothstep(position.getY(i), -0.4, 0.4);
    indices.push(0, 1, 0, 0);
    weights.push(1 - second, second, 0, 0);
  }
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(indices, 4));
  geometry.setAttribute('skinWeight', new THREE.Float32BufferAttribute(weights, 4));
  const [root, tip] = [new THREE.Bone(), new THREE.Bone()];
  root.add(tip);
  const moved = new THREE.SkinnedMesh(geometry, material);
  moved.add(root);
  moved.bind(new THREE.Skeleton([root, tip]));
  tip.rotation.set(0.7, 0.3, 0.5);
  tip.position.set(0.1, 0.15, 0);
  moved.updateMatrixWorld(true);

  const bones = [root.matrixWorld, tip.matrixWorld];
  const bakedGeometry = torus();
  const blend = (name: string, along: 0 | 1) => {
    const attribute = bakedGeometry.getAttribute(name) as THREE.BufferAttribute;
    for (let i = 0; i < attribute.count; i++) {
      const sum = new THREE.Vector4(0, 0, 0, 0);
      const from = new THREE.Vector4().fromBufferAttribute(attribute, i).setW(along);
      bones.forEach((bone, b) => {
        sum.addScaledVector(from.clone().applyMatrix4(bone), weights[4 * i + b] as number);
      });
      attribute.setXYZ(i, sum.x, sum.y, sum.z);
    }
  };
  blend('position', 1);
  blend('normal', 0);
  blend('tangent', 0);
  return { moved, baked: new THREE.Mesh(bakedGeometry, material) };
};

/** Two targets of positions and normals. */
const morphed: Deform = (material) => {
  const targets = [
    new THREE.Matrix4().makeScale(1.5, 0.6, 1),
    new THREE.Matrix4().makeShear(0.3, 0, 0.5, 0, 0, 0.2),
  ];
  const influences = [0.7, 0.4];
  const geometry = torus();
  const baked = torus();
  for (const name of ['position', 'normal'] as const) {
    const base = geometry.getAttribute(name);
    const result = baked.getAttribute(name) as THREE.BufferAttribute;
    geometry.morphAttributes[name] = targets.map((matrix, t) => {
      const delta = new Float32Array(base.count * 3);
      const there = torus().applyMatrix4(matrix).getAttribute(name);
      for (let i = 0; i < base.count; i++) {
        for (let c = 0; c < 3; c++) {
          const difference = there.getComponent(i, c) - base.getComponent(i, c);
          delta[3 * i + c] = difference;
          result.setComponent(i, c, result.getComponent(i, c) + difference * (influences[t] as number));
        }
      }
      return new THREE.Float32BufferAttribute(delta, 3);
    });
  }
  geometry.morphTargetsRelative = true;
  const moved = new THREE.Mesh(geometry, material);
  moved.updateMorphTargets();
  moved.morphTargetInfluences = influences;
  return { moved, baked: new THREE.Mesh(baked, material) };
};

export const DEFORMATIONS: Readonly<Record<string, Deform>> = { instanced, skinned, morphed };

const VALUES: Readonly<Record<string, Record<string, unknown>>> = {
  isotropic: { roughness: 0.4, clearcoat: 1 },
  anisotropic: { metallic: 1, anisotropic: 0.9, roughness: 0.4 },
};

export interface DeformedResult {
  readonly deformation: string;
  readonly material: string;
  /** Pixels that show the mesh. */
  readonly count: number;
  /** The share of them that differ by more than a hundredth. */
  readonly different: number;
}

/** Draws every deformation in every material, by the vertex shader and baked. */
export async function compareDeformed(renderer: THREE.WebGPURenderer): Promise<DeformedResult[]> {
  const results: DeformedResult[] = [];
  for (const [deformation, deform] of Object.entries(DEFORMATIONS)) {
    for (const [name, values] of Object.entries(VALUES)) {
      const material = new BrdfMaterial(modelNamed('principled'), values);
      const { moved, baked } = deform(material);
      const pictures = [await draw(renderer, moved), await draw(renderer, baked)];
      const [first, second] = pictures as [Float32Array, Float32Array];
      let [count, different] = [0, 0];
      for (let i = 0; i < second.length; i += 4) {
        if (!second[i + 3] && !first[i + 3]) continue;
        count++;
        const far = [0, 1, 2].some((c) => {
          const [a, b] = [first[i + c] as number, second[i + c] as number];
          return !(Math.abs(a - b) <= 0.01 * Math.max(b, 0.05));
        });
        if (far) different++;
      }
      results.push({ deformation, material: name, count, different: different / count });
      material.dispose();
    }
  }
  return results;
}

function draw(renderer: THREE.WebGPURenderer, object: THREE.Object3D): Promise<Float32Array> {
  const light = new THREE.DirectionalLight(0xffffff, 3);
  light.position.set(1, 2, 2);
  const scene = new THREE.Scene();
  scene.add(object, light);
  return drawScene(renderer, scene);
}
