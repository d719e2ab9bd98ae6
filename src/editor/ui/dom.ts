/** Builds DOM elements in one expression: tag, attributes, listeners, children. */

export type Child = Node | string | null | undefined | false;

type Listeners = { [E in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[E]) => void };

export interface Attributes {
  class?: string | undefined;
  /** Shown by the page's own tooltip (ui/tooltip.ts). */
  tip?: string | undefined;
  /** The id of the action that it runs: the tooltip says its keys. */
  keys?: string | undefined;
  on?: Listeners;
  [attribute: string]: string | number | boolean | undefined | Listeners;
}

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false || name === 'on') continue;
    if (name === 'class') element.className = String(value);
    else if (name === 'tip') element.dataset.tip = String(value);
    else if (name === 'keys') element.dataset.keys = String(value);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
  for (const [type, listener] of Object.entries(attributes.on ?? {})) {
    element.addEventListener(type, listener as EventListener);
  }
  append(element, children);
  return element;
}

export function append(parent: Node, children: readonly Child[]): void {
  for (const child of children) {
    if (child) parent.appendChild(typeof child === 'string' ? document.createTextNode(child) : child);
  }
}

/** Makes these the children. What stays in its place is not touched: an element that is taken out loses focus and drag. */
export function arrange(parent: Element, children: readonly Element[]): void {
  const wanted = new Set(children);
  for (const child of [...parent.children]) if (!wanted.has(child)) child.remove();
  for (const [place, child] of children.entries()) {
    const there = parent.children[place] ?? null;
    if (there !== child) parent.insertBefore(child, there);
  }
}

/** True while the person types: shortcuts must not fire then. */
export function isTextEntry(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return true;
  if (!(target instanceof HTMLInputElement)) return false;
  return !['range', 'checkbox', 'button', 'file', 'radio'].includes(target.type);
}
