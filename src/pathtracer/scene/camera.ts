import { MathUtils, Matrix4, Vector3 } from 'three/webgpu';
import type { Camera } from '../../scene/schema.ts';
import { HEADER, WORDS_PER_SLOT } from './layout.ts';

/** Half the height of the 36 x 24 mm picture that f-numbers are counted for, in metres. */
const HALF_PICTURE = 0.012;

/** The radius in metres of the lens that throws the field of view onto such a picture; 0 is a pinhole. */
export function lensRadius({ fov, fStop }: Camera): number {
  if (fStop <= 0) return 0;
  const focalLength = HALF_PICTURE / Math.tan(MathUtils.degToRad(fov) / 2);
  return focalLength / fStop / 2;
}

/** The distance along the view that is in focus, in metres. */
export function focusDistance({ focusDistance: distance, position, target }: Camera): number {
  if (distance > 0) return distance;
  // Where the camera is at its target, any distance is as good.
  return Math.hypot(...position.map((p, i) => target[i]! - p)) || 1;
}

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
