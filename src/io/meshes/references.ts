const isRelative = (reference: unknown): reference is string =>
  typeof reference === 'string' && reference !== '' && !/^([a-z][a-z0-9+.-]*:|\/\/)/i.test(reference);

/** The files beside it that a model file asks for, as it names them. What is wrong with it the import will say. */
export function referencesOf(path: string, bytes: Uint8Array): string[] {
  const text = () => new TextDecoder().decode(bytes);
  if (/\.(gltf|json)$/i.test(path)) {
    try {
      const { buffers = [], images = [] } = JSON.parse(text()) as Record<string, Record<string, unknown>[]>;
      return [...buffers.map(({ uri }) => uri), ...images.map(({ uri, url }) => uri ?? url)].filter(
        isRelative,
      );
    } catch {
      return [];
    }
  }
  if (/\.obj$/i.test(path))
    return [...text().matchAll(/^\s*mtllib\s+(.+?)\s*$/gm)].map(([, name]) => name ?? '').filter(isRelative);
  if (/\.mtl$/i.test(path))
    return [
      ...text().matchAll(/^\s*(?:map_\w+|norm|bump)\s+(?:-\w+\s+(?:(?:on|off|[-\d.]+)\s+)*)*(.+?)\s*$/gim),
    ]
      .map(([, name]) => name ?? '')
      .filter(isRelative);
  return [];
}
