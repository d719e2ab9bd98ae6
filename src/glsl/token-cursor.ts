/** The place in the tokens at which a parser is, and what it says when it meets something else. */
import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import type { Token } from './tokens.ts';
import { typeNamed } from './types.ts';

/** How deep expressions and statements may nest: far more than people write, far less than the stack holds. */
const MAX_DEPTH = 200;
const UNSUPPORTED: Record<string, string> = {
  while: 'a loop without constant bounds',
  do: 'a loop without constant bounds',
  switch: 'switch',
  discard: 'discard',
  uniform: 'a uniform: list it in ::begin parameters',
  varying: 'varying',
  attribute: 'attribute',
};
const KEYWORDS = new Set([
  'if',
  'else',
  'for',
  'return',
  'break',
  'continue',
  'struct',
  'const',
  'in',
  'out',
  'inout',
  'true',
  'false',
  ...Object.keys(UNSUPPORTED),
]);

export class TokenCursor {
  protected position = 0;
  private depth = 0;
  private readonly tokens: readonly Token[];

  constructor(tokens: readonly Token[]) {
    this.tokens = tokens;
  }

  protected get token(): Token {
    return this.tokens[this.position] as Token;
  }

  protected peek(offset: number): Token {
    return this.tokens[Math.min(this.position + offset, this.tokens.length - 1)] as Token;
  }

  protected accept(text: string): boolean {
    if (this.token.text !== text || this.token.kind === 'end') return false;
    this.position++;
    return true;
  }

  protected expect(text: string): SourcePlace {
    const { place } = this.token;
    if (!this.accept(text)) this.fail(`'${text}'`);
    return place;
  }

  protected fail(expected: string): never {
    const { place, text, kind } = this.token;
    const problem = UNSUPPORTED[text];
    if (problem)
      throw new BrdfError(
        place,
        `${problem} is not supported`,
        problem.startsWith('a loop') ? 'for (int i = A; i < B; i += C) with constants A, B, C' : expected,
      );
    throw new BrdfError(
      place,
      kind === 'end' ? 'the shader ends too early' : `unexpected '${text}'`,
      expected,
    );
  }

  protected name(what: string): string {
    const { kind, text } = this.token;
    if (kind !== 'name' || KEYWORDS.has(text) || typeNamed(text)) this.fail(what);
    this.position++;
    return text;
  }

  protected nested<T>(parse: () => T): T {
    if (++this.depth > MAX_DEPTH)
      throw new BrdfError(this.token.place, 'the code is nested too deep', `at most ${MAX_DEPTH} levels`);
    const result = parse();
    this.depth--;
    return result;
  }
}
