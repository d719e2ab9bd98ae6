import type { Model } from '../../glsl/model.ts';
import type { Document, SceneObject } from '../../scene/schema.ts';
import type { Placement } from './instances.ts';
import type { UsedMaterial } from './materials.ts';
import type { PackedMesh } from './mesh.ts';
import type { SkyDistribution, SkyMap } from './sky.ts';
import type { TextureTable } from './textures.ts';

/** A visible object. */
export interface Instance {
  readonly object: SceneObject;
  readonly placement: Placement;
  readonly mesh: PackedMesh;
  /** Its material's place among the scene's. */
  readonly material: number;
}

/** Everything that is written, as it is known before anything is. */
export interface Scene {
  readonly document: Document;
  readonly instances: readonly Instance[];
  readonly materials: readonly UsedMaterial[];
  readonly models: readonly Model[];
  readonly textures: TextureTable;
  /** The generic sampler's, for each material; null for those whose model brings a sampler. */
  readonly tables: readonly (Uint32Array<ArrayBuffer> | null)[];
  readonly map: SkyMap | null;
  readonly distribution: SkyDistribution;
}
