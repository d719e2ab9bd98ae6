/** Formats of models in words, for help texts; without what reads them. */
export const modelFileKinds =
  '.glb, .gltf, .obj, .ply, .stl, a .zip with one of them, or a scene of three.js (.json)';
