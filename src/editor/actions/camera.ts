/** The camera by keyboard: round what it looks at, and nearer. Arrows move what is selected, if anything is. */
import { t } from '../language/language.ts';
import type { Session } from '../session.ts';
import type { CameraStep } from '../viewport/camera.ts';
import type { Action } from './action.ts';
import { isViewportFocused } from './tools.ts';

/** Of an arrow key; a right angle is six of them. */
const TURN = Math.PI / 12;
const NEARER = 0.8;

export function cameraActions(session: Session): Action[] {
  const step = (name: string, title: string, keys: string[], by: CameraStep): Action => ({
    id: `camera.${name}`,
    title,
    keys,
    enabled: () =>
      isViewportFocused() && (by.distance !== undefined || session.state.value.selected.every(isMaterial)),
    run: () => session.hands()?.step(by),
  });
  return [
    step('left', t('Turn the camera to the left'), ['ArrowLeft'], { right: -TURN }),
    step('right', t('Turn the camera to the right'), ['ArrowRight'], { right: TURN }),
    step('up', t('Turn the camera upwards'), ['ArrowUp'], { up: TURN }),
    step('down', t('Turn the camera downwards'), ['ArrowDown'], { up: -TURN }),
    step('nearer', t('Come nearer'), ['+', '='], { distance: NEARER }),
    step('farther', t('Go back'), ['-'], { distance: 1 / NEARER }),
  ];
}

/** Which has no place that arrows could move. */
const isMaterial = ({ kind }: { readonly kind: string }): boolean => kind === 'materials';
