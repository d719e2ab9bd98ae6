/** How far the path traced picture is: samples, time, error, speed; pause and go on; denoise. */

import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import { h } from '../ui/dom.ts';
import { icon, setIcon } from '../ui/icons.ts';
import { describe, describeDevice, fractionOf } from './figures.ts';
import type { PathTracing } from './path-tracing.ts';

const DENOISE_TIP = t(
  'Takes the noise out, and some of what is small or faint with it: when the samples have doubled, when the picture is complete, and at a pause. What is saved and compared is denoised, too; an EXR keeps the noisy radiance in a layer.',
);

export function createProgress({ store, state }: Session, tracing: PathTracing): HTMLElement {
  const text = h('span', { class: 'tracing-text' });
  const device = h('span', { class: 'tracing-device' });
  const bar = h('div', {
    class: 'bar',
    role: 'progressbar',
    'aria-label': t('Path traced picture'),
    'aria-valuemin': 0,
    'aria-valuemax': 100,
  });
  bar.append(h('div', { class: 'bar-fill' }));
  const pause = h('button', { type: 'button', class: 'icon-button' }, icon('pause'));
  pause.addEventListener('click', () => state.set({ tracingPaused: !state.value.tracingPaused }));
  const denoise = h('button', { type: 'button', class: 'tracing-denoise', tip: DENOISE_TIP }, t('Denoise'));
  denoise.addEventListener('click', () => state.set({ denoise: !state.value.denoise }));
  const whole = h(
    'span',
    { class: 'tracing-note', hidden: true },
    t('One term alone is seen only interactively'),
  );
  const element = h(
    'div',
    { class: 'tracing-progress', hidden: true },
    h('div', { class: 'tracing-line' }, text, pause),
    bar,
    h('div', { class: 'tracing-line' }, device, denoise),
    whole,
  );

  const show = () => {
    const { rendering, tracingPaused: paused } = state.value;
    element.hidden = rendering === 'interactive';
    if (element.hidden) return;
    const current = tracing.state;
    const { pathTracing } = store.document;
    text.textContent = describe(current, paused, tracing.denoised);
    text.classList.toggle('error', current.kind === 'failed');
    const fraction = fractionOf(current, pathTracing);
    bar.classList.toggle('unknown', fraction === null && !paused);
    bar.style.setProperty('--fraction', `${100 * (fraction ?? 0)}%`);
    bar.setAttribute('aria-valuenow', String(Math.round(100 * (fraction ?? 0))));
    device.textContent = describeDevice(current, tracing.device);
    whole.hidden = store.document.view.term === null;
    denoise.setAttribute('aria-pressed', String(state.value.denoise));
    pause.setAttribute('aria-label', paused ? t('Go on path tracing') : t('Pause path tracing'));
    pause.dataset.tip = paused ? t('Go on') : t('Pause');
    pause.dataset.keys = 'view.pauseTracing';
    pause.setAttribute('aria-pressed', String(paused));
    setIcon(pause, paused ? 'play' : 'pause');
  };
  tracing.subscribe(show);
  state.subscribe(show);
  store.subscribe(show);
  show();
  return element;
}
