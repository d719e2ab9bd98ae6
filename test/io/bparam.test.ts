import { describe, expect, test } from 'vitest';
import { readBparam, savedValues } from '../../src/io/bparam.ts';

/** As the Explorer writes it: floats, then switches, then colours. */
const saved = `bparam ../data/my brdfs/disney.brdf

::begin parameters
float roughness 0.000000 1.000000 0.250000
float ior 1.000000 2.500000 1.500000
bool include_Fresnel 1
color baseColor 0.820000 0.670000 0.160000
::end parameters
`;

describe('a .bparam file', () => {
  test('names its BRDF and has values', () => {
    const { source, model, parameters } = readBparam(saved, 'a.bparam');
    expect([source, model]).toEqual(['disney.brdf', 'disney']);
    expect(parameters.map((p) => [p.name, p.default])).toEqual([
      ['roughness', 0.25],
      ['ior', 1.5],
      ['include_Fresnel', true],
      ['baseColor', [0.82, 0.67, 0.16]],
    ]);
  });

  test.each([
    ['bparam C:\\brdfs\\gold.binary\r\n::begin parameters\r\n::end parameters\r\n', 'gold.binary', 'gold'],
    ['bparam ward.brdf', 'ward.brdf', 'ward'],
  ])('from any system: %j', (text, source, model) => {
    expect(readBparam(text, 'a.bparam')).toEqual({ source, model, parameters: [] });
  });

  test('gives a model what it can take, and tells the rest', () => {
    const model = readBparam(
      'bparam x.brdf\n::begin parameters\nfloat roughness 0 1 .5\nfloat baseColor 0 1 0\n::end parameters',
      'x.bparam',
    );
    expect(savedValues(readBparam(saved, 'a.bparam'), model.parameters)).toEqual({
      values: { roughness: 0.25 },
      unknown: ['ior', 'include_Fresnel', 'baseColor'],
    });
  });

  test.each([
    ['', /^a\.bparam:1: not saved parameters; expected 'bparam FILE\.brdf'/],
    ['analytic\n::begin parameters\n::end parameters\n', /^a\.bparam:1: not saved/],
    ['bparam  \nfoo', /^a\.bparam:1: not saved/],
    [saved.replace('0.250000', 'rough'), /^a\.bparam:4: parameter roughness: 'rough' is no number/],
    [saved.replace('0.250000', '7'), /^a\.bparam:4: .* outside its range/],
    [saved.replace('::end parameters', ''), /^a\.bparam:\d+: .*parameters/],
    [saved.replace('bool include', 'int include'), /^a\.bparam:6: 'int' is no type/],
  ])('that is broken is refused with the line: %j', (text, message) => {
    expect(() => readBparam(text, 'a.bparam')).toThrow(message);
  });
});
