/** Strokes of a brush or of abrasive along v: as `anisotropic` of a model stretches the highlight across them. */
import { count, kind, paint, share } from './kind.ts';
import { clamp, gradientNoise } from './noise.ts';

export const brushed = kind({
  title: 'Brushed',
  shape: {
    strokes: count('Strokes from one side to the other', 8, 256),
    length: share('How long the strokes are'),
    contrast: share('How much they differ'),
  },
  defaults: { strokes: 128, length: 0.8, contrast: 0.5 },
  depth: ({ strokes }) => 0.12 / strokes,
  sampler({ seed, color, strokes, length, contrast }) {
    const rows = (columns: number): number => Math.max(1, Math.round(columns * 2 ** (-1 - 6 * length)));
    return (u, v, out) => {
      let sum = 0;
      let columns = strokes;
      for (let octave = 0; octave < 4; octave++) {
        const n = rows(columns);
        sum += gradientNoise(u * columns, v * n, columns, n, seed + octave) / 2 ** (octave / 2);
        columns = Math.max(4, columns >> 1);
      }
      const stroke = 0.45 * sum;
      paint(color, 1 + 0.25 * contrast * stroke, out);
      out.height = clamp(0.5 + 0.5 * stroke);
      out.roughness = 1 + 0.9 * contrast * stroke;
    };
  },
});
