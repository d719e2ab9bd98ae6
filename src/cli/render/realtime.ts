/** Pictures by the interactive renderer: one, or the frames of an animation. */
import { toAttributes } from '../../pathtracer/record.ts';
import type { Document } from '../../scene/schema.ts';
import { openFrames } from '../frame.ts';
import { Interruption } from './interruption.ts';
import { say } from './messages.ts';
import type { RenderOptions } from './options.ts';
import { planned } from './plan.ts';
import { saveWhole } from './save.ts';

/** @returns the exit code */
export async function realtime(document: Document, options: RenderOptions): Promise<number> {
  const open = await planned(document, options);
  if (open.length === 0) return 0;
  const frames = await openFrames(document, options);
  const interruption = new Interruption();
  try {
    for (const { shot, record } of open) {
      const { device } = frames;
      const file = await frames.draw(shot, (exposure) => toAttributes({ ...record, device, exposure }));
      saveWhole(shot.path, `-o ${shot.path}`, file);
      if (interruption.signal.aborted) {
        say(`interrupted after ${shot.path}`);
        break;
      }
    }
    return interruption.exitCode;
  } finally {
    interruption.dispose();
    frames.dispose();
  }
}
