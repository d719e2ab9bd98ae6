/** What a frame takes the GPU, by its own clock: the sum and the parts. Measured only while this is shown. */
import { type GpuTimesBoard, gpuTimeText } from '../../gpu-times.ts';
import { t } from '../../language/language.ts';
import type { EditorStateStore } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { icon } from '../../ui/icons.ts';
import { labelOf } from '../inspector/field.ts';

const TIP = t('GPU time of a frame and of its parts, here and beside the effects of the scene');
const HINT = t(
  'By the GPU’s clock, which browsers may round to 0.1 ms. What an effect adds to the shading of surfaces is in “Scene”.',
);
const NO_CLOCK = t('This browser or GPU has no timestamps: times of the GPU cannot be measured');

export function createGpuTimesPanel(
  state: EditorStateStore,
  board: GpuTimesBoard,
): { button: HTMLElement; element: HTMLElement } {
  const button = h(
    'button',
    { type: 'button', class: 'icon-button', 'aria-label': t('GPU times'), tip: TIP },
    icon('stopwatch'),
  );
  button.addEventListener('click', () => {
    const gpuTimes = !state.value.gpuTimes;
    state.set({ gpuTimes, ...(gpuTimes && { statusOpen: true }) });
  });
  const element = h('dl', { class: 'gpu-times', 'aria-label': t('GPU times'), tip: HINT });

  const update = () => {
    const { gpuTimes: on } = state.value;
    button.classList.toggle('on', on);
    button.setAttribute('aria-pressed', String(on));
    button.disabled = board.available === false;
    button.dataset.tip = board.available === false ? NO_CLOCK : TIP;
    element.hidden = !on;
    if (!on) return;
    const parts = [...board.times];
    const sum = parts.reduce((total, [, milliseconds]) => total + milliseconds, 0);
    const figures = [['GPU', sum] as const, ...parts.map(([name, time]) => [labelOf(name), time] as const)];
    element.replaceChildren(
      ...(parts.length === 0 ? [] : figures).map(([label, milliseconds]) =>
        h('div', { class: 'figure' }, h('dt', {}, label), h('dd', {}, gpuTimeText(milliseconds))),
      ),
    );
  };
  board.subscribe(update);
  state.subscribe((now, before) => {
    if (now.gpuTimes !== before.gpuTimes) update();
  });
  update();
  return { button, element };
}
