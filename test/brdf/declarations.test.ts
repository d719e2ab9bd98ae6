import { describe, expect, it } from 'vitest';
import { parseBrdf } from '../../src/brdf/parse.ts';

const parse = (header: string) =>
  parseBrdf(
    `analytic\n# A model.\n${header}\n::begin parameters\ncolor albedo 1 1 1\nbool on 1\nfloat x 0 1 0\n` +
      '::end parameters\n::begin shader\n::end shader\n',
    'test.brdf',
  ).declarations;

describe('declarations of a header', () => {
  it('are empty where the header has none', () => {
    expect(parse('# It gives up: nothing, in the middle of a sentence.')).toEqual({
      givesUp: [],
      lobes: [],
      distributions: [],
      maskings: [],
      multipleScattering: null,
      lossless: null,
    });
  });

  it('are lists of properties, of terms and of values', () => {
    const header = [
      '#   gives up: energy, reciprocity of sheenLobe',
      '# lobes: diffuseLobe, sheenLobe.',
      '# distributions: D',
      '# masking: G of D',
      '# multiple scattering: all',
      '# lossless: albedo = 1 .5 1; on = 0; x = 1',
    ];
    expect(parse(header.join('\n'))).toEqual({
      givesUp: [
        { property: 'energy', term: null },
        { property: 'reciprocity', term: 'sheenLobe' },
      ],
      lobes: ['diffuseLobe', 'sheenLobe'],
      distributions: ['D'],
      maskings: [{ masking: 'G', distribution: 'D' }],
      multipleScattering: 'all',
      lossless: { albedo: [1, 0.5, 1], on: false, x: 1 },
    });
  });

  it.each([
    ['# gives up: finiteness', /^test\.brdf:3: a model cannot give up 'finiteness'; expected positivity/],
    ['# gives up:', /test\.brdf:3: 'gives up:' names nothing/],
    ['# lobes: a b', /test\.brdf:3: 'a b' is no name of a term/],
    ['# masking: G', /test\.brdf:3: 'G' is no masking; expected a term 'of' the distribution/],
    ['# lobes: a\n# lobes: b', /test\.brdf:4: a second line 'lobes:'/],
    ['# multiple scattering: a, b', /test\.brdf:3: 'multiple scattering:' names more than one term/],
    ['# lossless: gain = 1', /test\.brdf:3: there is no parameter 'gain'/],
    ['# lossless: albedo = 1', /test\.brdf:3: albedo = '1'; expected three numbers/],
  ])('are refused where they are wrong: %s', (header, message) => {
    expect(() => parse(header)).toThrow(message);
  });
});
