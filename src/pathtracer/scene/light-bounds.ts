/**
 * Where and in which directions a group of lights shines: A. Conty Estevez and C. Kulla, 2018, "Importance Sampling of
 * Many Lights with Adaptive Tree Splitting", section 4.1; as in M. Pharr, W. Jakob and G. Humphreys, 2023, "Physically
 * Based Rendering", 4th edition, section 12.6.3.
 */

type Vector = readonly [number, number, number];

export type Box = readonly [number, number, number, number, number, number];

export interface LightBounds {
  /** Minimum and maximum. */
  readonly box: Box;
  /** Axis of the cone that holds the normals of all emitters, of length 1. */
  readonly axis: Vector;
  /** Half angle of that cone. */
  readonly cosNormals: number;
  /** The angle from a normal beyond which its emitter is dark. */
  readonly cosEmission: number;
  /** The intensity, in cd, of what shines straight at one, times pi: the power of a Lambertian emitter. */
  readonly power: number;
  readonly twoSided: boolean;
}

const clampedAcos = (cosine: number): number => Math.acos(Math.min(Math.max(cosine, -1), 1));
const cross = (a: Vector, b: Vector): [number, number, number] => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** The cone around two cones; with a cosine of -1 it is all directions. */
function uniteCones(a: Vector, cosA: number, b: Vector, cosB: number): { axis: Vector; cosine: number } {
  // Of many lights the cone soon is everything.
  if (cosA <= -1) return { axis: a, cosine: -1 };
  if (cosB <= -1) return { axis: b, cosine: -1 };
  const [thetaA, thetaB] = [clampedAcos(cosA), clampedAcos(cosB)];
  // Exact for small angles too, where the arc cosine is not.
  const between =
    2 *
    Math.atan2(
      Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),
      Math.hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]),
    );
  if (Math.min(between + thetaB, Math.PI) <= thetaA) return { axis: a, cosine: cosA };
  if (Math.min(between + thetaA, Math.PI) <= thetaB) return { axis: b, cosine: cosB };
  const theta = (thetaA + between + thetaB) / 2;
  const normal = cross(a, b);
  const sine = Math.hypot(...normal);
  if (theta >= Math.PI || sine === 0) return { axis: a, cosine: -1 };
  // a turned towards b.
  const turn = theta - thetaA;
  const side = cross(normal, a);
  const axis = [0, 1, 2].map((i) => Math.cos(turn) * a[i]! + (Math.sin(turn) / sine) * side[i]!);
  const length = Math.hypot(...axis);
  return { axis: axis.map((x) => x / length) as unknown as Vector, cosine: Math.cos(theta) };
}

export function uniteLights(a: LightBounds | null, b: LightBounds | null): LightBounds | null {
  if (a === null || b === null) return a ?? b;
  const { axis, cosine } = uniteCones(a.axis, a.cosNormals, b.axis, b.cosNormals);
  return {
    box: [
      Math.min(a.box[0], b.box[0]),
      Math.min(a.box[1], b.box[1]),
      Math.min(a.box[2], b.box[2]),
      Math.max(a.box[3], b.box[3]),
      Math.max(a.box[4], b.box[4]),
      Math.max(a.box[5], b.box[5]),
    ],
    axis,
    cosNormals: cosine,
    cosEmission: Math.min(a.cosEmission, b.cosEmission),
    power: a.power + b.power,
    twoSided: a.twoSided || b.twoSided,
  };
}

/**
 * The measure of how badly a group is bounded, M_A M_Omega times power (Conty Estevez and Kulla, equations 2 and 3).
 *
 * @param elongation the regularisation K_r of thin boxes, section 4.4
 */
export function groupCost({ box, cosNormals, cosEmission, power }: LightBounds, elongation: number): number {
  const [thetaO, thetaE] = [clampedAcos(cosNormals), clampedAcos(cosEmission)];
  const thetaW = Math.min(thetaO + thetaE, Math.PI);
  const sinO = Math.sin(thetaO);
  const directions =
    2 * Math.PI * (1 - cosNormals) +
    (Math.PI / 2) * (2 * thetaW * sinO - Math.cos(thetaO - 2 * thetaW) - 2 * thetaO * sinO + cosNormals);
  const [x, y, z] = [box[3] - box[0], box[4] - box[1], box[5] - box[2]];
  return power * directions * elongation * 2 * (x * y + y * z + z * x);
}
