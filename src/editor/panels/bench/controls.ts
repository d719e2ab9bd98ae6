/** The bench's settings beside the plots; those that no view in sight has are hidden. */
import { turning } from '../../../analysis/plots/azimuth-slice.ts';
import { substances } from '../../../analysis/substances/table.ts';
import { t, translate } from '../../language/language.ts';
import { termLabel } from '../../language/terms.ts';
import { h } from '../../ui/dom.ts';
import { type Choice, row, selectField, switchField } from '../../ui/fields.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { type BenchSettings, type BenchView, channelChoices, initialSettings, moving } from './settings.ts';
import { type ControlKey, viewInfo } from './views.ts';

interface Control {
  readonly element: HTMLElement;
  show(settings: BenchSettings): void;
}

export interface Controls {
  readonly element: HTMLElement;
  show(
    settings: BenchSettings,
    views: readonly BenchView[],
    terms: readonly string[],
    parameters: readonly string[],
  ): void;
}

export interface ControlActions {
  change(patch: Partial<BenchSettings>): void;
  /** Puts the scene's first directional light where l is. */
  placeLight(): void;
}

type NumberKey = 'thetaV' | 'phiV' | 'thetaL' | 'phiL' | 'thetaH' | 'thetaD' | 'brightness' | 'range';
type BoolKey = 'log' | 'cosine' | 'chroma' | 'squareRoot' | 'doubleTheta';

export function createControls({ change, placeLight }: ControlActions): Controls {
  const angle = (key: NumberKey, label: string, tip: string, max: number) =>
    slider(change, key, { label, tip, min: 0, max, hardMin: 0, hardMax: max, unit: '°' });
  const term = select({
    name: t('Term in the plots'),
    label: t('Term'),
    tip: t('One function of the model alone'),
    shown: (settings) => settings.term,
    onChange: (value) => change({ term: value }),
  });
  const parameter = select({
    name: t('Parameter of the plot'),
    label: t('Parameter'),
    tip: t('What grows to the right'),
    shown: (settings) => settings.parameter,
    onChange: (value) => change({ parameter: value }),
  });
  const substance = select({
    name: t('Substance in the plot'),
    label: t('Substance'),
    tip: t('Its n and k are published measurements'),
    choices: [...substances.values()].map(({ name, title, kind }) => ({
      value: name,
      label: translate(title),
      group: kind === 'conductor' ? t('Conductors') : t('Dielectrics'),
    })),
    shown: (settings) => settings.substance,
    onChange: (value) => change({ substance: value }),
  });
  const channelChoice = (key: 'channel' | 'tint', label: string, tip: string) =>
    select({
      name: label,
      label,
      tip,
      choices: channelChoices.map((value) => ({
        value,
        label: value === 'rgb' ? 'RGB' : translate(capital(value)),
      })),
      shown: (settings) => settings[key],
      onChange(value) {
        const found = channelChoices.find((choice) => choice === value);
        if (found) change({ [key]: found });
      },
    });
  const over = select({
    name: t('What moves'),
    label: t('Over'),
    tip: t('What moves through the plane of incidence; the other one stands still'),
    choices: moving.map((value) => ({ value, label: translate(capital(value)) })),
    shown: (settings) => settings.over,
    onChange(value) {
      const found = moving.find((choice) => choice === value);
      if (found) change({ over: found });
    },
  });
  const turns = select({
    name: t('What turns'),
    label: t('Turns'),
    tip: t('What goes round the normal'),
    choices: turning.map((value) => ({ value, label: value === 'half' ? t('Half vector') : t('Light') })),
    shown: (settings) => settings.turns,
    onChange(value) {
      const found = turning.find((choice) => choice === value);
      if (found) change({ turns: found });
    },
  });

  const controls: Readonly<Record<ControlKey, Control>> = {
    over,
    turns,
    thetaV: angle('thetaV', 'θv', t('Angle between the normal and the viewer; drag v in the plot'), 89),
    phiV: angle('phiV', 'φ', t('Azimuth from the tangent: of the viewer, or of the half vector'), 360),
    thetaL: angle('thetaL', 'θl', t('Angle between the normal and the light; drag l in the plot'), 89),
    phiL: angle('phiL', 'φl', t('Azimuth of the light from the tangent'), 360),
    light: lightControl(change, placeLight),
    thetaD: angle('thetaD', 'θd', t('Half the angle between light and viewer'), 89),
    thetaH: angle('thetaH', 'θh', t('Angle between the normal and the half vector'), 89),
    parameter,
    substance,
    term,
    channel: channelChoice('channel', t('Channel'), t('Of curves and lobes')),
    tint: channelChoice('tint', t('Picture'), t('What pictures show')),
    log: toggle(change, 'log', t('Log'), t('Logarithmic values')),
    cosine: toggle(change, 'cosine', t('Times n·l'), t('Multiply by the cosine at the light')),
    range: slider(change, 'range', {
      label: t('Range|axis'),
      tip: t('Where the axis of values ends; 0 finds it'),
      min: 0.1,
      max: 1000,
      hardMin: 0,
      scale: 'log',
    }),
    brightness: slider(change, 'brightness', {
      label: t('Brightness'),
      tip: t('Of pictures, in stops'),
      min: -6,
      max: 6,
      unit: 'EV',
    }),
    chroma: toggle(change, 'chroma', t('Chroma'), t('The colour alone, as bright as can be')),
    squareRoot: toggle(change, 'squareRoot', '√θh', t('More room for the highlight, which is at small θh')),
    doubleTheta: toggle(
      change,
      'doubleTheta',
      t('Double θl'),
      t('Look down the normal with the light at twice θl: the highlight is then at θl'),
    ),
  };
  const entries = Object.entries(controls) as [ControlKey, Control][];
  return {
    element: h('div', { class: 'bench-controls' }, ...entries.map(([, control]) => control.element)),
    show(settings, views, terms, parameters) {
      const wanted = new Set(views.flatMap((view) => viewInfo[view].controls));
      term.setChoices(
        terms.map((value) => ({ value, label: value === 'BRDF' ? t('Whole model') : termLabel(value) })),
      );
      parameter.setChoices(parameters.map((value) => ({ value, label: value })));
      for (const [key, { element, show }] of entries) {
        element.hidden = !wanted.has(key);
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

type Change = ControlActions['change'];

function slider(change: Change, key: NumberKey, { tip, ...options }: SliderSettings): Control {
  const field = sliderField({ ...options, onChange: (value) => change({ [key]: value }) });
  const onReset = () => change({ [key]: initialSettings[key] });
  const element = row(
    { label: options.label, tip: `${tip}\n${t('Double click: default')}`, onReset },
    field.element,
  );
  element.dataset.bench = key;
  return { element, show: (settings) => field.show(settings[key]) };
}

function toggle(change: Change, key: BoolKey, label: string, tip: string): Control {
  const field = switchField(label, (value) => change({ [key]: value }));
  const element = row({ label, tip }, field.element);
  element.dataset.bench = key;
  return { element, show: (settings) => field.show(settings[key]) };
}

function lightControl(change: Change, placeLight: () => void): Control {
  const label = t('Light');
  const field = switchField(label, (lightInStep) => change({ lightInStep }));
  const place = h(
    'button',
    {
      type: 'button',
      class: 'text-button',
      tip: t("Put the scene's first directional light where l is over a horizontal surface"),
    },
    t('Place'),
  );
  place.addEventListener('click', placeLight);
  const element = row(
    {
      label,
      tip: t(
        'Keep l and the first directional light of the scene in step; Alt and a drag over the viewport turn both',
      ),
    },
    h('div', { class: 'bench-light' }, field.element, place),
  );
  element.dataset.bench = 'light';
  return { element, show: (settings) => field.show(settings.lightInStep) };
}

interface SelectControl extends Control {
  setChoices(choices: readonly Choice[]): void;
}

interface SelectSettings {
  readonly name: string;
  readonly label: string;
  readonly tip?: string;
  readonly choices?: readonly Choice[];
  shown(settings: BenchSettings): string;
  onChange(value: string): void;
}

function select({ name, label, tip, choices = [], shown, onChange }: SelectSettings): SelectControl {
  const field = selectField(name, choices, onChange);
  return {
    element: row({ label, tip }, field.element),
    setChoices: field.setChoices,
    show: (settings) => field.show(shown(settings)),
  };
}

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
