import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import type {
  Declaration,
  Declarator,
  Expression,
  FunctionDefinition,
  Statement,
  StructDefinition,
  TopLevel,
  TypeRef,
} from './ast.ts';
import { TokenCursor } from './token-cursor.ts';
import type { Token } from './tokens.ts';
import { typeNamed } from './types.ts';

/** How many operands one run of `a + b + c ...` may have: each is one level of the tree. */
const MAX_CHAIN = 500;

/** Binary operators by precedence, loosest first (GLSL 4.60, section 5.1). */
const BINARY: readonly (readonly string[])[] = [
  ['||'],
  ['^^'],
  ['&&'],
  ['|'],
  ['^'],
  ['&'],
  ['==', '!='],
  ['<', '>', '<=', '>='],
  ['<<', '>>'],
  ['+', '-'],
  ['*', '/', '%'],
];
const PRECEDENCE = new Map(
  BINARY.flatMap((operators, level) => operators.map((operator) => [operator, level + 1])),
);
const ASSIGNMENT = new Set(['=', '+=', '-=', '*=', '/=', '%=', '<<=', '>>=', '&=', '|=', '^=']);
const PRECISION = new Set(['highp', 'mediump', 'lowp']);
/**
 * Parses tokens into a list of functions, structs and global declarations.
 *
 * @param isKernel whether `while` is allowed (docs/decisions/path-tracer.md)
 * @throws BrdfError
 */
export function parseGlsl(tokens: readonly Token[], isKernel = false): TopLevel[] {
  return new Parser(tokens, isKernel).parse();
}

class Parser extends TokenCursor {
  private readonly structs = new Set<string>();
  private readonly isKernel: boolean;

  constructor(tokens: readonly Token[], isKernel: boolean) {
    super(tokens);
    this.isKernel = isKernel;
  }

  parse(): TopLevel[] {
    const result: TopLevel[] = [];
    while (this.token.kind !== 'end') {
      if (this.accept(';')) continue;
      if (this.token.text === 'precision') {
        for (let end = false; !end && this.peek(0).kind !== 'end'; ) {
          end = this.accept(';');
          if (!end) this.position++;
        }
        continue;
      }
      if (this.token.text === 'struct') result.push(this.struct());
      else result.push(this.functionOrDeclaration());
    }
    return result;
  }

  private startsType(): boolean {
    const { kind, text } = this.token;
    return kind === 'name' && (typeNamed(text) !== undefined || this.structs.has(text));
  }

  private typeRef(): TypeRef {
    while (PRECISION.has(this.token.text)) this.position++;
    const { place, text } = this.token;
    if (!this.startsType()) this.fail('a type');
    this.position++;
    return { place, name: text, lengths: this.arrayLengths() };
  }

  private arrayLengths(): (Expression | null)[] {
    const lengths: (Expression | null)[] = [];
    while (this.accept('[')) {
      lengths.push(this.token.text === ']' ? null : this.ternary());
      this.expect(']');
    }
    return lengths;
  }

  private struct(): StructDefinition {
    const place = this.expect('struct');
    const name = this.name('the name of the struct');
    this.structs.add(name);
    this.expect('{');
    const fields: StructDefinition['fields'][number][] = [];
    while (!this.accept('}')) {
      const type = this.typeRef();
      do {
        const fieldPlace = this.token.place;
        fields.push({
          place: fieldPlace,
          type,
          name: this.name('the name of a field'),
          lengths: this.arrayLengths(),
        });
      } while (this.accept(','));
      this.expect(';');
    }
    this.expect(';');
    return { kind: 'struct', place, name, fields };
  }

  private functionOrDeclaration(): FunctionDefinition | Declaration {
    const { place } = this.token;
    const constant = this.accept('const');
    const type = this.typeRef();
    if (!constant && this.token.kind === 'name' && this.peek(1).text === '(') {
      return this.function(type, place);
    }
    return this.declaration(constant, type, place);
  }

  private function(type: TypeRef, place: SourcePlace): FunctionDefinition {
    const name = this.name('the name of a function');
    this.expect('(');
    const parameters: FunctionDefinition['parameters'][number][] = [];
    if (this.token.text === 'void' && this.peek(1).text === ')') this.position++;
    if (this.token.text !== ')') {
      do {
        this.accept('const');
        const parameterPlace = this.token.place;
        const qualifier = (['inout', 'out', 'in'] as const).find((word) => this.accept(word)) ?? 'in';
        this.accept('const');
        const parameterType = this.typeRef();
        // A parameter may go unnamed; no identifier starts with a digit, so this one collides with nothing.
        const parameterName =
          this.token.kind === 'name' ? this.name('the name of a parameter') : `${parameters.length}`;
        parameters.push({
          place: parameterPlace,
          qualifier,
          type: parameterType,
          name: parameterName,
          lengths: this.arrayLengths(),
        });
      } while (this.accept(','));
    }
    this.expect(')');
    if (this.accept(';')) return { kind: 'function', place, type, name, parameters, body: null };
    if (this.token.text !== '{') this.fail("'{' or ';'");
    return { kind: 'function', place, type, name, parameters, body: this.block() };
  }

  private declaration(constant: boolean, type: TypeRef, place: SourcePlace): Declaration {
    const declarators: Declarator[] = [];
    do {
      const namePlace = this.token.place;
      const name = this.name('the name of a variable');
      const lengths = this.arrayLengths();
      const init = this.accept('=') ? this.initialiser() : null;
      declarators.push({ place: namePlace, name, lengths, init });
    } while (this.accept(','));
    this.expect(';');
    return { kind: 'declare', place, constant, type, declarators };
  }

  private initialiser(): Expression {
    const { place } = this.token;
    if (!this.accept('{')) return this.assignment();
    return this.nested(() => {
      const items: Expression[] = [];
      do {
        if (this.token.text === '}') break;
        items.push(this.initialiser());
      } while (this.accept(','));
      this.expect('}');
      return { kind: 'list', place, items };
    });
  }

  private block(): Statement[] {
    this.expect('{');
    const body: Statement[] = [];
    while (!this.accept('}')) {
      if (this.token.kind === 'end') this.fail("'}'");
      body.push(this.statement());
    }
    return body;
  }

  private statement(): Statement {
    return this.nested(() => {
      const { place, text } = this.token;
      if (text === '{') return { kind: 'block', place, body: this.block() };
      if (this.accept(';')) return { kind: 'block', place, body: [] };
      if (this.accept('if')) {
        this.expect('(');
        const test = this.expression();
        this.expect(')');
        const yes = this.statement();
        return { kind: 'if', place, test, yes, no: this.accept('else') ? this.statement() : null };
      }
      if (this.accept('for')) return this.forLoop(place);
      if (this.isKernel && this.accept('while')) {
        this.expect('(');
        const test = this.expression();
        this.expect(')');
        return { kind: 'while', place, test, body: this.statement() };
      }
      if (this.accept('return')) {
        const value = this.token.text === ';' ? null : this.expression();
        this.expect(';');
        return { kind: 'return', place, value };
      }
      if (text === 'break' || text === 'continue') {
        this.position++;
        this.expect(';');
        return { kind: text, place };
      }
      return this.simpleStatement();
    });
  }

  private simpleStatement(): Statement {
    const { place } = this.token;
    if (this.accept('const')) return this.declaration(true, this.typeRef(), place);
    if (
      PRECISION.has(this.token.text) ||
      (this.startsType() && this.peek(1).text !== '(' && !this.constructsArray())
    ) {
      return this.declaration(false, this.typeRef(), place);
    }
    const expression = this.expression();
    this.expect(';');
    return { kind: 'expression', place, expression };
  }

  /** Whether `float[...](` starts here: a value, not a declaration. */
  private constructsArray(): boolean {
    let i = 1;
    while (this.peek(i).text === '[') {
      while (this.peek(i).text !== ']' && this.peek(i).kind !== 'end') i++;
      i++;
    }
    return i > 1 && this.peek(i).text === '(';
  }

  private forLoop(place: SourcePlace): Statement {
    this.expect('(');
    const init = this.accept(';') ? null : this.simpleStatement();
    const test = this.token.text === ';' ? null : this.expression();
    this.expect(';');
    const step = this.token.text === ')' ? null : this.expression();
    this.expect(')');
    return { kind: 'for', place, init, test, step, body: this.statement() };
  }

  private expression(): Expression {
    const first = this.assignment();
    if (this.token.text !== ',') return first;
    const items = [first];
    while (this.accept(',')) items.push(this.assignment());
    return { kind: 'sequence', place: first.place, items };
  }

  private assignment(): Expression {
    return this.nested(() => {
      const target = this.ternary();
      const { text, place } = this.token;
      if (!ASSIGNMENT.has(text)) return target;
      this.position++;
      return { kind: 'assign', place, operator: text, target, value: this.assignment() };
    });
  }

  private ternary(): Expression {
    return this.nested(() => {
      const test = this.binary(1);
      const { place } = this.token;
      if (!this.accept('?')) return test;
      const yes = this.assignment();
      this.expect(':');
      return { kind: 'ternary', place, test, yes, no: this.assignment() };
    });
  }

  private binary(level: number): Expression {
    let left = this.unary();
    for (let links = 0; ; links++) {
      if (links > MAX_CHAIN)
        throw new BrdfError(this.token.place, 'the expression is too long', `at most ${MAX_CHAIN} operands`);
      const { text, place, kind } = this.token;
      const precedence = kind === 'operator' ? PRECEDENCE.get(text) : undefined;
      if (precedence === undefined || precedence < level) return left;
      this.position++;
      const right = this.nested(() => this.binary(precedence + 1));
      left = { kind: 'binary', place, operator: text, left, right };
    }
  }

  private unary(): Expression {
    const { place, text, kind } = this.token;
    if (kind === 'operator' && ['-', '+', '!', '~', '++', '--'].includes(text)) {
      this.position++;
      const operand = this.nested(() => this.unary());
      if (text === '++' || text === '--')
        return { kind: 'step', place, operator: text, prefix: true, target: operand };
      return { kind: 'unary', place, operator: text, operand };
    }
    return this.postfix(this.primary());
  }

  private postfix(primary: Expression): Expression {
    let result = primary;
    for (let links = 0; ; links++) {
      if (links > MAX_CHAIN) throw new BrdfError(this.token.place, 'the expression is too long');
      const { place } = this.token;
      if (this.accept('.')) {
        const name = this.name('a component or a field');
        if (this.token.text === '(') this.fail('no call here: methods are not supported');
        result = { kind: 'member', place, object: result, name };
      } else if (this.accept('[')) {
        const index = this.expression();
        this.expect(']');
        result = { kind: 'index', place, object: result, index };
      } else if (this.token.text === '++' || this.token.text === '--') {
        const operator = this.token.text;
        this.position++;
        result = { kind: 'step', place, operator, prefix: false, target: result };
      } else return result;
    }
  }

  private primary(): Expression {
    const { kind, text, place } = this.token;
    if (kind === 'int' || kind === 'uint' || kind === 'float') {
      this.position++;
      return { kind: 'number', place, type: kind, value: Number(text) };
    }
    if (text === 'true' || text === 'false') {
      this.position++;
      return { kind: 'bool', place, value: text === 'true' };
    }
    if (this.accept('(')) {
      const inner = this.nested(() => this.expression());
      this.expect(')');
      return inner;
    }
    // A function may bear the name of a struct's constructor only by being that constructor.
    if (this.startsType() && (this.peek(1).text === '(' || this.constructsArray())) {
      return this.call(this.typeRef(), place);
    }
    const name = this.name('an expression');
    if (this.token.text === '(') return this.call({ place, name, lengths: [] }, place);
    return { kind: 'name', place, name };
  }

  private call(callee: TypeRef, place: SourcePlace): Expression {
    this.expect('(');
    const args: Expression[] = [];
    if (this.token.text === 'void' && this.peek(1).text === ')') this.position++;
    if (this.token.text !== ')') {
      do args.push(this.assignment());
      while (this.accept(','));
    }
    this.expect(')');
    return { kind: 'call', place, callee, args };
  }
}
