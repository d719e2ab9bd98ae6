import { BrdfError, type SourcePlace } from '../brdf/error.ts';
import type { SourceText } from '../brdf/model.ts';

export interface Token {
  readonly kind: 'name' | 'int' | 'uint' | 'float' | 'operator' | 'end';
  readonly text: string;
  readonly place: SourcePlace;
}

interface Macro {
  readonly parameters: readonly string[] | null;
  readonly body: readonly Token[];
}

/** Bounds that keep a hostile file from taking the machine's time. */
const MAX_TOKENS = 200_000;
const MAX_EXPANSION_DEPTH = 32;

const PATTERN =
  /(?<space>\s+)|(?<float>(?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?[fF]?|\d+[eE][+-]?\d+[fF]?|\d+[fF]\b)|(?<int>0[xX][0-9a-fA-F]+[uU]?|\d+[uU]?)|(?<name>[A-Za-z_]\w*)|(?<operator><<=|>>=|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||\^\^|\+=|-=|\*=|\/=|%=|&=|\|=|\^=|[-+*/%<>=!&|^~?:;,.(){}[\]])/y;

/** GLSL source to tokens: comments dropped, macros of `#define` expanded, `#ifdef` sections chosen. */
export function tokenize(source: SourceText): Token[] {
  const macros = new Map<string, Macro>();
  const result: Token[] = [];
  const conditions: { active: boolean; place: SourcePlace }[] = [];
  let inComment: SourcePlace | null = null;
  let pending: { text: string; place: SourcePlace } | null = null;

  for (const [index, { text: raw, file, line }] of source.lines.entries()) {
    const [text, commentOpen] = stripComments(raw, inComment !== null);
    inComment = commentOpen ? (inComment ?? { file, line }) : null;
    const place: SourcePlace = pending?.place ?? { file, line };
    const joined: string = (pending?.text ?? '') + text;
    const active = conditions.every((condition) => condition.active);
    if (joined.trimStart().startsWith('#')) {
      if (joined.endsWith('\\') && index + 1 < source.lines.length) {
        pending = { text: `${joined.slice(0, -1)} `, place };
        continue;
      }
      pending = null;
      directive(joined.trim().slice(1).trim(), place, active, macros, conditions);
      continue;
    }
    if (active) expand(scan(text, file, line), macros, [], result);
  }
  const last = source.lines.at(-1);
  const end: SourcePlace = last ? { file: last.file, line: last.line } : { file: '', line: 1 };
  if (inComment) throw new BrdfError(inComment, 'a comment that does not end', "'*/'");
  const open = conditions.at(-1);
  if (open) throw new BrdfError(open.place, 'a condition that does not end', '#endif');
  result.push({ kind: 'end', text: 'the end of the shader', place: end });
  refuseSplitMacroCalls(result, macros);
  return result;
}

function stripComments(line: string, inComment: boolean): [text: string, commentOpen: boolean] {
  let text = '';
  let inside = inComment;
  for (let i = 0; i < line.length; i++) {
    const two = line.slice(i, i + 2);
    if (inside) {
      // Blanks keep the columns of what follows.
      if (two === '*/') inside = false;
    } else if (two === '//') {
      break;
    } else if (two === '/*') {
      inside = true;
    } else {
      text += line[i];
      continue;
    }
    if (two === '*/' || two === '/*') {
      i++;
      text += ' ';
    }
    text += ' ';
  }
  return [text, inside];
}

function scan(text: string, file: string, line: number): Token[] {
  const tokens: Token[] = [];
  PATTERN.lastIndex = 0;
  while (PATTERN.lastIndex < text.length) {
    const column = PATTERN.lastIndex + 1;
    const match = PATTERN.exec(text);
    const place: SourcePlace = { file, line, column };
    if (!match?.groups) throw new BrdfError(place, `'${text[column - 1]}' has no meaning in GLSL`);
    const { float, int, name, operator } = match.groups;
    if (float !== undefined) tokens.push({ kind: 'float', text: float.replace(/[fF]$/, ''), place });
    else if (int !== undefined) {
      const unsigned = /[uU]$/.test(int);
      // C's octal: 017 is 15. Number() would read it as 17.
      const digits = int.replace(/[uU]$/, '');
      const value = /^0[0-7]+$/.test(digits) ? Number.parseInt(digits, 8) : Number(digits);
      if (value > (unsigned ? 0xffffffff : 0x7fffffff))
        throw new BrdfError(place, `the integer ${int} is too large`, '32 bits');
      tokens.push({ kind: unsigned ? 'uint' : 'int', text: String(value), place });
    } else if (name !== undefined) tokens.push({ kind: 'name', text: name, place });
    else if (operator !== undefined) tokens.push({ kind: 'operator', text: operator, place });
  }
  return tokens;
}

function directive(
  text: string,
  place: SourcePlace,
  active: boolean,
  macros: Map<string, Macro>,
  conditions: { active: boolean; place: SourcePlace }[],
): void {
  const [, word = '', rest = ''] = /^(\w*)\s*(.*)$/s.exec(text) ?? [];
  switch (word) {
    case 'ifdef':
    case 'ifndef':
      if (!/^\w+$/.test(rest)) throw new BrdfError(place, `#${word} without a name`, `#${word} NAME`);
      conditions.push({ active: macros.has(rest) === (word === 'ifdef'), place });
      return;
    case 'else':
    case 'endif': {
      const condition = conditions.at(-1);
      if (!condition)
        throw new BrdfError(place, `#${word} without its condition`, '#ifdef or #ifndef before it');
      if (word === 'else') condition.active = !condition.active;
      else conditions.pop();
      return;
    }
    case '':
    case 'version':
    case 'extension':
    case 'pragma':
    case 'line':
      return;
    case 'define': {
      if (!active) return;
      const [, name = '', list, body = ''] = /^([A-Za-z_]\w*)(\([^)]*\))?(.*)$/s.exec(rest) ?? [];
      if (name === '') throw new BrdfError(place, '#define without a name', '#define NAME VALUE');
      const parameters =
        list === undefined
          ? null
          : list
              .slice(1, -1)
              .split(',')
              .map((p) => p.trim())
              .filter((p) => p !== '');
      macros.set(name, { parameters, body: scan(body, place.file, place.line) });
      return;
    }
    case 'undef':
      if (active) macros.delete(rest);
      return;
    default:
      throw new BrdfError(
        place,
        `'#${word}' is not supported`,
        '#define, #undef, #ifdef, #ifndef, #else or #endif',
      );
  }
}

function expand(
  tokens: readonly Token[],
  macros: ReadonlyMap<string, Macro>,
  within: readonly string[],
  into: Token[],
): void {
  for (let i = 0; i < tokens.length; i++) {
    const token = tokens[i] as Token;
    const macro = token.kind === 'name' && !within.includes(token.text) ? macros.get(token.text) : undefined;
    if (!macro) {
      into.push(token);
    } else {
      if (within.length >= MAX_EXPANSION_DEPTH)
        throw new BrdfError(token.place, 'macros are nested too deep');
      let body = macro.body;
      if (macro.parameters) {
        const call = macroArguments(tokens, i + 1);
        if (!call) {
          into.push(token);
          continue;
        }
        if (
          call.args.length !== macro.parameters.length &&
          !(macro.parameters.length === 0 && call.args[0]?.length === 0)
        ) {
          throw new BrdfError(
            token.place,
            `macro ${token.text} was given ${call.args.length} arguments`,
            `${macro.parameters.length}`,
          );
        }
        const { parameters } = macro;
        body = body.flatMap((t) =>
          t.kind === 'name' && parameters.includes(t.text)
            ? (call.args[parameters.indexOf(t.text)] ?? [])
            : [t],
        );
        i = call.end;
      }
      // An error inside a macro is reported where the macro is used.
      expand(
        body.map((t) => ({ ...t, place: token.place })),
        macros,
        [...within, token.text],
        into,
      );
    }
    if (into.length > MAX_TOKENS)
      throw new BrdfError(token.place, 'the shader is too long', `at most ${MAX_TOKENS} tokens`);
  }
}

function macroArguments(tokens: readonly Token[], open: number): { args: Token[][]; end: number } | null {
  if (tokens[open]?.text !== '(') return null;
  const args: Token[][] = [[]];
  let depth = 0;
  for (let i = open; i < tokens.length; i++) {
    const token = tokens[i] as Token;
    if (token.text === '(' && depth++ === 0) continue;
    if (token.text === ')' && --depth === 0) return { args, end: i };
    if (token.text === ',' && depth === 1) args.push([]);
    else args.at(-1)?.push(token);
  }
  return null;
}

/** A function-like macro whose arguments run over several lines was left as it is: say so, with its place. */
function refuseSplitMacroCalls(tokens: readonly Token[], macros: ReadonlyMap<string, Macro>): void {
  for (const [i, token] of tokens.entries()) {
    if (token.kind === 'name' && macros.get(token.text)?.parameters && tokens[i + 1]?.text === '(') {
      throw new BrdfError(
        token.place,
        `the arguments of macro ${token.text} run over several lines`,
        'them on one line',
      );
    }
  }
}
