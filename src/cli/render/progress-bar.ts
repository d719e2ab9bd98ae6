/** How far a rendering is, on standard error: a line that is overwritten for a person, a line now and then for a log. */
import type { PassesState, Until } from './passes.ts';

const BAR = 20;
/** Seconds between updates; a log has its first one earlier, so that one sees how long it will take. */
const PERIODS = { terminal: 0.1, log: 10, firstOfLog: 1 } as const;

export interface ProgressStream {
  readonly isTTY?: boolean;
  readonly columns?: number;
  write(text: string): unknown;
}

export class ProgressBar {
  readonly #stream: ProgressStream;
  readonly #pixels: number;
  readonly #until: Until;
  /** What is being rendered, before all else. */
  readonly #title: string;
  #shown = 0;
  #drawn = false;

  constructor(pixels: number, until: Until, title = '', stream: ProgressStream = process.stderr) {
    this.#pixels = pixels;
    this.#until = until;
    this.#title = title;
    this.#stream = stream;
  }

  /** What goes on before the first sample. */
  prepare(text: string): void {
    if (this.#stream.isTTY) this.#draw(text);
  }

  update(state: PassesState): void {
    const { isTTY = false } = this.#stream;
    const period = isTTY ? PERIODS.terminal : this.#shown === 0 ? PERIODS.firstOfLog : PERIODS.log;
    if (state.seconds - this.#shown < period) return;
    this.#shown = state.seconds;
    const text = `${this.#title}${Math.floor(100 * state.part)} %, ${this.#figures(state)}`;
    if (!isTTY) {
      this.#stream.write(`${text}\n`);
      return;
    }
    const filled = Math.floor(BAR * state.part);
    this.#draw(`${'█'.repeat(filled)}${'░'.repeat(BAR - filled)} ${text}`);
  }

  /** Takes the line away, and says what was done. */
  end(state: PassesState): void {
    this.clear();
    this.#stream.write(`${this.#title}${this.#figures({ ...state, part: 1 })}\n`);
  }

  clear(): void {
    if (this.#drawn) this.#stream.write('\r\x1b[K');
    this.#drawn = false;
  }

  #draw(text: string): void {
    this.#drawn = true;
    this.#stream.write(`\r\x1b[K${text.slice(0, (this.#stream.columns || 80) - 1)}`);
  }

  #figures({ samples, seconds, part, error }: PassesState): string {
    const asked = this.#until.kind === 'samples' && part < 1 ? ` of ${this.#until.count}` : '';
    const done = Number.isInteger(samples) || samples >= 10 ? Math.floor(samples) : samples.toFixed(1);
    const parts = [`${done}${asked} ${asked === '' && samples === 1 ? 'sample' : 'samples'}`];
    if (seconds > 0) parts.push(`${rate((samples * this.#pixels) / seconds)} Mpaths/s`);
    parts.push(duration(seconds));
    if (part > 0 && part < 1) parts.push(`${duration((seconds * (1 - part)) / part)} left`);
    if (Number.isFinite(error)) parts.push(`error ${error.toPrecision(3)}`);
    return parts.join(', ');
  }
}

/** In millions, three digits. */
const rate = (perSecond: number): string => Number((perSecond / 1e6).toPrecision(3)).toString();

/** '7.4 s', '3:07', '2:03:07' */
export function duration(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(1)} s`;
  const whole = Math.round(seconds);
  const two = (n: number) => String(n).padStart(2, '0');
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return hours > 0 ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
}
