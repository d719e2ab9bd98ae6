/** Lights and the camera of a document as nodes of a glTF file. */
import * as THREE from 'three/webgpu';
import { keyOf } from '../../scene/groups.ts';
import { lightColor } from '../../scene/light-color.ts';
import type { Camera, Document, Light } from '../../scene/schema.ts';
import { lightsOf, SUN_ID } from '../../scene/sky/sun.ts';
import type { Notes } from '../gltf/notes.ts';
import type { GltfWriter, Json } from '../gltf/writer.ts';
import type { NodeOf } from './groups.ts';

type Vector = readonly [number, number, number];

/** What stands at a point and looks at another, along its -z as glTF's lights and cameras do. */
function placed(position: Vector, target: Vector): Json {
  const from = new THREE.Vector3(...position);
  const to = new THREE.Vector3(...target);
  // What looks at itself looks down, as nothing says otherwise.
  if (from.distanceTo(to) === 0) to.y -= 1;
  const matrix = new THREE.Matrix4().lookAt(from, to, new THREE.Vector3(0, 1, 0));
  const turn = new THREE.Quaternion().setFromRotationMatrix(matrix);
  return { translation: [...position], rotation: turn.toArray() };
}

export function exportCamera(
  { fov, near, far, position, target }: Camera,
  writer: GltfWriter,
  notes: Notes,
): void {
  const camera = writer.add('cameras', {
    type: 'perspective',
    perspective: { yfov: THREE.MathUtils.degToRad(fov), znear: near, zfar: far },
  });
  writer.add('nodes', { name: 'Camera', camera, ...placed(position, target) });
  notes.add('the point that the camera turns about is not in a glTF file');
}

/** KHR_lights_punctual; a sky's sun among them while it is up. */
export function exportLights(document: Document, writer: GltfWriter, nodes: NodeOf, notes: Notes): void {
  const written: Json[] = [];
  for (const [id, light] of Object.entries(lightsOf(document))) {
    if (id === SUN_ID && light.type === 'directional' && light.illuminance === 0) continue;
    const source = punctual(light, notes);
    if (source === null) continue;
    const { position, target } = light as Extract<Light, { type: 'spot' }>;
    const place = light.type === 'point' ? { translation: position } : placed(position, target);
    const index = written.push(source) - 1;
    if (!light.visible) writer.use('KHR_node_visibility');
    const node = writer.add('nodes', {
      name: light.name,
      ...place,
      extensions: {
        KHR_lights_punctual: { light: index },
        ...(!light.visible && { KHR_node_visibility: { visible: false } }),
      },
    });
    nodes.set(keyOf({ kind: 'lights', id }), node);
  }
  if (written.length === 0) return;
  writer.use('KHR_lights_punctual');
  writer.set('extensions', { KHR_lights_punctual: { lights: written } });
}

function punctual(light: Light, notes: Notes): Json | null {
  const { name } = light;
  const color = lightColor(light);
  const brightest = Math.max(1, ...color);
  const common = { name, color: color.map((value) => value / brightest) };
  if ('falloff' in light && light.falloff !== 'inverse-square')
    notes.add(`${name}: in glTF light fades with the square of the distance`);
  const range = 'range' in light && light.range > 0 ? { range: light.range } : {};
  switch (light.type) {
    case 'directional':
      return { ...common, type: 'directional', intensity: light.illuminance * brightest };
    case 'point':
      return { ...common, type: 'point', intensity: light.intensity * brightest, ...range };
    case 'spot': {
      if (light.exponent > 0) notes.add(`${name}: in glTF a beam is as bright at its edge as in the middle`);
      const outerConeAngle = THREE.MathUtils.degToRad(light.cutoff);
      return {
        ...common,
        type: 'spot',
        intensity: light.intensity * brightest,
        ...range,
        spot: {
          innerConeAngle: Math.min(outerConeAngle * (1 - light.penumbra), outerConeAngle - 1e-6),
          outerConeAngle,
        },
      };
    }
    default:
      notes.add(`${name}: glTF has no lights of the kind ${light.type}`);
      return null;
  }
}
