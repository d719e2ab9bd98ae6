/**
 * A lesson from its text: front matter, then steps, which begin with `## `. In a step are prose, formulas between
 * `$$` and directives, which begin with a colon. The text may come from a stranger: whatever it is, it becomes a
 * lesson or a LessonError.
 */
import { readDirective } from './directives.ts';
import { LessonError, type Place, shown } from './error.ts';
import { frontMatter } from './front-matter.ts';
import type { Block, Definition, Inline, Lesson, Prose, Setting, Step } from './lesson.ts';
import { formulasIn, inlineIn, parseProse } from './prose.ts';
import { checkTex } from './tex.ts';
import { Words } from './words.ts';

const MOST_CHARACTERS = 256 * 1024;
const MOST_IN_A_LINE = 4000;
const MOST_STEPS = 50;
const MOST_IN_A_STEP = 80;
const MOST_DEFINITIONS = 100;

export function parseLesson(text: string, file: string): Lesson {
  if (text.length > MOST_CHARACTERS)
    throw new LessonError({ file, line: 1 }, `more than ${MOST_CHARACTERS} characters`, 'a shorter lesson');
  const lines = text.replace(/^\uFEFF/, '').split(/\r\n?|\n/);
  for (const [i, line] of lines.entries())
    if (line.length > MOST_IN_A_LINE)
      throw new LessonError(
        { file, line: i + 1 },
        `a line of ${line.length} characters`,
        `at most ${MOST_IN_A_LINE}`,
      );
  const { matter, end } = frontMatter(lines, file);
  return { file, ...matter, ...new Body(lines, end, file).read() };
}

interface OpenStep {
  readonly title: string;
  readonly place: Place;
  readonly blocks: Block[];
  readonly settings: Setting[];
}

class Body {
  readonly #lines: readonly string[];
  readonly #file: string;
  #at: number;
  readonly #steps: OpenStep[] = [];
  readonly #definitions = new Map<string, Definition>();

  constructor(lines: readonly string[], from: number, file: string) {
    this.#lines = lines;
    this.#at = from;
    this.#file = file;
  }

  read(): { steps: Step[]; definitions: Map<string, Definition> } {
    while (this.#at < this.#lines.length) {
      const line = this.#line;
      if (line.trim() === '') this.#at += 1;
      else if (/^#/.test(line)) this.#heading(line);
      else if (line.startsWith('$$')) this.#formula();
      else if (/^:[A-Za-z]/.test(line)) this.#directive(line);
      else this.#prose();
    }
    if (this.#steps.length === 0)
      throw new LessonError(this.#place(), 'the lesson has no step', "a line '## Title of the step'");
    this.#checkFormulas();
    return { steps: this.#steps, definitions: this.#definitions };
  }

  get #line(): string {
    return this.#lines[this.#at] ?? '';
  }

  #place(at = this.#at): Place {
    return { file: this.#file, line: Math.min(at, this.#lines.length - 1) + 1 };
  }

  #heading(line: string): void {
    const title = /^##\s+(.+?)\s*#*\s*$/.exec(line)?.[1];
    const place = this.#place();
    if (title === undefined || title.length > 120)
      throw new LessonError(place, `“${shown(line)}”`, "'## ' and the title of a step");
    if (this.#steps.length >= MOST_STEPS) throw new LessonError(place, `more than ${MOST_STEPS} steps`);
    this.#steps.push({ title, place, blocks: [], settings: [] });
    this.#at += 1;
  }

  #formula(): void {
    const from = this.#at;
    const first = this.#line.slice(2);
    let tex = first;
    this.#at += 1;
    while (!tex.includes('$$')) {
      if (this.#at >= this.#lines.length)
        throw new LessonError(this.#place(from), 'the formula does not end', '$$ at its end');
      tex += `\n${this.#line}`;
      this.#at += 1;
    }
    const [inside = '', after = ''] = tex.split('$$', 2);
    if (after.trim() !== '')
      throw new LessonError(this.#place(), `“${shown(after.trim())}” behind a formula`, 'a line of its own');
    const place = this.#place(from);
    this.#add({ kind: 'formula', tex: inside.trim(), terms: this.#checked(inside, place), place });
  }

  #directive(line: string): void {
    const place = this.#place();
    const [, name = '', rest = ''] = /^:([A-Za-z]+)(.*)$/.exec(line) ?? [];
    let text = rest;
    this.#at += 1;
    // An indented line goes on with it.
    while (/^\s+\S/.test(this.#line)) {
      text += ` ${this.#line.trim()}`;
      this.#at += 1;
    }
    const directive = readDirective(name, new Words(text.trim(), place), place);
    if ('definition' in directive) this.#define(directive.definition);
    else if ('block' in directive) this.#add(directive.block);
    else if ('setting' in directive) this.#step(place).settings.push(directive.setting);
    else this.#answer(directive.answer, place);
  }

  #define(definition: Definition): void {
    const { key, place } = definition;
    if (this.#definitions.has(key)) throw new LessonError(place, `${key} is defined twice`, 'another key');
    if (this.#definitions.size >= MOST_DEFINITIONS)
      throw new LessonError(place, `more than ${MOST_DEFINITIONS} definitions`);
    this.#definitions.set(key, definition);
  }

  #answer(answer: readonly Inline[], place: Place): void {
    const { blocks } = this.#step(place);
    const question = blocks.at(-1);
    if (question?.kind !== 'question' || question.answer.length > 0)
      throw new LessonError(place, 'an answer without a question', ':question before it');
    blocks[blocks.length - 1] = { ...question, answer };
  }

  /** Up to a line that is something else. */
  #prose(): void {
    const from = this.#at;
    while (this.#at < this.#lines.length && !/^(#|\$\$|:[A-Za-z])/.test(this.#line)) this.#at += 1;
    const place = this.#place(from);
    const prose: Prose[] = parseProse(this.#lines.slice(from, this.#at).join('\n'));
    for (const part of prose) this.#add({ ...part, place });
  }

  #add(block: Block): void {
    const { blocks, settings } = this.#step(block.place);
    if (blocks.length + settings.length >= MOST_IN_A_STEP)
      throw new LessonError(block.place, `more than ${MOST_IN_A_STEP} parts in a step`, 'a further step');
    blocks.push(block);
  }

  #step(place: Place): OpenStep {
    const step = this.#steps.at(-1);
    if (!step) throw new LessonError(place, 'this stands before the first step', "'## Title of the step'");
    return step;
  }

  /** Definitions may stand anywhere, so this is for the end. */
  #checkFormulas(): void {
    for (const { text, place } of this.#definitions.values()) this.#checkInline(text, place);
    for (const { blocks } of this.#steps)
      for (const block of blocks) {
        const { place } = block;
        if (block.kind === 'formula') this.#checkDefined(block.terms.keys(), place);
        else if (block.kind === 'paragraph' || block.kind === 'list')
          this.#checkInline(inlineIn(block), place);
        else if (block.kind === 'question') {
          if (block.answer.length === 0)
            throw new LessonError(place, 'the question has no answer', ':answer below it');
          this.#checkInline([...block.question, ...block.answer], place);
        } else if ('text' in block) this.#checkInline(block.text, place);
      }
  }

  #checkInline(inline: readonly Inline[], place: Place): void {
    for (const tex of formulasIn(inline)) this.#checkDefined(this.#checked(tex, place).keys(), place);
  }

  #checkDefined(terms: Iterable<string>, place: Place): void {
    for (const key of terms)
      if (!this.#definitions.has(key))
        throw new LessonError(place, `nothing says what ${shown(key)} is`, `:define ${key} ...`);
  }

  #checked(tex: string, place: Place): Map<string, string> {
    try {
      return checkTex(tex);
    } catch (error) {
      const message = error instanceof Error ? error.message : String(error);
      throw new LessonError(
        place,
        `the formula cannot be set: ${message.replace(/^KaTeX parse error: /, '')}`,
      );
    }
  }
}
