/** What the inspector says of the camera beside its fields: the lens's length, its exposure value, and a picker of focus. */
import { ev100 } from '../../../color/exposure.ts';
import { fieldOfView, focalLength } from '../../../scene/lens.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row } from '../../ui/fields.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { tryEdit } from './cell.ts';
import type { Bound } from './field.ts';

/** Focal length, exposure value and the button that picks the focus. */
export function cameraFields(session: Session): readonly [Bound, Bound, Bound] {
  const { store } = session;
  const camera = () => store.document.camera;
  const length = sliderField({
    label: t('Focal length'),
    min: 8,
    max: 200,
    hardMin: 0.01,
    scale: 'log',
    unit: 'mm',
    onChange: (value, gesture) => {
      const fov = Number(fieldOfView(value / 1000, camera().sensorHeight).toPrecision(9));
      const merge = gesture && `focal length ${gesture}`;
      tryEdit(
        store,
        t('Change focal length'),
        (draft) => {
          draft.camera.fov = Math.min(170, Math.max(1, fov));
        },
        merge,
      );
    },
  });
  const value = h('output', { class: 'readout', 'aria-label': t('Exposure value') });
  const picker = h('button', { type: 'button', class: 'text-button' }, t('Pick in the picture'));
  picker.addEventListener('click', () => session.pickFocus());
  return [
    {
      element: row(
        { label: t('Focal length'), tip: t('Of the lens that throws the field of view onto the sensor') },
        length.element,
      ),
      update: () => length.show(1000 * focalLength(camera())),
    },
    {
      element: row(
        {
          label: t('Exposure value'),
          tip: t('EV at ISO 100 of f-number, shutter and ISO: exposes the picture where View says ‘camera’'),
        },
        value,
      ),
      update: () => {
        value.textContent = `EV ${ev100(camera()).toFixed(2)}`;
      },
    },
    {
      element: row(
        { label: t('Focus'), tip: t('Then click on what is to be in focus (Shift+F, Escape lets it be)') },
        picker,
      ),
      update: () => {},
    },
  ];
}
