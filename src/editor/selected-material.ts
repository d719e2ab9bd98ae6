import type { Document } from '../scene/schema.ts';
import type { Selection } from './state.ts';

/** The material that is selected, or that of the selected object; otherwise the scene's first. */
export function selectedMaterial({ objects, materials }: Document, selection: Selection): string | undefined {
  if (selection?.kind === 'materials') return selection.id;
  const object = selection?.kind === 'objects' ? objects[selection.id] : undefined;
  return object?.material ?? Object.keys(materials)[0];
}
