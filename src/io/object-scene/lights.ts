/** Lights and cameras of a three.js scene file; their units are three.js's, which are those of a document. */
import * as THREE from 'three/webgpu';
import { type Light, lightDefaults } from '../../scene/light-schema.ts';
import type { Camera } from '../../scene/schema.ts';
import { cameraDefaults } from '../../scene/stage-schema.ts';
import { linear } from './material.ts';
import type { SourceObject } from './schema.ts';

type Vector = [number, number, number];
const clamp = THREE.MathUtils.clamp;
const bounded = (vector: THREE.Vector3): Vector => vector.toArray().map((x) => clamp(x, -1e6, 1e6)) as Vector;

/** @param target where the object stands that the light looks at; three.js's lights look at the origin */
export function sceneLight(
  object: SourceObject,
  world: THREE.Matrix4,
  target: THREE.Matrix4 | undefined,
): Light | null {
  const name = (object.name || object.type.replace(/([a-z])([A-Z])/g, '$1 $2')).slice(0, 180);
  const common = { name, color: linear(object.color) };
  const intensity = clamp(object.intensity, 0, 1e9);
  const position = bounded(new THREE.Vector3().setFromMatrixPosition(world));
  const aim = bounded(target ? new THREE.Vector3().setFromMatrixPosition(target) : new THREE.Vector3());
  const falloff = object.decay === 2 ? 'inverse-square' : object.decay === 0 ? 'constant' : 'linear';
  const range = clamp(object.distance, 0, 1e6);
  switch (object.type) {
    // three.js counts light from everywhere as irradiance, pi times the radiance.
    case 'AmbientLight':
      return { ...lightDefaults.ambient, ...common, luminance: intensity / Math.PI };
    case 'HemisphereLight':
      return {
        ...lightDefaults.hemisphere,
        ...common,
        luminance: intensity / Math.PI,
        groundColor: linear(object.groundColor),
      };
    case 'DirectionalLight':
      return { ...lightDefaults.directional, ...common, illuminance: intensity, position, target: aim };
    case 'PointLight':
      return { ...lightDefaults.point, ...common, intensity, position, falloff, range };
    case 'SpotLight':
      return {
        ...lightDefaults.spot,
        ...common,
        intensity,
        position,
        target: aim,
        falloff,
        range,
        exponent: 0,
        cutoff: clamp(THREE.MathUtils.radToDeg(object.angle), 0.1, 90),
        penumbra: clamp(object.penumbra, 0, 1),
      };
    case 'RectAreaLight':
      return {
        ...lightDefaults.rectangle,
        ...common,
        luminance: intensity,
        position,
        target: ahead(world, 5),
        width: clamp(object.width, 1e-3, 1e5),
        height: clamp(object.height, 1e-3, 1e5),
      };
    default:
      return null;
  }
}

/** A point on the way that something looks: along its -z. */
function ahead(world: THREE.Matrix4, distance: number): Vector {
  const direction = new THREE.Vector3(0, 0, -1).transformDirection(world);
  return bounded(direction.multiplyScalar(distance).add(new THREE.Vector3().setFromMatrixPosition(world)));
}

export function sceneCamera(object: SourceObject, world: THREE.Matrix4): Camera | null {
  if (object.type !== 'PerspectiveCamera') return null;
  const near = clamp(object.near, 1e-4, 1e4);
  return {
    ...cameraDefaults,
    fov: clamp(object.fov, 1, 170),
    position: bounded(new THREE.Vector3().setFromMatrixPosition(world)),
    target: ahead(world, Math.max(5, near * 2)),
    near,
    far: clamp(object.far, near * 2, 1e7),
  };
}
