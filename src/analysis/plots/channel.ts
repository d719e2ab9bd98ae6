import type { Rgb } from './curve.ts';

/** What a plot shows of a colour. */
export const channels = ['luminance', 'red', 'green', 'blue'] as const;
export type Channel = (typeof channels)[number];

/** The luminance is that of linear Rec. 709 (ITU-R BT.709-6, item 3.2). */
export function channelOf([r, g, b]: Rgb, channel: Channel): number {
  switch (channel) {
    case 'luminance':
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    case 'red':
      return r;
    case 'green':
      return g;
    case 'blue':
      return b;
  }
}
