/** Every effect, in the order in which they work on a frame. */
import type { EffectDefinition } from '../frame/effect.ts';
import { bloom } from './bloom.ts';

export const effects: readonly EffectDefinition[] = [bloom];
