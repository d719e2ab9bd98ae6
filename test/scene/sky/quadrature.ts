import type { EnvironmentMap } from '../../../src/scene/environment-map.ts';

/** What a plane facing along a unit vector has from an image of all directions: a sum over its texels. */
export function irradiance(
  { texels, width, height }: EnvironmentMap,
  normal: readonly [number, number, number],
): [number, number, number] {
  const sum: [number, number, number] = [0, 0, 0];
  for (let y = 0; y < height; y++) {
    const [south, north] = [y, y + 1].map((edge) => Math.PI * (edge / height - 0.5)) as [number, number];
    const latitude = (south + north) / 2;
    const solidAngle = (Math.sin(north) - Math.sin(south)) * ((2 * Math.PI) / width);
    for (let x = 0; x < width; x++) {
      const longitude = 2 * Math.PI * ((x + 0.5) / width - 0.5);
      const cosine =
        Math.cos(longitude) * Math.cos(latitude) * normal[0] +
        Math.sin(latitude) * normal[1] +
        Math.sin(longitude) * Math.cos(latitude) * normal[2];
      if (cosine <= 0) continue;
      for (const c of [0, 1, 2] as const) sum[c] += texels[4 * (y * width + x) + c]! * cosine * solidAngle;
    }
  }
  return sum;
}
