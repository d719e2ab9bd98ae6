/**
 * The camera under the person's hand. While it is dragged only the picture's camera moves; when
 * the hand lets go the document gets the new pose, and drags in a row are one undo step.
 */
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type Box3, type PerspectiveCamera, Sphere, Spherical, Vector3 } from 'three/webgpu';
import type { Camera, Document } from '../../scene/schema.ts';
import type { DocumentStore } from '../../scene/store.ts';
import { attempt } from '../commands.ts';
import { t } from '../language/language.ts';
import { eased, type Pose, poseBetween } from './navigation/camera-path.ts';

export interface CameraControl {
  /** Where the camera is while it is moved, as the document will say. */
  pose(): Pick<Camera, 'position' | 'target'>;
  /** Takes the pose from the document: after undo, another scene, a typed number. */
  follow(document: Document): void;
  /** Moves so that all of the box is seen. @param label of the undo step */
  focus(box: Box3, label: string): void;
  /** Looks at the same point from another side. @param from the direction in which the camera then is */
  lookFrom(from: Vector3, label: string): void;
  /** One step, as by a key. */
  step(by: CameraStep): void;
  /** While something else is dragged, the camera is not. */
  hold(held: boolean): void;
  dispose(): void;
}

/** How the camera goes round what it looks at. */
export interface CameraStep {
  /** To the right, radians. */
  readonly right?: number;
  /** Towards the zenith, radians. */
  readonly up?: number;
  /** The distance becomes so many times as large. */
  readonly distance?: number;
}

const MERGE = 'camera in the viewport';
/** What it keeps from the zenith and the nadir, where it would not know which way is up; radians. */
const LEAST_POLAR = 1e-3;
/** Of a move from one pose to another. */
const MOVE_MS = 200;

export function createCameraControl(
  camera: PerspectiveCamera,
  canvas: HTMLElement,
  store: DocumentStore,
  onMove: () => void,
): CameraControl {
  const controls = new OrbitControls(camera, canvas);
  controls.zoomToCursor = true;
  controls.rotateSpeed = 0.8;
  controls.addEventListener('change', onMove);

  const pose = () => ({ position: rounded(camera.position), target: rounded(controls.target) });

  const write = (label: string) => {
    const { position, target } = pose();
    const { camera: before } = store.document;
    // A click that moves nothing is no step to be undone.
    if (String(position) === String(before.position) && String(target) === String(before.target)) return;
    attempt(t('The camera stays where it was'), () =>
      store.edit(
        label,
        (draft) => {
          draft.camera.position = position;
          draft.camera.target = target;
        },
        { merge: MERGE },
      ),
    );
  };
  controls.addEventListener('end', () => write(t('Move camera')));

  const set = ({ position, target }: Pose) => {
    controls.target.copy(target);
    camera.position.copy(position);
    controls.update();
  };

  let animation = 0;
  const stop = () => {
    cancelAnimationFrame(animation);
    animation = 0;
  };
  controls.addEventListener('start', stop);

  const follow = ({ camera: { position, target } }: Document) => {
    stop();
    set({ position: new Vector3(...position), target: new Vector3(...target) });
  };

  /** The document is there at once; the picture comes after, so that a person sees from where to where it goes. */
  const goTo = (to: Pose, label: string) => {
    stop();
    const from: Pose = { position: camera.position.clone(), target: controls.target.clone() };
    set(to);
    write(label);
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    const start = performance.now();
    const step = (now: number) => {
      const part = Math.min(1, Math.max(0, (now - start) / MOVE_MS));
      if (part === 1) follow(store.document);
      else {
        set(poseBetween(from, to, eased(part)));
        animation = requestAnimationFrame(step);
      }
      onMove();
    };
    set(from);
    animation = requestAnimationFrame(step);
  };

  return {
    pose,
    follow,
    focus(box, label) {
      const sphere = box.getBoundingSphere(new Sphere());
      if (box.isEmpty() || !(sphere.radius > 0)) return;
      const halfAngle = Math.atan(Math.tan((camera.fov * Math.PI) / 360) * Math.min(1, camera.aspect));
      const distance = (1.15 * sphere.radius) / Math.sin(halfAngle);
      const away = camera.position.clone().sub(controls.target).normalize();
      if (away.lengthSq() === 0) away.set(0, 0, 1);
      goTo({ position: sphere.center.clone().addScaledVector(away, distance), target: sphere.center }, label);
    },
    lookFrom(from, label) {
      const target = controls.target.clone();
      // A camera in what it looks at steps back a metre.
      const distance = camera.position.distanceTo(target) || 1;
      goTo({ position: target.clone().addScaledVector(from, distance), target }, label);
    },
    step({ right = 0, up = 0, distance = 1 }) {
      stop();
      const target = controls.target.clone();
      const side = new Spherical().setFromVector3(camera.position.clone().sub(target));
      side.theta += right;
      side.phi = Math.max(LEAST_POLAR, Math.min(Math.PI - LEAST_POLAR, side.phi - up));
      side.radius *= distance;
      set({ position: new Vector3().setFromSpherical(side).add(target), target });
      write(t('Move camera'));
    },
    hold(held) {
      controls.enabled = !held;
    },
    dispose: () => controls.dispose(),
  };
}

/** A tenth of a millimetre: a document that people read needs no more. */
function rounded(v: Vector3): [number, number, number] {
  // Never -0, which would be another value than the document's 0.
  const round = (x: number) => Number(x.toFixed(4)) + 0;
  return [round(v.x), round(v.y), round(v.z)];
}
