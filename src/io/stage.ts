/** A scene for a model that comes with none: nothing in it but light from all around. */
import { createDocument } from '../scene/document.ts';
import type { Document } from '../scene/schema.ts';
import type { Draft } from '../scene/store.ts';
import type { ImportedModel } from './gltf/add.ts';

export function modelStage(name: string): Document {
  const empty = createDocument(name.slice(0, 200));
  return {
    ...empty,
    environment: { ...empty.environment, source: { type: 'preset', name: 'studio' } },
    background: { type: 'color', color: [0.05, 0.05, 0.055] },
  };
}

/** A file with lights of its own is lit by them alone. */
export function lightByFile(draft: Draft, { contents }: Pick<ImportedModel, 'contents'>): void {
  if (contents.lights.length > 0) draft.environment.source = { type: 'none' };
}
