/** The choice of a preset of effects. Which one it is at present is not kept anywhere: the effects say. */
import {
  applyPreset,
  type PresetName,
  presetNames,
  presetOf,
  presets,
} from '../../../scene/effect-presets.ts';
import { attempt } from '../../commands.ts';
import { t, translate } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { row, selectField } from '../../ui/fields.ts';
import type { MenuEntry } from '../../ui/menu.ts';
import { type Bound, choiceLabel } from './field.ts';

const CUSTOM = 'custom';

export const setPreset = ({ store }: Session, name: PresetName) =>
  attempt(t('The effects are as they were'), () => applyPreset(store, name));

export function presetChoice(session: Session): Bound {
  const { store } = session;
  const choices = presetNames.map((name) => ({ value: name as string, label: choiceLabel(name) }));
  const field = selectField(t('Preset'), choices, (value) => setPreset(session, value as PresetName));
  const tip = presetNames
    .map((name) => `${choiceLabel(name)}: ${translate(presets[name].description)}`)
    .join('\n');
  return {
    element: row({ label: t('Preset'), tip }, field.element),
    update() {
      const name = presetOf(store.document.effects);
      // Only a state, nothing that could be chosen.
      field.setChoices(name === null ? [{ value: CUSTOM, label: t('Custom') }, ...choices] : choices);
      field.show(name ?? CUSTOM);
    },
  };
}

/** The presets as entries of a menu, with a mark at the present one. */
export function presetEntries(session: Session): MenuEntry[] {
  const present = presetOf(session.store.document.effects);
  return presetNames.map((name) => ({
    label: choiceLabel(name),
    tip: translate(presets[name].description),
    ...(name === present && { icon: 'check' as const }),
    run: () => void setPreset(session, name),
  }));
}
