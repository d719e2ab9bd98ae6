/**
 * The ground under the objects. It is no surface of the scene: it shows the shadows on it and nothing of itself. A ground
 * that is seen is an object, a plane or a circle, with any material.
 */
import { z } from 'zod';
import { boolean, number, numberOrNull, withDefaults } from './fields.ts';

export const groundShape = {
  shadowCatcher: boolean(
    'Shows the shadows of the objects on a level ground that is itself not seen: the background is darker where they keep light off',
  ),
  height: numberOrNull(
    'How high the ground lies; off, it is where the lowest of the visible objects touches it',
    { range: [-1e6, 1e6], unit: 'm', slider: [-5, 5], step: 0.01 },
  ),
  radius: number('How far it reaches around the middle of the objects; 0 has no end', {
    range: [0, 1e6],
    unit: 'm',
    slider: [0, 20],
    step: 0.1,
  }),
  fade: number('The part of the radius over which the shadows fade towards the rim', {
    range: [0, 1],
    step: 0.01,
  }),
  strength: number('How much of the shadows is shown; 1 is all of them', { range: [0, 1], step: 0.01 }),
};

export const groundSchema = z.strictObject(groundShape);
export type Ground = z.output<typeof groundSchema>;

export const groundDefaults: Readonly<Ground> = {
  shadowCatcher: false,
  height: null,
  radius: 0,
  fade: 0.5,
  strength: 1,
};

export const groundFileSchema = withDefaults(groundShape, groundDefaults);
