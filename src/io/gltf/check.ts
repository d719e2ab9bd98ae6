/**
 * What the glTF schema cannot say: that indices name something, that data lies within its
 * buffer, that nodes form a tree. After this, loading may fail, but neither hangs nor
 * allocates more than the file's own size justifies.
 */
import { GltfError } from './error.ts';
import { dracoSchema, type Gltf, imageIndex, meshoptSchema } from './schema.ts';

const componentSizes = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 } as const;
const componentCounts = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 } as const;

/** Values that all accessors may decode to together: 2 GB of floats. */
const maxValues = 512 * 1024 * 1024;

/** `bufferSizes` are the bytes that there are, whatever `byteLength` claims. */
export function checkGltf(gltf: Gltf, bufferSizes: readonly number[], file: string): void {
  const fail = (path: string, message: string): never => {
    throw new GltfError(file, `${path}: ${message}`);
  };
  const need = (index: number | undefined, list: keyof Gltf, path: string): void => {
    const entries = gltf[list];
    if (index !== undefined && !(Array.isArray(entries) && index < entries.length))
      fail(path, `there is no ${String(list)}[${index}]`);
  };
  const within = (offset: number, length: number, size: number, path: string): void => {
    if (offset + length > size)
      fail(path, `bytes ${offset} to ${offset + length} lie beyond the ${size} bytes there are`);
  };

  for (const [i, view] of gltf.bufferViews.entries()) {
    const path = `bufferViews[${i}]`;
    const packed = meshoptOf(view.extensions)?.value ?? null;
    if (packed !== null) {
      need(packed.buffer, 'buffers', `${path}.extensions`);
      within(packed.byteOffset, packed.byteLength, bufferSizes[packed.buffer] ?? 0, path);
      // The codec packs vertices in groups of 16 with at least a byte for each group.
      if (packed.count > 16 * 256 * (packed.byteLength + 1))
        fail(path, `cannot hold ${packed.count} elements`);
    } else {
      need(view.buffer, 'buffers', `${path}.buffer`);
      within(view.byteOffset, view.byteLength, bufferSizes[view.buffer] ?? 0, path);
    }
  }

  const compressed = new Set<number>();
  for (const [i, mesh] of gltf.meshes.entries()) {
    for (const [j, primitive] of mesh.primitives.entries()) {
      const path = `meshes[${i}].primitives[${j}]`;
      need(primitive.material, 'materials', `${path}.material`);
      need(primitive.indices, 'accessors', `${path}.indices`);
      const attributes = [primitive.attributes, ...(primitive.targets ?? [])];
      for (const [name, accessor] of attributes.flatMap((a) => Object.entries(a)))
        need(accessor, 'accessors', `${path}.attributes.${name}`);
      const draco = primitive.extensions?.KHR_draco_mesh_compression;
      if (draco !== undefined) {
        const result = dracoSchema.safeParse(draco);
        if (!result.success) fail(path, 'KHR_draco_mesh_compression is not valid');
        else need(result.data.bufferView, 'bufferViews', path);
        for (const accessor of Object.values(primitive.attributes)) compressed.add(accessor);
        if (primitive.indices !== undefined) compressed.add(primitive.indices);
      }
    }
  }

  let values = 0;
  for (const [i, accessor] of gltf.accessors.entries()) {
    const path = `accessors[${i}]`;
    const components = componentCounts[accessor.type];
    values += accessor.count * components;
    if (values > maxValues) fail(path, 'the file describes more data than can be loaded');
    const elementSize = components * componentSizes[accessor.componentType];
    for (const part of [accessor.sparse?.indices, accessor.sparse?.values])
      need(part?.bufferView, 'bufferViews', `${path}.sparse`);
    if (accessor.bufferView === undefined) continue;
    need(accessor.bufferView, 'bufferViews', `${path}.bufferView`);
    const view = gltf.bufferViews[accessor.bufferView];
    if (view === undefined || accessor.count === 0 || compressed.has(i)) continue;
    const packed = meshoptOf(view.extensions)?.value ?? null;
    const size = packed === null ? view.byteLength : packed.count * packed.byteStride;
    const stride = view.byteStride ?? elementSize;
    within(accessor.byteOffset, stride * (accessor.count - 1) + elementSize, size, path);
  }

  for (const [i, image] of gltf.images.entries()) need(image.bufferView, 'bufferViews', `images[${i}]`);
  for (const [i, texture] of gltf.textures.entries()) {
    need(imageIndex(texture), 'images', `textures[${i}].source`);
    need(texture.sampler, 'samplers', `textures[${i}].sampler`);
  }
  need(gltf.scene, 'scenes', 'scene');
  for (const [i, scene] of gltf.scenes.entries())
    for (const node of scene.nodes) need(node, 'nodes', `scenes[${i}].nodes`);
  checkTree(gltf, need, fail);
}

function checkTree(
  gltf: Gltf,
  need: (index: number | undefined, list: keyof Gltf, path: string) => void,
  fail: (path: string, message: string) => never,
): void {
  const parents = new Map<number, number>();
  for (const [i, node] of gltf.nodes.entries()) {
    need(node.mesh, 'meshes', `nodes[${i}].mesh`);
    need(node.camera, 'cameras', `nodes[${i}].camera`);
    for (const child of node.children) {
      need(child, 'nodes', `nodes[${i}].children`);
      if (parents.has(child)) fail(`nodes[${i}].children`, `node ${child} already has a parent`);
      parents.set(child, i);
    }
  }
  // With one parent each, a node that does not lead up to a root is part of a cycle.
  const rooted = new Set<number>();
  for (const start of parents.keys()) {
    const way: number[] = [];
    for (let at: number | undefined = start; at !== undefined && !rooted.has(at); at = parents.get(at)) {
      way.push(at);
      if (way.length > gltf.nodes.length) fail(`nodes[${start}]`, 'the node is among its own descendants');
    }
    for (const node of way) rooted.add(node);
  }
}

/** The meshopt compression of a buffer view, under either of its names. */
export function meshoptOf(extensions: Readonly<Record<string, unknown>> | undefined) {
  for (const name of ['EXT_meshopt_compression', 'KHR_meshopt_compression']) {
    const result = meshoptSchema.safeParse(extensions?.[name]);
    if (result.success) return { name, value: result.data };
  }
  return null;
}
