/** Path traced pictures: one, or the frames of an animation. */
import { meterPicture } from '../../color/exposure.ts';
import { denoise } from '../../pathtracer/denoise/denoise.ts';
import { denoiseAlpha } from '../../pathtracer/denoise/denoise-alpha.ts';
import type { RenderRecord } from '../../pathtracer/record.ts';
import type { Document } from '../../scene/schema.ts';
import { CliError } from '../command.ts';
import { Interruption } from './interruption.ts';
import { say } from './messages.ts';
import { checkFilmSize, type RenderOptions } from './options.ts';
import { type PassesResult, renderPasses } from './passes.ts';
import { filmToExr, radianceToPng } from './picture.ts';
import { planned } from './plan.ts';
import { ProgressBar } from './progress-bar.ts';
import { savePicture } from './save.ts';
import type { Shot } from './shots.ts';
import { createMachine, loadScene, type Machine } from './tracer.ts';

/** @returns the exit code */
export async function pathTraced(document: Document, options: RenderOptions): Promise<number> {
  checkFilmSize(options);
  const open = await planned(document, options);
  if (open.length === 0) return 0;

  const interruption = new Interruption();
  const machine = await createMachine(options.device);
  try {
    const bar = new ProgressBar(options.width * options.height, options.until);
    try {
      await loadScene(machine, document, interruption.signal, (part) =>
        bar.prepare(`preparing the scene, ${Math.floor(100 * part)} %`),
      );
    } catch (error) {
      if (!interruption.signal.aborted) throw error;
    } finally {
      bar.clear();
    }
    if (interruption.signal.aborted) say('interrupted: nothing was rendered');
    for (const { shot, record } of open) {
      if (interruption.signal.aborted) break;
      await renderShot(machine, shot, record, options, document, interruption.signal);
    }
    return interruption.exitCode;
  } finally {
    machine.dispose();
    interruption.dispose();
  }
}

async function renderShot(
  { tracer, pathsPerPass, lost }: Machine,
  { path, camera, seed, title }: Shot,
  planned: RenderRecord,
  options: RenderOptions,
  { view, background }: Document,
  signal: AbortSignal,
): Promise<void> {
  const { width, height, maxDepth, clamp, until, first, animation } = options;
  const bar = new ProgressBar(width * height, until, title);
  tracer.start(camera, { width, height, maxDepth, seed, strategy: 'mis', clamp });
  const result = await renderPasses(tracer, {
    first,
    until,
    pixels: width * height,
    pathsPerPass,
    signal,
    lost,
    onProgress: (state) => bar.update(state),
  });
  const { film, numbers, stopped } = result;
  // Half a frame would look like a whole one when the animation goes on.
  const isWorthIt = film !== null && (stopped === null || animation === null);
  if (isWorthIt) {
    const range = { from: first, to: first + numbers };
    // An interruption ends the rendering; its picture is finished as any other.
    const denoised = options.denoise
      ? {
          radiance: await denoise(film, {
            onProgress: (part) => bar.prepare(`${title}denoising, ${Math.floor(100 * part)} %`),
          }),
          alpha: (await denoiseAlpha(film)) ?? film.meanAlpha(),
        }
      : null;
    bar.clear();
    const shown = denoised?.radiance ?? film.mean();
    const metered = view.exposureMode === 'auto' ? meterPicture(shown, width, height) : 0;
    const record = {
      ...planned,
      samples: [range],
      device: tracer.device,
      exposure: planned.exposure + metered,
    };
    const transparent = background.type === 'transparent';
    const file =
      options.format === 'exr'
        ? filmToExr(film, record, options.aovs, denoised, transparent)
        : radianceToPng(
            shown,
            film,
            record,
            view.show === 'luminance',
            transparent ? (denoised?.alpha ?? film.meanAlpha()) : undefined,
          );
    savePicture(path, `-o ${path}`, file);
    bar.end(result);
  }
  bar.clear();
  report(result, path, isWorthIt);
}

/** Says what came of a rendering that did not come to its end. */
function report({ stopped, samples }: PassesResult, path: string, isWritten: boolean): void {
  if (stopped === null) return;
  const what = isWritten
    ? `${path} has what was finished, ${Math.floor(samples)} ${samples === 1 ? 'sample' : 'samples'} of each pixel`
    : `${path} was not finished and not written`;
  if (stopped !== 'signal') throw new CliError(`${stopped.message}; ${what}`, { cause: stopped });
  say(`interrupted: ${what}`);
}
