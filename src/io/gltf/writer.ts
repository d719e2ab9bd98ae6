/** A GLB put together part by part: what other formats become here, and what the export writes. */
import { padded, writeGlb } from './glb.ts';

export type Json = Record<string, unknown>;

const components = { VEC4: 4, VEC3: 3, VEC2: 2, SCALAR: 1 } as const;
type AccessorType = keyof typeof components;

/** glTF 2.0, 3.6.2: 34962 is ARRAY_BUFFER, 34963 is ELEMENT_ARRAY_BUFFER. */
const TARGETS = { vertices: 34962, indices: 34963 } as const;
const FLOAT = 5126;
const UINT16 = 5123;
const UINT32 = 5125;

export class GltfWriter {
  readonly #lists = new Map<string, Json[]>();
  readonly #extensions = new Set<string>();
  readonly #parts: Uint8Array[] = [];
  #length = 0;
  #root: Json = {};

  /** Adds an entry to one of glTF's lists, such as `materials`; returns its index. */
  add(list: string, entry: Json): number {
    const entries = this.#lists.get(list) ?? [];
    this.#lists.set(list, entries);
    return entries.push(entry) - 1;
  }

  /** Says that the file uses an extension. */
  use(extension: string): void {
    this.#extensions.add(extension);
  }

  /** A field of the file itself, such as `extensions`. */
  set(name: string, value: unknown): void {
    this.#root[name] = value;
  }

  /** Attributes of vertices. Positions need `bounds` (3.6.2.4). */
  attribute(values: Float32Array, type: AccessorType, bounds = false): number {
    const size = components[type];
    return this.add('accessors', {
      bufferView: this.bytes(bytesOf(values), { target: TARGETS.vertices }),
      componentType: FLOAT,
      count: values.length / size,
      type,
      ...(bounds && boundsOf(values, size)),
    });
  }

  /** Corners of triangles, with 16 bits where that is enough. */
  indices(values: Uint32Array, vertices: number): number {
    // 65535 is the value that restarts a primitive, and not allowed as an index.
    const small = vertices < 65_536;
    const stored = small ? Uint16Array.from(values) : values;
    return this.add('accessors', {
      bufferView: this.bytes(bytesOf(stored), { target: TARGETS.indices }),
      componentType: small ? UINT16 : UINT32,
      count: values.length,
      type: 'SCALAR',
    });
  }

  /** An encoded image file; returns its index among the images. */
  image(bytes: Uint8Array, mimeType: string, name: string): number {
    return this.add('images', { name, mimeType, bufferView: this.bytes(bytes) });
  }

  /** Returns the index of the view of the buffer that holds these bytes. */
  bytes(bytes: Uint8Array, fields: Json = {}): number {
    const byteOffset = this.#length;
    this.#parts.push(bytes);
    this.#length += padded(bytes.length);
    return this.add('bufferViews', { buffer: 0, byteOffset, byteLength: bytes.length, ...fields });
  }

  finish(): Uint8Array<ArrayBuffer> {
    const binary = new Uint8Array(this.#length);
    let at = 0;
    for (const part of this.#parts) {
      binary.set(part, at);
      at += padded(part.length);
    }
    const nodes = this.#lists.get('nodes') ?? [];
    const inside = new Set(nodes.flatMap(({ children }) => (children as number[] | undefined) ?? []));
    const json = {
      asset: { version: '2.0', generator: 'Irradia' },
      ...(this.#extensions.size > 0 && { extensionsUsed: [...this.#extensions] }),
      scene: 0,
      scenes: [{ nodes: [...nodes.keys()].filter((index) => !inside.has(index)) }],
      ...Object.fromEntries(this.#lists),
      ...this.#root,
      ...(binary.length > 0 && { buffers: [{ byteLength: binary.length }] }),
    };
    return writeGlb(json, binary);
  }
}

const bytesOf = ({ buffer, byteOffset, byteLength }: ArrayBufferView): Uint8Array =>
  new Uint8Array(buffer, byteOffset, byteLength);

function boundsOf(values: Float32Array, size: number): { min: number[]; max: number[] } {
  const min = new Array<number>(size).fill(Number.POSITIVE_INFINITY);
  const max = new Array<number>(size).fill(Number.NEGATIVE_INFINITY);
  for (let i = 0; i < values.length; i++) {
    const [value, c] = [values[i]!, i % size];
    if (value < min[c]!) min[c] = value;
    if (value > max[c]!) max[c] = value;
  }
  return { min, max };
}
