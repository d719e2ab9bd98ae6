/** Textures by what they are: references to the same image with the same settings share one. */
import * as THREE from 'three/webgpu';
import type { AssetLoader, TextureImage } from '../assets.ts';
import type { Asset, TextureRef } from '../schema.ts';

interface Entry {
  users: number;
  texture: Promise<THREE.Texture>;
}

export interface TextureUse {
  readonly texture: Promise<THREE.Texture>;
  /**
   * Moves the image over the surface, without another upload. False, and nothing done, if
   * more than that would change or if another user would see it move.
   */
  move(ref: TextureRef): boolean;
  release(): void;
}

const wraps = {
  repeat: THREE.RepeatWrapping,
  mirror: THREE.MirroredRepeatWrapping,
  clamp: THREE.ClampToEdgeWrapping,
} as const;

export class TextureCache {
  readonly #assets: AssetLoader;
  readonly #entries = new WeakMap<Asset, Map<string, Entry>>();

  constructor(assets: AssetLoader) {
    this.#assets = assets;
  }

  acquire(ref: TextureRef, asset: Asset): TextureUse {
    const entries = this.#entries.get(asset) ?? new Map<string, Entry>();
    this.#entries.set(asset, entries);
    let key = keyOf(ref);
    const entry = entries.get(key) ?? { users: 0, texture: this.#load(ref, asset) };
    entries.set(key, entry);
    entry.users += 1;
    return {
      texture: entry.texture,
      move: (to) => {
        const next = keyOf(to);
        if (entry.users > 1 || entries.has(next) || keyOf({ ...to, ...placeOf(ref) }) !== keyOf(ref))
          return false;
        entries.delete(key);
        entries.set(next, entry);
        key = next;
        entry.texture.then((texture) => place(texture, to), ignore);
        return true;
      },
      release: () => {
        entry.users -= 1;
        if (entry.users > 0) return;
        entries.delete(key);
        entry.texture.then((texture) => texture.dispose(), ignore);
      },
    };
  }

  async #load(ref: TextureRef, asset: Asset): Promise<THREE.Texture> {
    const texture = createTexture(await this.#assets.image(asset, ref.texture));
    texture.name = asset.name;
    texture.colorSpace = ref.colorSpace === 'srgb' ? THREE.SRGBColorSpace : THREE.NoColorSpace;
    texture.wrapS = wraps[ref.wrap];
    texture.wrapT = wraps[ref.wrap];
    texture.channel = ref.uv;
    place(texture, ref);
    texture.magFilter = THREE.LinearFilter;
    texture.minFilter = THREE.LinearMipmapLinearFilter;
    texture.generateMipmaps = true;
    texture.anisotropy = 8;
    // Images are decoded bottom row first, on every platform and back end alike.
    texture.flipY = false;
    texture.needsUpdate = true;
    return texture;
  }
}

/** What failed to load has been reported to whoever asked for it. */
const ignore = (): void => {};

const placeOf = ({ repeat, offset, rotation }: TextureRef) => ({ repeat, offset, rotation });

function place(texture: THREE.Texture, { repeat, offset, rotation }: TextureRef): void {
  texture.repeat.fromArray(repeat);
  texture.offset.fromArray(offset);
  texture.rotation = THREE.MathUtils.degToRad(rotation);
}

/** The channel is the material's choice, not the texture's. */
function keyOf({ texture, colorSpace, repeat, offset, rotation, wrap, uv }: TextureRef): string {
  return JSON.stringify([texture, colorSpace, wrap, uv, repeat, offset, rotation]);
}

function createTexture(image: TextureImage): THREE.Texture {
  return 'data' in image
    ? new THREE.DataTexture(image.data, image.width, image.height)
    : new THREE.Texture(image);
}
