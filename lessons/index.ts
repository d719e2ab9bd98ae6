/** The lessons that ship: every folder here that has a scene.json. Nobody registers one; docs/lessons.md says how to write one. */

const texts = import.meta.glob<string>('./*/lesson.*.md', { query: '?raw', import: 'default', eager: true });
const scenes = import.meta.glob<unknown>('./*/scene.json', { import: 'default', eager: true });

export interface ShippedLesson {
  /** Its folder's name. */
  readonly name: string;
  /** By language: `en`, `es`. */
  readonly texts: ReadonlyMap<string, string>;
  /** A document, as JSON. */
  readonly scene: unknown;
}

export const shippedLessons: readonly ShippedLesson[] = Object.entries(scenes).map(([path, scene]) => {
  const folder = path.replace(/scene\.json$/, '');
  const own = Object.entries(texts).filter(([file]) => file.startsWith(folder));
  return {
    name: folder.slice('./'.length, -1),
    texts: new Map(own.map(([file, text]) => [file.split('.').at(-2) ?? '', text])),
    scene,
  };
});
