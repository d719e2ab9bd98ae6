/** What is said of a path traced picture, and how complete it is. */
import type { PathTracing as Settings } from '../../scene/schema.ts';
import { plural, t, translate } from '../language/language.ts';
import type { Device, Figures, Phase } from './messages.ts';
import type { TracingState } from './path-tracing.ts';

type PictureState = Extract<TracingState, { kind: 'picture' }>;

const PHASES: Readonly<Record<Phase, string>> = {
  packing: t('Packing the scene'),
  compiling: t('Compiling the kernel'),
  tracing: t('First sample'),
};

/** @param denoised samples that the denoised picture was made of, null where the noisy one is shown */
export function describe(state: TracingState, paused: boolean, denoised: number | null): string {
  if (state.kind === 'failed') return translate(state.message);
  if (state.kind === 'idle') return t('Starts when the camera rests');
  if (state.kind === 'starting') {
    if (paused && state.phase === 'tracing') return t('Paused');
    const percent = state.part > 0 ? ` ${Math.round(100 * state.part)} %` : '…';
    return `${PHASES[state.phase]}${percent}`;
  }
  const { figures } = state;
  const how = figures.reached !== null ? t('complete') : paused ? t('paused') : '';
  return [
    samples(figures.samples),
    duration(figures.seconds),
    error(figures.error),
    how,
    denoisedText(state, denoised),
  ]
    .filter((part) => part !== '')
    .join(' · ');
}

function denoisedText({ figures, denoising }: PictureState, denoised: number | null): string {
  if (denoised === figures.samples) return t('denoised');
  if (denoised !== null) return t('denoised at {samples}', { samples: denoised });
  return denoising === null ? '' : t('denoising {percent} %', { percent: Math.round(100 * denoising) });
}

/** How fast it is, and what does it. */
export function describeDevice(state: TracingState, device: Device | null): string {
  if (device === null) return '';
  const by =
    device.note === ''
      ? translate(device.name)
      : t('{device}, as {note}', { device: translate(device.name), note: translate(device.note) });
  return state.kind === 'picture'
    ? t('{speed} by {device}', { speed: speed(state.figures.pathsPerSecond), device: by })
    : by;
}

/** The way to whichever goal is nearer; the error falls with the square root of the samples. Null: not known yet. */
export function fractionOf(state: TracingState, goal: Pick<Settings, 'samples' | 'error'>): number | null {
  if (state.kind === 'idle' || state.kind === 'failed') return 0;
  if (state.kind === 'starting') return state.part > 0 ? 0 : null;
  const { samples: done, error: now, reached } = state.figures;
  if (reached !== null) return 1;
  return Math.min(1, Math.max(done / goal.samples, now > 0 ? (goal.error / now) ** 2 : 1));
}

const samples = (count: number) => plural(count, '1 sample/pixel', '{count} samples/pixel');

function duration(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  return t('{minutes} min {seconds} s', {
    minutes: Math.floor(seconds / 60),
    seconds: Math.floor(seconds % 60),
  });
}

function error(relative: Figures['error']): string {
  if (!Number.isFinite(relative)) return t('error –');
  const percent = 100 * relative;
  return t('error {percent} %', { percent: percent >= 100 ? Math.round(percent) : percent.toPrecision(2) });
}

function speed(pathsPerSecond: number): string {
  return t('{millions} Mpaths/s', { millions: (pathsPerSecond / 1e6).toPrecision(2) });
}
