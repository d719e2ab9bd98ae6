/** What lights the air: the scene's lamps as rows of a texture, written anew for each frame, and the mean of all else. */
import {
  type AmbientLight,
  Color,
  DataTexture,
  FloatType,
  type HemisphereLight,
  type Light,
  NearestFilter,
  RGBAFormat,
  type Scene,
  type Texture,
} from 'three/webgpu';
import { isLamp, LAMP_TEXELS, writeLamp } from '../../../lights/lamp-row.ts';
import type { ShadowMaps } from '../../frame/inputs.ts';
import { meanRadiance } from './mean-radiance.ts';

/** Where a row has the number of its shadows' row, or -1. */
const SHADOW_ROW = 4 * 4 + 3;

export class AirLamps {
  texture = rows(4);
  count = 0;
  /** Radiance from everywhere, over all directions. */
  readonly ambient = new Color();

  /** @param scene its world matrices are up to date */
  update(scene: Scene, shadows: ShadowMaps | null): void {
    const lamps: Light[] = [];
    this.ambient.setRGB(0, 0, 0);
    scene.traverseVisible((object) => {
      const light = object as Light;
      if (!light.isLight) return;
      if (isLamp(light)) lamps.push(light);
      else this.#addAmbient(light);
    });
    const { environment, environmentIntensity } = scene;
    if (environment) this.ambient.add(meanRadiance(environment).clone().multiplyScalar(environmentIntensity));
    this.count = lamps.length;
    let capacity = this.texture.image.height;
    while (capacity < lamps.length) capacity *= 4;
    if (capacity !== this.texture.image.height) {
      this.texture.dispose();
      this.texture = rows(capacity);
    }
    const data = this.texture.image.data as Float32Array;
    for (const [i, light] of lamps.entries()) {
      const at = 4 * LAMP_TEXELS * i;
      writeLamp(light, data, at);
      data[at + SHADOW_ROW] = (light.castShadow ? shadows?.rowOf(light) : null) ?? -1;
    }
    this.texture.needsUpdate = true;
  }

  /** three.js counts light from everywhere as irradiance, pi times its radiance. */
  #addAmbient(light: Light): void {
    const add = (color: Color, share: number) =>
      this.ambient.add(color.clone().multiplyScalar((share * light.intensity) / Math.PI));
    const { isAmbientLight } = light as Partial<AmbientLight>;
    const { isHemisphereLight, groundColor } = light as Partial<HemisphereLight>;
    if (isAmbientLight) add(light.color, 1);
    if (!isHemisphereLight) return;
    add(light.color, 0.5);
    add(groundColor as Color, 0.5);
  }
}

function rows(count: number): DataTexture {
  const data = new Float32Array(4 * LAMP_TEXELS * count);
  const texture: DataTexture & Texture = new DataTexture(data, LAMP_TEXELS, count, RGBAFormat, FloatType);
  texture.name = 'lamps in the air';
  texture.minFilter = NearestFilter;
  texture.magFilter = NearestFilter;
  return texture;
}
