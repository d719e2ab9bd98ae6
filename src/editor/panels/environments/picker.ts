/** All environments as pictures, to choose one from: by pointer, or by arrows and Enter. */
import { newSky, setEnvironmentSource } from '../../../scene/environment-commands.ts';
import { environmentPresets } from '../../../scene/presets.ts';
import type { EnvironmentSource } from '../../../scene/schema.ts';
import { studioOf } from '../../../scene/studio-arrangements.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { openPopup } from '../../ui/popup.ts';
import { choiceLabel } from '../inspector/field.ts';
import { presetPicture } from './shipped.ts';

const COLUMNS = 3;

interface Offer {
  readonly label: string;
  readonly picture: HTMLElement;
  readonly isPresent: boolean;
  source(): EnvironmentSource;
}

export function openEnvironmentPicker(session: Session, anchor: HTMLElement): void {
  const { store } = session;
  const grid = h('div', { class: 'environment-grid', role: 'listbox', 'aria-label': t('Environment') });
  const close = openPopup({ anchor, content: grid, label: t('Choose an environment') });
  const options = offersOf(store.document.environment.source).map(({ label, picture, isPresent, source }) => {
    const option = h(
      'button',
      { type: 'button', role: 'option', class: 'environment-option', 'aria-selected': String(isPresent) },
      picture,
      h('span', {}, label),
    );
    option.addEventListener('click', () => {
      close();
      anchor.focus({ preventScroll: true });
      attempt(t('The environment stays as it is'), () => setEnvironmentSource(store, source()));
    });
    return option;
  });
  grid.append(...options);
  grid.addEventListener('keydown', (event) => {
    const present = options.indexOf(document.activeElement as HTMLButtonElement);
    const next = placeAfter(event.key, present, options.length);
    if (next === null) return;
    event.preventDefault();
    options[next]?.focus();
  });
  keepInside(grid.parentElement);
  const chosen = options.find((option) => option.getAttribute('aria-selected') === 'true');
  (chosen ?? options[0])?.focus();
}

/** Where a key leads to in the grid; null for keys that lead nowhere. */
function placeAfter(key: string, from: number, count: number): number | null {
  const steps: Readonly<Record<string, number>> = {
    ArrowLeft: -1,
    ArrowRight: 1,
    ArrowUp: -COLUMNS,
    ArrowDown: COLUMNS,
  };
  if (key === 'Home') return 0;
  if (key === 'End') return count - 1;
  const step = steps[key];
  if (step === undefined) return null;
  const to = from + step;
  return to < 0 || to >= count ? from : to;
}

function offersOf(present: EnvironmentSource): Offer[] {
  const computed = (type: 'sky' | 'studio', label: string, source: () => EnvironmentSource): Offer => ({
    label,
    picture: h('span', { class: `environment-picture of-${type}` }),
    isPresent: present.type === type,
    source,
  });
  return [
    computed('sky', t('Sky and sun'), newSky),
    computed('studio', t('Soft boxes'), () => studioOf('threePoint')),
    ...environmentPresets.map((name) => ({
      label: choiceLabel(name),
      picture: presetPicture(name),
      isPresent: present.type === 'preset' && present.name === name,
      source: (): EnvironmentSource => ({ type: 'preset', name }),
    })),
  ];
}

/** The popup was placed while still empty. */
function keepInside(popup: HTMLElement | null): void {
  if (!popup) return;
  const box = popup.getBoundingClientRect();
  popup.style.left = `${Math.max(6, Math.min(box.left, innerWidth - box.width - 6))}px`;
  popup.style.top = `${Math.max(6, Math.min(box.top, innerHeight - box.height - 6))}px`;
}
