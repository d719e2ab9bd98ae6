import type { Model } from '../glsl/model.ts';
import { parseDocument } from '../scene/document.ts';
import type { Document } from '../scene/schema.ts';

/** A scene that shows a model: a sphere before a dark ground, lit from three sides. */
export function previewDocument(model: Model, source: string): Document {
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
      name: model.name,
      camera: { fov: 30, position: [0, 0, 2.4], target: [0, 0, 0], near: 0.1, far: 10 },
      background: { type: 'color', color: [0.03, 0.03, 0.033] },
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
      models: { preview: { source } },
    },
    model.file.fileName,
  );
}
