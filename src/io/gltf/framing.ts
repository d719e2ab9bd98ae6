/** Where a camera stands to see all of a model. */
import type { Camera } from '../../scene/schema.ts';
import { cameraSchema } from '../../scene/stage-schema.ts';

type Vector = readonly [number, number, number];

export interface Bounds {
  min: [number, number, number];
  max: [number, number, number];
}

/** From the front, a little from the right and above, as things are shown that one can take into the hand. */
const FROM: Vector = [0.45, 0.3, 0.84];
/** Air around the model. */
const MARGIN = 1.05;

/** @returns the camera as it is where no camera can stand: the model is larger than a document's world */
export function framed(camera: Camera, { min, max }: Bounds): Camera {
  const center = min.map((value, axis) => (value + max[axis]!) / 2) as [number, number, number];
  const radius = Math.max(1e-6, Math.hypot(...max.map((value, axis) => value - min[axis]!)) / 2);
  const fov = 35;
  const distance = (MARGIN * radius) / Math.sin((fov * Math.PI) / 360);
  const length = Math.hypot(...FROM);
  const near = Math.min(1e5, Math.max(1e-4, (distance - radius) / 20));
  const seeing: Camera = {
    ...camera,
    fov,
    target: center,
    position: center.map((value, axis) => value + (FROM[axis]! / length) * distance) as [
      number,
      number,
      number,
    ],
    near,
    far: Math.min(1e7, Math.max(2 * near, distance + 20 * radius)),
  };
  return cameraSchema.safeParse(seeing).success ? seeing : camera;
}
