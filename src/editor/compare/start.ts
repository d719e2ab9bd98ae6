/** Beginning and ending a comparison. */
import { assignMaterial, setMaterialModel } from '../../scene/material-commands.ts';
import { attempt } from '../commands.ts';
import { t } from '../language/language.ts';
import { contentOf, giveLook, type Offer, titleOf } from '../panels/library/chosen.ts';
import type { Session } from '../session.ts';
import { toast } from '../ui/toast.ts';
import { type Comparison, missingOf } from './comparison.ts';

export function startComparison({ store, state }: Session, material: string, offer: Offer): void {
  if (offer.kind === 'scene' && offer.id === material) return;
  const { document } = store;
  if (!attempt(t('Nothing to compare with'), () => contentOf(offer, document))) return;
  begin({ store, state }, { material, other: offer, title: titleOf(offer, document) });
}

export function compareModel(session: Session, material: string, model: string): void {
  begin(session, { material, other: { kind: 'model', model }, title: model });
}

/** What is compared is the interactive picture. */
function begin({ store, state }: Pick<Session, 'store' | 'state'>, comparison: Comparison): void {
  if (missingOf(store.document, comparison) === 'objects') {
    toast('info', t('Nothing to compare'), t('No object has this material.'));
    return;
  }
  if (state.value.rendering !== 'interactive')
    toast('info', t('Materials are compared in the interactive picture'));
  state.set({ comparison, rendering: 'interactive', divider: 0.5 });
}

/** @param keep the material that is left; A is what the scene has */
export function endComparison(session: Session, keep: 'A' | 'B'): void {
  const { store, state } = session;
  const { comparison } = state.value;
  if (!comparison) return;
  state.set({ comparison: null });
  if (keep === 'A') return;
  const { material, other } = comparison;
  if (other.kind === 'scene') {
    const users = Object.entries(store.document.objects).filter(([, object]) => object.material === material);
    attempt(t('The material stays as it was'), () =>
      assignMaterial(
        store,
        users.map(([id]) => id),
        other.id,
      ),
    );
  } else if (other.kind === 'model')
    attempt(t('The material stays as it was'), () => setMaterialModel(store, material, other.model));
  else giveLook(session, other, [material]);
}
