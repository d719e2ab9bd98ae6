import { MathUtils, Matrix4, Vector3 } from 'three/webgpu';
import { luminance } from '../../color/rec709.ts';
import { temperatureColor } from '../../lights/units.ts';
import type { Light, LightOf } from '../../scene/schema.ts';
import { FALLOFFS, LIGHT_SLOTS, LIGHT_TYPES, NO_TRAIL } from './layout.ts';
import type { LightBounds } from './light-bounds.ts';
import type { Words } from './words.ts';

type Rgb = [number, number, number];

/** A light as six slots of four numbers, and what the tree of lights has to know. */
export interface LightRecord {
  readonly type: number;
  readonly a: number;
  /** 1 for what shines through everything. */
  readonly b: number;
  /** Slots 1 to 5. */
  readonly slots: readonly (readonly number[])[];
  /** Null for lights that are infinitely far away. */
  readonly bounds: LightBounds | null;
}

/** Colour and temperature. */
export function colorOf({ color, temperature }: Light): Rgb {
  const tint = temperature === null ? [1, 1, 1] : temperatureColor(temperature);
  return color.map((component, i) => component * tint[i]!) as Rgb;
}

const scaled = (rgb: Rgb, factor: number): Rgb => rgb.map((component) => component * factor) as Rgb;

/** r^-4 of a lamp's range, within float32; 0 without a range. */
const inverseRange4 = (range: number): number => (range > 0 ? Math.min(range ** -4, 3e38) : 0);

const ALL_DIRECTIONS = { axis: [0, 0, 1], cosNormals: -1, cosEmission: 0 } as const;

/** The edge of a spot without penumbra: as in src/lights/spot-light.ts. */
const STEP_SLOPE = 1e30;

/** Null if the light is dark, or has no direction; the light from everywhere is in the sky. */
export function lightRecord(light: Light): LightRecord | null {
  if (!light.visible || luminance(colorOf(light)) === 0) return null;
  switch (light.type) {
    case 'ambient':
    case 'hemisphere':
      return null;
    case 'directional':
      return light.illuminance > 0 ? directional(light) : null;
    case 'point':
      return light.intensity > 0 ? point(light) : null;
    case 'spot':
      return light.intensity > 0 ? spot(light) : null;
    case 'rectangle':
      return light.luminance > 0 ? rectangle(light) : null;
  }
}

/** The unit vector from a to b; null where they are the same. */
function direction(a: readonly number[], b: readonly number[]): Rgb | null {
  const difference = [0, 1, 2].map((i) => b[i]! - a[i]!) as Rgb;
  const length = Math.hypot(...difference);
  return length > 0 ? scaled(difference, 1 / length) : null;
}

const passesThrough = ({ castShadow }: { castShadow: boolean }): number => Number(!castShadow);

function directional(light: LightOf<'directional'>): LightRecord | null {
  const toLight = direction(light.target, light.position);
  if (toLight === null) return null;
  const irradiance = scaled(colorOf(light), light.illuminance);
  const tangent = Math.tan(MathUtils.degToRad(light.angularDiameter / 2));
  return {
    type: LIGHT_TYPES.directional,
    a: 0,
    b: passesThrough(light),
    slots: [[...irradiance, tangent], toLight],
    bounds: null,
  };
}

function point(light: LightOf<'point'>): LightRecord {
  const intensity = scaled(colorOf(light), light.intensity);
  return {
    type: LIGHT_TYPES.point,
    a: FALLOFFS[light.falloff],
    b: passesThrough(light),
    slots: [
      [...intensity, light.radius],
      [...light.position, inverseRange4(light.range)],
    ],
    bounds: {
      ...ALL_DIRECTIONS,
      box: [...light.position, ...light.position],
      power: Math.PI * luminance(intensity),
      twoSided: false,
    },
  };
}

function spot(light: LightOf<'spot'>): LightRecord | null {
  const axis = direction(light.position, light.target);
  if (axis === null) return null;
  const intensity = scaled(colorOf(light), light.intensity);
  const angle = MathUtils.degToRad(light.cutoff);
  const [outer, inner] = [Math.cos(angle), Math.cos(angle * (1 - light.penumbra))];
  return {
    type: LIGHT_TYPES.spot,
    a: FALLOFFS[light.falloff],
    b: passesThrough(light),
    slots: [
      [...intensity, light.radius],
      [...light.position, inverseRange4(light.range)],
      [...axis, outer],
      [light.exponent, inner > outer ? Math.min(1 / (inner - outer), STEP_SLOPE) : STEP_SLOPE],
    ],
    bounds: {
      box: [...light.position, ...light.position],
      axis,
      cosNormals: 1,
      cosEmission: outer,
      power: Math.PI * luminance(intensity),
      twoSided: false,
    },
  };
}

function rectangle(light: LightOf<'rectangle'>): LightRecord {
  const radiance = scaled(colorOf(light), light.luminance);
  const { position, width, height } = light;
  // As three.js turns lights: their -z axis towards the target.
  const frame = new Matrix4().lookAt(
    new Vector3(...position),
    new Vector3(...light.target),
    new Vector3(0, 1, 0),
  );
  const [x, y, z] = [new Vector3(), new Vector3(), new Vector3()];
  frame.extractBasis(x, y, z);
  const normal = z.negate().toArray();
  const [right, up] = [x.multiplyScalar(width / 2).toArray(), y.multiplyScalar(height / 2).toArray()];
  const reach = [0, 1, 2].map((i) => Math.abs(right[i]!) + Math.abs(up[i]!)) as Rgb;
  return {
    type: LIGHT_TYPES.rectangle,
    a: 0,
    b: passesThrough(light),
    slots: [radiance, position, [...normal, width * height], right, up],
    bounds: {
      box: [
        position[0] - reach[0],
        position[1] - reach[1],
        position[2] - reach[2],
        position[0] + reach[0],
        position[1] + reach[1],
        position[2] + reach[2],
      ],
      axis: normal,
      cosNormals: 1,
      cosEmission: 0,
      power: Math.PI * luminance(radiance) * width * height,
      twoSided: false,
    },
  };
}

/** Writes a light; it is in no tree yet. */
export function writeLight(words: Words, slot: number, { type, a, b, slots }: LightRecord): void {
  words.setUints(slot, type, a, b, NO_TRAIL);
  for (const [i, values] of slots.entries()) words.setFloats(slot + 1 + i, ...values);
}

export const lightSlot = (first: number, light: number): number => first + light * LIGHT_SLOTS;
