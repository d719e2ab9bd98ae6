/** Light from all around, where it comes from, and what is seen behind the scene. */
import { z } from 'zod';
import { choice, color, integer, number, numberOrNull, reference, withDefaults } from './fields.ts';
import { environmentPresets } from './presets.ts';

export const sunPositionShapes = {
  direction: {
    type: z.literal('direction'),
    azimuth: number('Where the sun stands, from north (-z) by east (+x)', {
      range: [-360, 360],
      unit: '°',
      slider: [0, 360],
      step: 0.1,
    }),
    elevation: number('How high the sun stands; below 0 it has set', {
      range: [-90, 90],
      unit: '°',
      slider: [-18, 90],
      step: 0.1,
    }),
  },
  place: {
    type: z.literal('place'),
    latitude: number('North of the equator', { range: [-90, 90], unit: '°', slider: [-90, 90], step: 0.01 }),
    longitude: number('East of Greenwich', {
      range: [-180, 180],
      unit: '°',
      slider: [-180, 180],
      step: 0.01,
    }),
    date: z.iso.date().describe('The day there, as YYYY-MM-DD'),
    time: number('What a clock there shows, in hours since midnight', {
      range: [0, 24],
      unit: 'h',
      slider: [0, 24],
      step: 0.05,
    }),
    utcOffset: number('By how much that clock is ahead of UTC', {
      range: [-14, 14],
      unit: 'h',
      slider: [-12, 14],
      step: 0.25,
    }),
  },
};

export const sunPositionSchema = z
  .discriminatedUnion('type', [
    z.strictObject(sunPositionShapes.direction),
    z.strictObject(sunPositionShapes.place),
  ])
  .describe('Where the sun stands: as given, or at a place and a time');
export type SunPosition = z.output<typeof sunPositionSchema>;

export const softBoxShape = {
  azimuth: number('Where its middle is seen, from north (-z) by east (+x)', {
    range: [-360, 360],
    unit: '°',
    slider: [0, 360],
    step: 1,
  }),
  elevation: number('How high its middle is seen', {
    range: [-90, 90],
    unit: '°',
    slider: [-90, 90],
    step: 1,
  }),
  width: number('The angle that it fills from side to side', {
    range: [0.5, 170],
    unit: '°',
    slider: [1, 120],
    step: 1,
  }),
  height: number('The angle that it fills from its lower to its upper edge', {
    range: [0.5, 170],
    unit: '°',
    slider: [1, 120],
    step: 1,
  }),
  roll: number('By how much it is turned about the line of sight', {
    range: [-180, 180],
    unit: '°',
    slider: [-90, 90],
    step: 1,
  }),
  softness: number('The part of its half that fades towards the edge', { range: [0, 1], step: 0.01 }),
  color: color('Colour of its light, linear Rec. 709'),
  temperature: numberOrNull('Colour as the temperature of a glowing body, times the colour', {
    range: [1667, 25_000],
    unit: 'K',
    slider: [1700, 12_000],
    step: 10,
  }),
  luminance: number('Luminance of its middle', { range: [0, 1e9], unit: 'nt', slider: [0, 50], step: 0.1 }),
};
export const softBoxSchema = z.strictObject(softBoxShape);
export type SoftBox = z.output<typeof softBoxSchema>;

export const softBoxDefaults: Readonly<SoftBox> = {
  azimuth: 0,
  elevation: 45,
  width: 40,
  height: 40,
  roll: 0,
  softness: 0.1,
  color: [1, 1, 1],
  temperature: null,
  luminance: 10,
};
export const MAX_SOFT_BOXES = 64;

const boxList = <S extends z.ZodType>(box: S) =>
  z
    .array(box)
    .max(MAX_SOFT_BOXES)
    .describe(
      'Luminous rectangles so far away that only their angles count; a later one covers those before it',
    );

export const environmentSourceShapes = {
  none: { type: z.literal('none') },
  constant: {
    type: z.literal('constant'),
    color: color('Colour of the light that comes from everywhere, linear Rec. 709'),
  },
  hdr: {
    type: z.literal('hdr'),
    asset: reference('An equirectangular HDR or EXR image', 'assets'),
  },
  preset: {
    type: z.literal('preset'),
    name: choice('An environment that comes with Irradia', environmentPresets),
  },
  sky: {
    type: z.literal('sky'),
    turbidity: number(
      'Optical thickness of air and haze over that of air alone: 1 is air without haze, 2 a clear day, 5 and more a hazy one',
      { range: [1, 20], slider: [1, 10], step: 0.1 },
    ),
    groundColor: color('What the ground beyond the scene reflects, linear Rec. 709'),
    brightness: number(
      'By how much sky and sun are brighter than on Earth, where the noon sun gives 100 000 lx; at -15 white paper in it has about 1 nit',
      { range: [-40, 10], unit: 'EV', slider: [-20, 0], step: 0.1 },
    ),
    sun: sunPositionSchema,
  },
  studio: {
    type: z.literal('studio'),
    dome: number('Luminance of the room around the soft boxes', {
      range: [0, 1e6],
      unit: 'nt',
      slider: [0, 1],
      step: 0.01,
    }),
    domeColor: color('Colour of the room, linear Rec. 709'),
    boxes: boxList(softBoxSchema),
  },
};

type Sources = typeof environmentSourceShapes;
export type EnvironmentSource = {
  [T in keyof Sources]: z.output<z.ZodObject<Sources[T], z.core.$strict>>;
}[keyof Sources];
export type SourceOf<T extends keyof Sources> = Extract<EnvironmentSource, { type: T }>;

export const sunPositionDefaults: { readonly [T in SunPosition['type']]: Extract<SunPosition, { type: T }> } =
  {
    direction: { type: 'direction', azimuth: 220, elevation: 35 },
    place: { type: 'place', latitude: 48.86, longitude: 2.35, date: '2026-06-21', time: 15, utcOffset: 2 },
  };
export const skyDefaults: Readonly<SourceOf<'sky'>> = {
  type: 'sky',
  turbidity: 2,
  groundColor: [0.2, 0.2, 0.2],
  brightness: -15,
  sun: sunPositionDefaults.direction,
};
export const studioDefaults: Readonly<SourceOf<'studio'>> = {
  type: 'studio',
  dome: 0.1,
  domeColor: [1, 1, 1],
  boxes: [],
};

export const environmentSourceSchema = z.discriminatedUnion('type', [
  z.strictObject(environmentSourceShapes.none),
  z.strictObject(environmentSourceShapes.constant),
  z.strictObject(environmentSourceShapes.hdr),
  z.strictObject(environmentSourceShapes.preset),
  z.strictObject(environmentSourceShapes.sky),
  z.strictObject(environmentSourceShapes.studio),
]);

const environmentSourceFileSchema = z.discriminatedUnion('type', [
  z.strictObject(environmentSourceShapes.none),
  z.strictObject(environmentSourceShapes.constant),
  z.strictObject(environmentSourceShapes.hdr),
  z.strictObject(environmentSourceShapes.preset),
  withDefaults(environmentSourceShapes.sky, skyDefaults),
  withDefaults(
    {
      ...environmentSourceShapes.studio,
      boxes: boxList(withDefaults(softBoxShape, softBoxDefaults)),
    },
    studioDefaults,
  ),
]);

export const environmentShape = {
  source: environmentSourceSchema,
  intensity: number('Luminance of a white texel', {
    range: [0, 1e6],
    unit: 'nt',
    slider: [0, 5],
    step: 0.01,
  }),
  rotation: number('Rotation of the environment about the vertical', {
    range: [-360, 360],
    unit: '°',
    slider: [-180, 180],
    step: 1,
  }),
  samples: integer('Directions per pixel from which its light is gathered', {
    range: [1, 1024],
    slider: [1, 128],
  }),
};

export const backgroundShapes = {
  color: { type: z.literal('color'), color: color('Colour behind the scene, linear Rec. 709') },
  environment: {
    type: z.literal('environment'),
    blur: number('How far the environment is out of focus', { range: [0, 1], step: 0.01 }),
  },
  transparent: { type: z.literal('transparent') },
};
export const backgroundSchema = z.discriminatedUnion('type', [
  z.strictObject(backgroundShapes.color),
  z.strictObject(backgroundShapes.environment),
  z.strictObject(backgroundShapes.transparent),
]);

export const environmentSchema = z.strictObject(environmentShape);
export type Environment = z.output<typeof environmentSchema>;
export type Background = z.output<typeof backgroundSchema>;

export const environmentDefaults: Readonly<Environment> = {
  source: { type: 'none' },
  intensity: 1,
  rotation: 0,
  samples: 32,
};
export const backgroundDefault: Readonly<Background> = {
  type: 'color',
  color: [0.02, 0.02, 0.022],
};

export const environmentFileSchema = withDefaults(
  { ...environmentShape, source: environmentSourceFileSchema as typeof environmentSourceSchema },
  environmentDefaults,
);
