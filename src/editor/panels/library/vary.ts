/** "Vary...": a small window beside the inspector, for materials near the selected one and between it and another. */
import { between, randomised, type Values } from '../../../analysis/library/variation.ts';
import { setValues } from '../../../scene/library-commands.ts';
import { findModel } from '../../../scene/models.ts';
import { attempt } from '../../commands.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import { h } from '../../ui/dom.ts';
import { row, selectField } from '../../ui/fields.ts';
import { type Gesture, newGesture } from '../../ui/gesture.ts';
import { sliderField } from '../../ui/slider-field.ts';
import { contentOf, keyOfOffer, type Offer, titleOf } from './chosen.ts';
import { allSections } from './sections.ts';
import type { Thumbnails } from './thumbnails.ts';

/** What the window had last, for the next time and for the action without it. */
let settings = { amount: 0.25, seed: 0 };
const MOST_SEED = 9999;

let closeOpen: (() => void) | null = null;

/** Another material near it, as one undo step. Returns the seed. */
export function randomise({ store }: Session, id: string, from?: Values, gesture?: Gesture): number {
  const material = store.document.materials[id];
  const model = material && findModel(store.document, material.model);
  if (!material || !model) return settings.seed;
  const values = randomised(model, from ?? material.parameters, settings);
  const label = t('Randomise, seed {seed}', { seed: settings.seed });
  attempt(t('The material stays as it was'), () => setValues(store, id, label, values, gesture));
  return settings.seed;
}

export function nextSeed(): void {
  settings = { ...settings, seed: 1 + Math.floor(Math.random() * MOST_SEED) };
}

export async function openVary(session: Session, thumbnails: Thumbnails, id: string): Promise<void> {
  closeOpen?.();
  const { store } = session;
  const { document } = store;
  const material = document.materials[id];
  if (!material) return;
  const own = (await (await thumbnails.storage())?.entries()) ?? [];
  if (settings.seed === 0) nextSeed();
  /** From where variations go out: what the material is but for our own last one. */
  let base: Values = material.parameters;
  let last: Values | null = null;
  const current = () => store.document.materials[id]?.parameters ?? {};
  const rebase = () => {
    if (current() !== last) base = current();
  };
  const apply = (gesture?: Gesture) => {
    rebase();
    randomise(session, id, base, gesture);
    last = current();
  };

  const amount = sliderField({
    label: t('How far'),
    min: 0,
    max: 1,
    hardMin: 0,
    hardMax: 1,
    onChange(value, gesture) {
      settings = { ...settings, amount: value };
      apply(gesture);
    },
  });
  const seed = sliderField({
    label: t('Seed'),
    min: 1,
    max: MOST_SEED,
    hardMin: 1,
    hardMax: MOST_SEED,
    integer: true,
    onChange(value, gesture) {
      settings = { ...settings, seed: value };
      apply(gesture);
    },
  });
  const roll = h(
    'button',
    { type: 'button', class: 'text-button primary', tip: t('Another material near this one') },
    t('Randomise'),
  );
  roll.addEventListener('click', () => {
    nextSeed();
    seed.show(settings.seed);
    apply();
  });

  const offers = new Map<string, Offer>();
  const choices = allSections(document, own).flatMap(({ title, offers: all }) =>
    all
      .filter((offer) => !(offer.kind === 'scene' && offer.id === id) && isSameModel(offer))
      .map((offer) => {
        offers.set(keyOfOffer(offer), offer);
        return { value: keyOfOffer(offer), label: titleOf(offer, document), group: title };
      }),
  );
  function isSameModel(offer: Offer): boolean {
    try {
      const content = contentOf(offer, document);
      const shares = offer.kind === 'scene' || !content?.models[content.material.model];
      return shares && content?.material.model === material?.model;
    } catch {
      return false;
    }
  }
  /** Blends of one pair are one undo step, however often the slider is taken up. */
  let blend: { readonly from: Values; readonly to: Offer; readonly merge: string } | null = null;
  const target = selectField(t('Blend with'), [{ value: '', label: '—' }, ...choices], (key) => {
    const to = offers.get(key);
    blend = to ? { from: current(), to, merge: newGesture() } : null;
    part.show(0);
    setEnabled();
  });
  const part = sliderField({
    label: t('Blend'),
    min: 0,
    max: 1,
    hardMin: 0,
    hardMax: 1,
    onChange(value) {
      const now = store.document.materials[id];
      const model = now && findModel(store.document, now.model);
      const to = blend && contentOf(blend.to, store.document);
      if (!blend || !model || !to || to.material.model !== now.model) return;
      const title = titleOf(blend.to, store.document);
      // Of a pattern its mean: what is blended are values.
      const target = blend.to.kind === 'library' ? blend.to.entry.look.parameters : to.material.parameters;
      const values = between(model, blend.from, target, value);
      const { merge } = blend;
      attempt(t('The material stays as it was'), () =>
        setValues(store, id, t('Blend with {name}', { name: title }), values, merge),
      );
    },
  });
  const setEnabled = () => {
    for (const input of part.element.querySelectorAll('input')) input.disabled = blend === null;
  };

  const close = h('button', { type: 'button', class: 'text-button' }, t('Close'));
  const panel = h(
    'section',
    { class: 'fit-panel vary-panel', 'aria-label': t('Vary {name}', { name: material.name }) },
    h('h1', {}, t('Vary {name}', { name: material.name })),
    row({ label: t('How far'), tip: t('0 nothing changes, 1 anything in the ranges') }, amount.element),
    row({ label: t('Seed'), tip: t('The same seed gives the same material') }, seed.element),
    h('div', { class: 'popup-actions' }, roll),
    h('hr'),
    row({ label: t('Blend with'), tip: t('Materials of the same model') }, target.element),
    row({ label: t('Blend'), tip: t('0 this material, 1 the other') }, part.element),
    h('div', { class: 'popup-actions' }, close),
  );
  const end = () => {
    unsubscribe();
    panel.remove();
    closeOpen = null;
  };
  const unsubscribe = store.subscribe(({ document: now }) => {
    if (now.materials[id]?.model !== material.model) end();
  });
  close.addEventListener('click', end);
  panel.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    end();
  });
  amount.show(settings.amount);
  seed.show(settings.seed);
  part.show(0);
  setEnabled();
  closeOpen = end;
  globalThis.document.body.append(panel);
  roll.focus();
}
