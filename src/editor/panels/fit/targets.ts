/** What a material can be fitted to: any material as it is, what is pinned in the bench, any model. */
import { findModel, modelNames } from '../../../scene/models.ts';
import type { Document } from '../../../scene/schema.ts';
import { t } from '../../language/language.ts';
import type { Choice } from '../../ui/fields.ts';
import { ownModel, type Subject, subjectsOf } from '../bench/series.ts';
import type { Pin } from '../bench/settings.ts';

export interface Target extends Choice {
  readonly subject: Subject;
}

export function targetsFor(document: Document, own: string, pins: readonly Pin[]): Target[] {
  const materials = Object.entries(document.materials).flatMap(([id, { name }]): Target[] => {
    const [subject] = subjectsOf(document, { kind: 'materials', id }, []);
    const label = id === own ? t('{name}, as it is now', { name }) : name;
    return subject ? [{ value: `material ${id}`, label, group: t('Materials'), subject }] : [];
  });
  const pinned = pins.map((pin) => ({
    value: `pin ${pin.id}`,
    label: pin.name,
    group: t('Pinned in the bench'),
    subject: pin,
  }));
  const models = modelNames(document).map((name) => ({
    value: `model ${name}`,
    label: name,
    group: t('Models, with their defaults'),
    subject: { id: name, name, color: '', model: name, source: ownModel(document, name), parameters: {} },
  }));
  return [...materials, ...pinned, ...models];
}

/** Models that have something to fit. */
export function fittableModels(document: Document): string[] {
  return modelNames(document).filter((name) => {
    try {
      return (findModel(document, name)?.parameters.length ?? 0) > 0;
    } catch {
      // A broken model can be no fit; the inspector says what is wrong with it.
      return false;
    }
  });
}

/** What one most likely wants: to replace measurements; else to be like another material. */
export function likelyTarget(
  document: Document,
  own: string,
  targets: readonly Target[],
): Target | undefined {
  const isData = ({ subject }: Target) => {
    const entry = document.models[subject.model];
    return entry !== undefined && 'measured' in entry;
  };
  const itself = targets.find(({ value }) => value === `material ${own}`);
  if (itself && isData(itself)) return itself;
  return targets.find(isData) ?? targets.find((target) => target !== itself) ?? itself;
}
