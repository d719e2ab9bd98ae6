/** The page's end of the thread that reads files. */
import * as THREE from 'three/webgpu';
import type { GltfSource, TextureImage } from '../../../scene/assets.ts';
import type { Asset } from '../../../scene/schema.ts';
import { t, translate } from '../../language/language.ts';
import { rememberBytes, toSend } from '../../storage/stored-document.ts';
import type { FromImporter, GeometryData, ImportResult, ToImporter } from './messages.ts';

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
        if (result.kind === 'model') {
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

/** A thread that nobody has asked for so long ends; it is started again when it is needed. */
const IDLE_MS = 20_000;

type Question = { kind: 'geometry'; node: number; primitive: number } | { kind: 'image'; texture: number };
type Answer = Extract<FromImporter, { ticket: number }>;

class RemoteGltf implements GltfSource {
  readonly #asset: Asset;
  readonly #geometries = new Map<string, THREE.BufferGeometry>();
  readonly #waiting = new Map<number, { resolve(answer: Answer): void; reject(error: Error): void }>();
  #worker: Worker | null = null;
  #ticket = 0;
  #idle = 0;
  /** The keys of geometries are those of one thread. */
  #life = 0;

  constructor(asset: Asset, worker: Worker | null) {
    this.#asset = asset;
    if (worker !== null) this.#use(worker);
  }

  async geometry(node: number, primitive: number): Promise<THREE.BufferGeometry> {
    const answer = await this.#ask({ kind: 'geometry', node, primitive });
    if (answer.kind !== 'geometry') throw new Error('a geometry was expected');
    const key = `${this.#life} ${answer.key}`;
    const geometry = answer.data === null ? this.#geometries.get(key) : geometryOf(answer.data);
    if (geometry === undefined) throw new Error('a geometry was lost');
    this.#geometries.set(key, geometry);
    return geometry;
  }

  async image(texture: number): Promise<TextureImage> {
    const answer = await this.#ask({ kind: 'image', texture });
    if (answer.kind !== 'image') throw new Error('an image was expected');
    return answer.image;
  }

  #ask(question: Question): Promise<Answer> {
    const worker = this.#worker ?? this.#restart();
    const ticket = ++this.#ticket;
    return new Promise((resolve, reject) => {
      this.#waiting.set(ticket, { resolve, reject });
      clearTimeout(this.#idle);
      worker.postMessage({ ...question, ticket } satisfies ToImporter);
    });
  }

  #restart(): Worker {
    const worker = spawn();
    this.#life += 1;
    this.#use(worker);
    worker.postMessage({ kind: 'open', asset: toSend(this.#asset) } satisfies ToImporter);
    return worker;
  }

  #use(worker: Worker): void {
    this.#worker = worker;
    worker.addEventListener('message', ({ data }: MessageEvent<FromImporter>) => {
      if (!('ticket' in data)) return;
      const waiting = this.#waiting.get(data.ticket);
      this.#waiting.delete(data.ticket);
      if (data.kind === 'refused') waiting?.reject(new Error(data.message));
      else waiting?.resolve(data);
      this.#rest();
    });
    worker.addEventListener('error', (event) => {
      const error = new Error(`${this.#asset.name}: ${event.message || 'its thread ended'}`);
      for (const { reject } of this.#waiting.values()) reject(error);
      this.#waiting.clear();
      this.#end();
    });
    this.#rest();
  }

  #rest(): void {
    clearTimeout(this.#idle);
    if (this.#waiting.size === 0) this.#idle = window.setTimeout(() => this.#end(), IDLE_MS);
  }

  #end(): void {
    this.#worker?.terminate();
    this.#worker = null;
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
