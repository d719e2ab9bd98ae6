/** Files that are models, or parameters of one, into the scene and onto a material. */
import { loadModel } from '../../../models/index.ts';
import { readBparam, savedValues } from '../../io/bparam.ts';
import { addModel, setMaterialModel } from '../../scene/material-commands.ts';
import { measuredAsset } from '../../scene/measured.ts';
import { addMeasuredModel } from '../../scene/measured-commands.ts';
import { findModel } from '../../scene/models.ts';
import { t } from '../language/language.ts';
import { toast } from '../ui/toast.ts';
import type { OpenContext } from './open.ts';
import { readBytes } from './read-bytes.ts';

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
    toast('success', t('Added the model {name}', { name }), t('Choose it as the model of a material.'));
    return;
  }
  setMaterialModel(store, material, name);
  showMaterial(target, material);
  toast(
    'success',
    t('{material} is now {model}', {
      material: store.document.materials[material]?.name ?? material,
      model: name,
    }),
  );
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
  const bytes = await readBytes(file, (fraction) =>
    onProgress(t('Reading {file}', { file: file.name }), fraction),
  );
  onProgress(t('Reading the samples of {file}', { file: file.name }), null);
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
      t(
        '{file} has values for {source}, and there is no model {model} here. Add {source} first, or drop both files together.',
        { file: file.name, source: saved.source, model: saved.model },
      ),
    );
  const id = targetMaterial(target);
  if (id === undefined)
    throw new Error(t('The scene has no material that could take the values. Add one first.'));
  const { values, unknown } = savedValues(saved, model.parameters);
  if (store.document.materials[id]?.model !== saved.model) setMaterialModel(store, id, saved.model);
  store.edit(t('Parameters of {file}', { file: file.name }), (draft) => {
    const material = draft.materials[id];
    if (material) material.parameters = structuredClone(values) as typeof material.parameters;
  });
  showMaterial(target, id);
  toast(
    'success',
    t('{name} has the values of {file}', { name: store.document.materials[id]?.name ?? id, file: file.name }),
  );
  if (unknown.length > 0)
    toast(
      'info',
      t('About {file}', { file: file.name }),
      t('{model} has no such parameters: {list}.', { model: saved.model, list: unknown.join(', ') }),
    );
}
