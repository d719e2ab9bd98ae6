/** What the library offers, in the order in which it is shown. */
import { type Category, categories } from '../../../analysis/library/entry.ts';
import { materialLibrary } from '../../../analysis/library/library.ts';
import type { Document } from '../../../scene/schema.ts';
import { t } from '../../language/language.ts';
import type { OwnEntry } from '../../storage/material-library.ts';
import { type Offer, titleOf } from './chosen.ts';

export interface Section {
  readonly key: string;
  readonly title: string;
  readonly offers: readonly Offer[];
}

const categoryNames: Readonly<Record<Category, string>> = {
  metals: t('Metals'),
  transparent: t('Glass, liquids, gems'),
  plastics: t('Plastics'),
  paints: t('Paints'),
  'car paint': t('Car paint'),
  fabrics: t('Fabrics and leather'),
  skin: t('Skin'),
  wax: t('Wax and soap'),
  food: t('Food'),
  wood: t('Wood'),
  stone: t('Stone'),
  ceramics: t('Ceramics'),
  rubber: t('Rubber'),
  paper: t('Paper'),
  ground: t('Ground'),
};

/** @param query words that a title or a section's title has to have, all of them */
export function sectionsOf(
  document: Document,
  own: readonly OwnEntry[],
  { query, only }: { readonly query: string; readonly only: string },
): Section[] {
  const words = query.toLocaleLowerCase().split(/\s+/).filter(Boolean);
  return allSections(document, own)
    .filter(({ key }) => only === '' || key === only)
    .map((section) => ({
      ...section,
      offers: section.offers.filter((offer) => {
        const text = `${titleOf(offer, document)} ${section.title}`.toLocaleLowerCase();
        return words.every((word) => text.includes(word));
      }),
    }))
    .filter(({ offers }) => offers.length > 0);
}

export function allSections(document: Document, own: readonly OwnEntry[]): Section[] {
  return [
    {
      key: 'scene',
      title: t('In this scene'),
      offers: Object.keys(document.materials).map((id) => ({ kind: 'scene', id })),
    },
    { key: 'own', title: t('My library'), offers: own.map((entry) => ({ kind: 'own', entry })) },
    ...categories.map((category) => ({
      key: category,
      title: categoryNames[category],
      offers: [...materialLibrary.values()]
        .filter((entry) => entry.category === category)
        .map((entry): Offer => ({ kind: 'library', entry })),
    })),
  ];
}
