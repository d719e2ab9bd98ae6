/** The light that comes from everywhere, and what is seen behind the scene. */
import * as THREE from 'three/webgpu';
import type { AssetLoader } from '../assets.ts';
import type { Asset, Document } from '../schema.ts';
import type { Pending } from './pending.ts';

export class EnvironmentMirror {
  readonly #scene: THREE.Scene;
  readonly #assets: AssetLoader;
  readonly #pending: Pending;
  /** What the present texture was made of. */
  #source: string | Asset = 'none';
  #texture: THREE.DataTexture | null = null;
  /** The texture of a constant environment, while there is one. */
  #constant: THREE.DataTexture | null = null;

  constructor(scene: THREE.Scene, assets: AssetLoader, pending: Pending) {
    this.#scene = scene;
    this.#assets = assets;
    this.#pending = pending;
  }

  apply(document: Document, before: Document | null): void {
    const { environment, background, assets } = document;
    if (before?.environment === environment && before.background === background && before.assets === assets)
      return;
    this.#setSource(document);
    const scene = this.#scene;
    const rotation = THREE.MathUtils.degToRad(environment.rotation);
    // Where BrdfMaterial looks for it.
    scene.userData.environmentSamples = environment.samples;
    scene.environmentIntensity = environment.intensity;
    scene.environmentRotation.set(0, rotation, 0);
    scene.backgroundIntensity = background.type === 'environment' ? environment.intensity : 1;
    scene.backgroundRotation.set(0, rotation, 0);
    scene.backgroundBlurriness = background.type === 'environment' ? background.blur : 0;
    this.#setBackground(document);
  }

  dispose(): void {
    this.#show(null);
    this.#scene.background = null;
  }

  #setSource(document: Document): void {
    const { source } = document.environment;
    const identity =
      source.type === 'hdr' ? (document.assets[source.asset] ?? 'none') : JSON.stringify(source);
    if (identity === this.#source) return;
    this.#source = identity;
    if (source.type === 'none') this.#show(null);
    else if (source.type === 'constant') this.#showConstant(source.color);
    else {
      const loading =
        source.type === 'preset'
          ? this.#assets.preset(source.name)
          : this.#assets.environment(document.assets[source.asset] as Asset);
      this.#pending.add(loading, (texture) => {
        // Another source may have been chosen while this one was on its way.
        if (this.#source !== identity) texture.dispose();
        else this.#show(texture);
      });
    }
  }

  /** A colour that is being dragged changes texels: another texture would be another shader. */
  #showConstant(color: Rgb): void {
    this.#constant ??= constantEnvironment();
    fill(this.#constant, color);
    if (this.#texture !== this.#constant) this.#show(this.#constant);
  }

  #show(texture: THREE.DataTexture | null): void {
    const old = this.#texture;
    this.#texture = texture;
    this.#scene.environment = texture;
    // The background is this texture, or the lack of one, unless it is a colour.
    if (!(this.#scene.background instanceof THREE.Color)) this.#scene.background = texture;
    if (old === this.#constant) this.#constant = null;
    old?.dispose();
  }

  #setBackground({ background }: Document): void {
    const scene = this.#scene;
    if (background.type === 'environment') {
      scene.background = this.#texture;
      return;
    }
    const color = scene.background instanceof THREE.Color ? scene.background : new THREE.Color();
    scene.background = color.setRGB(...background.color);
  }
}

type Rgb = readonly [number, number, number];

/** Small, yet an image like any other: whatever handles environments needs no special case. */
function constantEnvironment(): THREE.DataTexture {
  const [width, height] = [8, 4];
  const data = new Uint16Array(width * height * 4);
  const texture = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.HalfFloatType);
  texture.mapping = THREE.EquirectangularReflectionMapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearFilter;
  return texture;
}

function fill(texture: THREE.DataTexture, [r, g, b]: Rgb): void {
  const texel = [r, g, b, 1].map((value) => THREE.DataUtils.toHalfFloat(value));
  const { data } = texture.image;
  for (let at = 0; data !== null && at < data.length; at += 4) data.set(texel, at);
  texture.needsUpdate = true;
}
