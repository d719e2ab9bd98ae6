/** The scene itself: view, camera, fog, environment, background, path tracing. */

import { effectNames, effectShapes, effectsDefaults } from '../../../scene/effects-schema.ts';
import { backgroundDefault, backgroundShapes } from '../../../scene/environment-schema.ts';
import type { Background, Document } from '../../../scene/schema.ts';
import {
  cameraDefaults,
  cameraShape,
  fogDefaults,
  fogShape,
  pathTracingDefaults,
  pathTracingShape,
  viewDefaults,
  viewShape,
} from '../../../scene/stage-schema.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { section } from '../../ui/section.ts';
import { cameraFields } from './camera.ts';
import { type AlongWith, pathCell, tryEdit } from './cell.ts';
import { environmentRows, environmentStructure } from './environment.ts';
import { type Bound, choiceLabel, labelOf, shapeFields, wordsOf } from './field.ts';
import { withGpuTime } from './gpu-time.ts';
import { groundFields } from './ground.ts';
import type { InspectorPanel } from './panel.ts';
import { presetChoice } from './preset.ts';

/** What fog looks like and how it is drawn are in one place. */
const otherEffects = effectNames.filter((name) => name !== 'fog');

export function sceneStructure(document: Document): string {
  const { environment, background, ground } = document;
  return `${environmentStructure(environment)} ${background.type} ${ground.shadowCatcher}`;
}

export function scenePanel(session: Session): InspectorPanel {
  const { store, state } = session;
  const bound: Bound[] = [];
  const part = (
    name: string,
    shape: Readonly<Record<string, unknown>>,
    defaults?: object,
    skip: string[] = [],
    along?: AlongWith,
  ) => {
    const fields = shapeFields(shape, {
      cell: (field, label) =>
        pathCell(
          store,
          [...name.split('.'), field],
          t('Change {label}', { label: label.toLowerCase() }),
          along?.[field],
        ),
      defaults: { ...defaults },
      skip,
    });
    bound.push(...fields);
    return fields.map((field) => field.element);
  };
  const single = (field: Bound) => {
    bound.push(field);
    return field.element;
  };
  const fold = (title: string, ...children: Node[]) =>
    section(
      translate(title),
      state.value.folded.includes(title),
      (folded) => state.fold(title, folded),
      ...children,
    );

  /** The angle is what is kept; photographers know it as the length of a lens before a sensor. */
  const cameraRows = () => {
    const rows = part('camera', pose, cameraDefaults);
    const own = cameraFields(session);
    bound.push(...own);
    const [length, exposure, focus] = [own[0].element, own[1].element, own[2].element];
    const place = (name: string) => rows.findIndex((element) => element.dataset.label === labelOf(name));
    rows.splice(place('focusDistance') + 1, 0, focus);
    rows.splice(place('iso') + 1, 0, exposure);
    rows.splice(place('fov') + 1, 0, length);
    return rows;
  };

  const description = h('p', { class: 'hint scene-description' });
  const environment = environmentRows(session, part);
  bound.push(...environment.bound);
  const background = store.document.background;
  const { near, far, ...pose } = cameraShape;
  return {
    element: h(
      'div',
      {},
      description,
      fold('View', ...part('view', viewShape, viewDefaults)),
      fold('Environment', ...environment.rows),
      fold(
        'Background',
        single(backgroundChoice(session)),
        ...part(
          'background',
          backgroundShapes[background.type],
          background.type === 'color' ? backgroundDefault : { blur: 0 },
        ),
      ),
      fold('Shadows on the ground', ...groundFields(session).map(single)),
      fold('Camera', ...cameraRows()),
      withGpuTime(
        session,
        'fog',
        fold(
          'Fog',
          ...part('fog', fogShape, fogDefaults),
          ...part('effects.fog', effectShapes.fog, effectsDefaults.fog),
        ),
      ),
      fold('Effects', single(presetChoice(session))),
      ...otherEffects.map((name) =>
        withGpuTime(
          session,
          name,
          fold(wordsOf(name), ...part(`effects.${name}`, effectShapes[name], effectsDefaults[name])),
        ),
      ),
      fold('Path tracing', ...part('pathTracing', pathTracingShape, pathTracingDefaults)),
      fold('Near and far', ...part('camera', { near, far }, cameraDefaults)),
    ),
    update() {
      description.textContent = translate(store.document.description);
      description.hidden = store.document.description === '';
      for (const field of bound) field.update();
    },
  };
}

function backgroundChoice({ store }: Session): Bound {
  const choices = Object.keys(backgroundShapes).map((value) => ({ value, label: choiceLabel(value) }));
  const field = selectField(t('Background'), choices, (value) => {
    const next = structuredClone(
      value === 'environment'
        ? { type: value, blur: 0 }
        : value === 'transparent'
          ? { type: value }
          : backgroundDefault,
    ) as Background;
    tryEdit(store, t('Change background'), (draft) => {
      draft.background = next;
    });
  });
  return {
    element: row({ label: t('Shows'), tip: t('What is seen behind the objects') }, field.element),
    update: () => field.show(store.document.background.type),
  };
}
