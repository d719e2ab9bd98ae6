/** What every effect may read: the scene's camera, and what the surfaces pass has drawn. */
import { texture, uniform } from 'three/tsl';
import { Matrix4, type PerspectiveCamera, type TextureNode, Vector2, Vector3 } from 'three/webgpu';
import { SurfacesPass } from './surfaces-pass.ts';

/**
 * Full-screen passes have a camera of their own, so three.js' camera nodes are of no use in them: these are
 * the scene camera's. Textures have their first row at the top, as uv() of a full-screen pass has.
 */
export class FrameInputs {
  /** Pixels of the radiance buffer, the resolution scale counted in. */
  readonly size = uniform(new Vector2(1, 1));
  readonly projection = uniform(new Matrix4());
  readonly projectionInverse = uniform(new Matrix4());
  /** World to view space, and back. */
  readonly view = uniform(new Matrix4());
  readonly viewInverse = uniform(new Matrix4());
  /** World to clip space, in the frame before. */
  readonly previousViewProjection = uniform(new Matrix4());
  readonly cameraPosition = uniform(new Vector3());
  readonly near = uniform(0.1);
  readonly far = uniform(100);
  /** Counts the frames drawn: seeds of what changes from frame to frame. */
  readonly frameIndex = uniform(0, 'uint');

  readonly surfaces = new SurfacesPass();
  /** 0..1 as the depth buffer has it; 1 where nothing is. */
  readonly depth: TextureNode = texture(this.surfaces.depth);
  /** View space, xyz in -1..1; 0 where nothing is. */
  readonly normal: TextureNode = texture(this.surfaces.normal);
  /** By how much a point has moved since the last frame, in normalised device coordinates. */
  readonly velocity: TextureNode = texture(this.surfaces.velocity);

  readonly #viewProjection = new Matrix4();
  #known = false;

  /** Takes the camera over; its matrices must be up to date. */
  begin(camera: PerspectiveCamera, width: number, height: number): void {
    this.size.value.set(width, height);
    this.projection.value.copy(camera.projectionMatrix);
    this.projectionInverse.value.copy(camera.projectionMatrixInverse);
    this.view.value.copy(camera.matrixWorldInverse);
    this.viewInverse.value.copy(camera.matrixWorld);
    this.cameraPosition.value.setFromMatrixPosition(camera.matrixWorld);
    this.near.value = camera.near;
    this.far.value = camera.far;
    const now = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.previousViewProjection.value.copy(this.#known ? this.#viewProjection : now);
    this.#viewProjection.copy(now);
    this.#known = true;
    this.frameIndex.value += 1;
  }

  dispose(): void {
    this.surfaces.dispose();
  }
}
