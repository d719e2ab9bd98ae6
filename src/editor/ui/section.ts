/** A titled part of a panel that folds; what is folded is remembered in the editor's state. */
import { append, type Child, h } from './dom.ts';

export function section(
  title: string,
  folded: boolean,
  onFold: (folded: boolean) => void,
  ...children: Child[]
): HTMLDetailsElement {
  const details = h('details', { class: 'section', open: !folded }, h('summary', {}, title));
  const body = h('div', { class: 'section-body' });
  append(body, children);
  details.append(body);
  details.addEventListener('toggle', () => onFold(!details.open));
  return details;
}
