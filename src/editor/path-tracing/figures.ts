/** What is said of a path traced picture, and how complete it is. */
import type { PathTracing as Settings } from '../../scene/schema.ts';
import type { Device, Figures, Phase } from './messages.ts';
import type { TracingState } from './path-tracing.ts';

type PictureState = Extract<TracingState, { kind: 'picture' }>;

const PHASES: Readonly<Record<Phase, string>> = {
  packing: 'Packing the scene',
  compiling: 'Compiling the kernel',
  tracing: 'First sample',
};

/** @param denoised samples that the denoised picture was made of, null where the noisy one is shown */
export function describe(state: TracingState, paused: boolean, denoised: number | null): string {
  if (state.kind === 'failed') return state.message;
  if (state.kind === 'idle') return 'Starts when the camera rests';
  if (state.kind === 'starting') {
    if (paused && state.phase === 'tracing') return 'Paused';
    const percent = state.part > 0 ? ` ${Math.round(100 * state.part)} %` : '…';
    return `${PHASES[state.phase]}${percent}`;
  }
  const { figures } = state;
  const how = figures.reached !== null ? 'complete' : paused ? 'paused' : '';
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
  if (denoised === figures.samples) return 'denoised';
  if (denoised !== null) return `denoised at ${denoised}`;
  return denoising === null ? '' : `denoising ${Math.round(100 * denoising)} %`;
}

/** How fast it is, and what does it. */
export function describeDevice(state: TracingState, device: Device | null): string {
  if (device === null) return '';
  const by = device.note === '' ? device.name : `${device.name}, as ${device.note}`;
  return state.kind === 'picture' ? `${speed(state.figures.pathsPerSecond)} by ${by}` : by;
}

/** The way to whichever goal is nearer; the error falls with the square root of the samples. Null: not known yet. */
export function fractionOf(state: TracingState, goal: Pick<Settings, 'samples' | 'error'>): number | null {
  if (state.kind === 'idle' || state.kind === 'failed') return 0;
  if (state.kind === 'starting') return state.part > 0 ? 0 : null;
  const { samples: done, error: now, reached } = state.figures;
  if (reached !== null) return 1;
  return Math.min(1, Math.max(done / goal.samples, now > 0 ? (goal.error / now) ** 2 : 1));
}

const samples = (count: number) => `${count} sample${count === 1 ? '' : 's'}/pixel`;

function duration(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  return `${Math.floor(seconds / 60)} min ${Math.floor(seconds % 60)} s`;
}

function error(relative: Figures['error']): string {
  if (!Number.isFinite(relative)) return 'error –';
  const percent = 100 * relative;
  return `error ${percent >= 100 ? Math.round(percent) : percent.toPrecision(2)} %`;
}

function speed(pathsPerSecond: number): string {
  return `${(pathsPerSecond / 1e6).toPrecision(2)} Mpaths/s`;
}
