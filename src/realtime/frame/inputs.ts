/** What every effect may read: the scene's camera, and what the surfaces pass has drawn. */
import { texture, uniform } from 'three/tsl';
import {
  type Light,
  Matrix4,
  type PerspectiveCamera,
  type Texture,
  type TextureNode,
  Vector2,
  Vector3,
  Vector4,
} from 'three/webgpu';
import { SurfacesPass } from './surfaces-pass.ts';

/** What lamps see; src/realtime/effects/shadows/rows.ts says how it is read. */
export interface ShadowMaps {
  readonly atlas: Texture;
  readonly rows: Texture;
  /** Of a light that casts shadows, once the maps of this frame are drawn; null if it has none. */
  rowOf(light: Light): number | null;
}

/** Stands for settings that no later ones are. */
const CHANGED = {};

/**
 * Full-screen passes have a camera of their own, so three.js' camera nodes are of no use in them: these are
 * the scene camera's. Textures have their first row at the top, as uv() of a full-screen pass has.
 */
export class FrameInputs {
  /** Pixels of the radiance buffer, the resolution scale counted in. */
  readonly size = uniform(new Vector2(1, 1));
  /** Which part of a picture the frame is: xy its left upper corner, zw its size, as parts of the picture's. */
  readonly part = uniform(new Vector4(0, 0, 1, 1));
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
  /**
   * xy: by how much a point has moved since the last frame, in normalised device coordinates; zw: the normal of the triangle
   * itself, towards the camera, in view space, as toOctahedron() has it.
   */
  readonly velocity: TextureNode = texture(this.surfaces.velocity);
  /** Where in its pixels the scene is looked at, as a part of the frame from their middles; what is read here is of the middles. */
  readonly jitter = uniform(new Vector2());

  /** Null while lamps cast no shadows. */
  shadowMaps: ShadowMaps | null = null;

  /** Seconds from the last frame to this one: what moved, moved in that time. */
  readonly seconds = uniform(1 / 60);
  /** How many frames in a row, with the last one, were of the same scene, seen from the same place. */
  steady = 0;
  /** This frame has nothing to do with the one before: what was kept of that is of no use. */
  isCut = true;

  readonly #viewProjection = new Matrix4();
  #settings: unknown = null;
  #cuts = 0;

  /**
   * Takes the camera over; its matrices must be up to date.
   *
   * @param settings of the frame: the scene is taken to be as before if they are the same object, as documents are
   */
  begin(camera: PerspectiveCamera, width: number, height: number, settings: unknown, seconds: number): void {
    const resized = this.size.value.x !== width || this.size.value.y !== height;
    this.size.value.set(width, height);
    const { view } = camera;
    if (view?.enabled) {
      const { fullWidth, fullHeight, offsetX, offsetY } = view;
      this.part.value.set(
        offsetX / fullWidth,
        offsetY / fullHeight,
        view.width / fullWidth,
        view.height / fullHeight,
      );
    } else this.part.value.set(0, 0, 1, 1);
    this.projection.value.copy(camera.projectionMatrix);
    this.projectionInverse.value.copy(camera.projectionMatrixInverse);
    this.view.value.copy(camera.matrixWorldInverse);
    this.viewInverse.value.copy(camera.matrixWorld);
    this.cameraPosition.value.setFromMatrixPosition(camera.matrixWorld);
    this.near.value = camera.near;
    this.far.value = camera.far;
    const now = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    this.isCut = this.#settings === null || resized;
    if (this.isCut) this.#cuts += 1;
    const same = !this.isCut && settings === this.#settings && now.equals(this.#viewProjection);
    this.steady = same ? this.steady + 1 : 0;
    this.#settings = settings;
    this.previousViewProjection.value.copy(this.isCut ? now : this.#viewProjection);
    this.#viewProjection.copy(now);
    this.seconds.value = seconds;
    this.frameIndex.value += 1;
  }

  /** A number that follows on the last frame's, but after a cut. */
  get surfacesFrame(): number {
    return this.frameIndex.value + this.#cuts;
  }

  /** Something is not as it was that the settings do not tell, such as an image that has come. */
  changed(): void {
    if (this.#settings !== null) this.#settings = CHANGED;
  }

  /** What comes next is another scene. */
  cut(): void {
    this.#settings = null;
  }

  dispose(): void {
    this.surfaces.dispose();
  }
}
