/**
 * The container of RGL's measurements (`.bsdf`): named arrays of numbers. After W. Jakob's "tensor file" as
 * github.com/rgl-epfl/brdf-loader reads it: the 12 bytes `tensor_file\0`, two bytes of version, the number of fields in 32 bits; per
 * field the length of its name, the name, the number of dimensions, the type, where its data begin and the sizes.
 * All little-endian.
 */
import { ByteError, ByteReader, ByteWriter } from './bytes.ts';

export const TENSOR_MAGIC: Uint8Array = new TextEncoder().encode('tensor_file\0');
const VERSION = [1, 0];

/** The format numbers its types from 1; these are what the measurements have. */
const TYPES = { 1: { name: 'uint8', size: 1 }, 10: { name: 'float32', size: 4 } } as const;
const SIZES: Readonly<Record<number, number>> = {
  1: 1,
  2: 1,
  3: 2,
  4: 2,
  5: 4,
  6: 4,
  7: 8,
  8: 8,
  9: 2,
  10: 4,
  11: 8,
};

const MOST_FIELDS = 256;
const MOST_DIMENSIONS = 8;

interface Field {
  readonly type: number;
  readonly shape: readonly number[];
  /** Where its data begin. */
  readonly offset: number;
  /** Where the file describes it. */
  readonly described: number;
}

/** The fields of a file, read when they are asked for. Everything throws ByteError naming the field and the byte. */
export class TensorFile {
  readonly #fields = new Map<string, Field>();

  constructor(
    readonly bytes: Uint8Array,
    readonly fileName: string,
  ) {
    const reader = new ByteReader(bytes, fileName);
    if (!TENSOR_MAGIC.every((byte, i) => bytes[i] === byte))
      throw reader.error('not a tensor file; expected it to begin with "tensor_file"');
    reader.seek(TENSOR_MAGIC.length);
    const version = [reader.uint8(), reader.uint8()];
    if (version.some((part, i) => part !== VERSION[i]))
      throw new ByteError(fileName, 12, `version ${version.join('.')}; expected ${VERSION.join('.')}`);
    const at = reader.position;
    const count = reader.uint32();
    if (count > MOST_FIELDS)
      throw new ByteError(fileName, at, `${count} fields; expected ${MOST_FIELDS} at most`);
    for (let i = 0; i < count; i++) this.#describe(reader);
  }

  #describe(reader: ByteReader): void {
    const described = reader.position;
    const name = reader.utf8(reader.uint16());
    const fault = (message: string) => this.#fault(name, described, message);
    const dimensions = reader.uint16();
    if (dimensions > MOST_DIMENSIONS)
      throw fault(`${dimensions} dimensions; expected ${MOST_DIMENSIONS} at most`);
    const type = reader.uint8();
    const size = SIZES[type];
    if (size === undefined) throw fault(`no type has the number ${type}; expected 1 to 11`);
    const offset = reader.uint64();
    const shape = Array.from({ length: dimensions }, () => reader.uint64());
    const length = shape.reduce((product, n) => product * n, size);
    // Written so that overflow to infinity fails it too.
    if (!(offset + length <= this.bytes.length))
      throw fault(
        `${shape.join(' x ')} values of ${size} bytes from byte ${offset} on; the file ends at ${this.bytes.length}`,
      );
    if (this.#fields.has(name)) throw fault('the name comes twice');
    this.#fields.set(name, { type, shape, offset, described });
  }

  #fault(name: string, at: number, message: string): ByteError {
    return new ByteError(this.fileName, at, `field ${JSON.stringify(name)}: ${message}`);
  }

  has(name: string): boolean {
    return this.#fields.has(name);
  }

  shape(name: string): readonly number[] {
    return this.#field(name).shape;
  }

  #field(name: string): Field {
    const field = this.#fields.get(name);
    if (field) return field;
    const names = [...this.#fields.keys()].join(', ') || 'none';
    throw new ByteError(this.fileName, 0, `there is no field "${name}"; the file has ${names}`);
  }

  /** What is wrong with a field, at its description. */
  error(name: string, message: string): ByteError {
    return this.#fault(name, this.#field(name).described, message);
  }

  #expect(name: string, type: keyof typeof TYPES, rank: number): Field {
    const field = this.#field(name);
    if (field.type !== type)
      throw this.error(name, `type ${field.type}; expected ${type} (${TYPES[type].name})`);
    if (field.shape.length !== rank)
      throw this.error(name, `${field.shape.length} dimensions; expected ${rank}`);
    return field;
  }

  uint8(name: string): Uint8Array {
    const { offset, shape } = this.#expect(name, 1, 1);
    return this.bytes.subarray(offset, offset + (shape[0] as number));
  }

  /** A copy; each value is finite and at least `least`. */
  float32(name: string, rank: number, least = Number.NEGATIVE_INFINITY): Float32Array {
    const { offset, shape } = this.#expect(name, 10, rank);
    const view = new DataView(this.bytes.buffer, this.bytes.byteOffset + offset);
    const values = new Float32Array(shape.reduce((product, n) => product * n, 1));
    for (let i = 0; i < values.length; i++) {
      const value = view.getFloat32(4 * i, true);
      if (!(Number.isFinite(value) && value >= least)) {
        const expected = Number.isFinite(least) ? `a finite number, at least ${least}` : 'a finite number';
        throw this.#fault(name, offset + 4 * i, `value ${i} is ${value}; expected ${expected}`);
      }
      values[i] = value;
    }
    return values;
  }
}

export interface TensorField {
  readonly shape: readonly number[];
  readonly data: Float32Array | Uint8Array;
}

export function writeTensorFile(fields: Readonly<Record<string, TensorField>>): Uint8Array {
  const writer = new ByteWriter();
  writer.bytes(TENSOR_MAGIC);
  for (const part of VERSION) writer.uint8(part);
  const entries = Object.entries(fields);
  writer.int32(entries.length);
  const patches = entries.map(([name, { shape, data }]) => {
    const encoded = new TextEncoder().encode(name);
    writer.uint16(encoded.length);
    writer.bytes(encoded);
    writer.uint16(shape.length);
    writer.uint8(data instanceof Uint8Array ? 1 : 10);
    const patch = writer.length;
    writer.uint64(0);
    for (const size of shape) writer.uint64(size);
    return patch;
  });
  for (const [i, [, { data }]] of entries.entries()) {
    writer.setUint64(patches[i] as number, writer.length);
    if (data instanceof Uint8Array) writer.bytes(data);
    else for (const value of data) writer.float32(value);
  }
  return writer.finish();
}
