/** An ordinary image as an environment: sRGB, so nothing in it is brighter than white. */

import * as THREE from 'three/webgpu';
import { srgbToLinear } from '../color/srgb.ts';
import type { TextureImage } from './assets.ts';
import { readTexels } from './texels.ts';

/** sRGB bytes as linear half floats. */
const linear = Uint16Array.from({ length: 256 }, (_, byte) =>
  THREE.DataUtils.toHalfFloat(srgbToLinear(byte / 255)),
);
const one = THREE.DataUtils.toHalfFloat(1);

export function environmentOfImage(image: TextureImage, name: string): THREE.DataTexture {
  const { bytes, width, height } = readTexels(image);
  const data = new Uint16Array(bytes.length);
  for (let i = 0; i < bytes.length; i++) data[i] = i % 4 === 3 ? one : linear[bytes[i]!]!;
  const texture = new THREE.DataTexture(data, width, height, THREE.RGBAFormat, THREE.HalfFloatType);
  texture.mapping = THREE.EquirectangularReflectionMapping;
  texture.minFilter = THREE.LinearFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.name = name;
  // Rows are from the bottom, as those of the HDR and EXR readers are.
  texture.flipY = false;
  texture.needsUpdate = true;
  return texture;
}
