/** Skies and studios in a thread of their own: a sky takes 0.3 s, and is asked for with every step of a slider. */
import type { ComputedSource, EnvironmentMap } from '../../scene/environment-map.ts';
import { Thread } from '../threads/thread.ts';

const thread = new Thread<ComputedSource, EnvironmentMap>(
  () => new Worker(new URL('./environment-worker.ts', import.meta.url), { type: 'module' }),
);

/** For AssetLoader. */
export const computedElsewhere = (source: ComputedSource): Promise<EnvironmentMap> => thread.ask(source);
