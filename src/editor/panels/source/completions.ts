/** What can be written at a place of a .brdf file: parameters, functions of the file and of models/lib, built-ins. */
import { modelSources } from '../../../../models/index.ts';
import type { Parameter } from '../../../brdf/model.ts';
import { builtinNames } from '../../../glsl/builtins.ts';
import { t, translate } from '../../language/language.ts';

export interface Offer {
  readonly label: string;
  readonly kind: 'property' | 'function' | 'constant' | 'type' | 'keyword' | 'text';
  /** After the label. */
  readonly detail?: string;
  /** Beside the list. */
  readonly info?: string;
}

const TYPES = [
  'float',
  'int',
  'bool',
  'void',
  'vec2',
  'vec3',
  'vec4',
  'mat2',
  'mat3',
  'mat4',
  'ivec2',
  'ivec3',
];
const KEYWORDS = [
  'return',
  'if',
  'else',
  'for',
  'while',
  'break',
  'continue',
  'const',
  'in',
  'out',
  'inout',
  'struct',
];
const SIGNATURE = 'vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y';

/** Functions and constants at the top level, with the comment above them. */
const DECLARATION = /((?:^\/\/.*\n)*)^(?:const\s+)?(\w+)\s+(\w+)\s*(?:\(([^)]*)\)\s*\{|=\s*([^;]*);)/gm;

function declarationsOf(text: string, from: string): Offer[] {
  return [...text.matchAll(DECLARATION)].map(([, comment = '', type = '', label = '', args, value]) => {
    const info = comment.replace(/^\/\/ ?/gm, '').trim();
    const isFunction = args !== undefined;
    return {
      label,
      kind: isFunction ? 'function' : 'constant',
      detail: isFunction ? `(${args.replace(/\s+/g, ' ')}) ${type}` : ` = ${value}`,
      info: [info, from].filter(Boolean).join('\n'),
    };
  });
}

const libraries = [...modelSources].filter(([path]) => path.startsWith('lib/'));
let libraryOffers: readonly Offer[] | null = null;

/** By name, the first of each: overloads are one, and a parameter hides a function. */
function unique(offers: readonly Offer[]): Offer[] {
  return [...new Map([...offers].reverse().map((offer) => [offer.label, offer])).values()];
}

/**
 * @param parameters those of the file when it last compiled
 */
export function offersInGlsl(text: string, parameters: readonly Parameter[]): Offer[] {
  libraryOffers ??= libraries.flatMap(([path, library]) => declarationsOf(library, `::include ${path}`));
  const model = t('The model: 1/sr, without the cosine.');
  return unique([
    ...parameters.map(
      ({ name, type, description }): Offer => ({
        label: name,
        kind: 'property',
        detail: ` ${type}`,
        info: translate(description),
      }),
    ),
    ...declarationsOf(text, ''),
    ...libraryOffers,
    { label: 'BRDF', kind: 'function', detail: `(${SIGNATURE}) vec3`, info: model },
    ...builtinNames().map((label): Offer => ({ label, kind: 'function', detail: ' GLSL' })),
    ...TYPES.map((label): Offer => ({ label, kind: 'type' })),
    ...KEYWORDS.map((label): Offer => ({ label, kind: 'keyword' })),
  ]);
}

/** At the beginning of a line. */
export function directiveOffers(): Offer[] {
  const sections = ['parameters', 'shader', 'sampling'];
  return [
    ...libraries.map(([path, text]): Offer => {
      const info = (/^(?:\/\/.*\n)+/.exec(text)?.[0] ?? '').replace(/^\/\/ ?/gm, '').trim();
      return { label: `::include ${path}`, kind: 'text', info };
    }),
    ...sections.flatMap((name): Offer[] => [
      { label: `::begin ${name}`, kind: 'keyword' },
      { label: `::end ${name}`, kind: 'keyword' },
    ]),
  ];
}
