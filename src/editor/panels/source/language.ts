/** The colours of a .brdf file: a header of comments, a table of parameters, GLSL. */
import {
  HighlightStyle,
  LanguageSupport,
  StreamLanguage,
  type StreamParser,
  syntaxHighlighting,
} from '@codemirror/language';
import { shader } from '@codemirror/legacy-modes/mode/clike';
import { tags } from '@lezer/highlight';

interface BrdfState {
  section: 'header' | 'parameters' | 'glsl';
  /** Which word of a parameter's line comes next. */
  word: number;
  glsl: unknown;
}

const glsl = shader as StreamParser<unknown>;

const parser: StreamParser<BrdfState> = {
  name: 'brdf',
  startState: (indentUnit) => ({ section: 'header', word: 0, glsl: glsl.startState?.(indentUnit) }),
  copyState: (state) => ({ ...state, glsl: glsl.copyState?.(state.glsl) ?? state.glsl }),
  token(stream, state) {
    if (stream.sol()) {
      state.word = 0;
      const begin = stream.match(/^::begin\s+(\w+).*/, false) as RegExpMatchArray | null;
      if (stream.match(/^::.*/)) {
        if (begin) state.section = begin[1] === 'parameters' ? 'parameters' : 'glsl';
        else if (/^::end/.test(stream.string)) state.section = 'header';
        return 'meta';
      }
    }
    if (state.section === 'glsl') return glsl.token(stream, state.glsl);
    if (stream.eatSpace()) return null;
    if (stream.peek() === '#') {
      stream.skipToEnd();
      return 'comment';
    }
    if (state.section === 'header') {
      stream.skipToEnd();
      return 'meta';
    }
    stream.eatWhile(/[^\s#]/);
    state.word += 1;
    return state.word === 1 ? 'type' : state.word === 2 ? 'variableName.definition' : 'number';
  },
  indent(state, textAfter, context) {
    if (state.section !== 'glsl' || /^::/.test(textAfter)) return 0;
    return glsl.indent?.(state.glsl, textAfter, context) ?? null;
  },
  languageData: {
    commentTokens: { line: '//' },
    closeBrackets: { brackets: ['(', '[', '{'] },
    indentOnInput: /^\s*[{}]$/,
  },
};

/** From the page's own colours (style/tokens.css), which reach into the editor as custom properties. */
const colours = HighlightStyle.define([
  { tag: tags.comment, color: 'var(--text-faint)', fontStyle: 'italic' },
  { tag: [tags.keyword, tags.controlKeyword, tags.modifier], color: 'var(--code-keyword)' },
  { tag: [tags.typeName, tags.standard(tags.typeName)], color: 'var(--code-type)' },
  { tag: [tags.standard(tags.variableName), tags.standard(tags.name)], color: 'var(--axis-z)' },
  { tag: [tags.number, tags.bool, tags.atom], color: 'var(--axis-y)' },
  { tag: [tags.meta, tags.processingInstruction], color: 'var(--accent)' },
  { tag: tags.definition(tags.variableName), color: 'var(--text)', fontWeight: '600' },
  { tag: tags.operator, color: 'var(--text-dim)' },
]);

export function brdfLanguage(): LanguageSupport {
  return new LanguageSupport(StreamLanguage.define(parser), [syntaxHighlighting(colours)]);
}
