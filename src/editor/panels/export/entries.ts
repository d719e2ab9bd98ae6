/** What a scene can be taken away as, in the File menu: a model, a picture, a material. */
import type { RealtimeRenderer } from '../../../realtime/renderer.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import { findModel } from '../../../scene/models.ts';
import { download, fileNameOf } from '../../io/files.ts';
import { ImportCancelled } from '../../io/importer/import-job.ts';
import { runImport } from '../../io/open-import.ts';
import { t, translate } from '../../language/language.ts';
import { selectedMaterial } from '../../selected-material.ts';
import type { Session } from '../../session.ts';
import { documentToSend } from '../../storage/stored-document.ts';
import type { MenuEntry } from '../../ui/menu.ts';
import { toast, toastError } from '../../ui/toast.ts';

export interface ExportContext {
  readonly session: Session;
  readonly mirror: SceneMirror;
  /** Null until it has started, and where it cannot. */
  renderer(): RealtimeRenderer | null;
  /** Draws the viewport anew. */
  redraw(): void;
}

export function exportEntries(context: ExportContext): MenuEntry[] {
  const { store, state } = context.session;
  const material = selectedMaterial(store.document, state.value.selection);
  const name = material === undefined ? '' : ` ${store.document.materials[material]?.name ?? ''}`;
  return [
    'separator',
    { heading: t('Export') },
    {
      label: t('Picture…'),
      icon: 'image',
      tip: t('PNG, JPEG or linear EXR of any size, by either renderer'),
      disabled: context.renderer() === null,
      run: () => void exportPicture(context),
    },
    {
      label: t('Scene as GLB'),
      icon: 'mesh',
      tip: t('Objects, materials (KHR extensions), punctual lights and camera; says what glTF cannot hold'),
      disabled: Object.keys(store.document.objects).length === 0,
      run: () => void exportModel(context),
    },
    {
      label: t('Material{name} as JSON', { name }),
      icon: 'material',
      tip: t('With its model, images and measurements; drop the file on the page to bring it back'),
      disabled: material === undefined,
      run: () => material !== undefined && void exportMaterial(context, material),
    },
    {
      label: t('Copy material{name} as code', { name }),
      icon: 'copy',
      tip: t('For a program with three.js and the npm package irradia'),
      disabled: material === undefined,
      run: () => material !== undefined && void copyCode(context, material),
    },
  ];
}

async function exportPicture({ session, mirror, renderer, redraw }: ExportContext): Promise<void> {
  const drawn = renderer();
  if (drawn === null) return;
  const { openPictureDialog } = await import('./picture-dialog.ts');
  openPictureDialog({ renderer: drawn, mirror, document: session.store.document, redraw });
}

/** Put together in the thread that reads files, too. */
async function exportModel({ session }: ExportContext): Promise<void> {
  const { document } = session.store;
  const name = `${fileNameOf(document.name)}.glb`;
  try {
    const { result } = await runImport(t('Exporting {name}', { name }), {
      kind: 'export',
      document: documentToSend(document),
    });
    if (result.kind !== 'files') return;
    for (const { bytes } of result.files) download(name, new Blob([bytes], { type: 'model/gltf-binary' }));
    toast('success', t('Exported {name}', { name }));
    if (result.notes.length > 0)
      toast('note', t('About {name}', { name }), result.notes.map(translate).join('\n'));
  } catch (error) {
    if (!(error instanceof ImportCancelled)) toastError(t('{name} was not exported', { name }), error);
  }
}

async function exportMaterial({ session }: ExportContext, id: string): Promise<void> {
  const { document } = session.store;
  const name = `${fileNameOf(document.materials[id]?.name ?? 'material')}.material.json`;
  try {
    const { writeMaterialFile } = await import('../../../io/material-file.ts');
    download(name, new Blob([writeMaterialFile(document, id)], { type: 'application/json' }));
    toast('success', t('Exported {name}', { name }));
  } catch (error) {
    toastError(t('{name} was not exported', { name }), error);
  }
}

async function copyCode({ session }: ExportContext, id: string): Promise<void> {
  const { document } = session.store;
  const material = document.materials[id];
  const model = material && findModel(document, material.model);
  if (!material || !model) return;
  try {
    const { codeSample } = await import('../../../analysis/fit/code-sample.ts');
    const shipped = !Object.hasOwn(document.models, material.model);
    await navigator.clipboard.writeText(codeSample(model, material.parameters, shipped));
    const textures = Object.keys(material.textures).length > 0;
    toast(
      'success',
      t('The code is in the clipboard'),
      textures ? t('Its textures are not part of it.') : undefined,
    );
  } catch (error) {
    toastError(t('The code was not copied'), error);
  }
}
