/** The light types of a document, their units and their defaults. */
import { z } from 'zod';
import { TEMPERATURE_RANGE } from '../lights/units.ts';
import { boolean, choice, color, number, numberOrNull, text, vector3, withDefaults } from './fields.ts';
import { memberDefaults, memberShape } from './group-schema.ts';

export const nameField = text('Shown in the outliner', 200);

const position = vector3('Where the light is', { range: [-1e6, 1e6], unit: 'm', step: 0.01 });
const target = vector3('The point that the light looks at', {
  range: [-1e6, 1e6],
  unit: 'm',
  step: 0.01,
});
const luminance = number('Radiance of every direction that the light comes from', {
  range: [0, 1e9],
  unit: 'nt',
  slider: [0, 10],
  step: 0.01,
});
const intensity = number('Luminous intensity along the light’s axis', {
  range: [0, 1e9],
  unit: 'cd',
  slider: [0, 50],
  step: 0.01,
});
const falloff = choice(
  'How the light fades with distance: inverse square is physics; linear and constant are not',
  ['inverse-square', 'linear', 'constant'],
);
const range = number('Distance at which the light has faded to nothing; 0 never cuts it off', {
  range: [0, 1e6],
  unit: 'm',
  slider: [0, 50],
  step: 0.01,
});

const castShadow = boolean('Whether things keep its light off what is behind them');
const radius = number(
  'Radius of the lamp: how soft its shadows are. What is lit wholly is lit as from its centre',
  { range: [0, 1e5], unit: 'm', slider: [0, 0.5], step: 0.005 },
);

const common = {
  name: nameField,
  visible: boolean('Whether the light shines'),
  ...memberShape,
  color: color('Colour of the light, linear Rec. 709; its brightness is a field of its own'),
  temperature: numberOrNull('Colour temperature of a black body; multiplies the colour', {
    range: TEMPERATURE_RANGE,
    unit: 'K',
    slider: [1500, 15000],
    step: 10,
  }),
};

/** The fields of each light type, in the order in which the inspector shows them. */
export const lightShapes = {
  ambient: { type: z.literal('ambient'), ...common, luminance },
  hemisphere: {
    type: z.literal('hemisphere'),
    ...common,
    luminance,
    groundColor: color('Colour of the light that comes from below, linear Rec. 709'),
  },
  directional: {
    type: z.literal('directional'),
    ...common,
    illuminance: number('Illuminance of a surface that faces the light', {
      range: [0, 1e9],
      unit: 'lx',
      slider: [0, 20],
      step: 0.01,
    }),
    position,
    target,
    angularDiameter: number(
      'Angle that the light fills in the sky: how soft its shadows are. The sun’s is 0.53°',
      { range: [0, 90], unit: '°', slider: [0, 20], step: 0.01 },
    ),
    castShadow,
  },
  point: { type: z.literal('point'), ...common, intensity, position, falloff, range, radius, castShadow },
  spot: {
    type: z.literal('spot'),
    ...common,
    intensity,
    position,
    target,
    cutoff: number('Angle between the axis and the edge of the cone; no light beyond it', {
      range: [0.1, 90],
      unit: '°',
      slider: [1, 90],
      step: 0.1,
    }),
    exponent: number('s in I = I_max cos^s of the angle to the axis: larger is a tighter beam', {
      range: [0, 1e4],
      slider: [0, 64],
      step: 0.1,
    }),
    penumbra: number('Part of the cone, from the edge inwards, over which the light fades in', {
      range: [0, 1],
      step: 0.01,
    }),
    falloff,
    range,
    radius,
    castShadow,
  },
  rectangle: {
    type: z.literal('rectangle'),
    ...common,
    luminance: number('Luminance of the lit face', {
      range: [0, 1e9],
      unit: 'nt',
      slider: [0, 50],
      step: 0.01,
    }),
    position,
    target,
    width: number('Width of the panel', {
      range: [1e-3, 1e5],
      unit: 'm',
      slider: [0.01, 10],
      step: 0.01,
    }),
    height: number('Height of the panel', {
      range: [1e-3, 1e5],
      unit: 'm',
      slider: [0.01, 10],
      step: 0.01,
    }),
    castShadow,
  },
} as const;

export const lightSchemas = {
  ambient: z.strictObject(lightShapes.ambient),
  hemisphere: z.strictObject(lightShapes.hemisphere),
  directional: z.strictObject(lightShapes.directional),
  point: z.strictObject(lightShapes.point),
  spot: z.strictObject(lightShapes.spot),
  rectangle: z.strictObject(lightShapes.rectangle),
} as const;

export type LightType = keyof typeof lightShapes;
export type LightOf<T extends LightType> = z.output<(typeof lightSchemas)[T]>;
export type Light = { [T in LightType]: LightOf<T> }[LightType];

export const lightTypes = Object.keys(lightShapes) as LightType[];

export const lightSchema = z.discriminatedUnion('type', [
  lightSchemas.ambient,
  lightSchemas.hemisphere,
  lightSchemas.directional,
  lightSchemas.point,
  lightSchemas.spot,
  lightSchemas.rectangle,
]);

const white: [number, number, number] = [1, 1, 1];
const shared = { visible: true, ...memberDefaults, color: white, temperature: null };

/** Mean angle of the sun from the earth, in degrees: 2 asin(695 700 km / 149 597 871 km). */
const SUN_DIAMETER = 0.533;
/** A light bulb, in metres. */
const BULB_RADIUS = 0.03;

/** What a light of each type is when it has just been added, and what a file may leave out. */
export const lightDefaults: { readonly [T in LightType]: Readonly<LightOf<T>> } = {
  ambient: { type: 'ambient', name: 'Ambient light', ...shared, luminance: 0.1 },
  hemisphere: {
    type: 'hemisphere',
    name: 'Hemisphere light',
    ...shared,
    luminance: 0.3,
    groundColor: [0.25, 0.2, 0.15],
  },
  directional: {
    type: 'directional',
    name: 'Directional light',
    ...shared,
    illuminance: 2,
    position: [2, 4, 3],
    target: [0, 0, 0],
    angularDiameter: SUN_DIAMETER,
    castShadow: true,
  },
  point: {
    type: 'point',
    name: 'Point light',
    ...shared,
    intensity: 8,
    position: [0, 3, 2],
    falloff: 'inverse-square',
    range: 0,
    radius: BULB_RADIUS,
    castShadow: true,
  },
  spot: {
    type: 'spot',
    name: 'Spot light',
    ...shared,
    intensity: 40,
    position: [0, 4, 2],
    target: [0, 0, 0],
    cutoff: 30,
    exponent: 1,
    penumbra: 0,
    falloff: 'inverse-square',
    range: 0,
    radius: BULB_RADIUS,
    castShadow: true,
  },
  rectangle: {
    type: 'rectangle',
    name: 'Rectangle light',
    ...shared,
    luminance: 4,
    position: [0, 3, 2],
    target: [0, 0, 0],
    width: 2,
    height: 1,
    castShadow: true,
  },
};

export const lightFileSchema = z.discriminatedUnion('type', [
  withDefaults(lightShapes.ambient, lightDefaults.ambient),
  withDefaults(lightShapes.hemisphere, lightDefaults.hemisphere),
  withDefaults(lightShapes.directional, lightDefaults.directional),
  withDefaults(lightShapes.point, lightDefaults.point),
  withDefaults(lightShapes.spot, lightDefaults.spot),
  withDefaults(lightShapes.rectangle, lightDefaults.rectangle),
]);
