/** Environments that are computed: sky and studio as images of radiance, the same for every renderer. */
import type { Environment, EnvironmentSource, SourceOf } from './environment-schema.ts';

/** RGBA floats, linear Rec. 709. Equirectangular: the first row is y = -1, columns run from -x by -z, +x and +z. */
export interface EnvironmentMap {
  readonly texels: Float32Array;
  readonly width: number;
  readonly height: number;
}

export type ComputedSource = SourceOf<'sky'> | SourceOf<'studio'>;

export const isComputed = (source: EnvironmentSource): source is ComputedSource =>
  source.type === 'sky' || source.type === 'studio';

/** In nits; a sky's as on Earth, its brightness not counted. */
export async function computeEnvironment(source: ComputedSource): Promise<EnvironmentMap> {
  if (source.type === 'studio') return (await import('./studio.ts')).studioMap(source);
  return (await import('./sky/sky.ts')).skyMap(source);
}

/** By what the texels of a map are multiplied. */
export function environmentScale({ source, intensity }: Environment): number {
  return source.type === 'sky' ? intensity * 2 ** source.brightness : intensity;
}
