/** The text of a lesson as elements. Nothing in it is ever read as HTML. */
import type { Inline, Prose } from '../../learn/lesson.ts';
import { termsIn, typeset } from '../../learn/tex.ts';
import { h } from '../../ui/dom.ts';

/** A click on a term of a formula. */
export type OnTerm = (key: string) => void;

export function inlineNodes(inline: readonly Inline[], onTerm: OnTerm): Node[] {
  return inline.map((part) => {
    switch (part.kind) {
      case 'text':
        return document.createTextNode(part.text);
      case 'code':
        return h('code', {}, part.text);
      case 'formula':
        return formula(part.text, false, onTerm);
      default:
        return h(part.kind === 'strong' ? 'strong' : 'em', {}, ...inlineNodes(part.children, onTerm));
    }
  });
}

export function proseElement(prose: Prose, onTerm: OnTerm): HTMLElement {
  if (prose.kind === 'paragraph') return h('p', {}, ...inlineNodes(prose.children, onTerm));
  const items = prose.items.map((item) => h('li', {}, ...item.map((part) => proseElement(part, onTerm))));
  return h(prose.ordered ? 'ol' : 'ul', {}, ...items);
}

/** For the keyboard and for who does not see it, every term has a button beside the formula, too (terms.ts). */
export function formula(tex: string, display: boolean, onTerm: OnTerm): HTMLElement {
  const element = h(display ? 'div' : 'span', { class: display ? 'lesson-formula' : undefined });
  typeset(tex, element, display);
  for (const { key, part } of termsIn(element)) {
    part.classList.add('lesson-term');
    part.addEventListener('click', () => onTerm(key));
  }
  return element;
}

/** The smallest that a formula is made, of its own size; what is still wider can be scrolled. */
const SMALLEST = 0.7;

/** Makes formulas that are wider than the panel smaller; once they are on the page. */
export function fitFormulas(element: HTMLElement): void {
  for (const line of element.querySelectorAll<HTMLElement>('.lesson-formula')) {
    line.style.fontSize = '';
    const share = line.clientWidth / line.scrollWidth;
    if (share < 1) line.style.fontSize = `${Math.max(SMALLEST, share - 0.04)}em`;
  }
}
