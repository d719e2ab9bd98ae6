/** The lens before the picture: what the camera's fields mean for every renderer. */
import type { Camera } from './schema.ts';

/** In metres: of the lens that throws the field of view onto a sensor of this height. */
export function focalLength({ fov, sensorHeight }: Pick<Camera, 'fov' | 'sensorHeight'>): number {
  return sensorHeight / 1000 / (2 * Math.tan((fov * Math.PI) / 360));
}

/** The vertical field of view in degrees. @param length focal length in metres */
export function fieldOfView(length: number, sensorHeight: number): number {
  return (360 / Math.PI) * Math.atan(sensorHeight / 1000 / (2 * length));
}

/** The radius of the aperture in metres; 0 is a pinhole. */
export function lensRadius(camera: Pick<Camera, 'fov' | 'sensorHeight' | 'fStop'>): number {
  return camera.fStop <= 0 ? 0 : focalLength(camera) / camera.fStop / 2;
}

/** The distance along the view that is in focus, in metres. */
export function focusDistance({
  focusDistance: distance,
  position,
  target,
}: Pick<Camera, 'focusDistance' | 'position' | 'target'>): number {
  if (distance > 0) return distance;
  // Where the camera is at its target, any distance is as good.
  return Math.hypot(...position.map((p, i) => target[i]! - p)) || 1;
}
