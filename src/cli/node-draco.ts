import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { compileFunction } from 'node:vm';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { BufferAttribute, BufferGeometry } from 'three/webgpu';

/** Draco's decoder as far as it is used; it is compiled C++, hence the pointers. */
interface Draco {
  HEAPF32: Float32Array;
  _malloc(bytes: number): number;
  _free(pointer: number): void;
  Decoder: new () => Decoder;
  Mesh: new () => Mesh;
  destroy(object: unknown): void;
  DT_FLOAT32: number;
}
interface Mesh {
  num_faces(): number;
  num_points(): number;
}
interface Attribute {
  num_components(): number;
}
interface Decoder {
  DecodeArrayToMesh(file: Int8Array, length: number, mesh: Mesh): { ok(): boolean; error_msg(): string };
  GetAttributeByUniqueId(mesh: Mesh, id: number): Attribute;
  GetAttributeDataArrayForAllPoints(
    mesh: Mesh,
    a: Attribute,
    type: number,
    bytes: number,
    to: number,
  ): boolean;
  GetTrianglesUInt32Array(mesh: Mesh, bytes: number, to: number): boolean;
}

/** three.js' loader decodes in a web worker; this one in place, for Node. */
export class NodeDracoLoader extends DRACOLoader {
  override preload(): this {
    return this;
  }

  /** What GLTFLoader calls; three.js declares it nowhere. Attributes come as floats, whatever they were: so does the rest of our geometry. */
  async decodeDracoFile(
    buffer: ArrayBuffer,
    callback: (geometry: BufferGeometry) => void,
    attributeIds: Readonly<Record<string, number>> = {},
    _types?: unknown,
    _colorSpace?: unknown,
    onError: (error: unknown) => void = () => {},
  ): Promise<void> {
    try {
      callback(decode(await loadDraco(), new Int8Array(buffer), attributeIds));
    } catch (error) {
      onError(error);
    }
  }
}

let loading: Promise<Draco> | null = null;

function loadDraco(): Promise<Draco> {
  loading ??= (async () => {
    const { resolve } = createRequire(import.meta.url);
    const read = (name: string) => readFileSync(resolve(`three/addons/libs/draco/gltf/${name}`));
    // A CommonJS file inside a package of ES modules, so it cannot be imported. It is kept from seeing `process`,
    // on which it would install handlers of its own.
    const module: { exports: unknown } = { exports: {} };
    const source = read('draco_wasm_wrapper.js').toString();
    compileFunction(source, ['module', 'exports', 'process'])(module, module.exports, undefined);
    const start = module.exports as (options: { wasmBinary: Uint8Array }) => Promise<Draco>;
    return start({ wasmBinary: read('draco_decoder.wasm') });
  })();
  return loading;
}

function decode(
  draco: Draco,
  file: Int8Array,
  attributeIds: Readonly<Record<string, number>>,
): BufferGeometry {
  const decoder = new draco.Decoder();
  const mesh = new draco.Mesh();
  try {
    const status = decoder.DecodeArrayToMesh(file, file.length, mesh);
    if (!status.ok()) throw new Error(`Draco: ${status.error_msg()}`);
    const geometry = new BufferGeometry();
    for (const [name, id] of Object.entries(attributeIds)) {
      const attribute = decoder.GetAttributeByUniqueId(mesh, id);
      const size = attribute.num_components();
      const values = readHeap(draco, mesh.num_points() * size, (bytes, pointer) =>
        decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, draco.DT_FLOAT32, bytes, pointer),
      );
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(values), size));
    }
    const indices = readHeap(draco, mesh.num_faces() * 3, (bytes, pointer) =>
      decoder.GetTrianglesUInt32Array(mesh, bytes, pointer),
    );
    geometry.setIndex(new BufferAttribute(new Uint32Array(indices), 1));
    return geometry;
  } finally {
    draco.destroy(mesh);
    draco.destroy(decoder);
  }
}

/** The bytes of `count` 32-bit values that `fill` writes to the decoder's memory. */
function readHeap(
  draco: Draco,
  count: number,
  fill: (bytes: number, pointer: number) => boolean,
): ArrayBuffer {
  const bytes = count * 4;
  const pointer = draco._malloc(bytes);
  try {
    if (!fill(bytes, pointer)) throw new Error('Draco: an attribute cannot be decoded');
    // The memory may have grown, and moved, while it was written.
    return draco.HEAPF32.slice(pointer / 4, pointer / 4 + count).buffer as ArrayBuffer;
  } finally {
    draco._free(pointer);
  }
}
