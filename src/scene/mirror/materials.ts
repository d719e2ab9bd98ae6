/** The materials of the document as BrdfMaterials: a changed parameter is one uniform. */
import { materialOpacity, texture } from 'three/tsl';
import * as THREE from 'three/webgpu';
import { type Model, multipleScatteringModel } from '../../glsl/model.ts';
import { BrdfMaterial } from '../../material/brdf-material.ts';
import { materialMaps } from '../material-schema.ts';
import { findModel } from '../models.ts';
import type { Asset, Document, Material, MaterialMap, TextureRef } from '../schema.ts';
import { diff } from './diff.ts';
import { Disposal } from './disposal.ts';
import type { Pending } from './pending.ts';
import type { TextureCache, TextureUse } from './textures.ts';

/** A texture in one of a material's places. */
interface Slot {
  ref: TextureRef;
  asset: Asset;
  use: TextureUse;
}

interface Entry {
  material: BrdfMaterial;
  source: Material;
  slots: Map<string, Slot>;
}

export class MaterialsMirror {
  readonly #entries = new Map<string, Entry>();
  /** Counts the materials that were made: while it stays the same, so do they. */
  made = 0;
  readonly #textures: TextureCache;
  readonly #pending: Pending;
  readonly #disposal = new Disposal();

  constructor(textures: TextureCache, pending: Pending) {
    this.#textures = textures;
    this.#pending = pending;
  }

  apply(document: Document, before: Document | null): void {
    diff(before?.materials ?? {}, document.materials, {
      removed: (id) => this.#remove(id),
      added: (id, source) => this.#create(id, source, document),
      changed: (id, source) => this.#update(id, source, document),
    });
    // Textures are assets, and so are measurements, which make another model.
    if (before !== null && (before.models !== document.models || before.assets !== document.assets))
      for (const [id, { source }] of this.#entries) this.#update(id, source, document);
    this.#showTerm(document);
  }

  get(id: string): BrdfMaterial | undefined {
    return this.#entries.get(id)?.material;
  }

  dispose(): void {
    for (const id of [...this.#entries.keys()]) this.#remove(id);
    this.#disposal.dispose();
  }

  #create(id: string, source: Material, document: Document): void {
    const model = findModel(document, source.model);
    if (model === undefined) return;
    const entry: Entry = {
      material: new BrdfMaterial(model, source.parameters),
      source,
      slots: new Map(),
    };
    this.#entries.set(id, entry);
    this.made += 1;
    setSurface(entry.material, source, null);
    this.#setTextures(entry, document);
  }

  #update(id: string, source: Material, document: Document): void {
    const entry = this.#entries.get(id);
    if (entry?.material.model !== findModel(document, source.model)) {
      this.#remove(id);
      this.#create(id, source, document);
      return;
    }
    if (entry === undefined) return;
    const { material, source: before } = entry;
    entry.source = source;
    for (const parameter of material.model.parameters) {
      const value = source.parameters[parameter.name];
      if (value !== before.parameters[parameter.name])
        material.set(parameter.name, value ?? parameter.default);
    }
    setSurface(material, source, before);
    this.#setTextures(entry, document);
  }

  #remove(id: string): void {
    const entry = this.#entries.get(id);
    if (entry === undefined) return;
    this.#entries.delete(id);
    for (const { use } of entry.slots.values()) use.release();
    this.#disposal.later(entry.material);
  }

  #showTerm({ view }: Document): void {
    for (const [id, { material, source }] of this.#entries) {
      const term = view.term?.material === id ? view.term.name : wholeModel(material.model, source);
      if (material.term !== term) material.term = term;
    }
  }

  #setTextures(entry: Entry, document: Document): void {
    const { material, source } = entry;
    for (const { name } of material.model.parameters) {
      const ref = source.textures[name] ?? null;
      this.#setSlot(entry, `parameter ${name}`, ref, document, (image) => {
        material.setMap(name, image, entry.source.textures[name]?.channel ?? undefined);
      });
    }
    for (const map of materialMaps)
      this.#setSlot(entry, map, source[map], document, (image) => setMap(material, map, image, entry.source));
  }

  #setSlot(
    entry: Entry,
    name: string,
    ref: TextureRef | null,
    { assets }: Document,
    show: (image: THREE.Texture | null) => void,
  ): void {
    const old = entry.slots.get(name);
    const asset = ref === null ? undefined : assets[ref.asset];
    if (ref === null || asset === undefined) {
      if (old === undefined) return;
      entry.slots.delete(name);
      show(null);
      old.use.release();
      return;
    }
    if (old?.ref === ref && old.asset === asset) return;
    const moved =
      old !== undefined && old.asset === asset && old.ref.channel === ref.channel && old.use.move(ref);
    if (moved) {
      entry.slots.set(name, { ...old, ref });
      return;
    }
    const slot: Slot = { ref, asset, use: this.#textures.acquire(ref, asset) };
    entry.slots.set(name, slot);
    this.#pending.add(slot.use.texture, (image) => {
      // Another texture may have been chosen while this one was on its way.
      if (entry.slots.get(name)?.use === slot.use) show(image);
    });
    old?.use.release();
  }
}

/** The term that is the material when nobody asks for another. */
function wholeModel(model: Model, { multipleScattering }: Material): string {
  return (multipleScattering ? multipleScatteringModel(model) : model).main;
}

const materialTextures = {
  normalMap: 'normalMap',
  bumpMap: 'bumpMap',
  occlusionMap: 'aoMap',
  emissiveMap: 'emissiveMap',
} as const;

function setMap(
  material: BrdfMaterial,
  map: MaterialMap,
  image: THREE.Texture | null,
  source: Material,
): void {
  if (map === 'opacityMap') {
    // three's own alpha map takes red; files have their opacity in the colour's alpha.
    const channel = source.opacityMap?.channel ?? 'a';
    material.opacityNode = image === null ? null : materialOpacity.mul(texture(image)[channel]);
    material.needsUpdate = true;
    return;
  }
  const had = material[materialTextures[map]] !== null;
  material[materialTextures[map]] = image;
  // A shader with the map is another one than a shader without.
  if (had !== (image !== null)) material.needsUpdate = true;
}

/** Everything but the model's parameters and the textures themselves. */
function setSurface(material: BrdfMaterial, source: Material, before: Material | null): void {
  material.name = source.name;
  material.emissive.setRGB(...source.emissive);
  material.emissiveIntensity = source.emissiveIntensity * (source.emissiveMap?.scale ?? 1);
  const normal = source.normalMap?.scale ?? 1;
  material.normalScale.set(normal, normal);
  material.bumpScale = source.bumpMap?.scale ?? 1;
  material.aoMapIntensity = source.occlusionMap?.scale ?? 1;
  material.opacity = source.alphaMode === 'opaque' ? 1 : source.opacity * (source.opacityMap?.scale ?? 1);
  material.alphaTest = source.alphaMode === 'mask' ? source.alphaCutoff : 0;
  material.transparent = source.alphaMode === 'blend';
  material.side = source.doubleSided ? THREE.DoubleSide : THREE.FrontSide;
  const recompiles =
    before !== null && (before.alphaMode !== source.alphaMode || before.doubleSided !== source.doubleSided);
  if (recompiles) material.needsUpdate = true;
}
