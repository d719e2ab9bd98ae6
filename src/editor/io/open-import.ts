/** Models, scenes and materials from files: read in a thread of their own, put into the scene in one undo step. */

import type { ImportedModel } from '../../io/gltf/add.ts';
import { lightByFile } from '../../io/stage.ts';
import { createDocument } from '../../scene/document.ts';
import type { MemberRef } from '../../scene/entity.ts';
import type { Draft } from '../../scene/store.ts';
import { trustAsset } from '../../scene/validate.ts';
import { t, translate } from '../language/language.ts';
import { startProgress, toast } from '../ui/toast.ts';
import { handleOf } from './file-handles.ts';
import { pathOf } from './files.ts';
import { type ImportJob, startJob } from './importer/import-job.ts';
import type { ToImporter } from './importer/messages.ts';
import type { OpenContext, OpenOptions } from './open.ts';

type Result = Awaited<ImportJob['result']>;

/** Shows how far a job is, with a way to give it up. */
export async function runImport(text: string, message: ToImporter): Promise<Result> {
  let job: ImportJob | null = null;
  const progress = startProgress(text, () => job?.cancel());
  progress.update(text, null);
  try {
    job = startJob(message, (now, fraction) => progress.update(now, fraction));
    return await job.result;
  } finally {
    progress.done();
  }
}

/** @throws ImportCancelled, or Error that says what is wrong with the file and where */
export async function importFile(
  context: OpenContext,
  file: File,
  all: readonly File[],
  { onStage = false }: OpenOptions,
): Promise<void> {
  const { store, state, assets } = context;
  const placed = (one: File) => ({ path: pathOf(one), file: one });
  const { result, source } = await runImport(t('Reading {file}', { file: file.name }), {
    kind: 'import',
    main: placed(file),
    others: all.filter((other) => other !== file).map(placed),
  });
  switch (result.kind) {
    case 'document':
      if (await context.replaceDocument(result.document, await handleOf(file)))
        toast('success', t('Opened {name}', { name: result.document.name }));
      return;
    case 'material': {
      const { addMaterialFile } = await import('../../io/material-file.ts');
      let id = '';
      store.edit(t('Import {file}', { file: file.name }), (draft) => {
        id = addMaterialFile(draft, result.material);
      });
      state.select({ kind: 'materials', id });
      toast('success', t('Added the material {name}', { name: store.document.materials[id]?.name ?? id }));
      return;
    }
    case 'model': {
      const { imported } = result;
      const { addImported } = await import('../../io/gltf/add.ts');
      if (imported.asset) {
        assets.adopt(imported.asset, source);
        trustAsset(imported.asset);
      }
      let added: MemberRef[] = [];
      const wasNew = context.isNew();
      const isFramed = wasNew || Object.keys(store.document.objects).length === 0;
      store.edit(imported.label, (draft) => {
        if (wasNew) makeRoom(draft, imported, file.name);
        added = addImported(draft, imported);
        if (onStage) lightByFile(draft, imported);
      });
      // Panels that follow are work of their own: the page may draw in between.
      await new Promise((resolve) => setTimeout(resolve));
      // All of it, to be put where it should be.
      state.selectAll(added);
      const look = { label: t('Look at it'), run: () => context.lookAtSelection() };
      toast('success', t('Imported {file}', { file: file.name }), undefined, isFramed ? undefined : look);
      if (imported.notes.length > 0)
        toast('note', t('About {file}', { file: file.name }), imported.notes.map(translate).join('\n'));
    }
  }
}

/**
 * What a new scene begins with is there to be looked at until something comes; lights stay where none come. A scene that has
 * no name yet takes the file's, which Save then suggests.
 */
function makeRoom(draft: Draft, { contents }: ImportedModel, fileName: string): void {
  if (draft.name === createDocument().name)
    draft.name = fileName.replace(/\.[A-Za-z0-9]+$/, '').slice(0, 200);
  draft.objects = {};
  draft.materials = {};
  if (contents.lights.length > 0) draft.lights = {};
}
