/** The light from all around: what it is, and the fields that this kind of it has. */
import {
  EARTHLY,
  exposeForSky,
  newSky,
  setEarthlySky,
  setEnvironmentSource,
  setSunPositionType,
  setSunToNow,
} from '../../../scene/environment-commands.ts';
import {
  environmentDefaults,
  environmentShape,
  environmentSourceShapes,
  type SunPosition,
  skyDefaults,
  studioDefaults,
  sunPositionDefaults,
  sunPositionShapes,
} from '../../../scene/environment-schema.ts';
import { type EnvironmentPreset, environmentPresets } from '../../../scene/presets.ts';
import type { EnvironmentSource } from '../../../scene/schema.ts';
import { sunAngles } from '../../../scene/sky/sun.ts';
import { studioOf } from '../../../scene/studio-arrangements.ts';
import { attempt } from '../../commands.ts';
import { ENVIRONMENT_ACCEPT, isEnvironmentAsset } from '../../io/files.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField, switchField } from '../../ui/fields.ts';
import { icon } from '../../ui/icons.ts';
import { toastError } from '../../ui/toast.ts';
import { type AlongWith, tryEdit } from './cell.ts';
import { type Bound, choiceLabel } from './field.ts';

/** Rows of the fields of a part of the document. */
export type Part = (
  name: string,
  shape: Readonly<Record<string, unknown>>,
  defaults?: object,
  skip?: string[],
  along?: AlongWith,
) => HTMLElement[];

/** What of the document decides which rows there are. */
export function environmentStructure({ source }: { source: EnvironmentSource }): string {
  return source.type === 'sky' ? `sky ${source.sun.type}` : source.type;
}

export function environmentRows(session: Session, part: Part): { rows: HTMLElement[]; bound: Bound[] } {
  const { source } = session.store.document.environment;
  const choice = environmentChoice(session);
  const own =
    source.type === 'sky'
      ? [...skyRows(session, source.sun.type)]
      : source.type === 'studio'
        ? [studioRows(session)]
        : [];
  return {
    rows: [
      choice.element,
      ...part('environment.source', environmentSourceShapes[source.type], defaultsOf(source), ['name'], {
        brightness: exposeForSky,
      }),
      ...own.map(({ element }) => element),
      ...(source.type === 'sky'
        ? part(
            'environment.source.sun',
            sunPositionShapes[source.sun.type],
            sunPositionDefaults[source.sun.type],
          )
        : []),
      ...(source.type === 'none' ? [] : part('environment', environmentShape, environmentDefaults)),
    ],
    bound: [choice, ...own],
  };
}

const defaultsOf = ({ type }: EnvironmentSource): object | undefined =>
  type === 'sky' ? skyDefaults : type === 'studio' ? studioDefaults : undefined;

function* skyRows(session: Session, type: SunPosition['type']): Iterable<Bound> {
  yield earthlyRow(session);
  yield sunTypeRow(session);
  if (type !== 'place') return;
  yield dateRow(session);
  yield placedSunRow(session);
}

/** Whether the sky is as bright as it is, at one click. */
function earthlyRow({ store }: Session): Bound {
  const field = switchField(t('As bright as on Earth'), (value) =>
    attempt(t('The sky stays as it is'), () => setEarthlySky(store, value)),
  );
  const tip = t(
    'The true luminance of sky and sun, which a meter then exposes for; off, the noon sun is as bright as a lamp of 3 lx, and a scene exposed for lamps stays well exposed',
  );
  return {
    element: row({ label: t('As on Earth'), tip }, field.element),
    update() {
      const { source } = store.document.environment;
      field.show(source.type === 'sky' && source.brightness === EARTHLY);
    },
  };
}

function sunTypeRow({ store }: Session): Bound {
  const choices = [
    { value: 'direction', label: t('Direction') },
    { value: 'place', label: t('Place and time') },
  ];
  const field = selectField(t('Sun'), choices, (value) =>
    attempt(t('The sun stays where it is'), () => setSunPositionType(store, value as SunPosition['type'])),
  );
  return {
    element: row({ label: t('Sun'), tip: t('What says where the sun stands') }, field.element),
    update() {
      const { source } = store.document.environment;
      if (source.type === 'sky') field.show(source.sun.type);
    },
  };
}

/** A date, and what the clock says now. */
function dateRow({ store }: Session): Bound {
  const input = h('input', { type: 'date', 'aria-label': t('Date'), required: true });
  input.addEventListener('change', () => {
    const date = input.value;
    if (date === '') return;
    tryEdit(store, t('Change date'), ({ environment: { source } }) => {
      if (source.type === 'sky' && source.sun.type === 'place') source.sun.date = date;
    });
  });
  const now = h(
    'button',
    {
      type: 'button',
      class: 'text-button',
      tip: t('The sun as it stands there at this moment'),
      on: { click: () => attempt(t('The sun stays where it is'), () => setSunToNow(store, new Date())) },
    },
    t('Now'),
  );
  return {
    element: row({ label: t('Date'), tip: t('The day there') }, h('div', { class: 'date-cell' }, input, now)),
    update() {
      const { source } = store.document.environment;
      if (source.type !== 'sky' || source.sun.type !== 'place') return;
      if (document.activeElement !== input) input.value = source.sun.date;
    },
  };
}

/** How dark it is when the sun is so far below the horizon, in degrees (The Nautical Almanac). */
function darkness(depth: number): string {
  if (depth <= 6) return t('civil twilight');
  if (depth <= 12) return t('nautical twilight');
  return depth <= 18 ? t('astronomical twilight') : t('night');
}

/** Below this the sky is black at any exposure, unless it is as bright as on Earth. */
const SEEN = -6;

/** Where the sun then stands. */
function placedSunRow({ store }: Session): Bound {
  const text = h('output', { class: 'placed-sun' });
  return {
    element: row({ label: t('Stands at'), tip: t('Azimuth from north by east, and height') }, text),
    update() {
      const { source } = store.document.environment;
      if (source.type !== 'sky') return;
      const { azimuth, elevation } = sunAngles(source.sun);
      const height = (elevation * 180) / Math.PI;
      if (height >= 0) {
        const values = { azimuth: ((azimuth * 180) / Math.PI).toFixed(1), elevation: height.toFixed(1) };
        text.textContent = t('{azimuth}° around, {elevation}° high', values);
        return;
      }
      const values = { depth: (-height).toFixed(1), phase: darkness(-height) };
      const unseen = height < SEEN && source.brightness < EARTHLY;
      text.textContent = [
        t('{depth}° below the horizon: {phase}.', values),
        unseen && t('Black unless As on Earth is on.'),
      ]
        .filter(Boolean)
        .join(' ');
    },
  };
}

/** What arranges soft boxes comes when it is needed. */
function studioRows(session: Session): Bound {
  const element = h('div');
  let panel: Bound | null = null;
  import('../studio/panel.ts')
    .then(({ studioPanel }) => {
      panel = studioPanel(session);
      element.append(panel.element);
      panel.update();
    })
    .catch((error: unknown) => toastError(t('The studio cannot be shown'), error));
  return { element, update: () => panel?.update() };
}

const OPEN_FILE = 'open';

/** One list of everything that can light the scene from all around. */
function environmentChoice(session: Session): Bound {
  const { store } = session;
  const set = (source: EnvironmentSource) =>
    attempt(t('The environment stays as it is'), () => setEnvironmentSource(store, source));
  const open = async () =>
    session.openFiles(await session.chooseFiles(ENVIRONMENT_ACCEPT), { environment: true });
  const field = selectField(t('Environment'), [], (value) => {
    const [type, name = ''] = value.split(':');
    if (type === OPEN_FILE) {
      update();
      void open();
    } else if (type === 'preset') set({ type, name: name as EnvironmentPreset });
    else if (type === 'hdr') set({ type, asset: name });
    else if (type === 'constant') set({ type, color: [1, 1, 1] });
    else if (type === 'sky') set(newSky());
    else if (type === 'studio') set(studioOf('threePoint'));
    else set({ type: 'none' });
  });
  const update = () => {
    const { document } = store;
    const { source } = document.environment;
    const isShown = (id: string) => source.type === 'hdr' && source.asset === id;
    const files = Object.entries(document.assets).filter(
      ([id, asset]) => isEnvironmentAsset(asset) || isShown(id),
    );
    field.setChoices([
      { value: 'none', label: t('None') },
      { value: 'constant', label: t('Constant') },
      { value: 'sky', label: t('Sky and sun') },
      { value: 'studio', label: t('Soft boxes') },
      ...files.map(([id, asset]) => ({ value: `hdr:${id}`, label: asset.name, group: t('In this scene') })),
      ...environmentPresets.map((name) => ({
        value: `preset:${name}`,
        label: choiceLabel(name),
        group: t('Shipped'),
      })),
      { value: OPEN_FILE, label: t('Open HDR, EXR or image…') },
    ]);
    const name = source.type === 'hdr' ? source.asset : source.type === 'preset' ? source.name : null;
    field.show(name === null ? source.type : `${source.type}:${name}`);
  };
  const pictures = h(
    'button',
    {
      type: 'button',
      class: 'icon-button',
      'aria-haspopup': 'dialog',
      'aria-label': t('Choose an environment by its picture'),
      tip: t('Choose by pictures'),
      on: {
        click: () =>
          import('../environments/picker.ts')
            .then(({ openEnvironmentPicker }) => openEnvironmentPicker(session, pictures))
            .catch((error: unknown) => toastError(t('The pictures cannot be shown'), error)),
      },
    },
    icon('image'),
  );
  return {
    element: row({ label: t('Source'), tip: t('Light from all around'), after: pictures }, field.element),
    update,
  };
}
