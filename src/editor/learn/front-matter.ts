/** The lines between `---` at the beginning of a lesson: `title: Light`. */
import { LessonError, type Place, shown } from './error.ts';
import type { Lesson } from './lesson.ts';

type Matter = Pick<Lesson, 'title' | 'summary' | 'order' | 'minutes' | 'material'>;

const KEYS = ['title', 'summary', 'order', 'minutes', 'material'] as const;
type Key = (typeof KEYS)[number];

/** @returns the line behind it, from 0 */
export function frontMatter(lines: readonly string[], file: string): { matter: Matter; end: number } {
  const place = (i: number): Place => ({ file, line: i + 1 });
  if (lines[0]?.trim() !== '---') throw new LessonError(place(0), 'the lesson has no front matter', "'---'");
  const end = lines.indexOf('---', 1);
  if (end < 0) throw new LessonError(place(0), 'the front matter does not end', "a second '---'");
  const found = new Map<Key, { text: string; place: Place }>();
  for (let i = 1; i < end; i++) {
    const line = lines[i] ?? '';
    if (line.trim() === '') continue;
    const [, name, text = ''] = /^([a-z]+):\s*(.*?)\s*$/.exec(line) ?? [];
    const key = KEYS.find((known) => known === name);
    if (!key || text === '')
      throw new LessonError(place(i), `“${shown(line)}”`, `${KEYS.join(', ')}, each as 'title: Light'`);
    if (found.has(key)) throw new LessonError(place(i), `a second '${key}:'`, 'it once');
    found.set(key, { text, place: place(i) });
  }
  const text = (key: Key, most: number): string => {
    const entry = found.get(key);
    if (!entry) throw new LessonError(place(0), `there is no '${key}:'`, 'it in the front matter');
    if (entry.text.length > most)
      throw new LessonError(entry.place, `the ${key} is long`, `at most ${most} characters`);
    return entry.text;
  };
  const number = (key: Key, [min, max]: readonly [number, number], otherwise: number): number => {
    const entry = found.get(key);
    if (!entry) return otherwise;
    const value = Number(entry.text);
    if (!(value >= min && value <= max))
      throw new LessonError(entry.place, `${key}: ${shown(entry.text)}`, `a number, ${min} to ${max}`);
    return value;
  };
  return {
    matter: {
      title: text('title', 100),
      summary: found.has('summary') ? text('summary', 300) : '',
      // Behind those that ship.
      order: number('order', [0, 1000], 1000),
      minutes: number('minutes', [1, 600], 10),
      material: found.has('material') ? text('material', 64) : null,
    },
    end: end + 1,
  };
}
