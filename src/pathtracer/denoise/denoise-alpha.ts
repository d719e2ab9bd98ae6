/** The alpha that a noisy film of a transparent picture would come to: shadows on the ground are in nothing else. */
import type { Film } from '../film.ts';
import { Pace } from '../scene/pace.ts';
import { PASSES } from './denoise.ts';
import { featuresOf } from './features.ts';
import { nlMeans } from './nl-means.ts';
import { filmPlanes, type Planes } from './planes.ts';
import { boxMean, noiseScale, usableVariance } from './statistics.ts';

/** @returns null where alpha has no such noise @throws AbortError by the signal */
export async function denoiseAlpha(film: Film, signal?: AbortSignal): Promise<Float32Array | null> {
  if (film.shadowSquares.every((squares) => squares === 0)) return null;
  const pace = new Pace(signal);
  try {
    const features = featuresOf(filmPlanes(film), null, film.count);
    const shadow = film.shadow.map((sum, pixel) => sum / Math.max(1, film.count[pixel]!));
    let planes: Planes = {
      width: film.width,
      height: film.height,
      // The filter compares colours.
      channels: [shadow, shadow, shadow],
      variance: shadow.map((_, pixel) => 3 * film.shadowVariance(pixel)),
    };
    planes = usableVariance(planes, film.count);
    const scale = noiseScale(planes, features);
    planes = { ...planes, variance: planes.variance.map((x) => x * scale) };
    for (const pass of PASSES)
      planes = await nlMeans(
        { ...planes, variance: boxMean(planes.variance, film, 1) },
        { ...pass, features, pace },
      );
    return film.alpha.map((sum, pixel) => {
      const covered = sum / Math.max(1, film.count[pixel]!) + planes.channels[0]![pixel]!;
      return Math.min(1, Math.max(0, covered));
    });
  } finally {
    pace.end();
  }
}
