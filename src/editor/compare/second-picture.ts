/** The scene with B in place of A, by a renderer of its own on the same GPU: each picture has its own history. */
import type { Material as ThreeMaterial } from 'three/webgpu';
import type { MaterialFile } from '../../io/material-file.ts';
import type { Companion } from '../../realtime/output-pass.ts';
import type { RealtimeRenderer, Size } from '../../realtime/renderer.ts';
import type { AssetLoader } from '../../scene/assets.ts';
import { MaterialsMirror } from '../../scene/mirror/materials.ts';
import { materialFrom } from '../../scene/mirror/objects.ts';
import { Pending } from '../../scene/mirror/pending.ts';
import { TextureCache } from '../../scene/mirror/textures.ts';
import type { SceneMirror } from '../../scene/mirror.ts';
import type { Document } from '../../scene/schema.ts';

export interface SecondPictureOptions {
  readonly mirror: SceneMirror;
  readonly renderer: RealtimeRenderer;
  readonly assets: AssetLoader;
  onError(message: string): void;
}

/** B's id among the materials that are mirrored here, where it is alone. */
const B = 'b';

export class SecondPicture {
  readonly #options: SecondPictureOptions;
  readonly #renderer: RealtimeRenderer;
  readonly #pending: Pending;
  readonly #materials: MaterialsMirror;
  #shown: Document | null = null;

  constructor(options: SecondPictureOptions) {
    this.#options = options;
    this.#renderer = options.renderer.beside();
    this.#pending = new Pending(options.onError);
    this.#materials = new MaterialsMirror(new TextureCache(options.assets), this.#pending);
  }

  /** What B is from now on. @param document whose view counts */
  show(document: Document, { material, models, assets }: MaterialFile): void {
    const shown: Document = {
      ...document,
      materials: { [B]: material },
      models,
      assets,
      view: { ...document.view, term: null },
    };
    this.#materials.apply(shown, this.#shown);
    this.#shown = shown;
  }

  /** Its textures have come or failed. */
  settled(): Promise<void> {
    return this.#pending.settled();
  }

  changed(): void {
    this.#renderer.changed();
  }

  /** @param a the material of the document that B stands in for @param from the part of the width that is A's */
  draw(document: Document, a: string, size: Size, from: number): Companion | null {
    const { mirror } = this.#options;
    const material = this.#materials.get(B);
    if (!material) return null;
    const before: [{ material: ThreeMaterial | ThreeMaterial[] }, ThreeMaterial | ThreeMaterial[]][] = [];
    for (const [id, object] of Object.entries(document.objects)) {
      const mesh = object.material === a ? mirror.objectFor(id) : undefined;
      if (!mesh) continue;
      before.push([mesh, mesh.material]);
      materialFrom(mesh, material);
    }
    try {
      this.#renderer.draw(mirror, document, size);
    } finally {
      for (const [mesh, own] of before) mesh.material = own;
    }
    return this.last(from);
  }

  last(from: number): Companion {
    return { radiance: this.#renderer.texture, from };
  }

  dispose(): void {
    this.#materials.dispose();
    this.#renderer.release();
  }
}
