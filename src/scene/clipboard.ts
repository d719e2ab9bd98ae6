/**
 * Objects, lights and materials as text, for the clipboard: with the groups that are there as a whole, and the
 * materials, models and files that they need. The text holds a small document, so that whatever somebody else
 * put into the clipboard is parsed and checked as a file is.
 */
import { keepAsset } from './commands.ts';
import { compactDocument, isSame } from './compact.ts';
import { createDocument, parseDocument } from './document.ts';
import { describeEntities, type EntityKind, type EntityRef, entity, namesOf } from './entity.ts';
import { DocumentError } from './error.ts';
import { keyOf, memberCounts, wholeGroups } from './groups.ts';
import { materialMaps } from './material-schema.ts';
import { modelNames } from './models.ts';
import { FreeIds, FreeNames } from './names.ts';
import type { Document, Material } from './schema.ts';
import type { DocumentStore, Draft } from './store.ts';
import { assetsOf, trustAsset } from './validate.ts';

/** What the text begins with. */
const FORMAT = 'irradia-clipboard';
const VERSION = 1;
const FILE = 'clipboard';

const kinds: readonly EntityKind[] = ['lights', 'objects', 'materials'];

/** Whether a text claims to be of copyEntities(). */
export function isClipboardText(text: string): boolean {
  return /^\s*\{\s*"format"\s*:\s*"irradia-clipboard"/.test(text.slice(0, 200));
}

/** The text of these. */
export function copyEntities(document: Document, refs: readonly EntityRef[]): string {
  const part: Document = { ...createDocument(FILE), ...partOf(document, inOrder(document, refs)) };
  const chosen = refs.map(({ kind, id }) => ({ kind, id }));
  return JSON.stringify({
    format: FORMAT,
    version: VERSION,
    selected: chosen,
    document: compactDocument(part),
  });
}

/** As they come in the document, each kind by itself. */
function inOrder(document: Document, refs: readonly EntityRef[]): EntityRef[] {
  const chosen = new Set(refs.map(keyOf));
  return kinds.flatMap((kind) =>
    Object.keys(document[kind])
      .map((id) => ({ kind, id }))
      .filter((ref) => chosen.has(keyOf(ref))),
  );
}

type Part = Pick<Document, 'lights' | 'objects' | 'groups' | 'materials' | 'models' | 'assets'>;

function partOf(document: Document, refs: readonly EntityRef[]): Part {
  const part: Part = { lights: {}, objects: {}, groups: {}, materials: {}, models: {}, assets: {} };
  const whole = wholeGroups(document, refs);
  const within = (group: string | null) => (group !== null && whole.has(group) ? group : null);
  const addAsset = (id: string) => {
    part.assets[id] = entity(document, 'assets', id);
  };
  const addMaterial = (id: string) => {
    if (Object.hasOwn(part.materials, id)) return;
    const material = entity(document, 'materials', id);
    part.materials[id] = material;
    for (const [, asset] of assetsOf(material)) addAsset(asset);
    const model = Object.hasOwn(document.models, material.model)
      ? document.models[material.model]
      : undefined;
    if (!model) return;
    part.models[material.model] = model;
    if ('measured' in model) addAsset(model.measured);
  };
  for (const id of whole) {
    const { name, parent } = entity(document, 'groups', id);
    part.groups[id] = { name, parent: within(parent) };
  }
  for (const { kind, id } of refs) {
    if (kind === 'materials') addMaterial(id);
    else if (kind === 'lights') {
      const light = entity(document, 'lights', id);
      part.lights[id] = { ...light, group: within(light.group) };
    } else {
      const object = entity(document, 'objects', id);
      part.objects[id] = { ...object, group: within(object.group) };
      addMaterial(object.material);
      if (object.geometry.type === 'gltf') addAsset(object.geometry.asset);
    }
  }
  return part;
}

interface Clipboard {
  readonly document: Document;
  readonly selected: readonly EntityRef[];
}

/** Throws DocumentError, whatever the text is. */
function parseClipboard(text: string): Clipboard {
  const fail = (path: string, message: string) => new DocumentError(FILE, [{ path, message }]);
  let json: unknown;
  try {
    json = JSON.parse(text);
  } catch (cause) {
    throw new DocumentError(FILE, [{ path: '', message: 'not JSON' }], { cause });
  }
  if (typeof json !== 'object' || json === null || !('format' in json) || json.format !== FORMAT)
    throw fail('format', `not copied from Irradia: expected "${FORMAT}"`);
  const { version, document, selected } = json as Record<string, unknown>;
  if (version !== VERSION)
    throw fail('version', `copied from another version of Irradia: expected ${VERSION}`);
  const parsed = parseDocument(document, FILE);
  return { document: parsed, selected: refsOf(selected, parsed) };
}

/** Those that name something in the document, then the other lights and objects in it: nothing is left out. */
function refsOf(json: unknown, document: Document): EntityRef[] {
  const named = Array.isArray(json)
    ? json.filter(
        (ref: unknown): ref is EntityRef =>
          typeof ref === 'object' &&
          ref !== null &&
          'kind' in ref &&
          'id' in ref &&
          kinds.some((kind) => kind === ref.kind) &&
          typeof ref.id === 'string' &&
          Object.hasOwn(document[ref.kind as EntityKind], ref.id),
      )
    : [];
  const all = (['lights', 'objects'] as const).flatMap((kind) =>
    Object.keys(document[kind]).map((id) => ({ kind, id })),
  );
  const refs = [...named, ...all].map(({ kind, id }) => ({ kind, id }));
  return [...new Map(refs.map((ref) => [keyOf(ref), ref])).values()];
}

/**
 * Adds what the text of copyEntities() holds as one step, under free ids and names, and returns it. Files,
 * models and materials that are there already are not added again, unless the material itself was copied.
 * Throws DocumentError, and changes nothing, if the text is not such a text or does not fit.
 */
export function pasteEntities(store: DocumentStore, text: string): EntityRef[] {
  const { document: from, selected } = parseClipboard(text);
  if (selected.length === 0)
    throw new DocumentError(FILE, [{ path: 'selected', message: 'nothing was copied' }]);
  const pasted = new Map<string, EntityRef>();
  store.edit(`Paste ${describeEntities(from, selected)}`, (draft) => {
    const merge = new Merge(draft, store.document, from);
    const counts = memberCounts(from);
    for (const id of Object.keys(from.groups)) if (counts.has(id)) merge.addGroup(id);
    // Materials first: objects that were copied with theirs get the copies.
    const ordered = inOrder(from, selected).sort((a, b) => rank(a) - rank(b));
    for (const ref of ordered) pasted.set(keyOf(ref), { kind: ref.kind, id: merge.add(ref) });
  });
  return selected.flatMap((ref) => pasted.get(keyOf(ref)) ?? []);
}

const rank = ({ kind }: EntityRef) => (kind === 'materials' ? 0 : 1);

/** Puts parts of one document into a draft of another. What something needs comes with it, once. */
class Merge {
  readonly #draft: Draft;
  readonly #into: Document;
  readonly #from: Document;
  readonly #assets = new Map<string, string>();
  readonly #models = new Map<string, string>();
  readonly #materials = new Map<string, string>();
  readonly #groups = new Map<string, string>();
  readonly #ids: Readonly<Record<EntityKind | 'groups', FreeIds>>;
  readonly #names: Readonly<Record<EntityKind | 'groups', FreeNames>>;
  readonly #modelNames: FreeNames;

  constructor(draft: Draft, into: Document, from: Document) {
    this.#draft = draft;
    this.#into = into;
    this.#from = from;
    const ids = (kind: EntityKind | 'groups') => new FreeIds(Object.keys(into[kind]));
    const names = (kind: EntityKind | 'groups') => new FreeNames(namesOf(into[kind]));
    const each = <T>(make: (kind: EntityKind | 'groups') => T) => ({
      lights: make('lights'),
      objects: make('objects'),
      materials: make('materials'),
      groups: make('groups'),
    });
    this.#ids = each(ids);
    this.#names = each(names);
    this.#modelNames = new FreeNames(modelNames(into));
  }

  /** Its id in the draft. What was locked can be moved, for it was put there to be. */
  add({ kind, id }: EntityRef): string {
    if (kind === 'materials') return this.#material(id, true);
    const original = entity(this.#from, kind, id);
    const name = this.#names[kind].take(original.name);
    const own = this.#ids[kind].take(id.replace(/-\d+$/, ''));
    const group = original.group === null ? null : this.addGroup(original.group);
    const common = { name, locked: false, group };
    if (kind === 'lights')
      this.#draft.lights[own] = { ...structuredClone(entity(this.#from, kind, id)), ...common };
    else {
      const object = structuredClone(entity(this.#from, 'objects', id));
      if (object.geometry.type === 'gltf') object.geometry.asset = this.#asset(object.geometry.asset);
      this.#draft.objects[own] = { ...object, ...common, material: this.#material(object.material, false) };
    }
    return own;
  }

  /** Its id in the draft; the groups that it is in come with it. */
  addGroup(id: string): string {
    const known = this.#groups.get(id);
    if (known !== undefined) return known;
    const { name, parent } = entity(this.#from, 'groups', id);
    const own = this.#ids.groups.take(id.replace(/-\d+$/, ''));
    this.#groups.set(id, own);
    this.#draft.groups[own] = { name: this.#names.groups.take(name), parent: null };
    const group = this.#draft.groups[own];
    if (parent !== null && group) group.parent = this.addGroup(parent);
    return own;
  }

  /** @param isCopied somebody wants one more of it, not only something that has it */
  #material(id: string, isCopied: boolean): string {
    const known = this.#materials.get(id);
    if (known !== undefined) return known;
    const material = this.#translated(entity(this.#from, 'materials', id));
    const same = isCopied
      ? undefined
      : Object.entries(this.#into.materials).find(([, other]) => isSame(other, material));
    const own = same?.[0] ?? this.#ids.materials.take(id.replace(/-\d+$/, ''));
    this.#materials.set(id, own);
    if (!same) this.#draft.materials[own] = { ...material, name: this.#names.materials.take(material.name) };
    return own;
  }

  #translated(original: Material): Material {
    const material = structuredClone(original);
    material.model = this.#model(material.model);
    for (const texture of Object.values(material.textures)) texture.asset = this.#asset(texture.asset);
    for (const map of materialMaps) {
      const texture = material[map];
      if (texture !== null) texture.asset = this.#asset(texture.asset);
    }
    return material;
  }

  /** A model that ships has the same name everywhere, unless this document has one of its own under that name. */
  #model(name: string): string {
    const own = Object.hasOwn(this.#from.models, name) ? this.#from.models[name] : undefined;
    if (own === undefined) return name;
    const known = this.#models.get(name);
    if (known !== undefined) return known;
    const model = 'measured' in own ? { measured: this.#asset(own.measured) } : { source: own.source };
    const same = Object.entries(this.#into.models).find(([, other]) => isSame(other, model));
    const found = same?.[0] ?? this.#modelNames.take(name);
    this.#models.set(name, found);
    if (!same) this.#draft.models[found] = model;
    return found;
  }

  #asset(id: string): string {
    const known = this.#assets.get(id);
    if (known !== undefined) return known;
    const asset = entity(this.#from, 'assets', id);
    // It has just been parsed.
    trustAsset(asset);
    const own = keepAsset(this.#draft, asset);
    this.#assets.set(id, own);
    return own;
  }
}
