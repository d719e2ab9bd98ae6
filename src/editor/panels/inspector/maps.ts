/** The maps that every material has, whatever its model: one row each, from the schema. */
import { fieldInfo } from '../../../scene/fields.ts';
import { materialMaps, materialShape, scaledTextureShape } from '../../../scene/material-schema.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { row } from '../../ui/fields.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { pathCell } from './cell.ts';
import { type Bound, labelOf } from './field.ts';
import { textureSlot } from './texture-slot.ts';

export function mapRows(session: Session, id: string): Bound[] {
  const scaleInfo = fieldInfo(scaledTextureShape.scale);
  const [min, max] = scaleInfo?.slider ?? [0, 1];
  return materialMaps.map((map) => {
    const label = labelOf(map);
    const cell = pathCell(
      session.store,
      ['materials', id, map, 'scale'],
      t('Change {label} strength', { label: label.toLowerCase() }),
    );
    const slider = sliderField({
      label: t('{label} strength', { label }),
      min,
      max,
      hardMin: scaleInfo?.min,
      hardMax: scaleInfo?.max,
      onChange: (value, gesture) => cell.set(value, gesture),
    });
    const slot = textureSlot(session, id, { map });
    const element = row(
      { label, tip: translate(fieldInfo(materialShape[map])?.description ?? ''), after: slot.element },
      slider.element,
    );
    return {
      element,
      update() {
        const scale = cell.get();
        element.classList.toggle('empty', scale === undefined);
        slider.element.inert = scale === undefined;
        slider.show(typeof scale === 'number' ? scale : 1);
        slot.update();
      },
    };
  });
}
