/** The verdict on the selected material's model, computed while its tab is in sight; it follows the source. */
import type { Check, Outcome, Property, Verdict, WorstCase } from '../../../analysis/verdict/types.ts';
import type { RealtimeRenderer } from '../../../realtime/renderer.ts';
import { plural, t, translate } from '../../language/language.ts';
import { h } from '../../ui/dom.ts';
import { createHeatMapPanel } from './heat-map.ts';
import type { Subject } from './series.ts';
import { askGpu } from './verdict-gpu.ts';
import type { VerdictAnswer, VerdictJob, VerdictRequest } from './verdict-job.ts';

export interface VerdictPanel {
  readonly element: HTMLElement;
  /** Called whenever the tab is in sight. */
  show(subject: Subject | undefined): void;
}

const OUTCOMES: Readonly<Record<Outcome, string>> = {
  pass: t('Pass'),
  fail: t('Fail'),
  'given up': t('Given up'),
  'not applicable': '–',
};

/** Where the law's own name says too little. */
const NAMES: Partial<Record<Property, string>> = {
  finiteness: t('Finite'),
  positivity: t('Positive'),
  reciprocity: t('Reciprocal'),
  energy: t('Conserves energy'),
  furnace: t('White furnace'),
  lobes: t('Lobes add up'),
  continuity: t('Continuous'),
  gpu: t('GPU = float64'),
};

const nameOf = (property: Property): string =>
  NAMES[property] ?? property.charAt(0).toUpperCase() + property.slice(1);

/** Typing changes the model every few tenths of a second: it is checked when there is a pause. */
const PAUSE = 700;

export interface VerdictActions {
  showCase(worst: WorstCase): void;
  /** What a cell of the map does; it is worth a look beside the map, too. */
  showCell(worst: WorstCase): void;
  /** Null as long as there is no GPU to ask. */
  renderer(): RealtimeRenderer | null;
}

export function createVerdictPanel({ showCase, showCell, renderer }: VerdictActions): VerdictPanel {
  const button = h('button', { type: 'button', class: 'text-button' }, t('Check'));
  const state = h('span', { class: 'verdict-state', role: 'status' });
  const progress = h('progress', {
    class: 'bench-progress',
    max: 1,
    'aria-label': t('Checking'),
    hidden: true,
  });
  const list = h('ul', { class: 'verdict-list' });
  const map = createHeatMapPanel(showCell);
  const element = h(
    'div',
    { class: 'verdict' },
    h('div', { class: 'verdict-head' }, button, state, progress),
    list,
    map.element,
  );
  let asked: VerdictJob | null = null;
  let worker: Worker | null = null;
  let timer = 0;

  const stop = (text: string) => {
    worker?.terminate();
    worker = null;
    clearTimeout(timer);
    progress.hidden = true;
    button.textContent = t('Check');
    state.textContent = text;
  };
  const begin = (job: VerdictJob) => {
    stop(t('Checking {model}', { model: job.model }));
    map.show(null);
    button.textContent = t('Cancel');
    progress.hidden = false;
    progress.value = 0;
    const started = new Worker(new URL('./verdict-worker.ts', import.meta.url), { type: 'module' });
    worker = started;
    const tell = (request: VerdictRequest) => started.postMessage(request);
    started.addEventListener('message', ({ data }: MessageEvent<VerdictAnswer>) => {
      if (data.kind === 'progress') {
        progress.value = data.done;
        state.textContent = `${job.model}: ${nameOf(data.property)}`;
      } else if (data.kind === 'gpu') {
        void askGpu(renderer(), job, data.term, data.points).then(tell);
      } else if (data.kind === 'error') {
        stop(data.message);
      } else {
        stop(summary(data.verdict));
        list.replaceChildren(...data.verdict.checks.map((check) => row(check, showCase)));
        list.classList.remove('old');
        // Where both computed at once, both would be late.
        map.show(job);
      }
    });
    tell(job);
  };
  button.addEventListener('click', () => {
    if (worker) stop(t('Cancelled'));
    else if (asked) begin(asked);
  });

  return {
    element,
    show(subject) {
      button.disabled = !subject;
      if (!subject || (asked?.model === subject.model && asked.source === subject.source)) return;
      const first = asked === null;
      const { model, source } = subject;
      const job = { model, source };
      asked = job;
      list.classList.add('old');
      stop(t('Checking {model}', { model }));
      timer = window.setTimeout(() => begin(job), first ? 0 : PAUSE);
    },
  };
}

function summary({ model, checks, sound }: Verdict): string {
  const failed = checks.filter(({ outcome }) => outcome === 'fail').length;
  if (!sound)
    return plural(
      failed,
      '{model} breaks a law that it does not give up',
      '{model} breaks {count} laws that it does not give up',
      { model },
    );
  const givenUp = checks.filter(({ outcome }) => outcome === 'given up').length;
  return givenUp > 0
    ? t('{model} is sound, but for what it gives up on purpose', { model })
    : t('{model} is sound', { model });
}

function row(check: Check, showCase: (worst: WorstCase) => void): HTMLElement {
  const { property, outcome, figureText, sentence, worst } = check;
  const show =
    worst && outcome !== 'pass'
      ? h(
          'button',
          {
            type: 'button',
            class: 'text-button',
            'aria-label': t('Show the worst case of {property}', { property: nameOf(property) }),
            tip: t('Put its parameters on the material and its directions into the plots'),
          },
          t('Show'),
        )
      : null;
  if (worst) show?.addEventListener('click', () => showCase(worst));
  const item = h(
    'li',
    {},
    h('span', { class: 'verdict-outcome' }, OUTCOMES[outcome]),
    h('span', { class: 'verdict-name' }, nameOf(property)),
    h('span', { class: 'verdict-figure' }, translate(figureText)),
    h('span', { class: 'verdict-sentence' }, translate(sentence)),
    show ?? h('span', {}),
  );
  item.dataset.property = property;
  item.dataset.outcome = outcome;
  return item;
}
