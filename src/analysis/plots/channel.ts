import { luminance } from '../../color/rec709.ts';
import type { Rgb } from './curve.ts';

/** What a plot shows of a colour. */
export const channels = ['luminance', 'red', 'green', 'blue'] as const;
export type Channel = (typeof channels)[number];

export function channelOf(rgb: Rgb, channel: Channel): number {
  const [r, g, b] = rgb;
  switch (channel) {
    case 'luminance':
      return luminance(rgb);
    case 'red':
      return r;
    case 'green':
      return g;
    case 'blue':
      return b;
  }
}
