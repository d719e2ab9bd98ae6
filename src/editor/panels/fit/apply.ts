/** A finished fit goes into the material, as one undo step, and its target into the bench. */
import type { Fit } from '../../../analysis/fit/types.ts';
import { findModel } from '../../../scene/models.ts';
import { t } from '../../language/language.ts';
import type { Session } from '../../session.ts';
import type { Subject } from '../bench/series.ts';
import { freeColor } from '../bench/settings.ts';

export function applyFit({ store, state }: Session, id: string, fit: Fit, target: Subject): void {
  const next = findModel(store.document, fit.model);
  const known = new Map((next?.parameters ?? []).map((parameter) => [parameter.name, parameter]));
  store.edit(
    t('Fit {name} to {target}', { name: store.document.materials[id]?.name ?? id, target: target.name }),
    (draft) => {
      const material = draft.materials[id];
      if (!material) throw new Error(t('The material is not there any more.'));
      material.model = fit.model;
      // A document stores what differs from the defaults.
      material.parameters = Object.fromEntries(
        Object.entries(fit.parameters)
          .filter(([name, value]) => JSON.stringify(value) !== JSON.stringify(known.get(name)?.default))
          .map(([name, value]) => [name, structuredClone(value)]),
      ) as typeof material.parameters;
      // What was fitted is the whole value: a map would change it.
      for (const name of Object.keys(material.textures)) delete material.textures[name];
      if (draft.view.term?.material === id && !next?.terms.includes(draft.view.term.name))
        draft.view.term = null;
    },
  );
  const { bench } = state.value;
  const { name, model, source, parameters } = target;
  const same = bench.pins.some((pin) => pin.model === model && pin.parameters === parameters);
  const pin = { id: crypto.randomUUID(), name, model, source, parameters, color: freeColor(bench.pins) };
  state.set({
    benchOpen: true,
    bench: { ...bench, solo: null, pins: same ? bench.pins : [...bench.pins, pin] },
  });
}
