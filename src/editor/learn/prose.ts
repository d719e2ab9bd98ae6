/** The running text of a lesson: a part of Markdown, as plain data. There is no HTML in it; what looks like it is text. */

import type { Inline, Prose } from './lesson.ts';
import { createMarkdownIt, type Token } from './markdown-it.ts';

const markdown = createMarkdownIt();

/** Paragraphs and lists. */
export function parseProse(text: string): Prose[] {
  return proseOf(new Reader(markdown.parse(text, {})));
}

/** Text within a line: strong, emphasis, `code`, $formula$. */
export function parseInline(text: string): Inline[] {
  const [token] = markdown.parseInline(text, {});
  return inlineOf(new Reader(token?.children ?? []));
}

class Reader {
  readonly #tokens: readonly Token[];
  #at = 0;

  constructor(tokens: readonly Token[]) {
    this.#tokens = tokens;
  }

  /** The next token, unless it ends what is being read. */
  next(): Token | undefined {
    const token = this.#tokens[this.#at];
    this.#at += 1;
    return token?.nesting === -1 ? undefined : token;
  }
}

function proseOf(reader: Reader): Prose[] {
  const prose: Prose[] = [];
  for (let token = reader.next(); token; token = reader.next()) {
    if (token.type === 'inline')
      prose.push({ kind: 'paragraph', children: inlineOf(new Reader(token.children ?? [])) });
    else if (token.type === 'paragraph_open') prose.push(...proseOf(reader));
    else if (token.type.endsWith('list_open')) {
      const items: Prose[][] = [];
      while (reader.next()) items.push(proseOf(reader));
      prose.push({ kind: 'list', ordered: token.type === 'ordered_list_open', items });
    }
  }
  return prose;
}

function inlineOf(reader: Reader): Inline[] {
  const inline: Inline[] = [];
  for (let token = reader.next(); token; token = reader.next()) {
    switch (token.type) {
      case 'strong_open':
        inline.push({ kind: 'strong', children: inlineOf(reader) });
        break;
      case 'em_open':
        inline.push({ kind: 'emphasis', children: inlineOf(reader) });
        break;
      case 'code_inline':
        inline.push({ kind: 'code', text: token.content });
        break;
      case 'formula':
        inline.push({ kind: 'formula', text: token.content });
        break;
      case 'softbreak':
      case 'hardbreak':
        inline.push({ kind: 'text', text: ' ' });
        break;
      default:
        if (token.content) inline.push({ kind: 'text', text: token.content });
    }
  }
  return inline;
}

/** The formulas in it. */
export function formulasIn(inline: readonly Inline[]): string[] {
  return inline.flatMap((part) => {
    if ('children' in part) return formulasIn(part.children);
    return part.kind === 'formula' ? [part.text] : [];
  });
}

export function inlineIn(prose: Prose): Inline[] {
  if (prose.kind === 'paragraph') return [...prose.children];
  return prose.items.flat().flatMap(inlineIn);
}
