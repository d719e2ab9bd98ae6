/** What the interactive renderer adds to plain shading: a group of fields for each effect. */
import { z } from 'zod';
import { boolean, choice, integer, number, withDefaults } from './fields.ts';

/** The fields of each effect, in the order in which the inspector shows them. */
export const effectShapes = {
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
  antialiasing: { method: 'msaa' },
  depthOfField: { enabled: false, samples: 48 },
  motionBlur: { enabled: false, samples: 16 },
  bloom: { enabled: false, strength: 0.05, radius: 0.6 },
  lens: { enabled: false, dispersion: 0.005, dirt: 0.3, vignette: 1 },
};

export const effectsFileSchema = withDefaults(
  {
    antialiasing: withDefaults(effectShapes.antialiasing, effectsDefaults.antialiasing),
    depthOfField: withDefaults(effectShapes.depthOfField, effectsDefaults.depthOfField),
    motionBlur: withDefaults(effectShapes.motionBlur, effectsDefaults.motionBlur),
    bloom: withDefaults(effectShapes.bloom, effectsDefaults.bloom),
    lens: withDefaults(effectShapes.lens, effectsDefaults.lens),
  },
  effectsDefaults,
);
