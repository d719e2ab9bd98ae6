/** Which language the page speaks, and how it finds the Spanish of texts that other rooms wrote. */
import { describe, expect, test } from 'vitest';
import { loadModel } from '../../../models/index.ts';
import { preferredLanguage } from '../../../src/editor/language/choice.ts';
import spanish from '../../../src/editor/language/es/index.ts';
import { plural, t, translate } from '../../../src/editor/language/language.ts';
import { translated } from '../../../src/editor/language/patterns.ts';
import { parseDocument } from '../../../src/scene/document.ts';

const messageOf = (run: () => unknown): string => {
  try {
    run();
  } catch (error) {
    return (error as Error).message;
  }
  throw new Error('nothing was thrown');
};

test('the first of the browser’s languages that the page speaks, whatever the country', () => {
  expect(preferredLanguage(['fr-FR', 'es-MX', 'en'])).toBe('es');
  expect(preferredLanguage(['EN-gb', 'es'])).toBe('en');
  expect(preferredLanguage(['eo', 'tlh'])).toBe('en');
  expect(preferredLanguage([])).toBe('en');
});

test('English is what is written, with its holes filled and without the word that tells meanings apart', () => {
  expect(t('Delete {name}, {name} and {other}', { name: 'a', other: 3 })).toBe('Delete a, a and 3');
  expect(t('{nothing} fills this')).toBe('{nothing} fills this');
  expect(t('Light|theme')).toBe('Light');
  expect([0, 1, 2].map((count) => plural(count, '1 lamp', '{count} lamps'))).toEqual([
    '0 lamps',
    '1 lamp',
    '2 lamps',
  ]);
  expect(translate('Delete Lamp')).toBe('Delete Lamp');
});

describe('what other rooms wrote, in Spanish', () => {
  test('names of edits, with the names that a person gave as they are', () => {
    expect(translated(spanish, 'Delete Light')).toBe('Eliminar Light');
    expect(translated(spanish, 'Delete 2 lights, 1 object and 3 materials')).toBe(
      'Eliminar 2 luces, 1 objeto y 3 materiales',
    );
    expect(translated(spanish, 'Add point light')).toBe('Añadir luz puntual');
    expect(translated(spanish, 'Rename Road to Nowhere to Gold')).toBe(
      'Cambiar el nombre de Road a Nowhere to Gold',
    );
    // A material of that name, and what it got from the library of substances.
    expect(translated(spanish, 'Metallic: Gold, Au')).toBe('Metallic: Oro, Au');
    expect(translated(spanish, 'Kaput')).toBe('Kaput');
    // What is selected, without an edit.
    expect(translated(spanish, '1 light and 2 objects')).toBe('1 luz y 2 objetos');
  });

  test('faults keep their place; what is wrong and what was expected are Spanish', () => {
    const shader = (line: string) =>
      `analytic\n::begin shader\nvec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n${line}\n}\n::end shader\n`;
    const fault = (line: string) =>
      translated(
        spanish,
        messageOf(() => loadModel(shader(line), 'x.brdf')),
      );
    expect(fault('return vec3(nobody);')).toBe("x.brdf:4:13: 'nobody' no está declarado");
    expect(fault('if (1.) return L; return L;')).toMatch(
      /^x\.brdf:4:\d+: un float como condición; se esperaba un bool$/,
    );
    expect(
      translated(
        spanish,
        messageOf(() => parseDocument('{"format": "irradia"', 'x.json')),
      ),
    ).toMatch(/^x\.json: no es JSON/);
    expect(
      translated(
        spanish,
        messageOf(() =>
          parseDocument({ format: 'irradia', version: 1, name: 'x', camera: { iso: -5 } }, 'x.json'),
        ),
      ),
    ).toMatch(/^x\.json: camera\.iso: Demasiado pequeño: se esperaba number >=/);
    expect(translated(spanish, 'head.ply: line 3: "widget" is not a type of PLY')).toBe(
      'head.ply: línea 3: "widget" no es un tipo de PLY',
    );
  });

  test('a verdict says where in the middle of its sentence', () => {
    expect(
      translated(
        spanish,
        'sampleL gives directions that are below the surface with the light at 91.0° and the viewer at 3.0° from the normal: no light comes from there, and the sample should be given up as vec3(0).',
      ),
    ).toBe(
      'sampleL da direcciones bajo la superficie con la luz a 91.0° y el observador a 3.0° de la normal: de ahí no viene luz, y la muestra debería darse por perdida como vec3(0).',
    );
  });
});
