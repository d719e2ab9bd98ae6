/**
 * Decoding of assets: images, environments, glTF files, Suzanne. Every asset is decoded once
 * for as long as the document holds it. What differs between a page and Node is injected.
 * A promise that fails says which asset and what is wrong with it.
 */

import type { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import * as THREE from 'three/webgpu';
import { ByteError } from '../io/bytes.ts';
import { type GltfFile, readGltf, textureImage } from '../io/gltf/file.ts';
import type { Geometries } from '../io/gltf/geometry.ts';
import { decodeBase64, decodeDataUrl } from './base64.ts';
import { type ComputedSource, computeEnvironment, type EnvironmentMap } from './environment-map.ts';
import { isPattern } from './pattern/asset.ts';
import { type EnvironmentPreset, loadPreset, loadSuzanne } from './presets.ts';
import type { Asset } from './schema.ts';

/** A decoded image: sRGB or data as stored, alpha not multiplied in, bottom row first. */
export type TextureImage = ImageBitmap | { data: Uint8Array; width: number; height: number };

/** What a browser and Node do differently. */
export interface AssetPlatform {
  decodeImage(bytes: Uint8Array<ArrayBuffer>, mediaType: string): Promise<TextureImage>;
  dracoLoader(): DRACOLoader;
  /** Opens a glTF asset elsewhere, such as in a worker; null leaves it to this thread. */
  openGltf?(asset: Asset): GltfSource | null;
  /** The same for an environment. */
  decodeEnvironment?(asset: Asset): Promise<THREE.DataTexture> | null;
  /** The same for a picture of a pattern. */
  drawPattern?(asset: Asset, texture: number | null): Promise<TextureImage>;
  /** The same for an environment that is computed. */
  computeEnvironment?(source: ComputedSource): Promise<EnvironmentMap>;
  /** Is told of an environment that ships, which is loaded. */
  onPreset?(name: EnvironmentPreset, coming: Promise<unknown>): void;
}

/** A glTF file that is open. */
export interface GltfSource {
  /** Of a primitive of a node's mesh; nodes with the same mesh share it. */
  geometry(node: number, primitive: number): Promise<THREE.BufferGeometry>;
  /** Of a texture, decoded. */
  image(texture: number): Promise<TextureImage>;
}

export class AssetLoader {
  readonly #platform: AssetPlatform;
  readonly #images = new WeakMap<Asset, Map<number | null, Promise<TextureImage>>>();
  readonly #gltfs = new WeakMap<Asset, GltfSource>();
  #suzanne: Promise<THREE.BufferGeometry> | null = null;
  #draco: DRACOLoader | null = null;

  constructor(platform: AssetPlatform) {
    this.#platform = platform;
  }

  /** An image asset, or with an index that texture's image of a glTF asset. */
  image(asset: Asset, texture: number | null): Promise<TextureImage> {
    const images = this.#images.get(asset) ?? new Map<number | null, Promise<TextureImage>>();
    this.#images.set(asset, images);
    const image = images.get(texture) ?? this.#decodeImage(asset, texture);
    images.set(texture, image);
    return image;
  }

  /** The geometry of a primitive of a node's mesh; shared, so not to be changed or disposed. */
  async gltfGeometry(asset: Asset, node: number, primitive: number): Promise<THREE.BufferGeometry> {
    return this.#gltf(asset).geometry(node, primitive);
  }

  /** What is open already need not be opened again. */
  adopt(asset: Asset, source: GltfSource): void {
    this.#gltfs.set(asset, source);
  }

  /** Throws GltfError if the asset is not a glTF file. */
  #gltf(asset: Asset): GltfSource {
    const open =
      this.#gltfs.get(asset) ??
      this.#platform.openGltf?.(asset) ??
      this.#openGltf(readGltf(decodeBase64(asset.data), asset.name));
    this.#gltfs.set(asset, open);
    return open;
  }

  suzanne(): Promise<THREE.BufferGeometry> {
    this.#suzanne ??= this.#loadSuzanne();
    return this.#suzanne;
  }

  /** The caller's own, to dispose of. */
  async environment(asset: Asset): Promise<THREE.DataTexture> {
    const elsewhere = this.#platform.decodeEnvironment?.(asset);
    if (elsewhere) return elsewhere;
    const bytes = decodeBase64(asset.data);
    if (!/^image\/(png|jpeg|webp|avif)$/.test(asset.mediaType)) return decodeEnvironment(bytes, asset.name);
    const { environmentOfImage } = await import('./image-environment.ts');
    return environmentOfImage(await this.image(asset, null), asset.name);
  }

  /** A sky or a studio, in nits. */
  computed(source: ComputedSource): Promise<EnvironmentMap> {
    return this.#platform.computeEnvironment?.(source) ?? computeEnvironment(source);
  }

  /** The caller's own, to dispose of. */
  async preset(name: EnvironmentPreset): Promise<THREE.DataTexture> {
    let image: string;
    try {
      const coming = loadPreset(name);
      this.#platform.onPreset?.(name, coming);
      image = await coming;
    } catch (cause) {
      throw new Error(
        `the environment "${name}" did not come; without a network only what was loaded before is there`,
        {
          cause,
        },
      );
    }
    return decodeEnvironment(bytesOf(image), name);
  }

  dispose(): void {
    this.#draco?.dispose();
    this.#draco = null;
  }

  async #decodeImage(asset: Asset, texture: number | null): Promise<TextureImage> {
    // What is wrong with it says already in which pattern and where.
    if (isPattern(asset)) return this.#drawPattern(asset, texture);
    try {
      if (texture === null)
        return await this.#platform.decodeImage(decodeBase64(asset.data), asset.mediaType);
      return await this.#gltf(asset).image(texture);
    } catch (cause) {
      const place = texture === null ? asset.name : `${asset.name}, textures[${texture}]`;
      throw new Error(`${place}: the image cannot be read: ${messageOf(cause)}`, { cause });
    }
  }

  async #drawPattern(asset: Asset, texture: number | null): Promise<TextureImage> {
    if (this.#platform.drawPattern) return this.#platform.drawPattern(asset, texture);
    const { drawPatternAsset } = await import('./pattern/draw.ts');
    return drawPatternAsset(asset, texture);
  }

  #openGltf(file: GltfFile): GltfSource {
    let geometries: Promise<Geometries> | null = null;
    const open = async () => {
      const { openGeometries } = await import('../io/gltf/geometry.ts');
      return openGeometries(file, () => {
        this.#draco ??= this.#platform.dracoLoader();
        return this.#draco;
      });
    };
    return {
      async geometry(node, primitive) {
        geometries ??= open();
        return (await geometries)(node, primitive);
      },
      image: async (texture) => {
        const { bytes, mediaType } = textureImage(file, texture);
        return this.#platform.decodeImage(new Uint8Array(bytes), mediaType);
      },
    };
  }

  async #loadSuzanne(): Promise<THREE.BufferGeometry> {
    return this.#openGltf(readGltf(bytesOf(await loadSuzanne()), 'Suzanne')).geometry(0, 0);
  }
}

export const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

function bytesOf(dataUrl: string): Uint8Array<ArrayBuffer> {
  const decoded = decodeDataUrl(dataUrl);
  if (decoded === null) throw new Error('a shipped asset is not a data URL');
  return decoded.bytes;
}

/** Radiance HDR or OpenEXR, told apart by their first bytes. */
async function decodeEnvironment(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<THREE.DataTexture> {
  const isExr = bytes[0] === 0x76 && bytes[1] === 0x2f && bytes[2] === 0x31 && bytes[3] === 0x01;
  const isHdr = bytes[0] === 0x23 && bytes[1] === 0x3f;
  if (!isExr && !isHdr) throw new Error(`${name}: neither a Radiance HDR nor an OpenEXR image`);
  try {
    const texture = await (isExr ? readExr(bytes, name) : readHdr(bytes, name));
    texture.mapping = THREE.EquirectangularReflectionMapping;
    texture.name = name;
    return texture;
  } catch (cause) {
    // Says already in which file and where.
    if (cause instanceof ByteError) throw cause;
    throw new Error(`${name}: the image cannot be read: ${messageOf(cause)}`, { cause });
  }
}

async function readExr(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<THREE.DataTexture> {
  const { checkExr } = await import('../io/exr-check.ts');
  checkExr(bytes, name);
  const { EXRLoader } = await import('three/addons/loaders/EXRLoader.js');
  return new EXRLoader().createDataTexture(bytes.buffer);
}

async function readHdr(bytes: Uint8Array<ArrayBuffer>, name: string): Promise<THREE.DataTexture> {
  const { decodeHdr } = await import('../io/hdr.ts');
  const { width, height, pixels } = decodeHdr(bytes, name);
  const texture = new THREE.DataTexture(pixels, width, height, THREE.RGBAFormat, THREE.HalfFloatType);
  texture.colorSpace = THREE.LinearSRGBColorSpace;
  texture.minFilter = THREE.LinearFilter;
  texture.magFilter = THREE.LinearFilter;
  // Rows are from the top, a texture's from the bottom.
  texture.flipY = true;
  texture.needsUpdate = true;
  return texture;
}
