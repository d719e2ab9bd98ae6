/**
 * From linear radiance to the sRGB values of a screen, on the CPU: exposure, tone mapping, encoding. The numbers are
 * three.js's, which the interactive renderer's output pass uses; a test holds the two together.
 */
import { ZONE_COLORS, zoneIndex } from './false-color.ts';
import { type Matrix3, type Triple, transform } from './matrix.ts';
import { luminance } from './rec709.ts';
import { linearToSrgb } from './srgb.ts';

export const TONE_MAPPINGS = ['none', 'aces', 'agx', 'neutral'] as const;
export type ToneMapping = (typeof TONE_MAPPINGS)[number];

export interface Display {
  /** In EV: the radiance is multiplied by 2 to this power. */
  readonly exposure: number;
  readonly toneMapping: ToneMapping;
  /** Shows luminance in false colours instead. */
  readonly falseColor?: boolean;
}

/**
 * RGBA bytes in sRGB, alpha not multiplied in.
 *
 * @param radiance linear RGB
 * @param alpha of each pixel, by which its radiance is multiplied; left out, all is opaque
 */
export function displayPixels(
  radiance: Float32Array,
  display: Display,
  alpha?: ArrayLike<number>,
): Uint8ClampedArray {
  const { exposure, toneMapping, falseColor } = display;
  if (falseColor) return falseColorPixels(radiance, exposure);
  const exposed = 2 ** exposure;
  const map = MAPPINGS[toneMapping];
  const pixels = new Uint8ClampedArray((radiance.length / 3) * 4).fill(255);
  for (let i = 0; i < radiance.length / 3; i++) {
    const covered = alpha?.[i] ?? 1;
    // Where nothing is, what shines through is no colour.
    const scale = covered > 0 ? exposed / covered : 0;
    const [r, g, b] = map([
      radiance[3 * i]! * scale,
      radiance[3 * i + 1]! * scale,
      radiance[3 * i + 2]! * scale,
    ]);
    pixels[4 * i] = 255 * linearToSrgb(r);
    pixels[4 * i + 1] = 255 * linearToSrgb(g);
    pixels[4 * i + 2] = 255 * linearToSrgb(b);
    pixels[4 * i + 3] = 255 * covered;
  }
  return pixels;
}

function falseColorPixels(radiance: Float32Array, exposure: number): Uint8ClampedArray {
  const pixels = new Uint8ClampedArray((radiance.length / 3) * 4).fill(255);
  for (let i = 0; i < radiance.length / 3; i++) {
    const nits = luminance([radiance[3 * i]!, radiance[3 * i + 1]!, radiance[3 * i + 2]!]);
    pixels.set(ZONE_COLORS[zoneIndex(nits, exposure)]!, 4 * i);
  }
  return pixels;
}

const MAPPINGS: Readonly<Record<ToneMapping, (color: Triple) => Triple>> = {
  none: (color) => color,
  aces,
  agx,
  neutral,
};

const clamp = (x: number): number => Math.min(1, Math.max(0, x));
const each = ([r, g, b]: Triple, f: (x: number) => number): Triple => [f(r), f(g), f(b)];

/** S. Hill's fit of the Academy's reference and output transforms (RRT and ODT). */
function aces(color: Triple): Triple {
  // 0.6 makes it as bright as the others.
  const fitted = each(
    transform(
      ACES_INPUT,
      each(color, (x) => x / 0.6),
    ),
    (x) => (x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.432951) + 0.238081),
  );
  return each(transform(ACES_OUTPUT, fitted), clamp);
}

/** Linear sRGB to AP1 with the RRT's saturation. */
const ACES_INPUT: Matrix3 = [
  [0.59719, 0.35458, 0.04823],
  [0.076, 0.90834, 0.01566],
  [0.0284, 0.13383, 0.83777],
];
/** The ODT's saturation and AP1 to linear sRGB. */
const ACES_OUTPUT: Matrix3 = [
  [1.60475, -0.53108, -0.07367],
  [-0.10208, 1.10813, -0.00605],
  [-0.00327, -0.07276, 1.07602],
];

/** T. Sobotka's AgX, its curve as B. Wrensch's polynomial, between Rec. 2020 primaries as in Blender. */
function agx(color: Triple): Triple {
  const [low, high] = [-12.47393, 4.026069];
  const inset = transform(AGX_INSET, transform(SRGB_TO_REC2020, color));
  const curved = each(inset, (x) => agxCurve(clamp((Math.log2(Math.max(x, 1e-10)) - low) / (high - low))));
  const linear = each(transform(AGX_OUTSET, curved), (x) => Math.max(0, x) ** 2.2);
  return each(transform(REC2020_TO_SRGB, linear), clamp);
}

const agxCurve = (x: number): number =>
  (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x - 0.00232;

const SRGB_TO_REC2020: Matrix3 = [
  [0.6274, 0.3293, 0.0433],
  [0.0691, 0.9195, 0.0113],
  [0.0164, 0.088, 0.8956],
];
const REC2020_TO_SRGB: Matrix3 = [
  [1.6605, -0.5876, -0.0728],
  [-0.1246, 1.1329, -0.0083],
  [-0.0182, -0.1006, 1.1187],
];
const AGX_INSET: Matrix3 = [
  [0.856627153315983, 0.0951212405381588, 0.0482516061458583],
  [0.137318972929847, 0.761241990602591, 0.101439036467562],
  [0.11189821299995, 0.0767994186031903, 0.811302368396859],
];
const AGX_OUTSET: Matrix3 = [
  [1.1271005818144368, -0.11060664309660323, -0.016493938717834573],
  [-0.1413297634984383, 1.157823702216272, -0.016493938717834257],
  [-0.14132976349843826, -0.11060664309660294, 1.2519364065950405],
];

/** Khronos PBR Neutral tone mapper, 2024. */
function neutral(color: Triple): Triple {
  const start = 0.8 - 0.04;
  const least = Math.min(...color);
  const offset = least < 0.08 ? least - 6.25 * least * least : 0.04;
  const shifted = each(color, (x) => x - offset);
  const peak = Math.max(...shifted);
  if (peak < start) return shifted;
  const range = 1 - start;
  const newPeak = 1 - (range * range) / (peak + range - start);
  const white = 1 - 1 / (0.15 * (peak - newPeak) + 1);
  return each(shifted, (x) => ((x * newPeak) / peak) * (1 - white) + newPeak * white);
}
