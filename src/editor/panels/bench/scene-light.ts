/**
 * The plots' l and the scene's first directional light. A horizontal surface stands for the plots' frame: its
 * normal is the scene's +y, its tangent +x; theta_l is the light's angle to the zenith.
 */
import { radians } from '../../../analysis/plots/curve.ts';
import { direction, type Vec3 } from '../../../analysis/vector.ts';
import { addLight } from '../../../scene/commands.ts';
import type { Document, Light } from '../../../scene/schema.ts';
import type { DocumentStore } from '../../../scene/store.ts';
import { t } from '../../language/language.ts';
import { tenths, wrapped } from './frame.ts';
import { type BenchSettings, STEEPEST } from './settings.ts';

type Angles = Pick<BenchSettings, 'thetaL' | 'phiL'>;
type Directional = Extract<Light, { type: 'directional' }>;

/** Where an added light stands, m from its target; its distance changes nothing. */
const DISTANCE = 5;
/** Degrees: closer than this, two directions are the same. */
const SAME = 0.06;

function firstDirectional({ lights }: Document): [string, Directional] | null {
  for (const [id, light] of Object.entries(lights)) if (light.type === 'directional') return [id, light];
  return null;
}

/** null where there is no such light, or it shines from below. */
export function sceneLightAngles(document: Document): Angles | null {
  const light = firstDirectional(document)?.[1];
  if (!light) return null;
  const to = light.position.map((value, i) => value - (light.target[i] as number));
  const [x = 0, y = 0, z = 0] = to;
  const length = Math.hypot(x, y, z);
  if (length === 0 || y <= 0) return null;
  const thetaL = Math.min(STEEPEST, tenths((Math.acos(y / length) * 180) / Math.PI));
  return { thetaL, phiL: wrapped(tenths((Math.atan2(-z, x) * 180) / Math.PI)) };
}

/** Adds a light if there is none that could stand there. */
export function placeSceneLight(store: DocumentStore, { thetaL, phiL }: Angles, merge?: string): void {
  const [x, z, y] = direction(Math.cos(radians(thetaL)), radians(phiL));
  const to: Vec3 = [x, y, -z];
  const found = firstDirectional(store.document);
  if (!found) {
    addLight(store, 'directional', {
      position: to.map((value) => DISTANCE * value) as never,
      target: [0, 0, 0],
    });
    return;
  }
  const [id, { name, position, target }] = found;
  const distance = Math.hypot(...position.map((value, i) => value - (target[i] as number))) || DISTANCE;
  store.edit(
    t('Turn {name}', { name }),
    (draft) => {
      const light = draft.lights[id];
      if (light?.type === 'directional')
        light.position = target.map((value, i) => value + distance * (to[i as 0] as number)) as never;
    },
    merge === undefined ? {} : { merge },
  );
}

/** Whether both are the same direction, up to the rounding of the angles. */
export function sameAngles(a: Angles, b: Angles): boolean {
  const apart = Math.abs(wrapped(a.phiL - b.phiL + 180) - 180);
  return Math.abs(a.thetaL - b.thetaL) < SAME && (apart < SAME || a.thetaL < SAME);
}
