/** Files that are models, or parameters of one, into the scene and onto a material. */
import { loadModel } from '../../../models/index.ts';
import { readBparam, savedValues } from '../../io/bparam.ts';
import { addModel, setMaterialModel } from '../../scene/material-commands.ts';
import { measuredAsset } from '../../scene/measured.ts';
import { addMeasuredModel } from '../../scene/measured-commands.ts';
import { findModel } from '../../scene/models.ts';
import { toast } from '../ui/toast.ts';
import { readBytes } from './files.ts';
import type { OpenContext } from './open.ts';

type Target = Pick<OpenContext, 'store' | 'state'>;

/** The selected material, or the selected object's, or the first one there is. */
function targetMaterial({ store, state }: Target): string | undefined {
  const { selection } = state.value;
  if (selection?.kind === 'materials') return selection.id;
  const object = selection?.kind === 'objects' ? store.document.objects[selection.id] : undefined;
  return object?.material ?? Object.keys(store.document.materials)[0];
}

function showMaterial({ state }: Target, id: string): void {
  if (state.value.selection?.kind !== 'objects') state.select({ kind: 'materials', id });
}

function giveModel(target: Target, name: string): void {
  const { store } = target;
  const material = targetMaterial(target);
  if (material === undefined) {
    toast('success', `Added the model ${name}`, 'Choose it as the model of a material.');
    return;
  }
  setMaterialModel(store, material, name);
  showMaterial(target, material);
  toast('success', `${store.document.materials[material]?.name} is now ${name}`);
}

export async function openBrdf(target: Target, file: File): Promise<void> {
  const source = await file.text();
  // Compiled first under the file's own name, so that what is wrong is said in its terms.
  loadModel(source, file.name);
  giveModel(target, addModel(target.store, file.name, source));
}

export async function openMeasured(
  target: Target,
  file: File,
  onProgress: (text: string, fraction: number | null) => void,
): Promise<void> {
  const bytes = await readBytes(file, (fraction) => onProgress(`Reading ${file.name}`, fraction));
  onProgress(`Reading the samples of ${file.name}`, null);
  // The page shows the line before this thread is busy.
  await new Promise((resolve) => setTimeout(resolve, 30));
  giveModel(target, addMeasuredModel(target.store, measuredAsset(bytes, file.name)));
}

/** Model and values; parameters that the file does not have take their defaults. */
export async function openBparam(target: Target, file: File): Promise<void> {
  const { store } = target;
  const saved = readBparam(await file.text(), file.name);
  const model = findModel(store.document, saved.model);
  if (!model)
    throw new Error(
      `${file.name} has values for ${saved.source}, and there is no model ${saved.model} here. ` +
        `Add ${saved.source} first, or drop both files together.`,
    );
  const id = targetMaterial(target);
  if (id === undefined)
    throw new Error('The scene has no material that could take the values. Add one first.');
  const { values, unknown } = savedValues(saved, model.parameters);
  if (store.document.materials[id]?.model !== saved.model) setMaterialModel(store, id, saved.model);
  store.edit(`Parameters of ${file.name}`, (draft) => {
    const material = draft.materials[id];
    if (material) material.parameters = structuredClone(values) as typeof material.parameters;
  });
  showMaterial(target, id);
  toast('success', `${store.document.materials[id]?.name} has the values of ${file.name}`);
  if (unknown.length > 0)
    toast('info', `About ${file.name}`, `${saved.model} has no such parameters: ${unknown.join(', ')}.`);
}
