/** How the names of model files end; three.js's scenes end in .json as documents do, and are told by what is inside. */
export const modelExtensions = ['glb', 'gltf', 'obj', 'ply', 'stl'] as const;

export const isModelFile = (name: string): boolean =>
  modelExtensions.some((extension) => name.toLowerCase().endsWith(`.${extension}`));
