/** What a scene can be taken away as, in the File menu: a model, a picture, a material. */
import type { RealtimeRenderer } from '../../../realtime/renderer.ts';
import { materialMaps } from '../../../scene/material-schema.ts';
import type { SceneMirror } from '../../../scene/mirror.ts';
import type { Action } from '../../actions/action.ts';
import { actionEntry } from '../../actions/entry.ts';
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
  /** Resolves when everything in the scene can be drawn. */
  whole(): Promise<void>;
}

export function exportActions(context: ExportContext): Action[] {
  const { store, state } = context.session;
  const material = () => selectedMaterial(store.document, state.value.selection);
  const withMaterial = (act: (id: string) => Promise<void>) => () => {
    const id = material();
    if (id !== undefined) void act(id);
  };
  return [
    {
      id: 'file.exportPicture',
      title: t('Export a picture…'),
      enabled: () => context.renderer() !== null,
      run: () => void exportPicture(context),
    },
    {
      id: 'file.exportModel',
      title: t('Export the scene as GLB'),
      enabled: () => Object.keys(store.document.objects).length > 0,
      run: () => void exportModel(context),
    },
    {
      id: 'file.exportMaterial',
      title: t('Export the material as JSON'),
      enabled: () => material() !== undefined,
      run: withMaterial((id) => exportMaterial(context, id)),
    },
    {
      id: 'file.copyCode',
      title: t('Copy the material as code'),
      enabled: () => material() !== undefined,
      run: withMaterial((id) => copyCode(context, id)),
    },
  ];
}

/** The same in the File menu, under a heading of their own. */
export function exportEntries({ store, state, actions }: Session): MenuEntry[] {
  const material = selectedMaterial(store.document, state.value.selection);
  const name = material === undefined ? '' : ` ${store.document.materials[material]?.name ?? ''}`;
  return [
    'separator',
    { heading: t('Export') },
    actionEntry(actions, 'file.exportPicture', {
      label: t('Picture…'),
      icon: 'image',
      tip: t('PNG, JPEG or linear EXR of any size, by either renderer'),
    }),
    actionEntry(actions, 'file.exportModel', {
      label: t('Scene as GLB'),
      icon: 'mesh',
      tip: t('Objects, materials (KHR extensions), punctual lights and camera; says what glTF cannot hold'),
    }),
    actionEntry(actions, 'file.exportMaterial', {
      label: t('Material{name} as JSON', { name }),
      icon: 'material',
      tip: t('With its model, images and measurements; drop the file on the page to bring it back'),
    }),
    actionEntry(actions, 'file.copyCode', {
      label: t('Copy material{name} as code', { name }),
      icon: 'copy',
      tip: t('For a program with three.js and the npm package irradia'),
    }),
  ];
}

async function exportPicture({ session, mirror, renderer, redraw, whole }: ExportContext): Promise<void> {
  const drawn = renderer();
  if (drawn === null) return;
  const { openPictureDialog } = await import('./picture-dialog.ts');
  openPictureDialog({ renderer: drawn, mirror, document: session.store.document, redraw, whole });
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
  try {
    const { materialCode } = await import('./material-code.ts');
    const code = materialCode(document, id);
    if (!material || code === null) return;
    await navigator.clipboard.writeText(code);
    const textures =
      Object.keys(material.textures).length > 0 || materialMaps.some((map) => material[map] !== null);
    toast(
      'success',
      t('The code is in the clipboard'),
      textures ? t('Its textures are not part of it.') : undefined,
    );
  } catch (error) {
    toastError(t('The code was not copied'), error);
  }
}
