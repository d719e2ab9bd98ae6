/** The page's end of the thread that reads files. */
import * as THREE from 'three/webgpu';
import type { GltfSource, TextureImage } from '../../../scene/assets.ts';
import type { Asset } from '../../../scene/schema.ts';
import { t, translate } from '../../language/language.ts';
import { rememberBytes, toSend } from '../../storage/stored-document.ts';
import { Thread } from '../../threads/thread.ts';
import type {
  FromImporter,
  GeometryData,
  ImportResult,
  ModelAnswer,
  ModelQuestion,
  ToImporter,
} from './messages.ts';

/** An import was given up by the person: nothing to report. */
export class ImportCancelled extends Error {}

const spawn = (): Worker => new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });

export interface ImportJob {
  /** Fails with ImportCancelled after cancel(). */
  readonly result: Promise<{ result: ImportResult; source: GltfSource }>;
  cancel(): void;
}

export function startJob(
  job: ToImporter,
  onProgress: (text: string, fraction: number | null) => void,
): ImportJob {
  const worker = spawn();
  let cancel = (): void => {};
  const parts: string[] = [];
  const result = new Promise<{ result: ImportResult; source: GltfSource }>((resolve, reject) => {
    const end = (error: Error): void => {
      worker.terminate();
      reject(error);
    };
    cancel = () => end(new ImportCancelled());
    worker.addEventListener('message', ({ data }: MessageEvent<FromImporter>) => {
      if (data.kind === 'text') parts.push(data.part);
      else if (data.kind === 'progress') onProgress(translate(data.text), data.fraction);
      else if (data.kind === 'failed') end(new Error(data.message));
      else if (data.kind === 'done') {
        const { result } = data;
        if (result.kind === 'model' && result.imported.asset) {
          const asset = { ...result.imported.asset, data: parts.join('') };
          if (result.bytes) rememberBytes(asset, result.bytes.sha256, result.bytes.blob);
          const imported = { ...result.imported, asset };
          resolve({ result: { ...result, imported }, source: new RemoteGltf(asset, worker) });
        } else {
          worker.terminate();
          resolve({ result, source: noSource });
        }
      }
    });
    worker.addEventListener('error', (event) =>
      end(
        new Error(
          event.message || t('The thread that reads files could not be started, or ran out of memory.'),
        ),
      ),
    );
  });
  worker.postMessage(job);
  return { result, cancel: () => cancel() };
}

const noSource: GltfSource = {
  geometry: () => Promise.reject(new Error('no model is open')),
  image: () => Promise.reject(new Error('no model is open')),
};

/** For AssetLoader: decoding an environment takes seconds where it is large. */
export const environmentElsewhere = (asset: Asset): Promise<THREE.DataTexture> | null =>
  asset.data.length < WORTH_A_THREAD ? null : decodeEnvironment(asset);

async function decodeEnvironment(asset: Asset): Promise<THREE.DataTexture> {
  const { result } = await startJob({ kind: 'environment', asset: toSend(asset) }, () => {}).result;
  if (result.kind !== 'environment') throw new Error('an environment was expected');
  const { data, width, height, format, type, colorSpace, flipY } = result.environment;
  const texture = new THREE.DataTexture(
    data,
    width,
    height,
    format as THREE.PixelFormat,
    type as THREE.TextureDataType,
  );
  texture.colorSpace = colorSpace;
  texture.flipY = flipY;
  texture.mapping = THREE.EquirectangularReflectionMapping;
  texture.minFilter = THREE.LinearFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.name = asset.name;
  texture.needsUpdate = true;
  return texture;
}

/** So large, as base64, an asset has to be for a thread of its own. */
const WORTH_A_THREAD = 2 * 1024 * 1024;

/** For AssetLoader: what would hold up the page is opened elsewhere. */
export const openElsewhere = (asset: Asset): GltfSource | null =>
  asset.data.length < WORTH_A_THREAD ? null : new RemoteGltf(asset, null);

class RemoteGltf implements GltfSource {
  readonly #thread: Thread<ModelQuestion, ModelAnswer>;
  /** By the life of the thread, and its key. */
  readonly #geometries = new Map<string, THREE.BufferGeometry>();

  /** @param running a thread that has it open */
  constructor(asset: Asset, running: Worker | null) {
    const open = () => {
      const worker = spawn();
      worker.postMessage({ kind: 'open', asset: toSend(asset) } satisfies ToImporter);
      return worker;
    };
    this.#thread = new Thread(open, { name: asset.name, ...(running && { running }) });
  }

  async geometry(node: number, primitive: number): Promise<THREE.BufferGeometry> {
    const answer = await this.#thread.ask({ kind: 'geometry', node, primitive });
    if (answer.kind !== 'geometry') throw new Error('a geometry was expected');
    const key = `${this.#thread.life} ${answer.key}`;
    const geometry = answer.data === null ? this.#geometries.get(key) : geometryOf(answer.data);
    if (geometry === undefined) throw new Error('a geometry was lost');
    this.#geometries.set(key, geometry);
    return geometry;
  }

  async image(texture: number): Promise<TextureImage> {
    const answer = await this.#thread.ask({ kind: 'image', texture });
    if (answer.kind !== 'image') throw new Error('an image was expected');
    return answer.image;
  }
}

function geometryOf({ attributes, index, box, sphere }: GeometryData): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  for (const [name, { array, itemSize }] of Object.entries(attributes))
    geometry.setAttribute(name, new THREE.BufferAttribute(array, itemSize));
  if (index !== null) geometry.setIndex(new THREE.BufferAttribute(index, 1));
  geometry.boundingBox = new THREE.Box3(
    new THREE.Vector3().fromArray(box),
    new THREE.Vector3().fromArray(box, 3),
  );
  geometry.boundingSphere = new THREE.Sphere(new THREE.Vector3().fromArray(sphere), sphere[3] ?? 0);
  return geometry;
}
