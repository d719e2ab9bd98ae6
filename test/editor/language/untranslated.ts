/** Finds English that is shown without the language having seen it. */
import {
  argumentsOf,
  calleeOf,
  isNode,
  lineOf,
  type SourceFile,
  type SyntaxNode,
  textsOf,
  walk,
} from './source-texts.ts';

export interface Untranslated {
  readonly text: string;
  readonly place: string;
}

/** Attributes of elements, and what menus, choices and rows are made of. */
const PROPERTIES = new Set(['aria-label', 'tip', 'title', 'placeholder', 'alt', 'label', 'heading', 'group']);

/** Which arguments of these a person reads. */
const CALLS: Readonly<Record<string, readonly number[]>> = {
  toast: [1, 2],
  toastError: [0],
  startProgress: [0],
  attempt: [0],
  confirm: [0, 1, 2],
  menuButton: [0],
  openMenu: [1],
  selectField: [0],
  textField: [0],
  switchField: [0],
  tryEdit: [1],
  pathCell: [2],
};

/** What is the same in every language: names, formats, units, quantities, code. */
const WRITTEN = [
  'Irradia',
  'WebGPU',
  'WebGL 2',
  '{source}.brdf',
  ' GLSL',
  'EV {value}',
  /^::/,
  /^[^a-z]*$/,
  /^[θφ{}\w°√ ]{0,12}$/,
];

export const isWritten = ({ text }: Untranslated): boolean =>
  WRITTEN.some((known) => (typeof known === 'string' ? known === text : known.test(text)));

export function untranslated(file: SourceFile): Untranslated[] {
  const found: Untranslated[] = [];
  const read = (node: unknown) => {
    if (!isNode(node)) return;
    const place = `${file.path}:${lineOf(file, node)}`;
    found.push(...textsOf(node).map((text) => ({ text, place })));
  };
  for (const node of walk(file.root)) {
    if (node.type === 'CallExpression') {
      const [callee, given] = [calleeOf(node), argumentsOf(node)];
      if (callee === 'h') for (const child of given.slice(2)) read(child);
      for (const index of CALLS[callee] ?? []) read(given[index]);
    } else if (node.type === 'Property' && PROPERTIES.has(keyOf(node))) read(node.value);
    else if (node.type === 'AssignmentExpression' && /^(textContent|tip)$/.test(memberOf(node.left)))
      read(node.right);
  }
  return found;
}

function keyOf({ key }: SyntaxNode): string {
  const { name, value } = key as { name?: string; value?: string };
  return name ?? String(value);
}

function memberOf(node: unknown): string {
  const property = isNode(node) && node.type === 'MemberExpression' ? (node.property as SyntaxNode) : null;
  return property?.type === 'Identifier' ? String(property.name) : '';
}
