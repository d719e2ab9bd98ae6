/** Colour arithmetic of the picker. Documents hold linear Rec. 709; people pick in sRGB. */

import { linearToSrgb, srgbToLinear } from '../../color/srgb.ts';

export type Rgb = readonly [number, number, number];

export function toSrgb([r, g, b]: Rgb): Rgb {
  return [linearToSrgb(r), linearToSrgb(g), linearToSrgb(b)];
}

/** Rounded so that a document stays readable; finer than a 16-bit channel. */
export function toLinear([r, g, b]: Rgb): Rgb {
  const round = (c: number) => Number(srgbToLinear(c).toFixed(6));
  return [round(r), round(g), round(b)];
}

/** CSS colour of a linear one; values above 1 are clamped, as the screen would. */
export function cssColor(linear: Rgb): string {
  const [r, g, b] = toSrgb(linear).map((c) => Math.round(Math.min(1, Math.max(0, c)) * 255));
  return `rgb(${r} ${g} ${b})`;
}

export function toHex(linear: Rgb): string {
  const hex = toSrgb(linear).map((c) =>
    Math.round(Math.min(1, Math.max(0, c)) * 255)
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${hex.join('')}`;
}

/** `#rgb`, `#rrggbb`, with or without the hash; null for anything else. */
export function fromHex(text: string): Rgb | null {
  const match = /^#?([0-9a-f]{3}|[0-9a-f]{6})$/i.exec(text.trim());
  const digits = match?.[1];
  if (!digits) return null;
  const size = digits.length / 3;
  const channel = (i: number) => {
    const part = digits.slice(i * size, i * size + size);
    return Number.parseInt(size === 1 ? part + part : part, 16) / 255;
  };
  return toLinear([channel(0), channel(1), channel(2)]);
}

/** Hue 0..360, saturation and value 0..1, of an sRGB colour. */
export function toHsv([r, g, b]: Rgb): Rgb {
  const max = Math.max(r, g, b);
  const d = max - Math.min(r, g, b);
  let hue = 0;
  if (d > 0) {
    if (max === r) hue = ((g - b) / d + 6) % 6;
    else if (max === g) hue = (b - r) / d + 2;
    else hue = (r - g) / d + 4;
  }
  return [hue * 60, max > 0 ? d / max : 0, max];
}

export function fromHsv([hue, s, v]: Rgb): Rgb {
  const channel = (n: number) => {
    const k = (n + hue / 60) % 6;
    return v - v * s * Math.max(0, Math.min(k, 4 - k, 1));
  };
  return [channel(5), channel(3), channel(1)];
}
