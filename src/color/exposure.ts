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

/** Of a picture's half: cells this far from the middle count by exp(-1/2). Cameras call it centre-weighted. */
const CENTRE = 0.5;

/**
 * The exposure in EV that shows the mean of the log luminances between two percentiles as middle grey; 0 for a black
 * picture.
 *
 * @param cells luminances in nits, row by row
 * @param columns of cells; the middle of the picture counts more than its borders
 */
export function meter(cells: Float32Array, columns: number): number {
  const rows = cells.length / columns;
  const lit = [...cells.keys()].filter((i) => cells[i]! > DARKEST && cells[i]! < Number.POSITIVE_INFINITY);
  if (lit.length === 0) return 0;
  lit.sort((a, b) => cells[a]! - cells[b]!);
  const weights = lit.map((i) => {
    const x = (2 * ((i % columns) + 0.5)) / columns - 1;
    const y = (2 * (Math.floor(i / columns) + 0.5)) / rows - 1;
    return Math.exp((-0.5 * (x * x + y * y)) / CENTRE ** 2);
  });
  const total = weights.reduce((sum, weight) => sum + weight, 0);
  const [from, to] = METERED.map((share) => share * total) as [number, number];
  let [passed, sum] = [0, 0];
  for (const [k, i] of lit.entries()) {
    const next = passed + weights[k]!;
    // The part of the cell's weight that lies between the percentiles.
    sum += Math.max(0, Math.min(next, to) - Math.max(passed, from)) * Math.log2(cells[i]!);
    passed = next;
  }
  const exposure = Math.log2(MIDDLE_GRAY) - sum / (to - from);
  return Math.min(MOST, Math.max(-MOST, exposure));
}

/** A picture is metered in so many cells along each side, each by its mean. */
export const METER_CELLS = 64;

/** What a meter says of a picture. @param radiance linear RGB */
export function meterPicture(radiance: Float32Array, width: number, height: number): number {
  return meter(cellLuminances(radiance, width, height), Math.min(METER_CELLS, width));
}

/** The mean luminances of a picture's cells, as the GPU finds them for its own. */
function cellLuminances(radiance: Float32Array, width: number, height: number): Float32Array {
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
