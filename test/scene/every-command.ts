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
import { addableGeometries } from '../../src/scene/geometry-schema.ts';
import { groupEntities, moveToGroup, shift, ungroup } from '../../src/scene/group-commands.ts';
import { lightTypes } from '../../src/scene/light-schema.ts';
import {
  addMaterial,
  addModel,
  assignMaterial,
  removeModel,
  setMaterialModel,
  setParameter,
  setTexture,
} from '../../src/scene/material-commands.ts';
import { materialMaps, textureRef } from '../../src/scene/material-schema.ts';
import { findModel, modelNames } from '../../src/scene/models.ts';
import {
  duplicateEntities,
  removeEntities,
  setLocked,
  setVisible,
} from '../../src/scene/selection-commands.ts';
import type { DocumentStore } from '../../src/scene/store.ts';
import { place } from '../../src/scene/transform-commands.ts';

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

/** What changes the things in the scene, and nothing of how they are drawn. */
export const commandsOfScene: readonly SceneCommand[] = [
  (target, pick) => void addLight(target, pick(lightTypes) ?? 'point'),
  (target, pick) => void addObject(target, pick(addableGeometries) ?? 'box'),
  (target, pick) => void addMaterial(target, pick(modelNames(target.document))),
  (target) => void addModel(target, 'flat.brdf', flat),
  ...kinds.map((kind) => onOne(kind, (target, id) => removeEntities(target, [{ kind, id }]))),
  (target) => removeUnused(target),
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
  (target, pick) =>
    onOne('materials', (t, id) => setField(t, ['materials', id, pick(materialMaps) ?? 'normalMap'], null))(
      target,
      pick,
    ),
  ...kinds.map((kind) => onOne(kind, (target, id) => void duplicateEntities(target, [{ kind, id }]))),
  onOne('objects', (target, id) => rename(target, 'objects', id, 'Renamed')),
  onOne('objects', (target, id) => setField(target, ['objects', id, 'position', 1], 2)),
  (target, pick) =>
    onOne('objects', (t, id) => setGeometryType(t, id, pick(addableGeometries) ?? 'box'))(target, pick),
  (target, pick) => onOne('lights', (t, id) => setLightType(t, id, pick(lightTypes) ?? 'spot'))(target, pick),
  (target, pick) =>
    onOne('materials', (t, id) => setMaterialModel(t, id, pick(modelNames(t.document)) ?? 'lambert'))(
      target,
      pick,
    ),
  (target, pick) =>
    onOne('materials', (t, id) => {
      const objects = pick(Object.keys(t.document.objects));
      if (objects !== undefined) assignMaterial(t, [objects], id);
    })(target, pick),
  (target, pick) => setVisible(target, some(membersIn(target), pick), pick([true, false]) ?? true),
  (target, pick) => setLocked(target, some(membersIn(target), pick), pick([true, false, false]) ?? false),
  (target, pick) => {
    const members = some(membersIn(target), pick);
    if (members.length > 0) groupEntities(target, members);
  },
  (target, pick) => ungroup(target, some(membersIn(target), pick)),
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
  (target, pick) => {
    const members = some(membersIn(target), pick);
    if (members.length > 0) shift(target, members, pick([-1, 1]) ?? 1);
  },
  (target, pick) =>
    removeEntities(target, [], Object.keys(target.document.groups).slice(0, pick([0, 1]) ?? 0)),
  (target, pick) => void duplicateEntities(target, some(membersIn(target), pick)),
  (target, pick) => {
    const members = some(membersIn(target), pick);
    if (members.length > 0) pasteEntities(target, copyEntities(target.document, members));
  },
  (target, pick) => {
    const [id] = some(Object.keys(target.document.groups), pick);
    if (id !== undefined) rename(target, 'groups', id, 'Renamed');
  },
  (target, pick) =>
    place(
      target,
      'Move',
      some(membersIn(target), pick).map((ref) => ({
        ...ref,
        placement: { position: [1, pick([0, 2, -3]) ?? 0, 3] },
      })),
    ),
];

/** Every command of src/scene. */
export const everyCommand: readonly SceneCommand[] = [
  ...commandsOfScene,
  (target, pick) => applyPreset(target, pick(presetNames) ?? 'low'),
];

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

/** Does one of them; the numbers choose what it is done to. */
export function act(
  target: DocumentStore,
  command: SceneCommand | undefined,
  numbers: readonly number[],
): void {
  const left = [...numbers];
  command?.(target, (from) => from[(left.pop() ?? 0) % Math.max(from.length, 1)]);
  target.endMerge();
}
