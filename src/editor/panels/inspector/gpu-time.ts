/** What an effect takes the GPU, in the header of its section, while the status bar shows the GPU's times. */
import type { EffectName } from '../../../scene/effects-schema.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';

export function withGpuTime(
  { gpuTimes }: Session,
  effect: EffectName,
  section: HTMLDetailsElement,
): HTMLDetailsElement {
  const time = h('span', { class: 'gpu-time', tip: t('GPU time of this effect’s own passes in a frame') });
  section.querySelector('summary')?.append(time);
  gpuTimes.label(time, effect);
  return section;
}
