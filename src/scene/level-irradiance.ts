/** What an image of all directions sheds on level ground. */
import type { EnvironmentMap } from './environment-map.ts';

type Rgb = [number, number, number];

/** Steps from the horizon to the zenith at least, and for each row of the image. */
const LEAST_STEPS = 256;
const STEPS_PER_ROW = 4;

/**
 * The irradiance from above over pi: the radiance of an even sky that gives as much. Exact for an even image; else within what
 * the steps leave of the linear course between two rows.
 *
 * @param hasHorizon whether rows are not mixed at the horizon, as in a sky that is computed
 */
export function levelRadiance(map: EnvironmentMap, hasHorizon: boolean): Rgb {
  const { height } = map;
  const rows = rowMeans(map);
  const least = hasHorizon ? height / 2 : 0;
  const steps = Math.max(LEAST_STEPS, STEPS_PER_ROW * height);
  const sum: Rgb = [0, 0, 0];
  for (let i = 0; i < steps; i++) {
    // Even steps of sin^2 of the elevation have even shares of the irradiance.
    const elevation = Math.asin(Math.sqrt((i + 0.5) / steps));
    const at = (elevation / Math.PI + 0.5) * height - 0.5;
    const low = Math.floor(at);
    const row = (y: number) => rows[Math.min(Math.max(y, least), height - 1)]!;
    for (let c = 0; c < 3; c++) sum[c]! += row(low)[c]! + (at - low) * (row(low + 1)[c]! - row(low)[c]!);
  }
  return sum.map((total) => total / steps) as Rgb;
}

function rowMeans({ texels, width, height }: EnvironmentMap): Rgb[] {
  return Array.from({ length: height }, (_, y) => {
    const sum: Rgb = [0, 0, 0];
    for (let i = 4 * width * y; i < 4 * width * (y + 1); i += 4)
      for (let c = 0; c < 3; c++) sum[c]! += texels[i + c]! / width;
    return sum;
  });
}
