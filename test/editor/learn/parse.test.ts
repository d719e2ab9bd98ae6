/** A lesson's text becomes a lesson, or an error that says where and what was expected; whatever the text is. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { shippedLessons } from '../../../lessons/index.ts';
import { LessonError } from '../../../src/editor/learn/error.ts';
import { parseLesson } from '../../../src/editor/learn/parse.ts';
import { prepareLesson } from '../../../src/editor/learn/prepare.ts';
import { parseDocument } from '../../../src/scene/document.ts';

const scene = parseDocument(
  {
    format: 'irradia',
    version: 1,
    lights: { key: { type: 'point' } },
    materials: { ball: { name: 'Ball', model: 'cook-torrance' } },
    objects: { ball: { material: 'ball', geometry: { type: 'sphere' } } },
  },
  'scene.json',
);

const lessonOf = (body: string, matter = 'title: Light') => `---\n${matter}\n---\n${body}`;
const read = (text: string) => prepareLesson(parseLesson(text, 'lesson.en.md'), scene);
const step = (body: string) => read(lessonOf(`## One\n${body}`)).steps[0];

function errorOf(run: () => unknown): LessonError {
  try {
    run();
  } catch (error) {
    if (error instanceof LessonError) return error;
    throw error;
  }
  throw new Error('there was no error');
}

describe('a step', () => {
  it('is the scene with its own lines on top', () => {
    const found = step(
      [
        ':set materials.ball.roughness 0.7',
        ':set lights.key.position.y 4',
        ':look 1 2 3 at 0 1 0',
        ':term distribution',
        ':effect bloom on',
        ':show both',
        ':plot thetaH term=distribution log=true',
        ':pin "smooth one" roughness=0.1',
        ':select objects.ball',
      ].join('\n'),
    );
    expect(found?.document.materials.ball?.parameters.roughness).toBe(0.7);
    expect(found?.document.lights.key).toMatchObject({ position: [0, 4, 2] });
    expect(found?.document.camera).toMatchObject({ position: [1, 2, 3], target: [0, 1, 0] });
    expect(found?.document.view.term).toEqual({ material: 'ball', name: 'distribution' });
    expect(found?.document.effects.bloom.enabled).toBe(true);
    expect(found?.rendering).toBe('split');
    expect(found?.selection).toEqual({ kind: 'objects', id: 'ball' });
    expect(found?.bench).toMatchObject({ term: 'distribution', log: true, active: 0 });
    expect(found?.bench?.panes?.[0]).toBe('thetaH');
    expect(found?.bench?.pins?.[0]).toMatchObject({ name: 'smooth one', parameters: { roughness: 0.1 } });
  });

  it('knows nothing of the steps before it', () => {
    const { steps } = read(lessonOf('## One\n:set view.exposure 3\n:without lights.key\n## Two\nText.'));
    expect(steps[0]?.document.view.exposure).toBe(3);
    expect(steps[0]?.document.lights).toEqual({});
    expect(steps[1]?.document).toEqual({ ...scene, name: 'Light', description: '' });
  });

  it('has text, in which HTML is text', () => {
    const found = step('<b onclick="x()">**Bold**</b> &amp; `code` $a_1$\n\n- one\n- two');
    expect(found?.blocks).toMatchObject([
      {
        kind: 'paragraph',
        children: [
          { kind: 'text', text: '<b onclick="x()">' },
          { kind: 'strong' },
          { kind: 'text', text: '</b> &amp; ' },
          { kind: 'code', text: 'code' },
          { kind: 'text', text: ' ' },
          { kind: 'formula', text: 'a_1' },
        ],
      },
      { kind: 'list', ordered: false },
    ]);
  });

  it('has formulas with terms', () => {
    const { steps, definitions } = read(
      lessonOf(':define D distribution How many.\n## One\n$$ \\term{D}{D(h_{1})} = 1\n  + 1 $$'),
    );
    expect(steps[0]?.blocks).toMatchObject([{ kind: 'formula', terms: new Map([['D', 'D(h_{1})']]) }]);
    expect(definitions.get('D')?.target).toEqual({ kind: 'term', name: 'distribution' });
  });

  it('goes on with a directive in indented lines', () => {
    expect(step(':do Move\n  the slider.')?.blocks).toMatchObject([
      { kind: 'do', text: [{ text: 'Move the slider.' }] },
    ]);
  });
});

describe('an error names the line and what was expected', () => {
  it.each([
    ['', 1, "'---'"],
    ['---\ntitle: A\n', 1, "a second '---'"],
    ['---\nname: A\n---\n', 2, 'title, summary'],
    ['---\nminutes: 5\n---\n', 1, 'it in the front matter'],
    ['---\ntitle: A\nminutes: many\n---\n', 3, 'a number, 1 to 600'],
    [lessonOf(''), 4, '## Title'],
    [lessonOf('Text\n## One'), 4, '## Title'],
    [lessonOf('# One'), 4, "'## '"],
  ])('%j', (text, line, expected) => {
    const error = errorOf(() => read(text));
    expect(error.line).toBe(line);
    expect(error.message).toMatch(/^lesson\.en\.md:\d+: /);
    expect(error.expected).toContain(expected);
  });

  it.each([
    [':st view.exposure 1', ':set'],
    [':set view.exposre 1', 'exposure'],
    [':set view.exposure bright', 'can have'],
    [':set view.exposure {', 'a number'],
    [':set lights.kye.intensity 1', 'key'],
    [':set materials.ball.rouhgness 1', 'roughness'],
    [':set lights.key.position.w 1', 'x, y or z'],
    [':set __proto__.polluted 1', 'camera'],
    [':set materials.__proto__.polluted 1', 'ball'],
    [':without lights.none', 'lights.<id>'],
    [':without materials.ball', 'can have'],
    [':look 1 2', 'x y z'],
    [':look 1 2 3 to 4 5 6', 'at x y z'],
    [':term D', 'distribution'],
    [':term distribution of sun', 'one of'],
    [':plot bars', 'polar'],
    [':plot polar thetaV=100', '0 to 89'],
    [':plot polar colour=red', 'thetaV'],
    [':plot fresnel substance=unobtainium', 'gold'],
    [':pin "a" roughness=1', ':plot before it'],
    [':plot polar\n:pin a shine=1', 'roughness'],
    [':effect sparkles on', 'bloom'],
    [':effect antialiasing on', ':set effects.antialiasing'],
    [':show traces', 'traced'],
    [':slider view.exposure Label', ':slider view.exposure 0 1'],
    [':slider view.exposure 3 1 Label', 'the smaller first'],
    [':slider view.toneMapping 0 1 Label', ':field view.toneMapping'],
    [':field lights.key Label', 'a single field'],
    [':question Why?', ':answer'],
    [':answer Because.', ':question'],
    [':do', 'a sentence'],
    [':define D distribution', 'a sentence'],
    [':define D nothing Text.', 'distribution'],
    [':define 1 - Text.', 'letters and digits'],
    ['$$ a', '$$ at its end'],
    ['$\\term{D}{D}$', ':define D'],
  ])('%s', (body, expected) => {
    const error = errorOf(() => step(body));
    expect(error.line).toBeGreaterThanOrEqual(5);
    expect(error.expected).toContain(expected);
  });

  it.each([
    '$\\frac{1}$',
    '$\\href{javascript:alert(1)}{x}$',
    '$\\htmlStyle{color:red}{x}$',
    '$\\includegraphics{a.png}$',
  ])('a formula: %s', (body) => {
    expect(errorOf(() => step(body)).message).toContain('lesson.en.md:5: the formula cannot be set');
  });

  it('a macro that grows without end', () => {
    expect(errorOf(() => step('$\\def\\a{\\a\\a}\\a$')).message).toContain('cannot be set');
  });
});

describe('a hostile text', () => {
  const words = [
    ...[
      '---',
      '## ',
      '$$',
      '$',
      ':set ',
      ':term ',
      ':plot ',
      ':pin ',
      ':define ',
      ':without ',
      ':slider ',
      ':look ',
    ],
    ...[
      'title: a\n',
      '\n',
      '  ',
      '\\term{',
      '}',
      '{',
      '**',
      '`',
      '- ',
      '1. ',
      'view.exposure',
      'materials.ball',
    ],
    ...[
      '__proto__',
      'constructor',
      '.',
      '=',
      '"',
      '[',
      ']',
      '<script>',
      '0',
      '1e999',
      '-',
      '\u0000',
      '\u2028',
      '𝔻',
    ],
  ];
  const text = fc.array(fc.constantFrom(...words), { maxLength: 60 }).map((parts) => parts.join(''));

  it('is a lesson or a LessonError', () => {
    fc.assert(
      fc.property(fc.oneof(text, fc.string({ maxLength: 300 })), (body) => {
        try {
          read(lessonOf(`## One\n${body}`));
        } catch (error) {
          expect(error).toBeInstanceOf(LessonError);
        }
      }),
      { numRuns: 600 },
    );
  });

  it('a lesson that was damaged anywhere is a lesson or a LessonError', () => {
    const { texts, scene: own } = shippedLessons.find(
      ({ name }) => name === 'microfacets',
    ) as (typeof shippedLessons)[0];
    const whole = texts.get('en') ?? '';
    const document = parseDocument(own, 'scene.json');
    fc.assert(
      fc.property(fc.nat(whole.length), fc.nat(40), fc.constantFrom('', ...words), (at, length, put) => {
        try {
          prepareLesson(
            parseLesson(whole.slice(0, at) + put + whole.slice(at + length), 'lesson.en.md'),
            document,
          );
        } catch (error) {
          expect(error).toBeInstanceOf(LessonError);
        }
      }),
      { numRuns: 60 },
    );
  });

  it.each([
    ['characters', 'a'.repeat(300_000)],
    ['a long line', `:do ${'a '.repeat(5000)}`],
    ['steps', '## A\n'.repeat(100)],
    ['parts', ':do It.\n'.repeat(1000)],
    ['definitions', Array.from({ length: 200 }, (_, i) => `:define a${i} - Text.`).join('\n')],
    ['pins', `:plot polar\n${':pin a roughness=1\n'.repeat(50)}`],
    ['a long formula', `$$\n${'x^{2}'.repeat(700)}\n$$`],
    ['nested formulas', `$$\n${'{'.repeat(1500)}\n$$`],
  ])('too many %s', (_, body) => {
    expect(errorOf(() => step(body))).toBeInstanceOf(LessonError);
  });

  it.each([
    ['lists', Array.from({ length: 300 }, (_, i) => `${'  '.repeat(i)}- a`).join('\n')],
    ['emphasis', '*a **b '.repeat(500)],
    ['backticks', Array.from({ length: 80 }, (_, i) => '`'.repeat(i)).join(' ')],
    ['money', '$ '.repeat(1900)],
  ])('deep or unbalanced %s are text', (_, body) => {
    expect(step(body)?.blocks.length).toBeGreaterThan(0);
  });
});
