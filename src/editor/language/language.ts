/** The words of the page. English is in the code; other languages are catalogues keyed by it. */

/** What stands in for `{name}` in a text. */
export type TextValues = Readonly<Record<string, string | number>>;

/** The text in the page's language; `{name}` is replaced by that value. The source is the English text. */
export function t(source: string, values: TextValues = {}): string {
  return source.replace(/\{(\w+)\}/g, (hole, name: string) => String(values[name] ?? hole));
}
