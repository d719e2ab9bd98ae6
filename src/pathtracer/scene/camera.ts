import { MathUtils, Matrix4, Vector3 } from 'three/webgpu';
import { focusDistance, lensRadius } from '../../scene/lens.ts';
import type { Camera } from '../../scene/schema.ts';
import { HEADER, WORDS_PER_SLOT } from './layout.ts';

/** Writes the camera of a rendering of `width` by `height` pixels into the scene's memory. */
export function writeCamera(
  words: Uint32Array<ArrayBuffer>,
  camera: Camera,
  { width, height }: { width: number; height: number },
): void {
  // As three.js turns cameras: their -z axis towards the target.
  const { position, target, fov, apertureBlades } = camera;
  const up = new Vector3(0, 1, 0);
  const frame = new Matrix4().lookAt(new Vector3(...position), new Vector3(...target), up);
  const [x, y, z] = [new Vector3(), new Vector3(), new Vector3()];
  frame.extractBasis(x, y, z);
  const halfHeight = Math.tan(MathUtils.degToRad(fov) / 2);
  x.multiplyScalar((halfHeight * width) / height);
  y.multiplyScalar(halfHeight);
  z.negate();
  const floats = new Float32Array(words.buffer, words.byteOffset, words.length);
  floats.set([...position, lensRadius(camera)], HEADER.cameraPosition * WORDS_PER_SLOT);
  floats.set([...x.toArray(), focusDistance(camera)], HEADER.cameraRight * WORDS_PER_SLOT);
  floats.set([...y.toArray(), apertureBlades < 3 ? 0 : apertureBlades], HEADER.cameraUp * WORDS_PER_SLOT);
  floats.set([...z.toArray(), 0], HEADER.cameraForward * WORDS_PER_SLOT);
}

/** What is drawn from to estimate direct light, by its number in the scene's memory. */
export const STRATEGIES = { mis: 0, brdf: 1, light: 2 } as const;

export interface RenderSettings {
  readonly width: number;
  readonly height: number;
  /** The most surfaces and scatterings of a path. */
  readonly maxDepth: number;
  readonly seed: number;
  readonly strategy: keyof typeof STRATEGIES;
  /** The most radiance of a sample of indirect light, per channel; 0 does not bound it. */
  readonly clamp: number;
}

/** Writes the settings of a rendering into the scene's memory. */
export function writeSettings(words: Uint32Array<ArrayBuffer>, settings: RenderSettings): void {
  const { width, height, maxDepth, seed, strategy, clamp } = settings;
  const floats = new Float32Array(words.buffer, words.byteOffset, words.length);
  words.set([width, height, maxDepth, seed], HEADER.image * WORDS_PER_SLOT);
  words.set([STRATEGIES[strategy], 0, 0, 0], HEADER.strategy * WORDS_PER_SLOT);
  floats.set([clamp, 0, 0, 0], HEADER.clamp * WORDS_PER_SLOT);
}
