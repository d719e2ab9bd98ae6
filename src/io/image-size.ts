/** As many as an image of 16,384 x 8,192 has: beyond that no GPU takes it, and memory runs out. */
export const MOST_TEXELS = 16_384 * 8192;
