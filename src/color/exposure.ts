/**
 * How bright a picture is shown: by hand, by the camera's settings, or by a meter. What comes out is in EV: the radiance
 * is multiplied by 2 to this power.
 */
import { MIDDLE_GRAY } from './false-color.ts';
import { luminance } from './rec709.ts';

/** What a camera says of the light that reaches its sensor. */
export interface CameraExposure {
  /** 0 is a pinhole. */
  readonly fStop: number;
  /** s */
  readonly shutter: number;
  readonly iso: number;
}

export interface ExposureSettings {
  readonly exposureMode?: 'manual' | 'camera' | 'auto';
  /** EV, added to what camera or meter say. */
  readonly exposure: number;
}

/** A pinhole has no f-number of use; the "sunny 16" rule's stands for it. */
const PINHOLE_F_STOP = 16;

/**
 * The luminance that is shown as 1, of a camera of which EV100 = 0: 78 / (100 q) with q = 0.65, by the saturation-based
 * speed of ISO 12232. S. Lagarde and C. de Rousiers, 2014, "Moving Frostbite to PBR", section 5.1.
 */
const SATURATION_NITS = 1.2;

/** The exposure value at ISO 100: log2(N^2 / t * 100 / S); the same source. */
export function ev100({ fStop, shutter, iso }: CameraExposure): number {
  const n = fStop > 0 ? fStop : PINHOLE_F_STOP;
  return Math.log2(((n * n) / shutter) * (100 / iso));
}

/** What a camera with this EV100 multiplies the radiance by, in EV. */
export function exposureOfEv100(value: number): number {
  return -value - Math.log2(SATURATION_NITS);
}

/** The EV100 of a camera that multiplies the radiance by 2 to the power `exposure`. */
export function ev100OfExposure(exposure: number): number {
  return -exposure - Math.log2(SATURATION_NITS);
}

/** @param metered what meter() said; of no interest but in the mode 'auto' */
export function exposureFor(
  { exposureMode = 'manual', exposure }: ExposureSettings,
  camera: CameraExposure | undefined,
  metered: number,
): number {
  if (exposureMode === 'auto') return exposure + metered;
  if (exposureMode === 'camera' && camera) return exposure + exposureOfEv100(ev100(camera));
  return exposure;
}

/** The shares of the pixels, sorted by luminance, between which the meter looks: neither shade nor lamps count. */
const METERED = [0.5, 0.95] as const;
/** nits; what is darker gives no light to expose by: the black behind the objects. */
const DARKEST = 1e-6;
/** EV; further than this no picture is pushed. */
const MOST = 32;

/**
 * The exposure in EV that shows the mean of the log luminances between two percentiles as middle grey; 0 for a black
 * picture. @param luminances nits, of the parts of a picture
 */
export function meter(luminances: Float32Array): number {
  const lit = luminances.filter((nits) => nits > DARKEST && nits < Number.POSITIVE_INFINITY).sort();
  if (lit.length === 0) return 0;
  const from = Math.floor(METERED[0] * lit.length);
  const to = Math.max(from + 1, Math.ceil(METERED[1] * lit.length));
  let sum = 0;
  for (let i = from; i < to; i++) sum += Math.log2(lit[i]!);
  const exposure = Math.log2(MIDDLE_GRAY) - sum / (to - from);
  return Math.min(MOST, Math.max(-MOST, exposure));
}

/** A picture is metered in so many cells along each side, each by its mean. */
export const METER_CELLS = 64;

/** The mean luminances of a picture's cells, as the GPU finds them for its own. @param radiance linear RGB */
export function cellLuminances(radiance: Float32Array, width: number, height: number): Float32Array {
  const columns = Math.min(METER_CELLS, width);
  const rows = Math.min(METER_CELLS, height);
  const sums = new Float32Array(columns * rows);
  const counts = new Float32Array(columns * rows);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = 3 * (y * width + x);
      const cell = Math.floor((y * rows) / height) * columns + Math.floor((x * columns) / width);
      sums[cell]! += luminance([radiance[i]!, radiance[i + 1]!, radiance[i + 2]!]);
      counts[cell]! += 1;
    }
  }
  return sums.map((sum, cell) => sum / counts[cell]!);
}

/** Seconds in which an eye, or a camera's meter, does most of the way. Towards the dark it takes longer. */
const TO_BRIGHT_S = 0.3;
const TO_DARK_S = 0.6;
/** EV; nearer than this nobody sees a difference. */
const ADAPTED = 0.01;

/** The exposure on the way to what the meter says, `seconds` later. */
export function adapted(from: number, to: number, seconds: number): number {
  const next = to + (from - to) * Math.exp(-seconds / (to < from ? TO_BRIGHT_S : TO_DARK_S));
  return Math.abs(next - to) < ADAPTED ? to : next;
}
