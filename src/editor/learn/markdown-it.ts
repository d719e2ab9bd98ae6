/** markdown-it with the few rules that a lesson's text has, and one of our own: $formula$. */
import MarkdownIt, { type MarkdownIt as Markdown, type Token } from 'markdown-it';

export type { Token };

/** Lists within lists; no lesson goes as deep. */
const MOST_NESTING = 12;

export function createMarkdownIt(): Markdown {
  const markdown = new MarkdownIt('zero', { maxNesting: MOST_NESTING });
  markdown.enable(['list', 'emphasis', 'backticks', 'escape', 'newline']);
  markdown.inline.ruler.before('escape', 'formula', (state, silent) => {
    const { src, pos, posMax } = state;
    if (src[pos] !== '$') return false;
    const end = src.indexOf('$', pos + 1);
    if (end < 0 || end >= posMax) return false;
    const text = src.slice(pos + 1, end);
    // As in other programs, $ beside a space is money.
    if (text.trim() !== text || text === '') return false;
    if (!silent) state.push('formula', 'span', 0).content = text;
    state.pos = end + 1;
    return true;
  });
  return markdown;
}
