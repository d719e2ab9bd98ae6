/** A direction or a point: x, y, z. */
export type Vec3 = readonly [number, number, number];

/** The direction at the angle acos(cosTheta) to +z and the azimuth phi (radians) from +x. */
export function direction(cosTheta: number, phi: number): Vec3 {
  const sinTheta = Math.sqrt(Math.max(0, 1 - cosTheta * cosTheta));
  return [sinTheta * Math.cos(phi), sinTheta * Math.sin(phi), cosTheta];
}
