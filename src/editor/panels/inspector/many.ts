/** Several things at once: the fields that all of them have. What is changed is changed in all of them. */
import type { Parameter } from '../../../brdf/model.ts';
import { type FieldInfo, fieldInfo } from '../../../scene/fields.ts';
import { geometryShapes } from '../../../scene/geometry-schema.ts';
import { lightShapes } from '../../../scene/light-schema.ts';
import { assignMaterial } from '../../../scene/material-commands.ts';
import { materialShape } from '../../../scene/material-schema.ts';
import { findModel } from '../../../scene/models.ts';
import { type Document, objectShape } from '../../../scene/schema.ts';
import { attempt } from '../../commands.ts';
import { plural, t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { Entity } from '../../state.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { section } from '../../ui/section.ts';
import { type Bound, infoField, labelOf } from './field.ts';
import { type ManyCell, manyCell } from './many-cell.ts';
import { materialPanel, materialStructure } from './material.ts';
import type { InspectorPanel } from './panel.ts';

type Shape = Readonly<Record<string, unknown>>;

/** What all that is selected has in common. */
interface Common {
  readonly shape: Shape;
  /** Where all of them are objects. */
  readonly objects: readonly string[] | null;
  /** Where all objects have it. */
  readonly geometry: Shape | null;
  readonly material: string | null;
  /** Where all materials are of the same model. */
  readonly parameters: readonly Parameter[];
  readonly model: string | null;
}

function commonOf(document: Document, selected: readonly Entity[]): Common {
  const shapes = new Set(selected.map((entity) => shapeOf(document, entity)));
  const objects = selected.every(({ kind }) => kind === 'objects') ? selected.map(({ id }) => id) : null;
  const only = <T>(values: readonly T[]): T | null => {
    const [first] = values;
    return first !== undefined && new Set(values).size === 1 ? first : null;
  };
  const geometry = objects && only(objects.map((id) => document.objects[id]?.geometry.type));
  const models = selected.map(({ kind, id }) =>
    kind === 'materials' ? document.materials[id]?.model : undefined,
  );
  const model = only(models) ?? null;
  return {
    shape: commonShape([...shapes]),
    objects,
    geometry: geometry && geometry !== 'gltf' ? geometryShapes[geometry] : null,
    material: (objects && only(objects.map((id) => document.objects[id]?.material))) ?? null,
    parameters: model === null ? [] : (findModel(document, model)?.parameters ?? []),
    model,
  };
}

function shapeOf(document: Document, { kind, id }: Entity): Shape {
  if (kind === 'objects') return objectShape;
  return kind === 'materials' ? materialShape : lightShapes[document.lights[id]?.type ?? 'point'];
}

/** The fields of the first that all others have, too, of the same kind and unit. */
function commonShape([first, ...others]: readonly Shape[]): Shape {
  const infoOf = (schema: unknown) =>
    schema === undefined ? undefined : fieldInfo(schema as Parameters<typeof fieldInfo>[0]);
  const same = (a: FieldInfo | undefined, b: FieldInfo | undefined) =>
    a !== undefined && a.kind === b?.kind && a.unit === b.unit;
  return Object.fromEntries(
    Object.entries(first ?? {}).filter(([name, schema]) =>
      others.every((other) => same(infoOf(schema), infoOf(other[name]))),
    ),
  );
}

/** The panel has to be made anew when this changes. */
export function manyStructure({ store, state }: Session): string {
  const { document } = store;
  const common = commonOf(document, state.value.selected);
  const material = common.material === null ? '' : materialStructure(document, common.material);
  return `${Object.keys(common.shape)} ${common.objects !== null} ${Object.keys(common.geometry ?? {})} ${common.model} ${material}`;
}

export function manyPanel(session: Session): InspectorPanel {
  const { store, state } = session;
  const common = commonOf(store.document, state.value.selected);
  const bound: Bound[] = [];
  const fields = (shape: Shape, within: readonly string[]): HTMLElement[] => {
    const made: HTMLElement[] = [];
    for (const [name, schema] of Object.entries(shape)) {
      const info = fieldInfo(schema as Parameters<typeof fieldInfo>[0]);
      // What can be switched off has a control of its own, for one thing alone.
      const isSwitched = info?.kind === 'number' && info.nullable;
      if (!info || isSwitched || name === 'name' || name === 'model') continue;
      const field = manyField(session, labelOf(name), [...within, name], info);
      if (!field) continue;
      bound.push(field);
      made.push(field.element);
    }
    return made;
  };
  const fold = (title: string, children: readonly HTMLElement[]) =>
    children.length === 0
      ? null
      : section(
          title,
          state.value.folded.includes(title),
          (folded) => state.fold(title, folded),
          ...children,
        );

  const about = h('p', { class: 'hint many-about' });
  const shared = fields(common.shape, []);
  const choice = common.objects ? materialChoice(session) : null;
  if (choice) {
    bound.push(choice);
    shared.push(choice.element);
  }
  const parameters = common.parameters.flatMap((parameter) => {
    const within = ['parameters', parameter.name];
    const field = manyField(session, labelOf(parameter.name), within, infoOf(parameter), parameter.default);
    if (field) bound.push(field);
    return field ? [field.element] : [];
  });
  const material = common.material === null ? null : materialPanel(session, common.material);
  const element = h(
    'div',
    {},
    about,
    fold(t('All of them'), shared),
    fold(t('Parameters'), parameters),
    fold(t('Geometry'), fields(common.geometry ?? {}, ['geometry'])),
    material?.element,
  );
  return {
    element,
    update() {
      about.textContent = aboutText(session);
      for (const field of bound) field.update();
      material?.update();
    },
  };
}

function aboutText({ store, state }: Session): string {
  const { selected } = state.value;
  const locked = selected.filter(
    ({ kind, id }) => kind !== 'materials' && store.document[kind][id]?.locked,
  ).length;
  const all = t('What is changed here is changed in all {count}.', { count: selected.length });
  return locked === 0
    ? all
    : `${all} ${plural(locked, 'One is locked and is not moved.', '{count} are locked and are not moved.')}`;
}

function manyField(
  session: Session,
  label: string,
  within: readonly string[],
  info: FieldInfo,
  fallback?: unknown,
): Bound | undefined {
  const change = t('Change {label}', { label: label.toLowerCase() });
  const cell = manyCell(session, within, change, fallback);
  const field = infoField(label, info, cell);
  return field && withMixed(field, cell);
}

/** Says beside the label where the values differ. */
function withMixed(field: Bound, cell: Pick<ManyCell, 'isMixed'>): Bound {
  const label = field.element.querySelector<HTMLElement>('.row-label');
  return {
    element: field.element,
    update() {
      field.update();
      const mixed = cell.isMixed();
      field.element.classList.toggle('mixed', mixed);
      if (label) label.dataset.mixed = mixed ? t('mixed') : '';
    },
  };
}

function infoOf(parameter: Parameter): FieldInfo {
  const { description = '' } = parameter as { description?: string };
  if (parameter.type === 'bool') return { kind: 'boolean', description };
  if (parameter.type === 'color') return { kind: 'color', description };
  return { kind: 'number', description, slider: [parameter.min, parameter.max] };
}

function materialChoice(session: Session): Bound {
  const { store, state } = session;
  const ids = () => state.value.selected.map(({ id }) => id);
  const field = selectField(t('Material'), [], (value) => {
    attempt(t('The material stays as it was'), () => assignMaterial(store, ids(), value));
  });
  const bound = {
    element: row({ label: t('Material'), tip: t('Objects may share a material') }, field.element),
    update() {
      const { materials, objects } = store.document;
      field.setChoices(Object.entries(materials).map(([value, { name }]) => ({ value, label: name })));
      field.show(objects[state.value.selection?.id ?? '']?.material ?? '');
    },
  };
  const isMixed = () => new Set(ids().map((id) => store.document.objects[id]?.material)).size > 1;
  return withMixed(bound, { isMixed });
}
