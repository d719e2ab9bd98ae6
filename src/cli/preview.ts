import { parseDocument } from '../scene/document.ts';
import type { Asset, Document } from '../scene/schema.ts';

/** What a model is made from: GLSL, or a file of measurements. */
export type PreviewSource = { readonly source: string } | { readonly measurements: Asset };

/** Per pixel: the light of a single sphere has little noise. */
export const PREVIEW_SAMPLES = 64;

/** A scene that shows a model: a sphere before a dark ground, lit from three sides. */
export function previewDocument(name: string, from: PreviewSource, fileName: string): Document {
  const directional = (illuminance: number, position: readonly number[]) => ({
    type: 'directional',
    illuminance,
    position,
    target: [0, 0, 0],
  });
  return parseDocument(
    {
      format: 'irradia',
      version: 1,
      name,
      camera: { fov: 30, position: [0, 0, 2.4], target: [0, 0, 0], near: 0.1, far: 10 },
      background: { type: 'color', color: [0.03, 0.03, 0.033] },
      pathTracing: { samples: PREVIEW_SAMPLES },
      lights: {
        key: directional(2.6, [2, 2.5, 2.5]),
        fill: directional(0.7, [-3, 0.5, 1.5]),
        rim: directional(1.8, [-1, 1.5, -2.5]),
        sky: { type: 'hemisphere', luminance: 0.25, groundColor: [0.25, 0.22, 0.2] },
      },
      objects: {
        sphere: {
          material: 'model',
          geometry: { type: 'sphere', radius: 0.5, widthSegments: 256, heightSegments: 128 },
        },
      },
      materials: { model: { model: 'preview' } },
      models: { preview: 'source' in from ? from : { measured: 'measurements' } },
      assets: 'source' in from ? {} : from,
    },
    fileName,
  );
}
