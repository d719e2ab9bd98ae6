/** The English texts that are written in the editor: what t() and plural() are given. */
import {
  argumentsOf,
  calleeOf,
  lineOf,
  literalOf,
  type SourceFile,
  sourceFiles,
  walk,
} from './source-texts.ts';

export interface PageText {
  /** The key of the catalogue; of a text that counts, its `other` form. */
  readonly text: string;
  readonly counts: boolean;
  /** Path and line. */
  readonly place: string;
}

export const editorFiles = (): SourceFile[] =>
  sourceFiles('src/editor').filter(
    ({ path }) => !/^src\/editor\/language\/(es\/|(language|patterns|catalogue|choice)\.ts)/.test(path),
  );

/** @throws Error where one is not written there as a literal, so that nobody could translate it */
export function pageTexts(files: readonly SourceFile[]): PageText[] {
  const found: PageText[] = [];
  for (const file of files)
    for (const node of walk(file.root)) {
      if (node.type !== 'CallExpression') continue;
      const name = calleeOf(node);
      if (name !== 't' && name !== 'plural') continue;
      const counts = name === 'plural';
      const text = literalOf(argumentsOf(node)[counts ? 2 : 0]);
      const place = `${file.path}:${lineOf(file, node)}`;
      if (text === null) throw new Error(`${place}: ${name}() is given something else than a literal`);
      found.push({ text, counts, place });
    }
  return found;
}
