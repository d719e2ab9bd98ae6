/** "Fit to...": a small window beside the inspector that fits a material's parameters while one goes on working. */
import { codeSample } from '../../../analysis/fit/code-sample.ts';
import type { Fit } from '../../../analysis/fit/types.ts';
import { findModel } from '../../../scene/models.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { toast, toastError } from '../../ui/toast.ts';
import { ownModel, type Subject } from '../bench/series.ts';
import { applyFit } from './apply.ts';
import { type FitAnswer, type FitJob, SPHERE_SIZE } from './job.ts';
import { fittableModels, likelyTarget, targetsFor } from './targets.ts';

let closeOpen: (() => void) | null = null;

/** @param id the material that becomes the fit */
export function openFit(session: Session, id: string): void {
  closeOpen?.();
  const { store, state } = session;
  const { document: scene } = store;
  const material = scene.materials[id];
  if (!material) return;
  const targets = targetsFor(scene, id, state.value.bench.pins);
  const models = fittableModels(scene);
  let target = likelyTarget(scene, id, targets);
  let model = models.includes(material.model)
    ? material.model
    : (models.find((name) => name === 'principled') ?? models[0] ?? '');
  let worker: Worker | null = null;

  const targetField = selectField(t('Target'), targets, (value) => {
    target = targets.find((one) => one.value === value);
  });
  targetField.show(target?.value ?? '');
  const modelField = selectField(
    t('Model that is fitted'),
    models.map((name) => ({ value: name, label: name })),
    (name) => {
      model = name;
    },
  );
  modelField.show(model);
  const progress = h('progress', { max: 1, value: 0, 'aria-label': t('Fitting'), hidden: true });
  const result = h('div', { class: 'fit-result', role: 'status' });
  const start = h('button', { type: 'button', class: 'text-button primary' }, t('Fit'));
  const close = h('button', { type: 'button', class: 'text-button' }, t('Close'));
  const panel = h(
    'section',
    { class: 'fit-panel', 'aria-label': t('Fit {name}', { name: material.name }) },
    h('h1', {}, t('Fit {name} to…', { name: material.name })),
    row({ label: t('Target'), tip: t('What the material is to look like') }, targetField.element),
    row({ label: t('Model'), tip: t('The model whose parameters are searched') }, modelField.element),
    progress,
    result,
    h('div', { class: 'popup-actions' }, close, start),
  );

  const idle = () => {
    worker?.terminate();
    worker = null;
    progress.hidden = true;
    start.textContent = t('Fit');
    for (const field of [targetField, modelField]) field.element.disabled = false;
  };
  const run = (subject: Subject) => {
    const job: FitJob = {
      target: { model: subject.model, source: subject.source, parameters: subject.parameters },
      model: { model, source: ownModel(store.document, model) },
    };
    worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<FitAnswer>) => {
      if (data.kind === 'progress') progress.value = data.done;
      else {
        idle();
        if (data.kind === 'error') toastError(t('Not fitted'), new Error(data.message));
        else
          attempt(t('The fit was not put into the material'), () => {
            applyFit(session, id, data.fit, subject);
            result.replaceChildren(...resultOf(session, data.fit, data.spheres));
          });
      }
    });
    worker.addEventListener('error', ({ message }) => {
      idle();
      toastError(t('Not fitted'), new Error(message));
    });
    worker.postMessage(job);
    result.replaceChildren();
    progress.value = 0;
    progress.hidden = false;
    start.textContent = t('Cancel');
    for (const field of [targetField, modelField]) field.element.disabled = true;
  };
  start.addEventListener('click', () => {
    if (worker) idle();
    else if (target) run(target.subject);
  });
  const end = () => {
    idle();
    panel.remove();
    closeOpen = null;
  };
  close.addEventListener('click', end);
  panel.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    end();
  });
  closeOpen = end;
  document.body.append(panel);
  start.focus();
}

function resultOf(
  { store }: Session,
  fit: Fit,
  [wanted, found]: readonly [Uint8ClampedArray<ArrayBuffer>, Uint8ClampedArray<ArrayBuffer>],
): Node[] {
  const copy = h(
    'button',
    { type: 'button', class: 'text-button', tip: t('The material as a line of TypeScript for three.js') },
    t('Copy as code'),
  );
  copy.addEventListener('click', async () => {
    const model = findModel(store.document, fit.model);
    if (!model) return;
    try {
      await navigator.clipboard.writeText(
        codeSample(model, fit.parameters, !store.document.models[fit.model]),
      );
      toast('success', t('Copied'));
    } catch (error) {
      toastError(t('Not copied'), error);
    }
  });
  const figure = (x: number) => (x < 0.01 ? t('less than 0.01') : x.toPrecision(2));
  const percent = (x: number) => `${figure(100 * x)} %`;
  return [
    h('div', { class: 'fit-spheres' }, sphere(wanted, t('Target')), sphere(found, fit.model)),
    h(
      'p',
      {
        class: 'fit-figures',
        tip: t('Of lit spheres in Oklab: black and white are 100 apart, 1 can just be seen'),
      },
      t('Pictures differ by {found} (the defaults by {defaults})', {
        found: figure(fit.errors.look),
        defaults: figure(fit.defaults.look),
      }),
    ),
    h(
      'p',
      { class: 'fit-figures', tip: t('Root mean square difference of cube roots, over all directions') },
      t('Cube roots by {found} ({defaults})', {
        found: percent(fit.errors.cubeRoot / fit.size),
        defaults: percent(fit.defaults.cubeRoot / fit.size),
      }),
    ),
    ...(fit.loose.length ? [h('p', { class: 'hint' }, looseText(fit))] : []),
    copy,
  ];
}

function looseText({ loose }: Fit): string {
  const alone = loose.filter((names) => names.length === 1).flat();
  const together = loose.filter((names) => names.length > 1).map((names) => names.join(' with '));
  return [
    ...(alone.length ? [t('No visible effect here: {list}.', { list: alone.join(', ') })] : []),
    ...(together.length ? [t('Determined only together: {list}.', { list: together.join('; ') })] : []),
  ].join(' ');
}

function sphere(pixels: Uint8ClampedArray<ArrayBuffer>, label: string): HTMLElement {
  const canvas = h('canvas', { width: SPHERE_SIZE, height: SPHERE_SIZE, role: 'img', 'aria-label': label });
  canvas.getContext('2d')?.putImageData(new ImageData(pixels, SPHERE_SIZE, SPHERE_SIZE), 0, 0);
  return h('figure', {}, canvas, h('figcaption', {}, label));
}
