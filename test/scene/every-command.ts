/** Every command of src/scene, right and wrong, for tests that do whatever a person could do. */
import { copyEntities, pasteEntities } from '../../src/scene/clipboard.ts';
import {
  addLight,
  addObject,
  putAsset,
  removeUnused,
  rename,
  setField,
  setGeometryType,
  setLightType,
} from '../../src/scene/commands.ts';
import { applyPreset, presetNames } from '../../src/scene/effect-presets.ts';
import type { MemberRef } from '../../src/scene/entity.ts';
import {
  addSoftBox,
  changeSoftBox,
  newSky,
  removeSoftBox,
  setEarthlySky,
  setEnvironmentSource,
  setSunPositionType,
  setSunToNow,
} from '../../src/scene/environment-commands.ts';
import { type EnvironmentSource, studioDefaults } from '../../src/scene/environment-schema.ts';
import { DocumentError } from '../../src/scene/error.ts';
import { addableGeometries } from '../../src/scene/geometry-schema.ts';
import { setShadowCatcher } from '../../src/scene/ground-commands.ts';
import { groupEntities, moveMaterials, moveToGroup, shift, ungroup } from '../../src/scene/group-commands.ts';
import { giveMaterial, putMaterialOnce, setLook, setValues } from '../../src/scene/library-commands.ts';
import { lightTypes } from '../../src/scene/light-schema.ts';
import {
  addMaterial,
  addModel,
  assignMaterial,
  giveOwnMaterials,
  removeModel,
  setMaterialModel,
  setParameter,
  setParameters,
  setTexture,
} from '../../src/scene/material-commands.ts';
import { materialMaps, textureRef } from '../../src/scene/material-schema.ts';
import { measuredAsset } from '../../src/scene/measured.ts';
import { addMeasuredModel } from '../../src/scene/measured-commands.ts';
import { findModel, modelNames } from '../../src/scene/models.ts';
import { isPattern, patternNames } from '../../src/scene/pattern/asset.ts';
import { defaultPattern } from '../../src/scene/pattern/pattern.ts';
import { givePattern, setPattern } from '../../src/scene/pattern-commands.ts';
import type { Document } from '../../src/scene/schema.ts';
import {
  duplicateEntities,
  removeEntities,
  setLocked,
  setVisible,
} from '../../src/scene/selection-commands.ts';
import type { DocumentStore } from '../../src/scene/store.ts';
import { place } from '../../src/scene/transform-commands.ts';
import { assetsOf } from '../../src/scene/validate.ts';
import { writeRgl } from '../io/rgl-writer.ts';

/** The text of a model. */
export const flat = `analytic
# Flat: the same in every direction.
::begin parameters
float level 0 1 .5
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(level); }
::end shader
`;

/** What a person could do next, chosen by numbers; what does not apply to the document is skipped. */
export type SceneCommand = (store: DocumentStore, pick: <T>(from: readonly T[]) => T | undefined) => void;

const onOne =
  (
    collection: 'lights' | 'objects' | 'materials',
    action: (store: DocumentStore, id: string) => void,
  ): SceneCommand =>
  (target, pick) => {
    const id = pick(Object.keys(target.document[collection]));
    if (id !== undefined) action(target, id);
  };

const kinds = ['lights', 'objects', 'materials'] as const;

const PICTURES = ['AAAA', 'AQID', 'BBBB'];

const parametersOf = (target: DocumentStore, id: string) =>
  findModel(target.document, target.document.materials[id]?.model ?? '')?.parameters ?? [];

/** Values of the fields of a document, found by their paths; what is a name of something else is left to commands. */
function leaves(value: unknown, path: readonly (string | number)[] = []): (readonly (string | number)[])[] {
  if (typeof value === 'number' || typeof value === 'boolean') return [path];
  if (typeof value !== 'object' || value === null) return [];
  return Object.entries(value).flatMap(([key, inside]) =>
    leaves(inside, [...path, Array.isArray(value) ? Number(key) : key]),
  );
}

/** Sections of the document whose fields the inspector sets one by one. */
const FIELDS = ['camera', 'fog', 'environment', 'background', 'ground', 'view', 'lights', 'objects'] as const;

/** Numbers become others near them, switches their opposites; what is out of bounds is refused. */
const changeField: SceneCommand = (target, pick) => {
  const section = pick(FIELDS) ?? 'view';
  const path = pick(leaves(target.document[section], [section]));
  if (!path) return;
  const value = path.reduce<unknown>(
    (holder, key) => (holder as Record<string | number, unknown>)[key],
    target.document,
  );
  const factor = pick([0.5, 1.25, 0]) ?? 1;
  setField(target, path, typeof value === 'boolean' ? !value : (value as number) * factor + 0.25);
};

const SOURCES: readonly EnvironmentSource[] = [
  { type: 'none' },
  { type: 'constant', color: [0.5, 0.25, 0] },
  structuredClone(studioDefaults) as EnvironmentSource,
  newSky(),
  {
    ...newSky(),
    sun: { type: 'place', latitude: 60, longitude: 5, date: '2026-03-01', time: 9, utcOffset: 1 },
  } as EnvironmentSource,
];

/** The light from all around is what the command is about: first there has to be such a one. */
const onSource = (
  type: 'sky' | 'studio',
  action: (store: DocumentStore, pick: Parameters<SceneCommand>[1]) => void,
): SceneCommand => {
  const source = SOURCES.find((one) => one.type === type) as EnvironmentSource;
  return (target, pick) => {
    if (target.document.environment.source.type === type) action(target, pick);
    else setEnvironmentSource(target, source);
  };
};

const boxesIn = ({ environment: { source } }: Document) =>
  source.type === 'studio' ? source.boxes.map((_, i) => i) : [];

/** A measured model of few values. */
const MEASUREMENTS = measuredAsset(
  writeRgl(() => [0.25, 0.5, 0.75], { thetas: 3, resolution: 4 }),
  'few.bsdf',
);

const steel = { name: 'Steel', model: 'principled', parameters: { metallic: 1, roughness: 0.3 } };

/**
 * Every command of src/scene, by its name: soak.test.ts fails if one is missing. Those that are mostly refused, or of which a
 * person does many, are here more than once.
 */
export const commands: Readonly<Record<string, readonly SceneCommand[]>> = {
  addLight: [(target, pick) => void addLight(target, pick(lightTypes) ?? 'point')],
  addObject: [(target, pick) => void addObject(target, pick(addableGeometries) ?? 'box')],
  addMaterial: [(target, pick) => void addMaterial(target, pick(modelNames(target.document)))],
  addModel: [(target) => void addModel(target, 'flat.brdf', flat)],
  addMeasuredModel: [(target) => void addMeasuredModel(target, MEASUREMENTS)],
  removeModel: [
    (target, pick) => {
      const used = new Set(Object.values(target.document.materials).map(({ model }) => model));
      const name = pick(Object.keys(target.document.models).filter((model) => !used.has(model)));
      if (name !== undefined) removeModel(target, name);
      else void addModel(target, 'flat.brdf', flat);
    },
  ],
  removeEntities: [
    ...kinds.map((kind) => onOne(kind, (target, id) => removeEntities(target, [{ kind, id }]))),
    (target, pick) =>
      removeEntities(target, [], Object.keys(target.document.groups).slice(0, pick([0, 1]) ?? 0)),
  ],
  removeUnused: [(target) => removeUnused(target)],
  setTexture: [
    (target, pick) =>
      target.edit('Add picture', (draft) => {
        putAsset(draft, 'dots.png', 'image/png', pick(PICTURES) ?? '');
      }),
    (target, pick) =>
      onOne('materials', (t, id) => {
        const [parameter, asset] = [pick(parametersOf(t, id)), pick(Object.keys(t.document.assets))];
        if (parameter && asset) setTexture(t, id, parameter.name, textureRef(asset));
      })(target, pick),
    (target, pick) =>
      onOne('materials', (t, id) => {
        const name = pick(Object.keys(t.document.materials[id]?.textures ?? {}));
        if (name) setTexture(t, id, name, null);
      })(target, pick),
  ],
  setParameter: [
    (target, pick) =>
      onOne('materials', (t, id) => {
        const parameter = pick(parametersOf(t, id));
        const value = pick([0.25, -0, 1e-7, 3]) ?? 0;
        const values = { float: value, color: [value, 1, 0.5], bool: value > 0.5 } as const;
        if (parameter) setParameter(t, id, parameter.name, values[parameter.type]);
      })(target, pick),
    (target, pick) =>
      onOne('materials', (t, id) => {
        const name = pick(Object.keys(t.document.materials[id]?.parameters ?? {}));
        if (name) setParameter(t, id, name, null);
      })(target, pick),
  ],
  setParameters: [
    (target, pick) =>
      onOne('materials', (t, id) => {
        const floats = parametersOf(t, id).filter(({ type }) => type === 'float');
        const value = pick([0.125, 0.75]) ?? 0;
        setParameters(
          t,
          id,
          'Two of them',
          Object.fromEntries(floats.slice(0, 2).map(({ name }) => [name, value])),
        );
      })(target, pick),
  ],
  setField: [
    changeField,
    changeField,
    (target, pick) =>
      onOne('materials', (t, id) => setField(t, ['materials', id, pick(materialMaps) ?? 'normalMap'], null))(
        target,
        pick,
      ),
    onOne('objects', (target, id) => setField(target, ['objects', id, 'position', 1], 2)),
  ],
  rename: [
    onOne('objects', (target, id) => rename(target, 'objects', id, 'Renamed')),
    (target, pick) => {
      const [id] = some(Object.keys(target.document.groups), pick);
      if (id !== undefined) rename(target, 'groups', id, 'Renamed');
    },
  ],
  setGeometryType: [
    (target, pick) =>
      onOne('objects', (t, id) => setGeometryType(t, id, pick(addableGeometries) ?? 'box'))(target, pick),
  ],
  setLightType: [
    (target, pick) =>
      onOne('lights', (t, id) => setLightType(t, id, pick(lightTypes) ?? 'spot'))(target, pick),
  ],
  setMaterialModel: [
    (target, pick) =>
      onOne('materials', (t, id) => setMaterialModel(t, id, pick(modelNames(t.document)) ?? 'lambert'))(
        target,
        pick,
      ),
  ],
  assignMaterial: [
    (target, pick) =>
      onOne('materials', (t, id) => {
        const objects = pick(Object.keys(t.document.objects));
        if (objects !== undefined) assignMaterial(t, [objects], id);
      })(target, pick),
  ],
  giveOwnMaterials: [
    (target, pick) => void giveOwnMaterials(target, some(Object.keys(target.document.objects), pick)),
  ],
  giveMaterial: [
    (target, pick) =>
      void giveMaterial(target, 'Steel', some(Object.keys(target.document.objects), pick), {
        put: (draft) => putMaterialOnce(draft, steel),
        isTry: ({ name }) => name.startsWith('Steel'),
      }),
  ],
  givePattern: [
    (target, pick) =>
      onOne('materials', (t, id) => {
        const parameter = pick(parametersOf(t, id));
        const place =
          pick([true, false]) || !parameter ? { map: 'normalMap' as const } : { parameter: parameter.name };
        if (parameter?.type !== 'bool') givePattern(t, id, place, pick(patternNames) ?? 'wood', 'Pattern');
      })(target, pick),
  ],
  setPattern: [
    (target, pick) => {
      const id = pick(Object.keys(target.document.materials));
      const material = target.document.materials[id ?? ''];
      const asset =
        material && assetsOf(material).find(([, each]) => isPattern(target.document.assets[each]))?.[1];
      if (id === undefined || asset === undefined) return;
      setPattern(
        target,
        id,
        asset,
        { ...defaultPattern('granite'), size: 16, seed: pick([1, 2, 3]) ?? 1 },
        'Pattern',
      );
    },
  ],
  setLook: [
    onOne('materials', (target, id) =>
      setLook(target, [id], 'Steel', { ...steel, multipleScattering: true }),
    ),
  ],
  setValues: [onOne('materials', (target, id) => setValues(target, id, 'As they came', {}))],
  setVisible: [
    (target, pick) => setVisible(target, some(membersIn(target), pick), pick([true, false]) ?? true),
  ],
  setLocked: [
    (target, pick) => setLocked(target, some(membersIn(target), pick), pick([true, false, false]) ?? false),
  ],
  groupEntities: [
    (target, pick) => {
      const members = some(membersIn(target), pick);
      if (members.length > 0) groupEntities(target, members);
    },
  ],
  ungroup: [(target, pick) => ungroup(target, some(membersIn(target), pick))],
  moveToGroup: [
    (target, pick) => {
      const groups = Object.keys(target.document.groups);
      const into = pick([...groups, null]) ?? null;
      moveToGroup(target, some(membersIn(target), pick), [], into);
    },
    (target, pick) => {
      const beside = pick(membersIn(target));
      const group = beside && (target.document[beside.kind][beside.id]?.group ?? null);
      if (beside && group !== undefined)
        moveToGroup(target, some(membersIn(target), pick), [], group, { ...beside, side: 'before' });
    },
  ],
  moveMaterials: [
    (target, pick) => {
      const ids = Object.keys(target.document.materials);
      const beside = pick(ids);
      if (beside !== undefined)
        moveMaterials(target, some(ids, pick), { kind: 'materials', id: beside, side: 'after' });
    },
  ],
  shift: [
    (target, pick) => {
      const members = some(membersIn(target), pick);
      if (members.length > 0) shift(target, members, pick([-1, 1]) ?? 1);
    },
  ],
  duplicateEntities: [
    ...kinds.map((kind) => onOne(kind, (target, id) => void duplicateEntities(target, [{ kind, id }]))),
    (target, pick) => void duplicateEntities(target, some(membersIn(target), pick)),
  ],
  pasteEntities: [
    (target, pick) => {
      const members = some(membersIn(target), pick);
      if (members.length > 0) pasteEntities(target, copyEntities(target.document, members));
    },
  ],
  place: [
    (target, pick) =>
      place(
        target,
        'Move',
        some(membersIn(target), pick).map((ref) => ({
          ...ref,
          placement: { position: [1, pick([0, 2, -3]) ?? 0, 3], width: pick([0.5, 2]) ?? 1 },
        })),
      ),
  ],
  setShadowCatcher: [(target) => setShadowCatcher(target, !target.document.ground.shadowCatcher)],
  setEnvironmentSource: [(target, pick) => setEnvironmentSource(target, pick(SOURCES) ?? { type: 'none' })],
  setSunPositionType: [
    onSource('sky', (target, pick) => setSunPositionType(target, pick(['direction', 'place']) ?? 'place')),
  ],
  setSunToNow: [
    onSource('sky', (target, pick) => {
      const { source } = target.document.environment;
      if (source.type === 'sky' && source.sun.type === 'direction') setSunPositionType(target, 'place');
      else
        setSunToNow(target, new Date(Date.UTC(2026, pick([0, 5, 8]) ?? 0, 12, pick([6, 12, 17]) ?? 0, 30)));
    }),
  ],
  setEarthlySky: [onSource('sky', (target, pick) => setEarthlySky(target, pick([true, false]) ?? true))],
  addSoftBox: [
    onSource('studio', (target, pick) => void addSoftBox(target, { azimuth: pick([0, 90, 200]) ?? 0 })),
  ],
  changeSoftBox: [
    onSource('studio', (target, pick) => {
      const index = pick(boxesIn(target.document));
      if (index === undefined) void addSoftBox(target);
      else changeSoftBox(target, index, { luminance: pick([1, 20]) ?? 5 }, 'Brighter');
    }),
  ],
  removeSoftBox: [
    onSource('studio', (target, pick) => {
      const index = pick(boxesIn(target.document));
      if (index === undefined) void addSoftBox(target);
      else removeSoftBox(target, index);
    }),
  ],
  applyPreset: [(target, pick) => applyPreset(target, pick(presetNames) ?? 'low')],
};

/** Those that change what is in the scene and the light on it, and no effect, whose noise is another in each frame. */
export const commandsOfScene: readonly SceneCommand[] = Object.entries(commands).flatMap(([name, own]) =>
  name === 'applyPreset' ? [] : own,
);

export const everyCommand: readonly SceneCommand[] = Object.values(commands).flat();

/** Up to three of these. */
function some<T>(from: readonly T[], pick: <U>(from: readonly U[]) => U | undefined): T[] {
  const first = pick(from);
  const at = first === undefined ? 0 : from.indexOf(first);
  return from.slice(at, at + (pick([1, 2, 3]) ?? 1));
}

function membersIn({ document }: DocumentStore): MemberRef[] {
  return (['objects', 'lights'] as const).flatMap((kind) =>
    Object.keys(document[kind]).map((id) => ({ kind, id })),
  );
}

/** What is refused whatever the document is: each has to throw, and to change nothing. */
export const wrongCommands: readonly SceneCommand[] = [
  (target) => removeEntities(target, [{ kind: 'objects', id: 'nothing' }]),
  (target) => removeEntities(target, [{ kind: 'materials', id: 'nothing' }]),
  (target) => void duplicateEntities(target, [{ kind: 'lights', id: '__proto__' }]),
  (target) => setVisible(target, [{ kind: 'objects', id: 'constructor' }], false),
  (target) => void groupEntities(target, []),
  (target) => moveToGroup(target, [], ['nothing'], null),
  (target) => rename(target, 'groups', 'nothing', 'Renamed'),
  (target) => setField(target, ['camera', 'fov'], 500),
  (target) => setField(target, ['camera', 'near'], 1e9),
  (target) => setField(target, ['effects', 'nothing'], true),
  (target) => void addModel(target, 'broken.brdf', flat.replace('return', 'retrun')),
  (target) => removeModel(target, 'nothing'),
  (target) => assignMaterial(target, [], 'nothing'),
  (target) => pasteEntities(target, '{"format":"irradia-clipboard","version":1,"document":null}'),
  (target) =>
    target.edit('Half an edit', (draft) => {
      draft.name = 'Changed';
      draft.objects = {};
      draft.camera.position = [0, 0, Number.NaN];
    }),
  (target) =>
    target.edit('Group a group in itself', (draft) => {
      draft.groups.loop = { name: 'Loop', parent: 'loop' };
    }),
];

/**
 * Does one of them; the numbers choose what it is done to. What is beyond the bounds of a field or of what a scene can hold,
 * or is locked, is refused, which is right, too.
 *
 * @returns why it was refused, null if it was not
 */
export function act(
  target: DocumentStore,
  command: SceneCommand | undefined,
  numbers: readonly number[],
): DocumentError | null {
  const left = [...numbers];
  try {
    command?.(target, (from) => from[(left.pop() ?? 0) % Math.max(from.length, 1)]);
    return null;
  } catch (error) {
    if (error instanceof DocumentError) return error;
    throw error;
  } finally {
    target.endMerge();
  }
}
