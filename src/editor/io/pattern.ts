/** Patterns in a thread of their own: one takes a tenth of a second, and is asked for with every step of a slider. */
import type { PatternImage } from '../../scene/pattern/draw.ts';
import type { Asset } from '../../scene/schema.ts';
import { Thread } from '../threads/thread.ts';
import type { PatternQuestion } from './pattern-worker.ts';

const thread = new Thread<PatternQuestion, PatternImage>(
  () => new Worker(new URL('./pattern-worker.ts', import.meta.url), { type: 'module' }),
);

/** For AssetLoader. */
export const patternElsewhere = (asset: Asset, texture: number | null): Promise<PatternImage> =>
  thread.ask({ asset, texture });
