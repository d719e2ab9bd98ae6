/** Gives the page the geometries and images of a glTF file that is open in this thread. */
import type { BufferGeometry } from 'three/webgpu';
import { ensureTangents } from '../../../material/tangents.ts';
import { AssetLoader, type TextureImage } from '../../../scene/assets.ts';
import { pageAssets } from '../../../scene/page-assets.ts';
import type { Asset } from '../../../scene/schema.ts';
import type { Answered } from '../../threads/answering.ts';
import { receivedAsset, type SentAsset } from '../../threads/sent-assets.ts';
import type { GeometryData, ModelAnswer, ModelQuestion } from './messages.ts';

export class Server {
  readonly assets = new AssetLoader(pageAssets);
  readonly #sent = new Map<BufferGeometry, string>();
  #asset: Promise<Asset> | null = null;

  open(asset: SentAsset): void {
    this.#asset = receivedAsset(asset);
  }

  /** The same of what this thread has made. */
  keep(asset: Asset): void {
    this.#asset = Promise.resolve(asset);
  }

  async answer(question: ModelQuestion): Promise<Answered<ModelAnswer>> {
    if (this.#asset === null) throw new Error('no file is open');
    const asset = await this.#asset;
    if (question.kind === 'image') return imageAnswer(await this.assets.image(asset, question.texture));
    return this.#geometryAnswer(await this.assets.gltfGeometry(asset, question.node, question.primitive));
  }

  #geometryAnswer(geometry: BufferGeometry): Answered<ModelAnswer> {
    const known = this.#sent.get(geometry);
    const key = known ?? `${this.#sent.size}`;
    if (known !== undefined) return { answer: { kind: 'geometry', key, data: null } };
    this.#sent.set(geometry, key);
    const data = dataOf(geometry);
    const attributes = Object.values(data.attributes).map(({ array }) => array.buffer);
    return {
      answer: { kind: 'geometry', key, data },
      transfer: data.index ? [...attributes, data.index.buffer] : attributes,
    };
  }
}

/** A copy goes: this thread may be asked again. */
async function imageAnswer(image: TextureImage): Promise<Answered<ModelAnswer>> {
  if (image instanceof ImageBitmap) {
    const copy = await createImageBitmap(image, { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
    return { answer: { kind: 'image', image: copy }, transfer: [copy] };
  }
  const { data, width, height } = image;
  return { answer: { kind: 'image', image: { data: data.slice(), width, height } } };
}

/** So many vertices get tangents ahead of need, and so many where equal ones have to be found first. */
const MOST_TANGENTS = 1_000_000;
const MOST_JOINED = 100_000;

/** The same as the page gives a geometry of its own, so that it need not. */
function dataOf(geometry: BufferGeometry): GeometryData {
  const vertices = geometry.getAttribute('position').count;
  if (vertices <= (geometry.getIndex() === null ? MOST_JOINED : MOST_TANGENTS)) ensureTangents(geometry);
  geometry.computeBoundingBox();
  geometry.computeBoundingSphere();
  const { boundingBox, boundingSphere } = geometry;
  const attributes: Record<string, { array: Float32Array<ArrayBuffer>; itemSize: number }> = {};
  for (const [name, attribute] of Object.entries(geometry.attributes))
    attributes[name] = {
      array: (attribute.array as Float32Array<ArrayBuffer>).slice(),
      itemSize: attribute.itemSize,
    };
  const index = geometry.getIndex();
  return {
    attributes,
    index: index && (vertices < 65_536 ? Uint16Array.from(index.array) : Uint32Array.from(index.array)),
    box: [...(boundingBox?.min.toArray() ?? []), ...(boundingBox?.max.toArray() ?? [])],
    sphere: [...(boundingSphere?.center.toArray() ?? []), boundingSphere?.radius ?? 0],
  };
}
