/** Every effect, in the order in which they work on a frame. */
import type { EffectDefinition } from '../frame/effect.ts';
import { ambientOcclusion } from './ambient-occlusion.ts';
import { bloom } from './bloom.ts';
import { depthOfField } from './depth-of-field/index.ts';
import { fog } from './fog/index.ts';
import { fxaa } from './fxaa.ts';
import { lens } from './lens.ts';
import { motionBlur } from './motion-blur.ts';
import { shadows } from './shadows/index.ts';
import { smaa } from './smaa.ts';
import { temporal } from './temporal.ts';
import { tracedLight } from './traced-light/index.ts';

export const effects: readonly EffectDefinition[] = [
  shadows,
  ambientOcclusion,
  tracedLight,
  fog,
  temporal,
  depthOfField,
  motionBlur,
  bloom,
  lens,
  smaa,
  fxaa,
];
