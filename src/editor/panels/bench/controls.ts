/** The bench's settings beside the plot; those that a view does not have are hidden. */
import { h } from '../../ui/dom.ts';
import { row, selectField, switchField } from '../../ui/fields.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { type BenchSettings, type BenchView, channelChoices } from './settings.ts';

interface Control {
  readonly element: HTMLElement;
  show(settings: BenchSettings): void;
}

export interface Controls {
  readonly element: HTMLElement;
  show(settings: BenchSettings, terms: readonly string[]): void;
}

type NumberKey = 'thetaV' | 'phiV' | 'thetaH' | 'thetaD' | 'brightness' | 'range';
type Change = (patch: Partial<BenchSettings>) => void;

const curves: readonly BenchView[] = ['polar', 'thetaL', 'thetaH', 'thetaD', 'albedo'];
const slices: readonly BenchView[] = ['polar', 'thetaL', 'thetaH', 'thetaD'];

export function createControls(change: Change): Controls {
  const angle = (key: NumberKey, label: string, tip: string, max: number) =>
    slider(change, key, { label, tip, min: 0, max, hardMin: 0, hardMax: max, unit: '°' });
  const term = selectField('Term in the plots', [], (value) => change({ term: value }));
  const channel = selectField(
    'Channel',
    channelChoices.map((value) => ({ value, label: value === 'rgb' ? 'RGB' : capital(value) })),
    (value) => {
      const found = channelChoices.find((choice) => choice === value);
      if (found) change({ channel: found });
    },
  );
  const controls: readonly (Control & { views: readonly BenchView[] | null })[] = [
    {
      ...angle('thetaV', 'θv', 'Angle between the normal and the viewer; drag in the plot', 89),
      views: ['polar', 'thetaL'],
    },
    { ...angle('thetaD', 'θd', 'Half the angle between light and viewer', 89), views: ['thetaH'] },
    { ...angle('thetaH', 'θh', 'Angle between the normal and the half vector', 89), views: ['thetaD'] },
    {
      ...angle('phiV', 'φ', 'Azimuth from the tangent: of the viewer, or of the half vector', 360),
      views: curves,
    },
    {
      element: row({ label: 'Term', tip: 'One function of the model alone' }, term.element),
      show: (s) => term.show(s.term),
      views: null,
    },
    {
      element: row({ label: 'Channel' }, channel.element),
      show: (s) => channel.show(s.channel),
      views: null,
    },
    { ...toggle(change, 'log', 'Log', 'A logarithmic axis of values'), views: curves },
    {
      ...toggle(change, 'cosine', 'Times n·l', 'Multiply by the cosine at the light'),
      views: [...slices, 'image'],
    },
    {
      ...slider(change, 'range', {
        label: 'Range',
        tip: 'Where the axis of values ends; 0 finds it',
        min: 0.1,
        max: 1000,
        hardMin: 0,
        scale: 'log',
      }),
      views: curves,
    },
    {
      ...slider(change, 'brightness', { label: 'Brightness', tip: 'In stops', min: -6, max: 6, unit: 'EV' }),
      views: ['image'],
    },
  ];
  return {
    element: h('div', { class: 'bench-controls' }, ...controls.map((control) => control.element)),
    show(settings, terms) {
      term.setChoices(terms.map((value) => ({ value, label: value === 'BRDF' ? 'Whole model' : value })));
      for (const { element, show, views } of controls) {
        element.hidden = views !== null && !views.includes(settings.view);
        show(settings);
      }
    },
  };
}

interface SliderSettings {
  readonly label: string;
  readonly tip: string;
  readonly min: number;
  readonly max: number;
  readonly hardMin?: number;
  readonly hardMax?: number;
  readonly unit?: string;
  readonly scale?: 'log';
}

function slider(change: Change, key: NumberKey, { tip, ...options }: SliderSettings): Control {
  const field = sliderField({ ...options, onChange: (value) => change({ [key]: value }) });
  const element = row({ label: options.label, tip }, field.element);
  element.dataset.bench = key;
  return { element, show: (settings) => field.show(settings[key]) };
}

function toggle(change: Change, key: 'log' | 'cosine', label: string, tip: string): Control {
  const field = switchField(label, (value) => change({ [key]: value }));
  const element = row({ label, tip }, field.element);
  element.dataset.bench = key;
  return { element, show: (settings) => field.show(settings[key]) };
}

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
