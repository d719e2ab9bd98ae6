/** Commands for measured models; see material-commands.ts for those of formulas. */

import { keepAsset } from './commands.ts';
import { modelNameFor } from './material-commands.ts';
import type { Asset } from './schema.ts';
import type { DocumentStore } from './store.ts';

/**
 * Adds a file of measurements, and a model of it under a name that no model has yet; returns that name.
 * Throws DocumentError if the file cannot be read.
 */
export function addMeasuredModel(store: DocumentStore, measurements: Asset): string {
  const name = modelNameFor(store, measurements.name);
  store.edit(`Add model ${name}`, (draft) => {
    draft.models[name] = { measured: keepAsset(draft, measurements) };
  });
  return name;
}
