/** A material that is offered, wherever it comes from, and what it means to choose it. */
import type { LibraryEntry } from '../../../analysis/library/entry.ts';
import { materialLibrary } from '../../../analysis/library/library.ts';
import { fileOf } from '../../../analysis/library/patterns.ts';
import { addMaterialFile, type MaterialFile, readMaterialFile } from '../../../io/material-file.ts';
import {
  giveMaterial,
  type MaterialLook,
  putMaterialOnce,
  setLook,
  sorted,
} from '../../../scene/library-commands.ts';
import { assignMaterial } from '../../../scene/material-commands.ts';
import type { Document, Material } from '../../../scene/schema.ts';
import { attempt } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { OwnEntry } from '../../storage/material-library.ts';
import { jobOf, type ThumbnailJob } from './thumbnail-job.ts';

export type Offer =
  | { readonly kind: 'library'; readonly entry: LibraryEntry }
  | { readonly kind: 'own'; readonly entry: OwnEntry }
  /** A material of the open document. */
  | { readonly kind: 'scene'; readonly id: string };

export const keyOfOffer = (offer: Offer): string =>
  `${offer.kind} ${offer.kind === 'scene' ? offer.id : offer.entry.id}`;

export function titleOf(offer: Offer, document: Document): string {
  if (offer.kind === 'library') return translate(offer.entry.title);
  return offer.kind === 'own' ? offer.entry.title : (document.materials[offer.id]?.name ?? '');
}

/** With what it needs; undefined for a material that has gone. @throws DocumentError for an own one that is broken */
export function contentOf(offer: Offer, document: Document): MaterialFile | undefined {
  if (offer.kind === 'own') return ownFile(offer.entry);
  if (offer.kind === 'library') return libraryFile(offer.entry);
  const material = document.materials[offer.id];
  return material && { material, models: document.models, assets: document.assets };
}

const libraryFiles = new WeakMap<LibraryEntry, MaterialFile>();

/** The same each time, so that its pattern is drawn once. */
function libraryFile(entry: LibraryEntry): MaterialFile {
  const known = libraryFiles.get(entry) ?? fileOf(entry);
  libraryFiles.set(entry, known);
  return known;
}

const files = new WeakMap<OwnEntry, MaterialFile>();

function ownFile(entry: OwnEntry): MaterialFile {
  const known = files.get(entry) ?? readMaterialFile(JSON.parse(entry.file), entry.title);
  files.set(entry, known);
  return known;
}

export function pictureJob(offer: Offer, document: Document): ThumbnailJob | null {
  try {
    const content = contentOf(offer, document);
    return content ? jobOf(content, content.material) : null;
  } catch {
    // Whoever chooses it is told what is wrong with it.
    return null;
  }
}

export const lookOf = ({ model, parameters, multipleScattering }: Material): MaterialLook => ({
  model,
  parameters,
  multipleScattering,
});

/** Gives the offered material to what is selected. False where nothing is that could have it. */
export function giveToSelected(session: Session, offer: Offer): boolean {
  const { selected } = session.state.value;
  const ids = (kind: 'objects' | 'materials') =>
    selected.filter((entity) => entity.kind === kind).map(({ id }) => id);
  const [objects, materials] = [ids('objects'), ids('materials')];
  if (objects.length > 0) giveToObjects(session, offer, objects);
  else if (materials.length > 0) giveLook(session, offer, materials);
  else return false;
  return true;
}

/** @returns the material's id */
export function giveToObjects(
  { store }: Session,
  offer: Offer,
  objects: readonly string[],
): string | undefined {
  return attempt(t('The objects keep their material'), () => {
    if (offer.kind === 'scene') {
      assignMaterial(store, objects, offer.id);
      return offer.id;
    }
    const title = titleOf(offer, store.document);
    const put: Parameters<typeof giveMaterial>[3]['put'] =
      offer.kind === 'library'
        ? (draft) => {
            const [first] = objects;
            const isBall = first === undefined || store.document.objects[first]?.geometry.type === 'sphere';
            const file = isBall ? libraryFile(offer.entry) : fileOf(offer.entry, false);
            const material = { ...file.material, name: title };
            return addMaterialFile(draft, { ...file, material }, putMaterialOnce);
          }
        : (draft) => addMaterialFile(draft, ownFile(offer.entry));
    return giveMaterial(store, title, objects, { put, isTry });
  });
}

/** Only adds it to the scene. @returns its id */
export const addToScene = (session: Session, offer: Offer): string | undefined =>
  giveToObjects(session, offer, []);

/** Materials of the scene that keep their names and get the offered look. */
export function giveLook(session: Session, offer: Offer, materials: readonly string[]): void {
  const { store } = session;
  attempt(t('The material stays as it was'), () => {
    const content = contentOf(offer, store.document);
    if (!content) return;
    const title = titleOf(offer, store.document);
    const names = materials.map((id) => store.document.materials[id]?.name ?? '').join(', ');
    const { model } = content.material;
    const needs = [content.models[model], ...Object.values(content.assets)];
    if (offer.kind === 'scene' || needs.every((need) => need === undefined)) {
      setLook(store, materials, `${names}: ${title}`, lookOf(content.material));
      return;
    }
    // Its model and its pattern come into the scene with it.
    store.edit(`${names}: ${title}`, (draft) => {
      const id = addMaterialFile(draft, content);
      const added = draft.materials[id];
      for (const target of materials) {
        const name = draft.materials[target]?.name;
        if (added && name !== undefined) draft.materials[target] = { ...structuredClone(added), name };
      }
      delete draft.materials[id];
    });
  });
}

/** A material of the library as it came: while one tries others, it need not stay. */
function isTry(material: Material, { assets }: Pick<Document, 'assets'>): boolean {
  const { name, ...rest } = material;
  const title = name.replace(/ \d+$/, '');
  const entry = [...materialLibrary.values()].find((known) => translate(known.title) === title);
  if (!entry) return false;
  const came = libraryFile(entry);
  const { name: _, ...usual } = came.material;
  return textOf(rest, assets) === textOf(usual, came.assets);
}

/** The same for materials that are the same but for the ids of what they need, and for how it is laid on their object. */
const textOf = (material: object, assets: Document['assets']): string =>
  JSON.stringify(sorted(material), (key, value) =>
    key === 'repeat' ? undefined : key === 'asset' ? assets[value]?.data : value,
  );
