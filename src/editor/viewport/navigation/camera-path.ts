/** The way of a camera from one pose to another, round what it looks at. */
import { MathUtils, Spherical, Vector3 } from 'three/webgpu';

export interface Pose {
  readonly position: Vector3;
  readonly target: Vector3;
}

/**
 * Turns about the target that moves along, the shorter way, and changes the distance by equal factors in equal times.
 *
 * @param part 0..1
 */
export function poseBetween(from: Pose, to: Pose, part: number): Pose {
  const [a, b] = [from, to].map(({ position, target }) =>
    new Spherical().setFromVector3(position.clone().sub(target)),
  ) as [Spherical, Spherical];
  // A camera in what it looks at has no direction to turn from.
  if (a.radius === 0 || b.radius === 0) return to;
  const turn = thetaOf(b) - thetaOf(a);
  const shorter = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
  const arm = new Vector3().setFromSphericalCoords(
    a.radius * (b.radius / a.radius) ** part,
    MathUtils.lerp(a.phi, b.phi, part),
    thetaOf(a) + shorter * part,
  );
  const target = from.target.clone().lerp(to.target, part);
  return { position: target.clone().add(arm), target };
}

/** Straight above or below there is none of its own: cameras there have x to the right, as at 0. */
const thetaOf = ({ phi, theta }: Spherical): number => (Math.sin(phi) < 1e-4 ? 0 : theta);

/** Slow at both ends (Perlin's smoothstep). */
export const eased = (part: number): number => MathUtils.smoothstep(part, 0, 1);
