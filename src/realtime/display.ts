/** How what a frame holds becomes colours of a screen: light, or the data behind it. */
import { log2, renderOutput, uniformArray, vec3, vec4 } from 'three/tsl';
import {
  ACESFilmicToneMapping,
  AgXToneMapping,
  Color,
  NeutralToneMapping,
  type Node,
  NoToneMapping,
  SRGBColorSpace,
  type ToneMapping,
} from 'three/webgpu';
import { COUNT_COLORS, MIDDLE_GRAY, ZONE_COLORS, ZONES_EACH_SIDE } from '../color/false-color.ts';
import type { View } from '../scene/schema.ts';

const TONE_MAPPINGS: Readonly<Record<View['toneMapping'], ToneMapping>> = {
  none: NoToneMapping,
  aces: ACESFilmicToneMapping,
  agx: AgXToneMapping,
  neutral: NeutralToneMapping,
};

/** Pixels of motion from one frame to the next that are shown as the strongest colour. */
const MOST_MOTION = 32;

export interface DisplayInputs {
  /** What the radiance is multiplied by. */
  readonly exposure: Node<'float'>;
  /** The distance in metres that is shown as half grey. */
  readonly distance: Node<'float'>;
  /** Whether pixels that nothing covers are to be seen through: what they show is multiplied by their alpha. */
  readonly transparent?: boolean;
}

type Vec4 = Node<'vec4'>;
type Float = Node<'float'>;

/** @param pixel of the radiance buffer: light in nits, or the data that is shown instead */
export function displayNode(
  show: View['show'],
  toneMapping: View['toneMapping'],
  pixel: Vec4,
  inputs: DisplayInputs,
): Node {
  switch (show) {
    case 'picture': {
      const shown = (light: Node) =>
        renderOutput(vec4(light as Node<'vec3'>, 1), TONE_MAPPINGS[toneMapping], SRGBColorSpace);
      const light = pixel.rgb.mul(inputs.exposure);
      if (!inputs.transparent) return shown(light);
      // The colour of what covers the pixel, not of that over black.
      const alpha = pixel.a.clamp(0, 1).toVar();
      const color = shown(light.div(alpha.max(1e-4))) as Node<'vec4'>;
      return vec4(color.rgb.mul(alpha), alpha);
    }
    case 'luminance':
      return vec4(falseColor(pixel, inputs.exposure), 1);
    case 'depth':
      // 1 at the lens, 1/2 in focus, 0 far away and where nothing is.
      return vec4(vec3(inputs.distance.div(inputs.distance.add(pixel.r)).mul(pixel.a)), 1);
    case 'shadingNormals':
    case 'meshNormals':
    case 'tangents':
      return vec4(pixel.rgb.mul(0.5).add(0.5).mul(pixel.a), 1);
    case 'textureCoordinates':
      return vec4(pixel.rg.fract().mul(pixel.a), 0, 1);
    case 'motion':
      return vec4(pixel.rg.div(2 * MOST_MOTION).add(0.5), 0.5, 1);
    case 'ambientOcclusion':
      return vec4(vec3(pixel.r.mul(pixel.a)), 1);
    case 'overdraw':
    case 'cascades':
    case 'lights':
      return vec4(palette(COUNT_COLORS, pixel.r.add(0.5)), 1);
  }
}

function falseColor(pixel: Vec4, exposure: Float): Node<'vec3'> {
  const nits = pixel.r.mul(0.2126).add(pixel.g.mul(0.7152)).add(pixel.b.mul(0.0722));
  // Of black a number that is far below the darkest zone, not the logarithm of 0.
  const stops = log2(
    nits
      .mul(exposure)
      .div(MIDDLE_GRAY)
      .max(2 ** -40),
  );
  return palette(ZONE_COLORS, stops.add(0.5 + ZONES_EACH_SIDE) as Float);
}

/** The colour with the whole part of this number; the first and the last stand for all beyond. */
function palette(colors: readonly (readonly [number, number, number])[], number: Float): Node<'vec3'> {
  const values = uniformArray(
    colors.map(([r, g, b]) => new Color(r / 255, g / 255, b / 255)),
    'color',
  );
  const index = number
    .floor()
    .clamp(0, colors.length - 1)
    .toInt();
  return values.element(index) as unknown as Node<'vec3'>;
}

/** What of a frame has a counterpart in a path traced picture. */
export const showsLight = (show: View['show']): boolean => show === 'picture' || show === 'luminance';
