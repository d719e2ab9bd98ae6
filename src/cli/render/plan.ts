/** What a call has to render: its pictures with what their files say of them, but for frames that are there. */

import { exposureFor } from '../../color/exposure.ts';
import { documentHash, type RenderRecord } from '../../pathtracer/record.ts';
import type { Document } from '../../scene/schema.ts';
import { packageVersion } from '../package-root.ts';
import { say } from './messages.ts';
import type { RenderOptions } from './options.ts';
import type { Until } from './passes.ts';
import { type Shot, shotsOf, whyRender } from './shots.ts';

export interface Plan {
  readonly shot: Shot;
  /** What a file says that is whole, but for samples and device, and for what a meter says, which come later. */
  readonly record: RenderRecord;
}

export async function planned(document: Document, options: RenderOptions): Promise<Plan[]> {
  const hash = await documentHash(document);
  const plans = shotsOf(document, options).map((shot) => ({
    shot,
    record: recordOf(document, hash, shot, options),
  }));
  if (options.animation === null) return plans;
  const open = plans.filter(({ shot, record }) => {
    const why = whyRender(shot.path, record, options);
    if (why !== null && why !== 'missing') say(`${shot.path} is rendered anew: ${why}`);
    return why !== null;
  });
  if (open.length < plans.length) say(`${plans.length - open.length} of ${plans.length} frames are there`);
  return open;
}

function recordOf(document: Document, hash: string, shot: Shot, options: RenderOptions): RenderRecord {
  const { name, view } = document;
  const common = {
    version: packageVersion(),
    document: hash,
    camera: JSON.stringify(shot.camera),
    name,
    device: '',
    exposure: exposureFor(view, shot.camera, 0),
    toneMapping: view.toneMapping,
    denoised: options.denoise,
  };
  if (options.renderer === 'realtime') return { ...common, ...ONE_FRAME };
  const { until, first, maxDepth, clamp } = options;
  return {
    ...common,
    renderer: 'pathtracer',
    seed: shot.seed,
    maxDepth,
    clamp,
    strategy: 'mis',
    samples: [],
    until: untilText(until, first),
  };
}

/** The interactive renderer: direct light, with nothing left to chance. */
const ONE_FRAME = {
  renderer: 'realtime',
  seed: 0,
  maxDepth: 1,
  clamp: 0,
  strategy: 'light',
  samples: [{ from: 0, to: 1 }],
  until: 'frame',
} as const;

function untilText(until: Until, first: number): string {
  if (until.kind === 'samples') return `samples ${first}:${first + until.count}`;
  return until.kind === 'time' ? `time ${until.seconds}` : `error ${until.error}, ${until.most} samples`;
}
