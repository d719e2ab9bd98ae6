/**
 * A material: the model and its parameters. The rows of parameters are made from the model's own
 * table; no name of a parameter appears here.
 */
import type { Parameter, Rgb } from '../../../brdf/model.ts';
import { setMaterialModel } from '../../../scene/material-commands.ts';
import { materialDefaults, materialShape } from '../../../scene/material-schema.ts';
import { findModel, modelNames, modelOrigin } from '../../../scene/models.ts';
import type { Document } from '../../../scene/schema.ts';
import { attempt, editSource } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { colorField } from '../../ui/color-field.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField, switchField } from '../../ui/fields.ts';
import { section } from '../../ui/section.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { openFit } from '../fit/fit.ts';
import { materialButtons } from '../library/buttons.ts';
import { type Cell, pathCell } from './cell.ts';
import { type Bound, labelOf, shapeFields } from './field.ts';
import { mapRows } from './maps.ts';
import type { InspectorPanel } from './panel.ts';
import { substanceRow } from './substance.ts';
import { textureSlot } from './texture-slot.ts';

/** The panel has to be made anew when this changes. */
export function materialStructure(document: Document, id: string): string {
  const material = document.materials[id];
  if (!material) return '';
  const origin = modelOrigin(document, material.model);
  const size = origin && ('source' in origin ? origin.source : origin.data).length;
  return `${id} ${material.model} ${size ?? ''}`;
}

export function materialPanel(session: Session, id: string): InspectorPanel {
  const { store, state } = session;
  const material = store.document.materials[id];
  const model = material && findModel(store.document, material.model);
  const cellOf = (name: string, label: string) =>
    pathCell(store, ['materials', id, name], t('Change {label}', { label: label.toLowerCase() }));
  const bound: Bound[] = [];
  const scatters = model !== undefined && model.file.declarations.multipleScattering !== null;

  const choice = modelChoice(session, id);
  bound.push(choice);
  const substance = substanceRow(session, id, model?.parameters ?? []);
  const parameters = (model?.parameters ?? []).map((parameter) => parameterRow(session, id, parameter));
  if (substance) parameters.unshift(substance);
  bound.push(...parameters);

  const maps = mapRows(session, id);
  const surface = shapeFields(materialShape, {
    cell: cellOf,
    defaults: materialDefaults,
    skip: ['name', 'model', ...(scatters ? [] : ['multipleScattering'])],
  });
  bound.push(...maps, ...surface);

  const manual = h(
    'div',
    { class: 'model-about' },
    // Its picture comes from the library's part of the page, which loads late.
    h('div', { class: 'model-preview', 'data-preview': id }),
    h('p', { class: 'hint model-title' }, translate(model?.file.title ?? '')),
    h(
      'div',
      { class: 'model-buttons' },
      editSourceButton(session),
      fitButton(session, id),
      ...materialButtons(session),
    ),
  );
  const fold = (title: string, ...children: Node[]) =>
    section(
      translate(title),
      state.value.folded.includes(title),
      (folded) => state.fold(title, folded),
      ...children,
    );
  return {
    element: h(
      'div',
      {},
      fold('Material', choice.element, manual, ...parameters.map((field) => field.element)),
      fold('Maps', ...maps.map((field) => field.element)),
      fold('Emission and transparency', ...surface.map((field) => field.element)),
    ),
    update() {
      for (const field of bound) field.update();
    },
  };
}

function editSourceButton({ store, state }: Session): HTMLElement {
  const button = h(
    'button',
    {
      type: 'button',
      class: 'text-button',
      tip: t('Edit the source of the model; one that ships is copied into the scene first'),
      keys: 'edit.source',
    },
    t('Edit source'),
  );
  button.addEventListener('click', () => editSource(store, state));
  return button;
}

function fitButton(session: Session, id: string): HTMLElement {
  const button = h(
    'button',
    {
      type: 'button',
      class: 'text-button',
      tip: t('Find parameters that reproduce measurements or another material'),
    },
    t('Fit to…'),
  );
  button.addEventListener('click', () => openFit(session, id));
  return button;
}

function modelChoice(session: Session, id: string): Bound {
  const { store } = session;
  const field = selectField(t('Model'), [], (name) => {
    attempt(t('The model stays as it was'), () => setMaterialModel(store, id, name));
  });
  return {
    element: row(
      {
        label: t('Model'),
        tip: t('The BRDF: a shipped one, or a .brdf or measured file dropped on the page'),
      },
      field.element,
    ),
    update() {
      const { document } = store;
      field.setChoices(
        modelNames(document).map((name) => ({
          value: name,
          label: name,
          group: Object.hasOwn(document.models, name) ? t('In this scene') : t('Shipped'),
        })),
      );
      field.show(document.materials[id]?.model ?? '');
    },
  };
}

function parameterRow(session: Session, id: string, parameter: Parameter): Bound {
  const { store } = session;
  const label = labelOf(parameter.name);
  const cell = pathCell(
    store,
    ['materials', id, 'parameters', parameter.name],
    t('Change {label}', { label: label.toLowerCase() }),
  );
  const control = parameterControl(parameter, label, cell);
  const slot = parameter.type === 'bool' ? null : textureSlot(session, id, { parameter });
  const element = row(
    {
      label,
      tip: parameterTip(parameter),
      onReset: () => cell.set(undefined),
      after: slot?.element ?? null,
    },
    control.element,
  );
  element.dataset.parameter = parameter.name;
  return {
    element,
    update() {
      control.update();
      slot?.update();
      element.classList.toggle('changed', cell.get() !== undefined);
    },
  };
}

function parameterControl(parameter: Parameter, label: string, cell: Cell): Bound {
  switch (parameter.type) {
    case 'float': {
      const { min, max } = parameter;
      const field = sliderField({ label, min, max, onChange: (value, gesture) => cell.set(value, gesture) });
      return {
        element: field.element,
        update: () => field.show((cell.get() as number | undefined) ?? parameter.default),
      };
    }
    case 'color': {
      const field = colorField({ label, onChange: (value, gesture) => cell.set([...value], gesture) });
      return {
        element: field.element,
        update: () => field.show((cell.get() as Rgb | undefined) ?? parameter.default),
      };
    }
    case 'bool': {
      const field = switchField(label, (value) => cell.set(value));
      return {
        element: field.element,
        update: () => field.show((cell.get() as boolean | undefined) ?? parameter.default),
      };
    }
  }
}

function parameterTip(parameter: Parameter): string {
  const range =
    parameter.type === 'float' ? t('{min} to {max}', { min: parameter.min, max: parameter.max }) : '';
  const about = [translate(parameter.description), range && t('Range {range}', { range })]
    .filter(Boolean)
    .join('\n');
  const value = Array.isArray(parameter.default) ? parameter.default.join(' ') : String(parameter.default);
  return `${about}${about ? '\n' : ''}${t('Double click: default ({value})', { value })}`;
}
