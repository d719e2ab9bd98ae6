/** The light that comes from everywhere, and what is seen behind the scene. */
import * as THREE from 'three/webgpu';
import type { AssetLoader } from '../assets.ts';
import {
  type ComputedSource,
  type EnvironmentMap,
  environmentScale,
  isComputed,
} from '../environment-map.ts';
import type { Asset, Document } from '../schema.ts';
import { sunOf } from '../sky/sun.ts';
import type { Pending } from './pending.ts';
import { SkyBackground } from './sky-background.ts';

/** What has been chosen: a shipped image or numbers, as text, or the asset itself. */
type Identity = string | Asset;

export class EnvironmentMirror {
  readonly #scene: THREE.Scene;
  readonly #assets: AssetLoader;
  readonly #pending: Pending;
  #identity: Identity = 'none';
  #texture: THREE.DataTexture | null = null;
  /** Made here, with one image or another as the numbers change: another texture would be another shader. */
  #own: THREE.DataTexture | null = null;
  /** By what the texels of the image were divided, so that half floats hold them. */
  #unit = 1;
  #sky: SkyBackground | null = null;
  #document: Document | null = null;
  /** What is to be computed next. */
  #wanted: { readonly source: ComputedSource; readonly identity: Identity } | null = null;
  #computing = false;

  constructor(scene: THREE.Scene, assets: AssetLoader, pending: Pending) {
    this.#scene = scene;
    this.#assets = assets;
    this.#pending = pending;
  }

  apply(document: Document, before: Document | null): void {
    const { environment, background, assets } = document;
    if (before?.environment === environment && before.background === background && before.assets === assets)
      return;
    this.#document = document;
    this.#setSource(document);
    this.#setScene(document);
  }

  dispose(): void {
    this.#show(null);
    this.#document = null;
    this.#scene.background = null;
    this.#scene.backgroundNode = null;
    this.#sky?.dispose();
  }

  #setSource(document: Document): void {
    const { source } = document.environment;
    const identity = identityOf(document);
    if (identity === this.#identity) return;
    this.#identity = identity;
    this.#wanted = null;
    if (source.type === 'none') this.#show(null);
    else if (source.type === 'constant') this.#showOwn(constantMap(source.color));
    else if (isComputed(source)) {
      this.#wanted = { source, identity };
      if (!this.#computing) this.#pending.add(this.#compute(), () => {});
    } else {
      const loading =
        source.type === 'preset'
          ? this.#assets.preset(source.name)
          : this.#assets.environment(document.assets[source.asset] as Asset);
      const failed = loading.catch((error: unknown) => {
        // What did not come may be asked for again.
        if (this.#identity === identity) this.#identity = 'none';
        throw error;
      });
      this.#pending.add(failed, (texture) => {
        // Another source may have been chosen while this one was on its way.
        if (this.#identity !== identity) texture.dispose();
        else {
          this.#unit = 1;
          this.#show(texture);
        }
      });
    }
  }

  /** One at a time: of the numbers that a hand drags through, those that came last. */
  async #compute(): Promise<void> {
    this.#computing = true;
    try {
      // All that this task asks for.
      await new Promise((resolve) => setTimeout(resolve));
      for (let next = this.#wanted; next !== null; next = this.#wanted) {
        this.#wanted = null;
        const map = await this.#assets.computed(next.source);
        // While a hand drags, what was asked for a moment ago is nearer than what is shown.
        if (this.#identity === next.identity || this.#isStillOfType(next.source.type)) this.#showOwn(map);
      }
    } finally {
      this.#computing = false;
    }
  }

  #isStillOfType(type: ComputedSource['type']): boolean {
    return this.#wanted?.source.type === type;
  }

  #showOwn(map: EnvironmentMap): void {
    const { image } = this.#own ?? {};
    if (image?.width !== map.width || image.height !== map.height) this.#own = null;
    this.#own ??= emptyTexture(map);
    this.#unit = fill(this.#own, map);
    this.#show(this.#own);
  }

  #show(texture: THREE.DataTexture | null): void {
    const old = this.#texture;
    this.#texture = texture;
    if (old !== texture) {
      if (old === this.#own) this.#own = null;
      old?.dispose();
    }
    if (this.#document !== null) this.#setScene(this.#document);
  }

  #setScene({ environment, background }: Document): void {
    const scene = this.#scene;
    const intensity = environmentScale(environment) * this.#unit;
    const rotation = THREE.MathUtils.degToRad(environment.rotation);
    scene.environment = this.#texture;
    // Where BrdfMaterial looks for it.
    scene.userData.environmentSamples = environment.samples;
    scene.environmentIntensity = intensity;
    scene.environmentRotation.set(0, rotation, 0);
    const shown = background.type === 'environment';
    scene.backgroundIntensity = shown ? intensity : 1;
    scene.backgroundRotation.set(0, rotation, 0);
    scene.backgroundBlurriness = shown ? background.blur : 0;
    scene.backgroundNode = null;
    if (background.type === 'transparent') {
      scene.background = null;
      return;
    }
    if (!shown) {
      const color = scene.background instanceof THREE.Color ? scene.background : new THREE.Color();
      scene.background = color.setRGB(...background.color);
      return;
    }
    scene.background = this.#texture;
    if (environment.source.type !== 'sky' || background.blur > 0 || this.#texture === null) return;
    this.#sky ??= new SkyBackground();
    scene.backgroundNode = this.#sky.show(this.#texture, sunOf(environment), intensity);
  }
}

function identityOf({ environment: { source }, assets }: Document): Identity {
  if (source.type === 'hdr') return assets[source.asset] ?? 'none';
  // Its light is counted elsewhere, and changes no image.
  return JSON.stringify(source.type === 'sky' ? { ...source, brightness: 0 } : source);
}

type Rgb = readonly [number, number, number];

/** Small, yet an image like any other: whatever handles environments needs no special case. */
function constantMap(color: Rgb): EnvironmentMap {
  const [width, height] = [8, 4];
  const texels = new Float32Array(4 * width * height);
  for (let i = 0; i < texels.length; i += 4) texels.set([...color, 1], i);
  return { texels, width, height };
}

function emptyTexture({ width, height }: EnvironmentMap): THREE.DataTexture {
  const data = new Uint16Array(width * height * 4);
  const texture = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.HalfFloatType);
  texture.mapping = THREE.EquirectangularReflectionMapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearFilter;
  return texture;
}

/** Numbers up to this one are left as they are. */
const EVEN = 1024;

/** @returns by what the texels were divided: a power of two, so that halves are as exact as they can be */
function fill(texture: THREE.DataTexture, { texels }: EnvironmentMap): number {
  let most = 0;
  for (let i = 0; i < texels.length; i += 1) if (i % 4 !== 3) most = Math.max(most, texels[i]!);
  // Of dark skies, too, the light has all the digits of a half float.
  const unit = most > EVEN || (most > 0 && most < 1 / EVEN) ? 2 ** Math.ceil(Math.log2(most / EVEN)) : 1;
  const { data } = texture.image;
  for (let i = 0; data !== null && i < texels.length; i += 1)
    data[i] = THREE.DataUtils.toHalfFloat(i % 4 === 3 ? 1 : texels[i]! / unit);
  // What three.js has made of the former image goes with it: it looks at no version.
  texture.dispose();
  texture.needsUpdate = true;
  texture.needsPMREMUpdate = true;
  return unit;
}
