/** The noise of the generic sampler beside that of a model's own. */

import { shippedModels } from '../../models/index.ts';
import { createRandom } from '../../src/analysis/random.ts';
import type { Sampler } from '../../src/analysis/sampler-test.ts';
import { direction, type Vec3 } from '../../src/analysis/vector.ts';
import type { ParameterValues } from '../../src/brdf/model.ts';
import { resolveParameters } from '../../src/brdf/values.ts';
import type { Model } from '../../src/glsl/model.ts';
import { modelCalls } from '../glsl/wasm/calls.ts';
import { genericSamplerOf, modelWithoutSampler } from './generic.ts';

/** Views from the normal to grazing. */
export const VIEWS: readonly Vec3[] = [
  direction(1, 0),
  direction(0.7, 0.5),
  direction(0.35, 2),
  direction(0.12, 4),
];

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Half the sky dark, half ever brighter; 18 degrees around a direction and its opposite: above and below. */
const slope = (l: Vec3): number => 0.02 + Math.max(l[1] + 0.3, 0) ** 2;
const lamp = (at: Vec3) => (l: Vec3) => (Math.abs(dot(l, at)) > 0.95 ? 1 : 0.02);

/** Radiance from a direction, as seen from v. */
export const LIGHTS: Readonly<Record<string, (v: Vec3) => (l: Vec3) => number>> = {
  even: () => () => 1,
  slope: () => slope,
  highlight: (v) => lamp([-v[0], -v[1], v[2]]),
  aside: () => lamp(direction(0.6, 1.2)),
};

/** Of one sample of the reflected luminance. */
export interface Noise {
  readonly mean: number;
  readonly deviation: number;
}

export interface NoiseComparison {
  readonly view: Vec3;
  readonly light: string;
  readonly own: Noise;
  readonly generic: Noise;
}

/** Both samplers of a shipped model under every light from every view. */
export async function compareNoise(
  name: string,
  parameters: ParameterValues,
  samples: number,
): Promise<NoiseComparison[]> {
  const model = shippedModels.get(name) as Model;
  const values = resolveParameters(model.file, parameters);
  const calls = modelCalls(model, ['BRDF', 'sampleL', 'pdf']);
  const frame = [
    [0, 0, 1],
    [1, 0, 0],
    [0, 1, 0],
  ];
  const generic = await genericSamplerOf(modelWithoutSampler(name), parameters);
  return VIEWS.flatMap((view) => {
    const own: Sampler = {
      sample(u) {
        const l = calls('sampleL', values, u, view, ...frame) as unknown as Vec3;
        return l[0] === 0 && l[1] === 0 && l[2] === 0 ? null : l;
      },
      pdf: (l) => calls('pdf', values, l, view, ...frame)[0] as number,
    };
    const reflected = (l: Vec3): number => {
      const [r, g, b] = calls('BRDF', values, l, view, ...frame) as unknown as Vec3;
      return (0.2126 * r + 0.7152 * g + 0.0722 * b) * Math.abs(l[2]);
    };
    const lights = Object.values(LIGHTS).map((light) => light(view));
    const [ofOwn, ofGeneric] = [own, generic.seenFrom(view)].map((sampler) =>
      noiseOf(sampler, reflected, lights, samples),
    ) as [Noise[], Noise[]];
    return Object.keys(LIGHTS).map((light, i) => ({
      view,
      light,
      own: ofOwn[i] as Noise,
      generic: ofGeneric[i] as Noise,
    }));
  });
}

function noiseOf(
  sampler: Sampler,
  reflected: (l: Vec3) => number,
  lights: readonly ((l: Vec3) => number)[],
  samples: number,
): Noise[] {
  const random = createRandom(44);
  const sums = lights.map(() => [0, 0] as [number, number]);
  for (let i = 0; i < samples; i++) {
    const l = sampler.sample([random(), random()]);
    if (l === null) continue;
    const weight = reflected(l) / sampler.pdf(l);
    for (const [k, light] of lights.entries()) {
      const x = weight * light(l);
      sums[k]![0] += x;
      sums[k]![1] += x * x;
    }
  }
  return sums.map(([sum, squares]) => {
    const mean = sum / samples;
    return { mean, deviation: Math.sqrt(Math.max(0, squares / samples - mean * mean)) };
  });
}

/** Less of the mean is no noise to anybody: one sample a pixel shows it as a grain of 3 per cent. */
const VISIBLE = 0.03;

/** How many times as noisy as the model's own sampler the generic one is. */
export function noiseRatio({ own, generic }: NoiseComparison): number {
  return generic.deviation / Math.max(own.deviation, VISIBLE * generic.mean);
}
