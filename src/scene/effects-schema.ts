/** What the interactive renderer adds to plain shading: a group of fields for each effect. */
import { z } from 'zod';
import { boolean, choice, integer, number, withDefaults } from './fields.ts';

/** Of the two effects that trace rays through the picture. Both trace the same ones: the more demanding settings count. */
const tracingShape = {
  rays: integer('Rays for each pixel and frame; more is smoother while things move', {
    range: [1, 64],
    slider: [1, 16],
  }),
  steps: integer('Places that are looked at along a ray; more finds smaller things', {
    range: [4, 256],
    slider: [8, 64],
  }),
  thickness: number('How far things go on behind what the camera sees of them', {
    range: [0.001, 1e4],
    unit: 'm',
    slider: [0.05, 5],
    step: 0.01,
  }),
  halfResolution: boolean('Traced at half the width and height: a quarter of the cost, slightly softer'),
  denoise: boolean('Frames are gathered over time and neighbours share what they find'),
};

/** The fields of each effect, in the order in which the inspector shows them. */
export const effectShapes = {
  shadows: {
    enabled: boolean('Things keep the light of lamps off what is behind them'),
    resolution: integer(
      'Points along each side of a map of what a lamp sees; more makes fine shadows sharp',
      {
        range: [64, 4096],
        slider: [256, 2048],
      },
    ),
    samples: integer('Points that are looked at for each pixel and lamp; more makes soft shadows smooth', {
      range: [4, 128],
      slider: [8, 64],
    }),
    cascades: integer('Maps of each directional light: the nearest shows the finest shadows', {
      range: [1, 4],
      slider: [1, 4],
    }),
    maxDistance: number('Directional lights’ maps are for what is nearer to the camera than this', {
      range: [0.01, 1e6],
      unit: 'm',
      slider: [5, 500],
      step: 1,
    }),
  },
  ambientOcclusion: {
    enabled: boolean('Light from everywhere is weaker in corners and under things, where it cannot reach'),
    radius: number('What is farther away than this keeps no light off', {
      range: [0.001, 1e4],
      unit: 'm',
      slider: [0.05, 5],
      step: 0.01,
    }),
    thickness: number('How far things go on behind what the camera sees of them', {
      range: [0.001, 1e4],
      unit: 'm',
      slider: [0.05, 5],
      step: 0.01,
    }),
    bounces: boolean('Light that bounces in a corner tints it: bright colours lose less than dark ones'),
    directions: integer('Directions on the screen in which a pixel looks; more is smoother', {
      range: [1, 16],
      slider: [1, 8],
    }),
    steps: integer('Places that a pixel looks at each way; more finds smaller things', {
      range: [1, 64],
      slider: [2, 16],
    }),
    halfResolution: boolean('Computed at half the width and height: a quarter of the cost, slightly softer'),
  },
  contactShadows: {
    enabled: boolean(
      'Short shadows where things touch, found in the picture itself; too fine for shadow maps',
    ),
    length: number('How far towards the light a pixel looks', {
      range: [0.001, 100],
      unit: 'm',
      slider: [0.01, 0.5],
      step: 0.01,
    }),
    thickness: number('How far things go on behind what the camera sees of them', {
      range: [0.001, 100],
      unit: 'm',
      slider: [0.01, 0.5],
      step: 0.01,
    }),
    steps: integer('Places on the way that are looked at; more finds finer things', {
      range: [2, 64],
      slider: [4, 32],
    }),
  },
  reflections: {
    enabled: boolean(
      'Glossy surfaces reflect what the picture shows; where it shows nothing, the environment',
    ),
    ...tracingShape,
  },
  indirectLight: {
    enabled: boolean(
      'Surfaces light each other: light that bounces between what the picture shows, and colours that it takes along',
    ),
    ...tracingShape,
  },
  fog: {
    enabled: boolean('The scene’s fog is seen, and lamps shine through it in shafts'),
    steps: integer('Places in the air that are looked at for each pixel and lamp; more makes shafts smooth', {
      range: [4, 256],
      slider: [8, 64],
    }),
    halfResolution: boolean('Computed at half the width and height: a quarter of the cost, slightly softer'),
  },
  antialiasing: {
    method: choice(
      'Against jagged edges: four samples a pixel (MSAA); frames gathered over time, the best when nothing moves; edges of the finished picture found and smoothed, carefully (SMAA) or quickly (FXAA)',
      ['msaa', 'temporal', 'smaa', 'fxaa', 'none'],
    ),
  },
  depthOfField: {
    enabled: boolean('What is not in focus is blurred, as the camera’s f-number and focus say'),
    samples: integer('How often the aperture is sampled; more is smoother where the blur is wide', {
      range: [8, 128],
      slider: [16, 96],
    }),
  },
  motionBlur: {
    enabled: boolean('What moves is blurred along its way while the camera’s shutter is open'),
    samples: integer('Places along the way that are looked at; more is smoother', {
      range: [4, 64],
      slider: [8, 32],
    }),
  },
  bloom: {
    enabled: boolean('Glow around what is bright, as lenses and eyes make it'),
    strength: number('Part of the light that is spread out; none is added or lost', {
      range: [0, 1],
      slider: [0, 0.3],
      step: 0.005,
    }),
    radius: number('How far the light is spread: 0 is close by, 1 is all over the picture', {
      range: [0, 1],
      step: 0.01,
    }),
  },
  lens: {
    enabled: boolean('Faults of a real lens'),
    dispersion: number('Coloured fringes that grow towards the edges: how far red and blue are apart there', {
      range: [0, 0.1],
      slider: [0, 0.02],
      step: 0.0005,
    }),
    dirt: number('Dust and smears on the glass, seen where bright things glow through them', {
      range: [0, 1],
      step: 0.01,
    }),
    vignette: number('Corners get less light: 1 is the cosine’s fourth power of a simple lens', {
      range: [0, 1],
      step: 0.01,
    }),
  },
} as const;

export const effectSchemas = {
  shadows: z.strictObject(effectShapes.shadows),
  ambientOcclusion: z.strictObject(effectShapes.ambientOcclusion),
  contactShadows: z.strictObject(effectShapes.contactShadows),
  reflections: z.strictObject(effectShapes.reflections),
  indirectLight: z.strictObject(effectShapes.indirectLight),
  fog: z.strictObject(effectShapes.fog),
  antialiasing: z.strictObject(effectShapes.antialiasing),
  depthOfField: z.strictObject(effectShapes.depthOfField),
  motionBlur: z.strictObject(effectShapes.motionBlur),
  bloom: z.strictObject(effectShapes.bloom),
  lens: z.strictObject(effectShapes.lens),
} as const;

export type EffectName = keyof typeof effectShapes;
export const effectNames = Object.keys(effectShapes) as EffectName[];

export const effectsSchema = z.strictObject(effectSchemas);
export type Effects = z.output<typeof effectsSchema>;

export const effectsDefaults: Readonly<Effects> = {
  shadows: { enabled: false, resolution: 1024, samples: 32, cascades: 3, maxDistance: 100 },
  ambientOcclusion: {
    enabled: false,
    radius: 1,
    thickness: 1,
    bounces: true,
    directions: 3,
    steps: 6,
    halfResolution: true,
  },
  contactShadows: { enabled: false, length: 0.1, thickness: 0.1, steps: 12 },
  reflections: { enabled: false, rays: 4, steps: 32, thickness: 0.5, halfResolution: true, denoise: true },
  indirectLight: { enabled: false, rays: 4, steps: 32, thickness: 0.5, halfResolution: true, denoise: true },
  fog: { enabled: true, steps: 24, halfResolution: true },
  antialiasing: { method: 'msaa' },
  depthOfField: { enabled: false, samples: 48 },
  motionBlur: { enabled: false, samples: 16 },
  bloom: { enabled: false, strength: 0.05, radius: 0.6 },
  lens: { enabled: false, dispersion: 0.005, dirt: 0.3, vignette: 1 },
};

export const effectsFileSchema = withDefaults(
  {
    shadows: withDefaults(effectShapes.shadows, effectsDefaults.shadows),
    ambientOcclusion: withDefaults(effectShapes.ambientOcclusion, effectsDefaults.ambientOcclusion),
    contactShadows: withDefaults(effectShapes.contactShadows, effectsDefaults.contactShadows),
    reflections: withDefaults(effectShapes.reflections, effectsDefaults.reflections),
    indirectLight: withDefaults(effectShapes.indirectLight, effectsDefaults.indirectLight),
    fog: withDefaults(effectShapes.fog, effectsDefaults.fog),
    antialiasing: withDefaults(effectShapes.antialiasing, effectsDefaults.antialiasing),
    depthOfField: withDefaults(effectShapes.depthOfField, effectsDefaults.depthOfField),
    motionBlur: withDefaults(effectShapes.motionBlur, effectsDefaults.motionBlur),
    bloom: withDefaults(effectShapes.bloom, effectsDefaults.bloom),
    lens: withDefaults(effectShapes.lens, effectsDefaults.lens),
  },
  effectsDefaults,
);
