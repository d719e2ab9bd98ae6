/** An environment that ships is loaded when it is chosen: where that takes a while, the page says so. */
import type { EnvironmentPreset } from '../../scene/presets.ts';
import { t } from '../language/language.ts';
import { choiceLabel } from '../panels/inspector/field.ts';
import { type Progress, startProgress } from '../ui/toast.ts';

/** What comes sooner needs no words, ms. */
const PATIENCE_MS = 300;

export function showComing(name: EnvironmentPreset, coming: Promise<unknown>): void {
  let progress: Progress | null = null;
  const timer = window.setTimeout(() => {
    const text = t('Loading the environment {name}', { name: choiceLabel(name) });
    progress = startProgress(text);
    progress.update(text, null);
  }, PATIENCE_MS);
  const end = () => {
    clearTimeout(timer);
    progress?.done();
  };
  coming.then(end, end);
}
