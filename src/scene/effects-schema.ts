/** What the interactive renderer adds to plain shading: a group of fields for each effect. */
import { z } from 'zod';
import { boolean, number, withDefaults } from './fields.ts';

/** The fields of each effect, in the order in which the inspector shows them. */
export const effectShapes = {
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
} as const;

export const effectSchemas = {
  bloom: z.strictObject(effectShapes.bloom),
} as const;

export type EffectName = keyof typeof effectShapes;
export const effectNames = Object.keys(effectShapes) as EffectName[];

export const effectsSchema = z.strictObject(effectSchemas);
export type Effects = z.output<typeof effectsSchema>;

export const effectsDefaults: Readonly<Effects> = {
  bloom: { enabled: false, strength: 0.05, radius: 0.6 },
};

export const effectsFileSchema = withDefaults(
  {
    bloom: withDefaults(effectShapes.bloom, effectsDefaults.bloom),
  },
  effectsDefaults,
);
