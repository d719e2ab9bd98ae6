/** What makes a document large, for whoever wants to send a small one. */
import type { Document } from '../../scene/schema.ts';
import { t } from '../language/language.ts';

export interface Part {
  readonly name: string;
  /** Bytes, before any packing. */
  readonly size: number;
}

/** What takes less of a document than this would not help much. */
const LEAST_SHARE = 0.05;

/** The largest first. */
export function largestParts(document: Document, most: number): Part[] {
  const parts: Part[] = [];
  for (const asset of Object.values(document.assets))
    parts.push({ name: asset.name, size: (asset.data.length / 4) * 3 });
  for (const [name, model] of Object.entries(document.models))
    if ('source' in model) parts.push({ name: t('the model {name}', { name }), size: model.source.length });
  for (const name of ['objects', 'materials', 'lights'] as const) {
    const count = Object.keys(document[name]).length;
    parts.push({ name: `${count} ${name}`, size: JSON.stringify(document[name]).length });
  }
  const least = LEAST_SHARE * parts.reduce((sum, { size }) => sum + size, 0);
  return parts
    .filter(({ size }) => size >= least)
    .toSorted((a, b) => b.size - a.size)
    .slice(0, most);
}
