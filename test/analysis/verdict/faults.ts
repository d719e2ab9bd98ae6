import { loadModel } from '../../../models/index.ts';
import type { Model } from '../../../src/glsl/model.ts';

/** Sound models and the same ones with one fault each, to see whether the verdict finds it. */

interface Parts {
  /** Lines of the header. */
  readonly header?: string;
  readonly parameters?: string;
  /** The body of BRDF(), in which NdotL, NdotV, H and NdotH are at hand. */
  readonly body: string;
  /** Other terms. */
  readonly terms?: string;
  readonly sampling?: string;
}

const ARGUMENTS = 'vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y';
const SETUP = `
  float NdotL = dot(N, L);
  float NdotV = dot(N, V);
  if (NdotL < 1e-7 || NdotV < 1e-7) return vec3(0.0);
  vec3 H = normalize(L + V);
  float NdotH = dot(N, H);`;

export function term(name: string, body: string): string {
  return `vec3 ${name}(${ARGUMENTS}) {${SETUP}\n  ${body}\n}\n`;
}

export function model({ header = '', parameters = '', body, terms = '', sampling }: Parts): Model {
  const comment = header.split('\n').map((line) => `# ${line}`);
  const lines = [
    'analytic',
    ...comment,
    '::begin parameters',
    parameters,
    '::end parameters',
    '::begin shader',
    'const float PI = 3.14159265358979;',
    terms,
    term('BRDF', body),
    '::end shader',
    ...(sampling ? ['::begin sampling', sampling, '::end sampling'] : []),
  ];
  return loadModel(lines.join('\n'), 'planted.brdf');
}

const COLOUR = 'color albedo .5 .5 .5';
const ROUGH = `${COLOUR}\nfloat roughness .2 1 .5`;

/** Blinn and Phong's lobe with a normalised distribution: (n + 2)/(2 pi) (n.h)^n. */
const DISTRIBUTION = 'float e = 2.0 / (roughness * roughness);';

/** Cosine-distributed directions and their density, which is to be `density`. */
const sampling = (density: string, direction = '') => `
vec3 sampleL(vec2 u, vec3 V, vec3 N, vec3 X, vec3 Y) {
  if (dot(N, V) < 1e-7) return vec3(0.0);
  float r = sqrt(u.x);
  float phi = 2.0 * PI * u.y;
  vec3 l = r * cos(phi) * X + r * sin(phi) * Y + sqrt(max(0.0, 1.0 - u.x)) * N;
  return ${direction || 'l'};
}
float pdf(${ARGUMENTS}) {
  float NdotL = dot(N, L);
  return NdotL < 1e-7 || dot(N, V) < 1e-7 ? 0.0 : ${density};
}
`;

/** Matte, sampled by the cosine, lossless when white: every law applies but those of facets. */
export const sound = (): Model =>
  model({
    header: 'lossless: albedo = 1 1 1\nlobes: halfLobe, otherLobe',
    parameters: COLOUR,
    body: 'return albedo / PI;',
    terms: term('halfLobe', 'return 0.25 * albedo / PI;') + term('otherLobe', 'return 0.75 * albedo / PI;'),
    sampling: sampling('NdotL / PI'),
  });

export const facets = (factor: string, header = ''): Model =>
  model({
    header: `distributions: D\n${header}`,
    parameters: ROUGH,
    terms: term('D', `${DISTRIBUTION} return vec3((e + 2.0) / ${factor} * pow(NdotH, e));`),
    body: `${DISTRIBUTION} return albedo * (e + 2.0) / ${factor} * pow(NdotH, e) * 0.25;`,
  });

/** GGX with Smith's masking, whose roughness is `factor` of the distribution's. */
export const maskedFacets = (factor: string): Model =>
  model({
    header: 'distributions: D\nmasking: G1 of D',
    parameters: 'float alpha .1 1 .5',
    terms:
      term(
        'D',
        'float t = NdotH * NdotH * (alpha * alpha - 1.0) + 1.0; return vec3(alpha * alpha / (PI * t * t));',
      ) +
      term(
        'G1',
        `float a = ${factor} * alpha; return vec3(2.0 * NdotV / (NdotV + sqrt(a * a + (1.0 - a * a) * NdotV * NdotV)));`,
      ),
    body: 'return vec3(0.1);',
  });

export const FAULTS = {
  'a factor 2': model({ parameters: COLOUR, body: 'return 2.0 * albedo / PI;' }),
  'a missing 1/pi': model({ parameters: COLOUR, body: 'return albedo;' }),
  'too dark in a furnace': model({
    header: 'lossless: albedo = 1 1 1',
    parameters: COLOUR,
    body: 'return 0.99 * albedo / PI;',
  }),
  // One factor of two has the light where the viewer belongs: only l is masked, twice.
  'swapped L and V in one factor': model({
    parameters: ROUGH,
    body: 'return albedo / PI * pow(1.0 - NdotL, 2.0) * pow(1.0 - NdotL, roughness) * pow(1.0 - NdotV, roughness);',
  }),
  'a negative lobe': model({
    parameters: ROUGH,
    body: 'return albedo / PI * (1.0 - 1.2 * pow(NdotH, 200.0));',
  }),
  'a NaN at grazing': model({
    parameters: ROUGH,
    body: 'return albedo / PI * (0.5 + 0.5 * sqrt(NdotL - 1e-5) * 0.0 + 0.1);',
  }),
  'an infinity at grazing': model({ body: 'return vec3(1e-3 / max(NdotL + NdotV - 0.02, 0.0));' }),
  'a hard edge': model({ parameters: COLOUR, body: 'return albedo / PI * (NdotH > 0.95 ? 1.0 : 0.9);' }),
  'a slider with a step': model({
    parameters: ROUGH,
    body: 'return albedo / PI * (roughness > 0.63 ? 1.0 : 0.9);',
  }),
  'a density off by the Jacobian': model({
    parameters: COLOUR,
    body: 'return albedo / PI;',
    // As if the samples were half vectors: 1/(4 l.h) too little.
    sampling: sampling('4.0 * dot(L, normalize(L + V)) * NdotL / PI'),
  }),
  'a density that is too uniform': model({
    parameters: COLOUR,
    body: 'return albedo / PI;',
    sampling: sampling('0.5 / PI'),
  }),
  'samples below the surface': model({
    parameters: COLOUR,
    body: 'return albedo / PI;',
    sampling: sampling('NdotL / PI', 'u.x > 0.9 ? -l : l'),
  }),
  'samples of any length': model({
    parameters: COLOUR,
    body: 'return albedo / PI;',
    sampling: sampling('NdotL / PI', '1.01 * l'),
  }),
  'a negative density': model({
    parameters: COLOUR,
    body: 'return albedo / PI;',
    sampling: sampling('(NdotL - 0.1) / PI'),
  }),
  'a distribution that is not normalised': facets('(3.0 * PI)'),
  'a masking of another roughness': maskedFacets('0.7'),
  'a lobe that is counted twice': model({
    header: 'lobes: a, b',
    parameters: COLOUR,
    terms: term('a', 'return 0.5 * albedo / PI;') + term('b', 'return 0.6 * albedo / PI;'),
    body: 'return albedo / PI;',
  }),
} satisfies Record<string, Model>;
