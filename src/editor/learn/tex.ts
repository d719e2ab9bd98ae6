/** Formulas: TeX by KaTeX, in which `\term{key}{...}` is a part that can be clicked. */
import katex, { type KatexOptions, type TrustContext } from 'katex';

/** The attribute by which the page knows a part of a formula: `data-lesson-term`. */
const ATTRIBUTE = 'data-lesson-term';

const MOST_TEX = 2000;
/** KaTeX sets a style attribute for these, which the page's policy forbids. */
const WITHOUT_STYLE = /\\(pmb|poormansbold|f?colorbox)\b/;

/** KaTeX's own commands that reach beyond the formula: of them only that of \term, with that one attribute. */
function trust({ command, attributes }: TrustContext & { attributes?: Record<string, string> }): boolean {
  const names = Object.keys(attributes ?? {});
  if (command === '\\htmlData' && names.length === 1 && names[0] === ATTRIBUTE) return true;
  throw new Error(`${command} is not allowed in a lesson`);
}

const options = (display: boolean): KatexOptions => ({
  displayMode: display,
  throwOnError: true,
  // \term is one of KaTeX's extensions of TeX; the others are harmless.
  strict: 'ignore',
  trust,
  // A formula must not grow without bound, nor leave its place.
  maxExpand: 200,
  maxSize: 10,
  macros: { '\\term': '\\htmlData{lesson-term=#1}{#2}' },
});

/** By the keys of the formula's terms, what the first of each looks like, as TeX. Throws an Error that says what is wrong with it. */
export function checkTex(tex: string): Map<string, string> {
  if (tex.length > MOST_TEX) throw new Error(`the formula has more than ${MOST_TEX} characters`);
  const forbidden = WITHOUT_STYLE.exec(tex);
  if (forbidden) throw new Error(`${forbidden[0]} is not allowed in a lesson`);
  const html = katex.renderToString(tex, options(true));
  const terms = new Map<string, string>();
  for (const [, key = ''] of html.matchAll(/data-lesson-term="([^"]*)"/g)) terms.set(key, insideOf(tex, key));
  return terms;
}

/** What stands in the braces of the first \term{key}{...}; the key itself where a macro hides it. */
function insideOf(tex: string, key: string): string {
  const opening = `\\term{${key}}{`;
  const from = tex.indexOf(opening) + opening.length;
  if (from < opening.length) return `\\text{${key}}`;
  let depth = 1;
  let to = from;
  for (; to < tex.length; to++) {
    if (tex[to] === '\\') to += 1;
    else if (tex[to] === '{') depth += 1;
    else if (tex[to] === '}') depth -= 1;
    if (depth === 0) return tex.slice(from, to);
  }
  return `\\text{${key}}`;
}

/** Puts a formula, which has been checked, into an element. */
export function typeset(tex: string, element: HTMLElement, display: boolean): void {
  katex.render(tex, element, options(display));
}

/** The parts of typeset formulas that can be clicked, with their keys. */
export function termsIn(element: HTMLElement): { readonly key: string; readonly part: HTMLElement }[] {
  return [...element.querySelectorAll<HTMLElement>(`[${ATTRIBUTE}]`)].map((part) => ({
    key: part.getAttribute(ATTRIBUTE) ?? '',
    part,
  }));
}
