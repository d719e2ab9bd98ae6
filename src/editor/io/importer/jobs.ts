/** Reading of files: all that takes time is done here, and told as it goes on. */

import { importModel, importObjectScene } from '../../../io/import-model.ts';
import { isMaterialFile, readMaterialFile } from '../../../io/material-file.ts';
import { type Companions, companionsFrom, findCompanion } from '../../../io/meshes/companions.ts';
import { materialFileOf, referencesOf } from '../../../io/meshes/references.ts';
import { isModelFile } from '../../../io/model-extensions.ts';
import { readZip } from '../../../io/zip.ts';
import { messageOf } from '../../../scene/assets.ts';
import { decodeBase64 } from '../../../scene/base64.ts';
import { parseDocument } from '../../../scene/document.ts';
import type { Asset } from '../../../scene/schema.ts';
import { receivedAsset, receivedDocument } from '../../threads/sent-assets.ts';
import { sha256Of } from '../../threads/sha256.ts';
import { readBytes } from '../read-bytes.ts';
import { fetchFiles } from './fetch.ts';
import type { EnvironmentData, FromImporter, ImportResult, PlacedFile, ToImporter } from './messages.ts';
import type { Server } from './server.ts';

type Job = Extract<ToImporter, { kind: 'import' | 'unzip' | 'fetch' | 'environment' | 'export' }>;
type Post = (message: FromImporter, transfer?: Transferable[]) => void;
export type Progress = (text: string, fraction: number | null) => void;

/** All that is read at once; a folder can hold more than any scene. */
const MOST_BYTES = 1024 * 1024 * 1024;

const nameOf = (path: string): string => path.replace(/^.*[/\\]/, '');

export async function runJob(job: Job, server: Server, post: Post): Promise<void> {
  try {
    const result = await resultOf(job, server, (text, fraction) =>
      post({ kind: 'progress', text, fraction }),
    );
    post(
      { kind: 'done', result: result.kind === 'model' ? inParts(result, post) : result },
      buffersOf(result),
    );
  } catch (error) {
    post({ kind: 'failed', message: messageOf(error) });
  }
}

/** Characters that a page takes over within a few milliseconds. */
const PART = 4 * 1024 * 1024;

/** @returns the result without the text that has been posted */
function inParts(result: Extract<ImportResult, { kind: 'model' }>, post: Post): ImportResult {
  const { imported } = result;
  if (imported.asset === null) return result;
  const { data } = imported.asset;
  for (let at = 0; at < data.length; at += PART) post({ kind: 'text', part: data.slice(at, at + PART) });
  return { ...result, imported: { ...imported, asset: { ...imported.asset, data: '' } } };
}

function buffersOf(result: ImportResult): ArrayBuffer[] {
  if (result.kind === 'files') return [...new Set(result.files.map(({ bytes }) => bytes.buffer))];
  return result.kind === 'environment' ? [result.environment.data.buffer] : [];
}

async function resultOf(job: Job, server: Server, progress: Progress): Promise<ImportResult> {
  switch (job.kind) {
    case 'import':
      return read(job.main, job.others, server, progress);
    case 'fetch':
      return { kind: 'files', files: await fetchFiles(job.url, progress), notes: [] };
    case 'export': {
      const { exportGltf } = await import('../../../io/gltf-export.ts');
      const { bytes, notes } = await exportGltf(
        await receivedDocument(job.document),
        server.assets,
        (fraction) => progress('Exporting the scene', fraction),
      );
      return { kind: 'files', files: [{ path: 'scene.glb', bytes }], notes };
    }
    case 'environment': {
      const { image, format, type, colorSpace, flipY } = await server.assets.environment(
        await receivedAsset(job.asset),
      );
      const data = image.data as unknown as EnvironmentData['data'];
      const { width, height } = image;
      return { kind: 'environment', environment: { data, width, height, format, type, colorSpace, flipY } };
    }
    case 'unzip': {
      const { path } = job.archive;
      const bytes = await readBytes(job.archive.file, (fraction) =>
        progress(`Reading ${nameOf(path)}`, fraction),
      );
      progress(`Unpacking ${nameOf(path)}`, null);
      const files = [...readZip(bytes, nameOf(path))].map(([inside, content]) => ({
        path: inside,
        // A buffer of its own, which can be handed over.
        bytes:
          content.byteLength === content.buffer.byteLength
            ? (content as Uint8Array<ArrayBuffer>)
            : content.slice(),
      }));
      return { kind: 'files', files, notes: [] };
    }
  }
}

async function read(
  main: PlacedFile,
  others: readonly PlacedFile[],
  server: Server,
  progress: Progress,
): Promise<ImportResult> {
  const name = nameOf(main.path);
  let total = 0;
  const load = ({ path, file }: PlacedFile): Promise<Uint8Array<ArrayBuffer>> => {
    total += file.size;
    if (total > MOST_BYTES)
      throw new Error(`${name}: with what lies beside it, more than ${MOST_BYTES} bytes`);
    return readBytes(file, (fraction) => progress(`Reading ${nameOf(path)}`, fraction));
  };
  const bytes = await load(main);
  const companions = await readCompanions(main.path, bytes, others, load);
  progress(`Decoding ${name}`, 0);
  const options = {
    companions,
    onProgress: (fraction: number) => progress(`Decoding ${name}`, fraction),
  };
  if (isModelFile(name)) return modelOf(await importModel(bytes, main.path, server.assets, options), server);
  return readJson(bytes, main.path, options, server);
}

async function modelOf(
  imported: Awaited<ReturnType<typeof importModel>>,
  server: Server,
): Promise<ImportResult> {
  const { asset } = imported;
  if (asset) server.keep(asset);
  return { kind: 'model', imported, bytes: asset && (await bytesOf(asset)) };
}

/** What the page keeps of a new asset, and would have to find out itself. */
async function bytesOf({ data }: Asset): Promise<{ sha256: string; blob: Blob } | null> {
  // Only where the page cannot have been tampered with on its way.
  if (!crypto.subtle) return null;
  const bytes = decodeBase64(data);
  return { sha256: await sha256Of(bytes), blob: new Blob([bytes]) };
}

/** Of a folder what the file asks for, and what that asks for; not the rest of what may be a whole library. */
async function readCompanions(
  main: string,
  bytes: Uint8Array,
  others: readonly PlacedFile[],
  load: (placed: PlacedFile) => Promise<Uint8Array>,
): Promise<Companions> {
  const near = companionsFrom(main, new Map(others.map((other) => [other.path, other])));
  const found = new Map<string, Uint8Array>();
  const pending = others.length > 0 ? referencesOf(main, bytes) : [];
  if (/\.obj$/i.test(main)) pending.push(materialFileOf(nameOf(main)));
  for (let reference = pending.pop(); reference !== undefined; reference = pending.pop()) {
    const placed = findCompanion(near, reference)?.content;
    if (placed === undefined || found.has(placed.path)) continue;
    const content = await load(placed);
    found.set(placed.path, content);
    pending.push(...referencesOf(placed.path, content));
  }
  return found;
}

/** A document, a scene of three.js or a material: what is inside tells. */
async function readJson(
  bytes: Uint8Array,
  path: string,
  options: { companions: Companions; onProgress(fraction: number): void },
  server: Server,
): Promise<ImportResult> {
  const name = nameOf(path);
  const text = new TextDecoder().decode(bytes);
  let json: unknown = null;
  try {
    json = JSON.parse(text);
  } catch {
    // The document's own parser says where it ends to be JSON.
  }
  if (isMaterialFile(json)) return { kind: 'material', material: readMaterialFile(json, name) };
  const scene = await importObjectScene(json, path, server.assets, options);
  return scene === null
    ? { kind: 'document', document: parseDocument(json ?? text, name) }
    : modelOf(scene, server);
}
