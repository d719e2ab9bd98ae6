/**
 * The camera under the person's hand. While it is dragged only the picture's camera moves; when
 * the hand lets go the document gets the new pose, and drags in a row are one undo step.
 */
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { type Box3, type PerspectiveCamera, Sphere, type Vector3 } from 'three/webgpu';
import type { Camera, Document } from '../../scene/schema.ts';
import type { DocumentStore } from '../../scene/store.ts';
import { attempt } from '../commands.ts';
import { t } from '../language/language.ts';

export interface CameraControl {
  /** Where the camera is while it is moved, as the document will say. */
  pose(): Pick<Camera, 'position' | 'target'>;
  /** Takes the pose from the document: after undo, another scene, a typed number. */
  follow(document: Document): void;
  /** Moves so that all of the box is seen. */
  focus(box: Box3, name: string): void;
  dispose(): void;
}

const MERGE = 'camera in the viewport';

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

  const follow = ({ camera: { position, target } }: Document) => {
    controls.target.set(...target);
    camera.position.set(...position);
    controls.update();
  };

  return {
    pose,
    follow,
    focus(box, name) {
      const sphere = box.getBoundingSphere(new Sphere());
      if (box.isEmpty() || !(sphere.radius > 0)) return;
      const halfAngle = Math.atan(Math.tan((camera.fov * Math.PI) / 360) * Math.min(1, camera.aspect));
      const distance = (1.15 * sphere.radius) / Math.sin(halfAngle);
      const away = camera.position.clone().sub(controls.target).normalize();
      controls.target.copy(sphere.center);
      camera.position.copy(sphere.center).addScaledVector(away, distance);
      controls.update();
      write(t('Focus {name}', { name }));
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
