/** The sun of a document's sky: a light from far away, and a disc that is seen behind the scene. */

import { environmentScale } from '../environment-map.ts';
import type { Environment, SunPosition } from '../environment-schema.ts';
import { lightDefaults } from '../light-schema.ts';
import type { Document, LightOf } from '../schema.ts';
import {
  BANDS,
  createAtmosphere,
  EARTH_RADIUS,
  EYE_HEIGHT,
  rgbOfBands,
  SUN_ANGULAR_RADIUS,
} from './atmosphere.ts';
import { columnsAlong } from './optical-depth.ts';
import { sunPosition } from './sun-position.ts';

type Rgb = [number, number, number];

/** In radians. */
export function sunAngles(sun: SunPosition): { azimuth: number; elevation: number } {
  const { azimuth, elevation } = sun.type === 'place' ? sunPosition(sun) : sun;
  return { azimuth: (azimuth * Math.PI) / 180, elevation: (elevation * Math.PI) / 180 };
}

/** Illuminance in lx, linear Rec. 709, on what faces the sun; its disc is cut by the horizon where it sets. */
export function sunIlluminance(turbidity: number, elevation: number): Rgb {
  const air = createAtmosphere(turbidity, [0, 0, 0]);
  const radius = EARTH_RADIUS + EYE_HEIGHT;
  const dip = Math.acos(EARTH_RADIUS / radius);
  const weights = new Float64Array(BANDS);
  // Strips of the disc of equal height, each with its own way through the air: low in the sky they differ.
  const strips = 15;
  for (let i = 0; i < strips; i += 1) {
    const y = (2 * (i + 0.5)) / strips - 1;
    const height = elevation + y * SUN_ANGULAR_RADIUS;
    if (height < -dip) continue;
    const share = (4 * Math.sqrt(1 - y * y)) / (Math.PI * strips);
    const [r, h, o] = columnsAlong(radius, Math.sin(height));
    for (let b = 0; b < BANDS; b += 1)
      weights[b] =
        weights[b]! +
        share * Math.exp(-(air.rayleigh[b]! * r + air.hazeExtinction[b]! * h + air.ozone[b]! * o));
  }
  return rgbOfBands(weights).map((value) => Math.max(0, value)) as Rgb;
}

export interface Sun {
  /** A unit vector in the world. */
  readonly direction: Rgb;
  /** In lx, as the document scales it. */
  readonly illuminance: Rgb;
  /** Of the middle of its disc, in nits. */
  readonly luminance: Rgb;
}

/**
 * Limb darkening: luminance falls as this power of the cosine at which a point of the sun is seen, at 610, 550 and 465 nm;
 * D. Hestroffer and C. Magnan, 1998, "Wavelength dependency of the solar limb darkening".
 */
export const LIMB_POWERS = [0.61, 0.55, 0.465].map((micrometres) => -0.023 + 0.292 / micrometres) as Rgb;

const known = new WeakMap<Environment, Sun | null>();

/** Null without a sky; dark once it has set. */
export function sunOf(environment: Environment): Sun | null {
  let sun = known.get(environment);
  if (sun === undefined) {
    sun = findSun(environment);
    known.set(environment, sun);
  }
  return sun;
}

function findSun(environment: Environment): Sun | null {
  const { source, rotation } = environment;
  if (source.type !== 'sky') return null;
  const { azimuth, elevation } = sunAngles(source.sun);
  const scale = environmentScale(environment);
  const illuminance = sunIlluminance(source.turbidity, elevation).map((value) => value * scale) as Rgb;
  // The mean of the disc is that of mu^p, 1 / (1 + p / 2) of its middle.
  const solidAngle = Math.PI * Math.sin(SUN_ANGULAR_RADIUS) ** 2;
  const luminance = illuminance.map((value, c) => (value / solidAngle) * (1 + LIMB_POWERS[c]! / 2)) as Rgb;
  // The environment turns about y, by which azimuths shrink.
  const turned = azimuth - (rotation * Math.PI) / 180;
  const level = Math.cos(elevation);
  const direction: Rgb = [Math.sin(turned) * level, Math.sin(elevation), -Math.cos(turned) * level];
  return { direction, illuminance, luminance };
}

/** The id that the sun has among the lights: none that a document may have. */
export const SUN_ID = '(sun)';

const withSuns = new WeakMap<Environment, { lights: Document['lights']; all: Document['lights'] }>();

/**
 * The document's lights and its sky's sun, also when that has set: one light more or less would be other shaders. The same object
 * for the same lights and environment.
 */
export function lightsOf({
  lights,
  environment,
}: Pick<Document, 'lights' | 'environment'>): Document['lights'] {
  const before = withSuns.get(environment);
  if (before?.lights === lights) return before.all;
  const sun = sunOf(environment);
  const all = sun === null ? lights : { ...lights, [SUN_ID]: lightOfSun(sun) };
  withSuns.set(environment, { lights, all });
  return all;
}

function lightOfSun({ direction, illuminance }: Sun): LightOf<'directional'> {
  const most = Math.max(...illuminance);
  return {
    ...lightDefaults.directional,
    name: 'Sun',
    color: most > 0 ? (illuminance.map((value) => value / most) as Rgb) : [1, 1, 1],
    illuminance: most,
    position: direction,
    target: [0, 0, 0],
    angularDiameter: (360 / Math.PI) * SUN_ANGULAR_RADIUS,
    castShadow: true,
  };
}
