/** Gives the page the geometries and images of a glTF file that is open in this thread. */
import type { BufferGeometry } from 'three/webgpu';
import { ensureTangents } from '../../../material/tangents.ts';
import { AssetLoader, messageOf } from '../../../scene/assets.ts';
import { pageAssets } from '../../../scene/page-assets.ts';
import type { Asset } from '../../../scene/schema.ts';
import { receivedAsset, type SentAsset } from '../../threads/sent-assets.ts';
import type { FromImporter, GeometryData, ToImporter } from './messages.ts';

type Question = Extract<ToImporter, { ticket: number }>;
type Post = (message: FromImporter, transfer?: Transferable[]) => void;

export class Server {
  readonly assets = new AssetLoader(pageAssets);
  readonly #post: Post;
  readonly #sent = new Map<BufferGeometry, string>();
  #asset: Promise<Asset> | null = null;

  constructor(post: Post) {
    this.#post = post;
  }

  open(asset: SentAsset): void {
    this.#asset = receivedAsset(asset);
  }

  /** The same of what this thread has made. */
  keep(asset: Asset): void {
    this.#asset = Promise.resolve(asset);
  }

  async answer(question: Question): Promise<void> {
    const { ticket } = question;
    try {
      if (this.#asset === null) throw new Error('no file is open');
      const asset = await this.#asset;
      if (question.kind === 'geometry') {
        const { node, primitive } = question;
        this.#give(ticket, await this.assets.gltfGeometry(asset, node, primitive));
      } else await this.#giveImage(ticket, asset, question.texture);
    } catch (error) {
      this.#post({ kind: 'refused', ticket, message: messageOf(error) });
    }
  }

  #give(ticket: number, geometry: BufferGeometry): void {
    const known = this.#sent.get(geometry);
    const key = known ?? `${this.#sent.size}`;
    if (known === undefined) this.#sent.set(geometry, key);
    const data = known === undefined ? dataOf(geometry) : null;
    const buffers = data
      ? [...Object.values(data.attributes).map(({ array }) => array.buffer), data.index?.buffer ?? []].flat()
      : [];
    this.#post({ kind: 'geometry', ticket, key, data }, buffers);
  }

  async #giveImage(ticket: number, asset: Asset, texture: number): Promise<void> {
    const image = await this.assets.image(asset, texture);
    // A copy goes: this thread may be asked again.
    if (image instanceof ImageBitmap) {
      const copy = await createImageBitmap(image, { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
      this.#post({ kind: 'image', ticket, image: copy }, [copy]);
      return;
    }
    const { data, width, height } = image;
    this.#post({ kind: 'image', ticket, image: { data: data.slice(), width, height } });
  }
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
